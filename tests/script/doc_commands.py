# SPDX-License-Identifier: BSD-3-Clause
"""doc_commands.py GRIT SOURCE WORK BUILD [--write]: what the blocks of README and docs say is done, page by page, each in a
folder that looks like the source tree.

On the pages of docs/start and docs/how every block counts: files, whose first line is a comment with their name, are written;
commands are run; a block `text` is what the commands before it print (`...` for lines left out). BUILD is installed for
them where the page needs it. Elsewhere commands of the program grit are run, and fragments of programs in WORLDS, in the
program around them that stands there. What takes minutes, or a program that is not here, is told, not run.
--write puts what was printed into the blocks `text`."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

sys.dont_write_bytecode = True
from page_blocks import FENCE, as_promised, lines_of, name_of_file, near  # noqa: E402

grit, source, work, build = pathlib.Path(sys.argv[1]), *map(pathlib.Path, sys.argv[2:5])
write = "--write" in sys.argv
shutil.rmtree(work, ignore_errors=True)
work.mkdir(parents=True)
long = re.compile(r"^\S*grit (mpm|calibrate) ")
done, left, took = {}, [], []


def count(kind, n=1):
    done[kind] = done.get(kind, 0) + n


def installed():
    """The parts of BUILD that pages link to, once."""
    prefix = work / "prefix"
    if not (work / "bin").exists():
        (work / "bin").mkdir()
        os.symlink(sys.executable, work / "bin/python3")
    if not prefix.exists():
        for part in ("library", "development", "tools"):
            subprocess.run(["cmake", "--install", build, "--prefix", prefix, "--component", part], check=True, capture_output=True)
    return prefix


def environment():
    prefix = installed()
    lib = next(prefix.glob("lib*/**/pkgconfig")).parent
    return dict(os.environ, PATH=f"{work}/bin:{prefix}/bin:{build}/adapters/lammps:{os.environ['PATH']}", PKG_CONFIG_PATH=f"{lib}/pkgconfig",
                CMAKE_PREFIX_PATH=str(prefix), GRIT_LIBS=str(lib), GRIT_ABAQUS=str(lib / "grit/abaqus"), PYTHONPATH=str(build / "adapters/python"),
                PYTHONDONTWRITEBYTECODE="1", OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                OMPI_MCA_btl_vader_single_copy_mechanism="none")


# Commands that a page for people has and a test has not: why.
elsewhere = [
    (re.compile(r"^apt-get install "), lambda: "script/try_pages does it, on a system that has only its base"),
    (re.compile(r"^(python3 -m venv|venv/bin/pip) "), lambda: "Python.InstallsWithPip tests it"),
    (re.compile(r"^(cmake --preset|cmake --build --preset|script/) ?"), lambda: "builds all"),
    (re.compile(r".*ccx-external"), lambda: None if pathlib.Path("~/.cache/grit/ccx-external").expanduser().exists()
     else "no CalculiX with external materials: script/calculix builds it"),
    (re.compile(r"^mpirun .*grit-lmp"), lambda: None if (build / "adapters/lammps/grit-lmp").exists() and shutil.which("mpirun")
     else "no grit-lmp"),
    (re.compile(r"^\S*grit calibrate "), lambda: None if b"calibrate" in subprocess.run([grit, "--help"], capture_output=True).stdout
     else "without calibration"),
    (re.compile(r"^(cc|c\+\+|python3|pkg-config|cmake) "), lambda: None),
]
needs = {"fortran": lambda: shutil.which("gfortran"), "python": lambda: list((build / "adapters/python").glob("grit/*.so"))}


def place_of(page):
    place = work / page.relative_to(source).with_suffix("")
    place.mkdir(parents=True)
    for folder in ("verification", "examples", "docs", "adapters", "tests", "README.md"):
        os.symlink(source / folder, place / folder)
    return place


def run(page, place, script, env=None):
    bash = subprocess.run(["bash", "-euo", "pipefail", "-c", script], cwd=place, env=env, capture_output=True, text=True)
    if bash.returncode:
        sys.exit(f"{page}: {script}\nended with {bash.returncode}:\n{bash.stdout}{bash.stderr}")
    return bash.stdout


def walk(page):
    """Every block of a page."""
    place, env, printed, lacking = place_of(page), environment(), None, []
    text = page.read_text()
    for match in list(FENCE.finditer(text)):
        language, block = match.groups()
        if language == "text":
            if printed is None:
                left.append(f"{page.stem}: what that would print")
            elif write:
                text = text.replace(match[0], match[0] if block.strip() else f"```text\n{printed.rstrip()}\n```", 1)
            else:
                as_promised(page, block, printed)
                count("outputs")
        elif language:
            name = name_of_file(page, language, block)
            (place / name).write_text(block)
            count("files")
            if language in needs and not needs[language]():
                lacking += [name, "cmake", "build/"]
        else:
            lines, printed, skipped = [], None, None
            for line in lines_of(block):
                reason = next((why() for words, why in elsewhere if words.match(line)), None)
                if not reason and any(word in line for word in lacking):
                    reason = "nothing here that compiles or runs it"
                if not reason and skipped:
                    reason = "after that one"
                skipped = skipped or reason
                if reason:
                    left.append(f"{page.stem}: {line.strip()} ({reason})")
                else:
                    lines.append(line)
            if lines:
                out = run(page, place, "\n".join(lines), env)
                printed = None if len(lines) < len(lines_of(block)) else out
                count("commands", len(lines))
    if write:
        page.write_text(text)


# Fragments of programs: what is around them. {} is the fragment.
PYTHON = """import numpy as np
n = 3
rng = np.random.default_rng(1)
strain_increment = -1e-5 * np.abs(rng.random((n, 6)))
mass_a = mass_b = np.ones(n); normal = np.tile([0.0, 0, 1], (n, 1)); s = np.zeros(n); d = np.ones(n)
velocity_a = np.tile([0.0, 0, 1], (n, 1)); velocity_b = np.zeros((n, 3))
path = [strain_increment, -strain_increment]
"""
WORLDS = {
    ("python", "import numpy as np, grit"): PYTHON + "{}",
    ("python", "names = [\"phi_c\""): PYTHON + "import grit\nsand = grit.Sand('lausitz')\nstress = np.tile([-100., -50, -50, 0, 0, 0], (n, 1))\n"
    "state = np.tile(sand.state(void_ratio=0.6), (n, 1))\n{}",
    ("toml", "[sand]\nname = \"karlsruhe-fine\""): "{} calibrate case/case.toml --samples 0 --out results",
    ("toml", "[sand]\nname = \"lausitz\""): "{} element case/case.toml --no-plot --out results",
    ("cmake", "project(host LANGUAGES Fortran)"): "{}",
    ("", "dir=$(pkg-config --variable=fortrandir grit)"): "LD_LIBRARY_PATH=$GRIT_LIBS ./host",
    ("fortran", "use grit"): "program around\n{}\nend program\n",
    ("c", "grit_contact_options options;"): "#include <grit/grit.h>\nint main(void) {{ grit_error error = {{0}}; grit_status status; enum {{ n = 2 }};"
    "double mass_a[n] = {{1, 1}}, mass_b[n] = {{1, 1}}, normal[2 * n] = {{0, -1, 0, -1}}, distance[n] = {{0}}, gap[n] = {{0}}, spacing[2] = {{1, 1}},"
    "velocity_a[2 * n] = {{0, -1}}, velocity_b[2 * n] = {{0}}; grit_contact_report reports[n]; static grit_contact_sums sums;\n{}\nreturn status; }}\n",
    ("c", "int parameters[15];"): "#include <grit/grit.h>\nint main(void) {{ grit_error error = {{0}}; grit_status status; enum {{ n = 1 }};"
    "double strain_increment[6] = {{-1e-3}}, stress[6] = {{-100, -100, -100}}, state[GRIT_SAND_STATE_SIZE] = {{0, 0, 0, 0, 0, 0, 0.55}};"
    "grit_sand_parameters p; grit_sand_parameters_init(&p, sizeof p); grit_sand_record_parameters(grit_sand_record_find(\"lausitz\"), 1.0, &p);"
    "grit_sand sand; grit_sand_prepare(&p, &sand, &error); grit_sand_options options; grit_sand_options_init(&options, sizeof options);"
    "grit_sand_points points = {{0}}; points.struct_size = sizeof points; points.strain_increment = grit_view_of(strain_increment, 6, 1);"
    "points.stress = grit_mutable_view_of(stress, 6, 1); points.state = grit_mutable_view_of(state, GRIT_SAND_STATE_SIZE, 1);"
    "grit_sand_report reports[n];\n{}\nreturn status; }}\n",
    ("c", "grit_sand_parameters parameters;"): "#include <grit/grit.h>\nint main(void) {{ grit_error error = {{0}}; double strain_increment[6] = {{-1e-3}},"
    "stress[6] = {{-100, -100, -100}}, state[GRIT_SAND_STATE_SIZE] = {{0, 0, 0, 0, 0, 0, 0.55}}, tangent[36]; grit_sand_options options;"
    "grit_sand_options_init(&options, sizeof options); grit_sand_report report;\n{}\nreturn report.status; }}\n",
}


def fragment(page, place, language, block):
    world = next((world for (of, start), world in WORLDS.items() if of == language and block.startswith(start)), None)
    if world is None:
        left.append(f"{page.stem}: a fragment of {language}: {block.splitlines()[0]}")
        return
    if (page.stem if page.stem in needs else language) in needs and not needs[page.stem if page.stem in needs else language]():
        left.append(f"{page.stem}: nothing here that compiles or runs {block.splitlines()[0]}")
        return
    if language == "toml" and (why := next((why() for words, why in elsewhere if words.match(world.format("grit"))), None)):
        left.append(f"{page.stem}: {block.splitlines()[0]} ({why})")
        return
    env = environment()
    if language == "python":
        (place / "fragment.py").write_text(world.replace("{}", block))
        run(page, place, "python3 fragment.py", env)
    elif language == "c":
        (place / "fragment.c").write_text(world.format(block))
        run(page, place, "cc fragment.c $(pkg-config --cflags --libs grit) -Wl,-rpath,$GRIT_LIBS -o fragment && ./fragment", env)
    elif language == "toml":  # a whole case, beside data as in verification/calibration
        (place / "case").mkdir(exist_ok=True)
        (place / "case/case.toml").write_text(block)
        if not (place / "data").exists():
            os.symlink(source / "verification/data", place / "data")
        run(page, place, world.format(grit))
    elif language == "cmake":
        (place / "cmake").mkdir()
        shutil.copy(source / "examples/triaxial.f90", place / "cmake/host.f90")
        (place / "cmake/CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.25)\n" + world.format(block))
        run(page, place, "cd cmake && cmake -S . -B build && cmake --build build && build/host", env)
    elif not language:
        shutil.copy(source / "examples/triaxial.f90", place / "host.f90")
        run(page, place, block + world, env)
    else:
        declared = re.sub(r"\bn\b", "3", block.replace("...", "strain_increment = 0; stress = 0; stress(1:3, :) = -1d2; state = 0; state(7, :) = 0.6d0; "
                                                       "call prepare()")).replace("use grit\n", "use grit\nimplicit none\ntype(grit_error) :: error\ninteger(c_int) :: status\n", 1)
        (place / "fragment.f90").write_text(
            world.format(declared).replace("end program", "contains\nsubroutine prepare()\ntype(grit_sand_parameters) :: p\n"
                                           "status = grit_sand_parameters_init(p)\nstatus = grit_sand_record_parameters(grit_sand_record_find('lausitz'), 1d0, p)\n"
                                           "status = grit_sand_prepare(p, sand, error)\nend subroutine\nend program"))
        run(page, place, "cat > CMakeLists.txt <<'E'\ncmake_minimum_required(VERSION 3.25)\nproject(host LANGUAGES Fortran)\n"
            "find_package(Grit REQUIRED COMPONENTS fortran)\nadd_executable(host fragment.f90)\ntarget_link_libraries(host PRIVATE Grit::fortran)\nE\n"
            "cmake -S . -B build && cmake --build build && build/host", env)
    count("fragments")


for page in [source / "README.md", *sorted((source / "docs").glob("*.md"))]:
    place = place_of(page)
    for example, block in re.findall(r"`build/\w+/examples/(\w+)` prints\s*^```\n(.*?)^```$", page.read_text(), flags=re.DOTALL | re.MULTILINE):
        if not (build / "examples" / example).exists():
            left.append(f"{page.stem}: {example}")
            continue
        printed = run(page, place, str(build / "examples" / example))
        if not near(block, printed):
            sys.exit(f"{page}: {example} prints\n{printed}")
        count("examples")
    for language, block in FENCE.findall(page.read_text()):
        if language or any(of == "" and block.startswith(start) for of, start in WORLDS):
            fragment(page, place, language, block)
            continue
        for line in block.replace("\\\n", " ").splitlines():
            if not re.match(r"(build/\w+/cli/)?grit ", line):
                if re.match(r"(script|build|verification|venv)/|(cmake|python3|ctest) ", line):
                    left.append(f"{page.stem}: {line}")
                continue
            if long.match(line):
                left.append(f"{page.stem}: {line}")
                continue
            if page.stem == "element-tests" and " plot " in line:  # of a run that the page does not repeat
                run(page, place, f"{grit} element verification/cases/karlsruhe_drained_triaxial.toml --no-plot --quiet --out results")
            run(page, place, re.sub(r"^\S*grit", str(grit), line))
            count("commands")
libraries = {"abaqus": "grit/abaqus/classic/libstandardU.so", "opensees": "libGRITUMAT.so", "mgis": "libGritMGIS.so"}
for page in sorted((source / "docs/start").glob("*.md")) + sorted((source / "docs/how").glob("*.md")):
    if page.stem == "index":
        continue
    library = libraries.get(page.stem)
    if library and not (pathlib.Path(environment()["GRIT_LIBS"]) / library).exists():
        left.append(f"{page.stem}: the page, for {library} was not built")
        continue
    started = time.monotonic()
    walk(page)
    took.append(f"{page.stem} {time.monotonic() - started:.1f} s")
if not write and (done.get("commands", 0) < 40 or done.get("files", 0) < 12 or done.get("outputs", 0) < 8):
    sys.exit(f"{done} only: are they still written as blocks?")
print(", ".join(f"{n} {kind}" for kind, n in sorted(done.items())) + " executed; pages walked: " + ", ".join(took))
print("left:", *left, sep="\n  ")
