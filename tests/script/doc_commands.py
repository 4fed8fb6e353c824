# SPDX-License-Identifier: BSD-3-Clause
"""doc_commands.py GRIT SOURCE WORK BUILD [--write] [PAGE...]: what the blocks of README and docs say is done, page by page, each in a
folder that looks like the source tree, with BUILD installed where pages link to it.

Every block has one of these ways (page_blocks.py tells them apart), or the test fails: commands are run, those of `grit mpm` on pages
that are no instructions only begun; files are written; a block `text` is what the commands before it print (`...` for lines left
out), or stands in a test; a fragment is compiled, run or read in the world around it (doc_worlds.py); `usage`, and commands that
take minutes or root (NOT_RUN there), are looked up: programs, options, files. So are commands within sentences; those of `grit` that
only print are run.
--write puts what was printed into empty blocks `text`. PAGE: docs/start/c.md and so on, all without."""

import functools
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

sys.dont_write_bytecode = True
from doc_worlds import AFTER, BEFORE, NOT_RUN, PRINTED_BY, SHARE, SHELL, WORLDS  # noqa: E402
from page_blocks import FENCE, as_promised, blocks_of, lines_of, name_of_file  # noqa: E402

grit, source, work, build = map(pathlib.Path.resolve, map(pathlib.Path, sys.argv[1:5]))
write = "--write" in sys.argv
named = [source / page for page in sys.argv[5:] if page != "--write"]
shutil.rmtree(work, ignore_errors=True)
work.mkdir(parents=True)
done, left, took = {}, [], []
blocks = {"executed": 0, "looked up": 0, "left": 0}


def count(kind, n=1):
    done[kind] = done.get(kind, 0) + n


def finds(table, page, block):
    return next((found for (stem, start), found in table.items() if stem == page.stem and block.startswith(start)), None)


@functools.cache
def environment():
    """The parts of BUILD that pages link to, and programs beside them."""
    prefix, path = work / "prefix", work / "bin"
    path.mkdir()
    os.symlink(sys.executable, path / "python3")
    for part in ("library", "development", "tools"):
        subprocess.run(["cmake", "--install", build, "--prefix", prefix, "--component", part], check=True, capture_output=True)
    lib = next(prefix.glob("lib*/**/pkgconfig")).parent
    return dict(os.environ, PATH=f"{path}:{prefix}/bin:{build}/adapters/lammps:{os.environ['PATH']}", PKG_CONFIG_PATH=f"{lib}/pkgconfig",
                CMAKE_PREFIX_PATH=str(prefix), GRIT_LIBS=str(lib), GRIT_ABAQUS=str(lib / "grit/abaqus"), PYTHONPATH=str(build / "adapters/python"),
                PYTHONDONTWRITEBYTECODE="1", OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                OMPI_MCA_btl_vader_single_copy_mechanism="none", BUILD=str(build))


@functools.cache
def help_of(*command):
    told = subprocess.run([*command, "--help"], capture_output=True, text=True)
    return told.stdout + told.stderr


# What this build or machine may be without.
HAS = {
    "fortran": lambda: shutil.which("gfortran"),
    "python": lambda: list((build / "adapters/python").glob("grit/*.so")),
    "calibration": lambda: "calibrate" in help_of(grit),
    "mgis": lambda: list(pathlib.Path(environment()["GRIT_LIBS"]).glob("libGritMGIS.so")),
    "abaqus": lambda: (pathlib.Path(environment()["GRIT_ABAQUS"]) / "classic/libstandardU.so").exists(),
    "opensees": lambda: (pathlib.Path(environment()["GRIT_LIBS"]) / "libGRITUMAT.so").exists(),
    "lammps": lambda: (build / "adapters/lammps/grit-lmp").exists() and shutil.which("mpirun"),
    "ccx": lambda: pathlib.Path("~/.cache/grit/ccx-external").expanduser().exists(),
    "lmp": lambda: HAS["lammps"]() and shutil.which("lmp"),
}
NEEDS = [(r"mpirun .*grit-lmp", "lammps"), (r"grit calibrate ", "calibration"), (r".*ccx-external", "ccx"), (r"python3 examples/", "python"),
         (r".*libstandardU.so", "abaqus"), (r".*libGRITUMAT.so", "opensees"), (r".*gfortran", "fortran")]


def lacks(line):
    """What the command is not done for here, or None."""
    name = next((name for words, name in NEEDS if re.match(words, line) and not HAS[name]()), None)
    program = re.match(r"build/\w+/((?:cli|examples|verification)/\S+)", line)
    return name and f"no {name} here" or (program and not (build / program[1]).exists() and "not built here") or None


def place_of(page):
    place = work / page.relative_to(source).with_suffix("")
    place.mkdir(parents=True)
    for folder in ("verification", "examples", "docs", "adapters", "tests", "README.md"):
        os.symlink(source / folder, place / folder)
    if not instructs(page):
        (place / "build").mkdir()
        for preset in ("ci", "run", "release"):
            os.symlink(build, place / "build" / preset)
    return place


