# SPDX-License-Identifier: BSD-3-Clause
"""Commands of grit whose calls that change files fail, one after the other (failing_calls.c), in a folder that is empty and over
an older result: whole files of this run or of the older one, and status 0 with all of this one's alone."""
import errno
import os
import pathlib
import re
import shutil
import struct
import subprocess
import xml.etree.ElementTree
import zlib

# Once: a disk with a bad spot. From there on: one that is full, one that the system has made read-only.
DISKS = [("EIO", False), ("ENOSPC", True), ("EROFS", True)]


def same_every_time(name, content):
    """Without the moment at which a document was made."""
    if name.endswith(".pdf"):
        return re.sub(rb"/CreationDate \([^)]*\)", b"", content)
    return content


def files_of(folder):
    if not folder.exists():
        return {}
    return {path.name: same_every_time(path.name, path.read_bytes()) for path in sorted(folder.iterdir())}


def rows_of(text):
    return [line for line in text.decode().splitlines() if not line.startswith("#")]


class Command:
    """grit ARGUMENTS, which writes into out; what is said of the input stands in files, of which those of an older run differ."""

    def __init__(self, name, place, arguments, new, old, ends_early=None):
        self.name, self.place, self.arguments, self.new, self.old = name, place / name, arguments, new, old
        self.ends_early = ends_early  # may this file stay of a run that was stopped by its disk?
        self.out = self.place / "out"
        self.place.mkdir()

    def run(self, program, files, *more, environment=None):
        for name, text in files.items():
            (self.place / name).write_text(text)
        return subprocess.run([program, *self.arguments, *more], cwd=self.place, env=environment, capture_output=True,
                              text=True, timeout=300)

    def clear(self):
        shutil.rmtree(self.out, ignore_errors=True)


class Titled(Command):
    """One whose results differ by the title alone that it is given."""

    def run(self, program, title, *more, environment=None):
        return super().run(program, {}, title, *more, environment=environment)


class Trials:
    def __init__(self, build, folder, complain):
        self.program = build / "cli/grit"
        self.preloaded = next(build.glob("verification/robustness/libfailing_calls.so"))
        self.complain = complain
        self.count, self.log = folder / "calls", folder / "log"

    def environment(self, command, call=0, error=0, forever=False):
        self.count.write_bytes(struct.pack("Q", 0))
        self.log.write_bytes(b"")
        return {**os.environ, "LD_PRELOAD": str(self.preloaded), "FAILING_BELOW": os.path.realpath(command.out),
                "FAILING_COUNT": str(self.count), "FAILING_LOG": str(self.log), "FAILING_CALL": str(call),
                "FAILING_ERROR": str(error), "FAILING_FOREVER": str(int(forever))}

    def whole(self, command, files, **more):
        command.clear()
        done = command.run(self.program, files, **more)
        if done.returncode != 0:
            raise SystemExit(f"{command.name}: {done.stderr}")
        return files_of(command.out)

    def try_all(self, command, most, draw):
        """Of so many calls, drawn; -1: of each."""
        old = self.whole(command, command.old)
        whole = self.whole(command, command.new, environment=self.environment(command))
        calls, = struct.unpack("Q", self.count.read_bytes())
        if old == whole or not set(old) <= set(whole):
            raise SystemExit(f"{command.name}: the older result is not another one of the same files")
        runs = failed = 0
        for name, forever in DISKS:
            for older in [{}, old]:
                chosen = range(1, calls + 1)
                if 0 < most < calls:
                    chosen = sorted(draw.sample(chosen, most))
                for call in chosen:
                    runs += 1
                    failed += self.try_one(command, whole, older, call, name, forever)
        print(f"{command.name}: {calls} calls that change files, {runs} runs, {failed} ended with an error", flush=True)

    def try_one(self, command, whole, older, call, error, forever):
        command.clear()
        if older:
            self.whole(command, command.old)
        done = command.run(self.program, command.new,
                           environment=self.environment(command, call, getattr(errno, error), forever))
        log = self.log.read_text().splitlines()
        where = log[call - 1].replace(str(command.out) + "/", "") if call <= len(log) else f"{call}"
        what = f"{command.name}, {error} {'from' if forever else 'at'} {where}{', over an older result' if older else ''}: "
        files = files_of(command.out)
        for name in files:
            if name.endswith(".part") or name == ".grit-lock":
                # What cannot be removed stays; calls that remove are not among those that fail.
                self.complain(f"{what}{name} is left")
        if done.returncode == 0:
            if files != whole:
                self.complain(f"{what}status 0, but {self.differing(files, whole)}; {done.stderr}")
            return 0
        if done.returncode != 1:
            self.complain(f"{what}status {done.returncode}; {done.stderr}")
        if not re.search("cannot|could not|no picture", done.stderr):
            self.complain(f"{what}nothing said of it: {done.stderr}")
        for name, content in files.items():
            if content in (whole.get(name), older.get(name)):
                continue
            if not (command.ends_early and command.ends_early(self, command, name, content, whole)):
                self.complain(f"{what}{name} is neither this result nor the older one ({len(content)} bytes); {done.stderr}")
        self.look_at_frames(what, files, whole, older)
        return 1

    @staticmethod
    def differing(files, whole):
        return ", ".join(name for name in sorted({*files, *whole}) if files.get(name) != whole.get(name)) + " differ"

    def look_at_frames(self, what, files, whole, older):
        """A list of frames names files of its own run only."""
        for name, content in files.items():
            if not name.endswith(".pvd"):
                continue
            of = older if content == older.get(name) else whole
            for frame in re.findall(r'file="([^"]*)"', content.decode()):
                if frame not in files or files[frame] != of.get(frame):
                    self.complain(f"{what}{name} names {frame}, which is not of its run")


def is_whole_svg(content):
    try:
        xml.etree.ElementTree.fromstring(content)
    except xml.etree.ElementTree.ParseError:
        return False
    return content.rstrip().endswith(b"</svg>")


def is_whole_png(content):
    """Chunks with their checksums one after the other, the last one says that it is."""
    at, last, lines = 8, None, b""
    while at + 12 <= len(content):
        length, = struct.unpack_from(">I", content, at)
        last, data = content[at + 4 : at + 8], content[at + 8 : at + 8 + length]
        if content[at + 8 + length : at + 12 + length] != struct.pack(">I", zlib.crc32(last + data)):
            return False
        if last == b"IDAT":
            lines += data
        at += 12 + length
    # The checksum of what is packed stands at its end.
    unpacked = zlib.decompressobj()
    try:
        unpacked.decompress(lines)
    except zlib.error:
        return False
    return content.startswith(b"\x89PNG\r\n\x1a\n") and last == b"IEND" and at == len(content) and unpacked.eof


def of_a_stopped_run(trials, command, name, content, whole):
    """The history so far, the frames so far, and a checkpoint from which it goes on to the whole result."""
    if name.endswith(".csv.incomplete"):
        rows = rows_of(content)
        return content.endswith(b"\n") and rows == rows_of(whole[name.removesuffix(".incomplete")])[: len(rows)]
    if name.endswith(".csv"):
        rows = rows_of(content)
        return b"# STOPPED EARLY" in content and rows == rows_of(whole[name])[: len(rows)]
    if name.endswith(".pvd"):
        return content.decode().rstrip().endswith("</VTKFile>")
    # Pictures of that history.
    if name.endswith(".svg"):
        return is_whole_svg(content)
    if name.endswith(".png"):
        return is_whole_png(content)
    if name.endswith(".checkpoint"):
        kept = command.place / "kept"
        shutil.rmtree(kept, ignore_errors=True)
        shutil.copytree(command.out, kept)
        done = command.run(trials.program, command.new, "--restart")
        good = done.returncode == 0 and files_of(command.out) == whole
        shutil.rmtree(command.out)
        kept.rename(command.out)
        return good
    return False