def instructs(page):
    """Pages for hands on the keyboard: all of them is done, to the end."""
    return page.parent.name in ("start", "how")


BEGUN = """grit() {
    case " $* " in
    *" --keys "* | *" --to-lammps "* | *" --help "*) command grit "$@" ;;
    " mpm "*) timeout -s INT 0.3 grit "$@" --quiet --no-plot || [ $? = 124 ] ;;
    *) command grit "$@" ;;
    esac
}
"""


def run(page, place, script):
    script = re.sub(r"\bbuild/\w+/cli/grit\b", "grit", script)
    script = re.sub(r"^ctest --preset ci (.*)$", rf"ctest --test-dir {build} \1 | sed 's/^[0-9]*: //'", script, flags=re.MULTILINE)
    bash = subprocess.run(["bash", "-euo", "pipefail", "-c", script if instructs(page) else BEGUN + script], cwd=place, env=environment(),
                          capture_output=True, text=True)
    if bash.returncode:
        sys.exit(f"{page}: {script}\nended with {bash.returncode}:\n{bash.stdout}{bash.stderr}")
    return bash.stdout


def options_known(words):
    """Options that the program of these words has, and its files, or what it lacks. None: a program of the system."""
    program = re.sub(r"^build/\w+/", "", words[0])
    if program in ("grit", "cli/grit"):
        if len(words) == 1 or words[1].startswith("-"):
            return help_of(grit)
        if not re.search(rf"^  {words[1]} ", help_of(grit), flags=re.MULTILINE):
            return None
        return help_of(grit, *words[1:3]) if words[1] == "sand" else help_of(grit, words[1])
    if program.startswith(("script/", "verification/")) and (source / program).is_file():
        text = (source / program).read_text()
        if "import argparse" in text:
            return help_of(source / program)
        return text + "".join(file.read_text() for file in (source / program).parent.glob("*.py"))
    if program.endswith("torture"):
        return help_of(build / program) if (build / program).exists() else None
    return ""


def look_up(page, line):
    """Programs, options, definitions and targets of a command that is not run."""
    line = re.sub(r"\s+#.*", "", line)
    for command in re.split(r"\s(?:&&|\|)\s|; ", line):
        words = [word for word in command.replace("[", " ").replace("]", " ").split() if not re.match(r"\w+=", word)]
        words = words[1:] if words[:1] in (["time"], ["do"]) else words
        if not words or not re.match(r"(build/\w+/|script/|verification/|grit$|cmake$)", words[0]):
            continue
        if words[0] == "cmake":
            text = "".join(file.read_text() for file in [*source.glob("cmake/*.cmake"), *source.rglob("CMakeLists.txt")] if "build" not in file.parts)
            names = re.findall(r"-D(GRIT_\w+)", command) + re.findall(r"\w+", (re.findall(r"--target (.*)", command) or [""])[0])
            unknown = [name for name in names if name != "install" and not re.search(rf"\b{name}\b", text)]
        else:
            if (known := options_known(words)) is None:
                sys.exit(f"{page}: {line}\nthere is no {' '.join(words[:2])}")
            unknown = [option for option in re.findall(r"(?<![\w-])--[a-z][\w-]*", command) if option not in known and option != "--help"]
            unknown += [file for file in re.findall(r"(?<!\S)(?:script|verification|tests|examples)/[\w./-]+", command)
                        if not (source / file).exists() and "$" not in file and "results" not in file]
        if unknown:
            sys.exit(f"{page}: {line}\nhas not: {', '.join(unknown)}")


def commands(page, place, block):
    """What they print, None if one of them was left; what became of them."""
    lines, reasons = [], []
    for line in lines_of(block):
        words = line.strip()
        why = next((why for start, why in NOT_RUN if re.match(start, words)), None)
        if why:
            look_up(page, words)
        why = why or lacks(words) or (reasons and instructs(page) and "after that one" or None)
        if why:
            reasons.append(why)
            left.append(f"{page.stem}: {words} ({why})")
        else:
            lines.append(line)
    if not lines:
        return None, "looked up" if any(why for start, why in NOT_RUN if why in reasons) else "left"
    before, after = finds(BEFORE, page, block), finds(AFTER, page, block)
    if before:
        run(page, place, before)
    printed = run(page, place, "\n".join([*lines, *([after] if after else [])]))
    count("commands", len(lines))
    return None if reasons else printed, "executed"


@functools.cache
def told_by_tests():
    """Their text, with what they say in pieces joined."""
    texts = [file.read_text(errors="replace") for file in (source / "tests").rglob("*") if file.suffix in (".cpp", ".hpp", ".py", ".toml", ".cmake")]
    return re.sub(r'"\s*\n\s*f?"', "", "\n".join(texts)).replace('\\"', '"')