ELEMENT = """[sand]
name = "lausitz"
[start]
pressure_kPa = 100
void_ratio = VOIDS
[[stage]]
test = "triaxial_undrained"
axial_strain_amplitude = -1e-4
cycles = 2
record_every = 1
[reference]
origin = "self"
[[reference.value]]
quantity = "void_ratio"
value = VOIDS
tolerance = 1.0
"""
BLOCK = """title = "A block that flies, TITLE"
gravity_m_per_s2 = 0.0
[grid]
geometry = "plane_strain"
[[grid.r]]
to_m = 4
cells = 4
[[grid.z]]
to_m = 4
cells = 4
[[body]]
name = "block"
density_kg_per_m3 = 2000
velocity_m_per_s = [0, SPEED]
[[body.box]]
r_m = [1, 3]
z_m = [1, 3]
[body.elastic]
youngs_modulus_kPa = 20
poissons_ratio = 0.3
[[stage]]
name = "flight"
[stage.until]
time_s = 0.5
[fields]
variables = ["velocity", "p"]
interval_s = FRAMES
"""
FIT = """title = "TITLE"
[sand]
name = "karlsruhe-fine"
[fit]
parameters = ["h_s"]
[[test]]
name = "oedometer"
test = "oedometer"
file = "oedometer.csv"
[test.columns]
stress_11 = { column = "s_kPa", compression = "positive" }
void_ratio = { column = "e", error = 0.002 }
"""


def inputs(name, text, **words):
    """Of the new run and of an older one: each word has one for either."""
    both = []
    for i in range(2):
        one = text
        for word, values in words.items():
            one = one.replace(word, values[i])
        both.append({name: one})
    return both


def commands(place, program):
    """Short runs of all commands that write files."""
    case = inputs("x.toml", ELEMENT, VOIDS=("0.6", "0.61"))
    yield Command("element", place, ["element", "--quiet", "--no-plot", "--out", "out", "x.toml"], *case)
    yield Command("element with pictures", place, ["element", "--out", "out", "x.toml"], *case)
    block = inputs("x.toml", BLOCK, TITLE=("newly", "of old"), SPEED=("-1.0", "1.0"), FRAMES=("0.1", "0.26"))
    mpm = ["mpm", "--quiet", "--checkpoint-minutes", "1e-9", "--out", "out", "x.toml"]
    yield Command("mpm", place, [*mpm, "--no-plot"], *block, of_a_stopped_run)
    yield Command("mpm with pictures", place, ["mpm", "--out", "out", "x.toml"], *block, of_a_stopped_run)
    yield Command("mpm to LAMMPS", place, ["mpm", "--to-lammps", "out", "x.toml"], *block)
    fit = inputs("x.toml", FIT, TITLE=("newly", "of old"))
    for each, words in zip(fit, ["0.85\n50,0.84\n100,0.83\n200,0.82\n400,0.80\n", "0.86\n50,0.84\n100,0.83\n200,0.82\n400,0.81\n"]):
        each["oedometer.csv"] = "s_kPa,e\n10," + words
    yield Command("calibrate", place, ["calibrate", "--threads", "1", "--out", "out", "x.toml"], *fit)
    results = place / "results"
    results.mkdir()
    (results / "x.toml").write_text(case[0]["x.toml"])
    subprocess.run([program, "element", "--quiet", "--no-plot", "--out", ".", "x.toml"], cwd=results, check=True,
                   stdout=subprocess.DEVNULL)
    for name, arguments in {"report": ["report", results, "--out", "out/index.html", "--title"],
                            "plot": ["plot", results / "x.csv", "--kind", "triaxial_undrained", "--pdf", "--out", "out/x", "--title"]}.items():
        yield Titled(name, place, arguments, "newly", "of old")


def try_all(build, folder, most, draw, complain):
    folder.mkdir()
    trials = Trials(build, folder, complain)
    for command in commands(folder, trials.program):
        trials.try_all(command, most, draw)