def stands_in_a_test(page, block):
    """Each line, from one of its colons on: what stands before is the file and the place."""
    for line in block.splitlines():
        ends = [line, *(line.split(": ", n)[-1] for n in range(1, line.count(": ") + 1))]
        if not any(len(end.split()) >= 5 and end in told_by_tests() for end in ends):
            sys.exit(f"{page}: no command stands before this, PRINTED_BY has none and no test holds it:\n{line}")


def numbers(text):
    found = []
    for word in re.split(r"[\s,=]+", text):
        try:
            found.append(float(word))
        except ValueError:
            pass
    return found


def fragment(page, place, language, block):
    world = next((world for (of, start), world in WORLDS.items() if of == language and block.startswith(start)), None)
    if world is None:
        sys.exit(f"{page}: nothing here does this block of {language or 'commands'}: it has no name of a file, and doc_worlds.py no world for it:\n{block}")
    if world.needs and not HAS[world.needs]():
        left.append(f"{page.stem}: {block.splitlines()[0]} (no {world.needs} here)")
        return "left"
    inside = place / f"fragment{len(list(place.glob('fragment*')))}"
    inside.mkdir()
    for name in ("verification", "examples", "tests"):
        os.symlink(source / name, inside / name)
    (inside / "case").mkdir()  # as verification/calibration lies beside data
    os.symlink(source / "verification/data", inside / "data")
    if language == "fortran":  # what a host declares
        block = re.sub(r"\bn\b", "3", block.replace("...", "strain_increment = 0; stress = 0; stress(1:3, :) = -1d2; state = 0; state(7, :) = 0.6d0; "
                                                    "call prepare()"))
        block = block.replace("use grit\n", "use grit\nimplicit none\ntype(grit_error) :: error\ninteger(c_int) :: status\n", 1)
    (inside / "fragment").write_text(world.around.replace("{}", block))
    if world.numbers_of:
        want, have = numbers(run(page, inside, world.numbers_of)), numbers(block)
        if not want or not any(have[i:i + len(want)] == want for i in range(len(have))):
            sys.exit(f"{page}: this has not the numbers of {world.numbers_of}, {want}:\n{block}")
    if shell := world.shell or SHELL.get(language, ""):
        run(page, inside, shell)
    count("fragments")
    return "executed"


def walk(page):
    """Every block of a page."""
    place, printed, text = place_of(page), "", page.read_text()
    for language, block in blocks_of(page):
        if language == "text":
            command = finds(PRINTED_BY, page, block)
            if command or printed:
                printed = run(page, place, command) if command else printed
                if write and not block.strip():
                    text = text.replace(f"```text\n{block}```", f"```text\n{printed.rstrip()}\n```", 1)
                else:
                    as_promised(page, block, printed, SHARE.get(page.stem, 1e-6))
                count("outputs")
                became = "executed"
            elif printed is None:
                left.append(f"{page.stem}: what that prints: {block.splitlines()[0]}")
                became = "left"
            else:
                stands_in_a_test(page, block)
                count("quotations of tests")
                became = "looked up"
        elif language == "usage":
            for line in lines_of(block):
                look_up(page, line)
            became = "looked up"
        elif not language:
            of_commands, became = commands(page, place, block)
        elif name := name_of_file(block):
            (place / name).write_text(block)
            count("files")
            became = "executed"
        else:
            became = fragment(page, place, language, block)
        printed = "" if language else of_commands
        blocks[became] += 1
    for command in re.findall(r"(?<!`)`((?:build/\w+/cli/grit|grit|script/[\w.]+|verification/\S+) [^`\n]+)`", FENCE.sub("", text)):
        look_up(page, command)
        count("commands within sentences")
        if re.fullmatch(r"grit (sand (list|show [a-z][a-z0-9-]*( --[a-z/. -]+)?)|doctor|man|(mpm|element) --keys( \w+)?)", command):
            run(page, place, command)
    if write:
        page.write_text(text)


for page in named or [source / "README.md", *sorted((source / "docs").rglob("*.md"))]:
    started = time.monotonic()
    walk(page)
    if (seconds := time.monotonic() - started) > 1:
        took.append(f"{page.stem} {seconds:.1f} s")
told = f"{sum(blocks.values())} blocks: " + ", ".join(f"{n} {became}" for became, n in blocks.items())
if not named and (sum(blocks.values()) < 145 or done.get("commands", 0) < 50 or done.get("outputs", 0) < 14 or done.get("fragments", 0) < 12):
    sys.exit(f"{told}; {done} only: are they still written as blocks?")
print(told + "; " + ", ".join(f"{n} {kind}" for kind, n in sorted(done.items())) + "; " + ", ".join(took))
print("not run:", *left, sep="\n  ")
