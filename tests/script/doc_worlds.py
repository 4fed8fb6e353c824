# SPDX-License-Identifier: BSD-3-Clause
"""What is around the blocks of README and docs where doc_commands.py does them. A block is found by its language and first words."""

from typing import NamedTuple

# Commands that a test must not or cannot take the time for, and why. Their programs, options and files are looked up.
NOT_RUN = [
    (r"script/(run|test|benchmark|fuzz|faults|mutants|coverage|package|try_packages|try_pages)\b|cmake --(preset|build --preset) |ctest --preset tsan|"
     r".*build/tsan/|cmake -S \. -B \S+ -G Ninja |cmake --build build(/install)? --target ", "builds all, for minutes"),
    (r"apt-get install ", "as root; script/try_pages does it, on a system that has only its base"),
    (r"python3 -m venv |venv/bin/pip ", "builds a wheel; Python.InstallsWithPip does it, script/try_packages from the package"),
    (r"script/calculix ", "builds CalculiX, and decks take minutes; script/test --all does it"),
    (r"\S*grit calibrate verification/calibration/karlsruhe.toml ", "three minutes; tests of calibration run it without samples"),
    (r"build/\w+/verification/paths/path_errors", "two minutes; tests Paths.* hold what it finds"),
    (r"build/\w+/verification/saturated/", "minutes"),
    (r"build/\w+/verification/robustness/torture ", "hours; tests Torture.* run fewer trials"),
    (r"build/\w+/verification/calibration/calibration_synthetic ", "a quarter of an hour"),
    (r"verification/(pile|push|saturated|footing|lammps|benchmarks)/\S+ |verification/pile/run$|verification/saturated/pile_figures.py|"
     r"verification/space/(quarter|phases|plates|py_curves|uplift).py |xvfb-run -a verification/|for [acn] in .* (verification/space/(shifted_pile.py|stub_plane|picture.py|phases.py)|results/geo_)|gnuplot -c verification/|cp results/benchmark/", "a campaign of minutes or hours, or what is made of its results"),
    (r"grit mpm verification/space/ten_million.toml ", "ten million particles"),
]

# What must have been done before.
BEFORE = {
    ("element-tests", "build/run/cli/grit plot"): "grit element verification/cases/karlsruhe_drained_triaxial.toml --no-plot --quiet --out results",
    ("fortran", "dir=$(pkg-config"): "cp examples/triaxial.f90 host.f90",
    ("python", "python3 -m venv --system"): "mkdir -p venv/bin && ln -s $(command -v python3) venv/bin/python",
}
# And afterwards.
AFTER = {("fortran", "dir=$(pkg-config"): "LD_LIBRARY_PATH=$GRIT_LIBS ./host"}

# Blocks `text` that no command stands before: the command that prints them.
PRINTED_BY = {
    ("README", "lausitz_dense "): "grit element verification/cases/lausitz_dense.toml --no-plot --out results | grep -E 'lausitz_dense +(stress|void|whole)'",
    ("README", "karlsruhe_drained"): "grit element verification/cases/karlsruhe_drained_triaxial.toml --no-plot --out results | grep 'mean ratio of 25'",
    ("calibration", "test_id,"): "sed '/^#/d; 9q' verification/data/kfs_oedometer.csv | head -n 3",
    ("element-tests", "grit: tests/cli"): "grit element tests/cli/malformed/MisspeltKey.toml 2>&1 || true",
}
# Numbers that another machine may compute with other roundoff, or another way to the same minimum: how far they may be off.
SHARE = {"accuracy": 1.0, "calibration": 0.01}


class World(NamedTuple):
    """The fragment in place of {} in `around`, as a file of its language, and `shell` in the folder of that file, which is `fragment`."""
    around: str = "{}"
    shell: str = ""
    numbers_of: str = ""  # a command: the fragment has the numbers that it prints, in this order
    needs: str = ""


SHELL = {"python": "python3 fragment", "c": "cc -x c fragment -x none $(pkg-config --cflags --libs grit) -Wl,-rpath,$GRIT_LIBS -o host && ./host"}

PYTHON = """import numpy as np
n = 3
rng = np.random.default_rng(1)
strain_increment = -1e-5 * np.abs(rng.random((n, 6)))
mass_a = mass_b = np.ones(n); normal = np.tile([0.0, 0, 1], (n, 1)); s = np.zeros(n); d = np.ones(n)
velocity_a = np.tile([0.0, 0, 1], (n, 1)); velocity_b = np.zeros((n, 3))
path = [strain_increment, -strain_increment]
"""
FORTRAN = """program around
{}
contains
    subroutine prepare()
        type(grit_sand_parameters) :: p
        status = grit_sand_parameters_init(p)
        status = grit_sand_record_parameters(grit_sand_record_find('lausitz'), 1d0, p)
        status = grit_sand_prepare(p, sand, error)
    end subroutine
end program
"""
FORTRAN_PROJECT = """cmake_minimum_required(VERSION 3.25)
project(host LANGUAGES Fortran)
find_package(Grit REQUIRED COMPONENTS fortran)
add_executable(host host.f90)
target_link_libraries(host PRIVATE Grit::fortran)
"""
BUILD_AND_RUN = "cmake -S . -B build >cmake.txt && cmake --build build >>cmake.txt && build/host"
# As MGIS reads a behaviour: by the name of a function in a library.
MGIS = """#include <dlfcn.h>
#include <stdexcept>
#include <string>
enum class Hypothesis { AXISYMMETRICAL };
namespace mgis::behaviour {
void load(const std::string& library, const std::string& behaviour, Hypothesis) {
    void* file = dlopen(library.c_str(), RTLD_NOW);
    if (!file || !dlsym(file, (behaviour + "_Axisymmetrical").c_str())) throw std::runtime_error(dlerror());
}
}
int main() {
{}
}
"""
PROJECT_FILE = """python3 - <<'E'
import ctypes, os, xml.etree.ElementTree as tree
relation = tree.fromstring(open("fragment").read().replace("...", ""))
library, behaviour = (relation.find(word).text for word in ("library", "behaviour"))
library = ctypes.CDLL(f"{os.environ['GRIT_LIBS']}/{library}.so")
for kind, nodes in (("MaterialProperties", "*/material_property"), ("InternalStateVariables", "*/state_variable")):
    n = ctypes.c_ushort.in_dll(library, f"{behaviour}_n{kind}").value
    names = {name.decode() for name in (ctypes.c_char_p * n).in_dll(library, f"{behaviour}_{kind}")}
    assert relation.findall(nodes) and {node.get("name") for node in relation.findall(nodes)} <= names, kind
E"""
FALLING = "grit mpm tests/script/falling.toml --to-lammps . >told.txt && "
CLASSIC = "grit sand show lausitz --void-ratio 0.6 --props classic"

WORLDS = {
    ("python", "import numpy as np, grit"): World(PYTHON + "{}", needs="python"),
    ("python", "names = [\"phi_c\""): World(
        PYTHON + "import grit\nsand = grit.Sand('lausitz')\nstress = np.tile([-100., -50, -50, 0, 0, 0], (n, 1))\n"
        "state = np.tile(sand.state(void_ratio=0.6), (n, 1))\n{}", needs="python"),
    ("python", "usub_lib_dir"): World("import os\n{}\nroot = '/usr/lib/x86_64-linux-gnu'\nassert usub_lib_dir.startswith(root)\n"
                                      "assert os.path.exists(os.environ['GRIT_LIBS'] + usub_lib_dir.removeprefix(root) + '/libstandardU.so')\n"),
    ("toml", "[sand]\nname = \"karlsruhe-fine\""): World(shell="cp fragment case/case.toml && grit calibrate case/case.toml --samples 0 --out results",
                                                         needs="calibration"),
    ("toml", "[sand]\nname = \"lausitz\""): World(shell="cp fragment case.toml && grit element case.toml --no-plot --out results"),
    ("cmake", "project(host LANGUAGES Fortran)"): World(
        "cmake_minimum_required(VERSION 3.25)\n{}", "cp fragment CMakeLists.txt && cp examples/triaxial.f90 host.f90 && " + BUILD_AND_RUN, needs="fortran"),
    ("fortran", "use grit"): World(FORTRAN, f"cp fragment host.f90 && cat >CMakeLists.txt <<'E'\n{FORTRAN_PROJECT}E\n" + BUILD_AND_RUN, needs="fortran"),
    ("story", "== "): World(shell="for e in dense loose; do grit element verification/cases/lausitz_$e.toml --no-plot --quiet --out results; done\n"
                                  "grit report results --story fragment && grep -q 'One sand, dense and loose' results/index.html"),
    ("deck", "*MATERIAL, NAME=LAUSITZ"): World(numbers_of=CLASSIC),
    ("deck", "*MATERIAL, NAME=@ABAQUS_GRITUMAT_SAND"): World(numbers_of="grit sand show lausitz --void-ratio 0.6 --props calculix | tail -n +2"),
    ("deck", "*MATERIAL, NAME=@ABAQUS_GRITUMAT\n"): World(  # one that a test gives to CalculiX
        shell="python3 -c 'assert open(\"fragment\").read() in open(\"verification/calculix/oedometer.inp\").read()'", numbers_of=CLASSIC),
    ("tcl", "nDMaterial UMAT"): World(numbers_of="grit sand show hochstetten --props classic 2>told.txt | sed '$s/ 0$/ 0.7/'"),
    ("cpp", "mgis::behaviour::load"): World(MGIS, "c++ -std=c++17 -x c++ fragment -o host && LD_LIBRARY_PATH=$GRIT_LIBS ./host", needs="mgis"),
    ("xml", "<constitutive_relation>"): World(shell=PROJECT_FILE, needs="mgis"),
    ("lammps", "python grit_add"): World(
        shell=FALLING + "sed \"s#/PLACE/#$BUILD/adapters/lammps/#\" fragment | cat - falling.in >stock.in && lmp -in stock.in -log none", needs="lmp"),
    ("lammps", "units si"): World(
        shell=FALLING + "mv falling.data case.data && grep -qF \"$(sed -n '/^fix/s/ \\.\\.\\.$//p' fragment)\" falling.fix && sed '/^fix/d' fragment >own.in && "
                        "echo -e 'include falling.fix\\nrun 20' >>own.in && grit-lmp -in own.in -log none", needs="lammps"),
    ("lammps", "fix_modify mpm"): World(
        shell=FALLING + "sed '/^fix_modify/,$d' falling.in | cat - fragment >own.in && grit-lmp -in own.in -log none", needs="lammps"),
    ("lammps", "thermo_style"): World(
        shell=FALLING + "sed '/^run/,$d' falling.in | cat - fragment >own.in && echo run 1000 >>own.in && grit-lmp -in own.in -log none && "
                        "grep -q 'ITEM: ATOMS id type x y vx vy' out.dump", needs="lammps"),
    ("lammps", "restart 10000"): World(
        shell=FALLING + "sed 's/10000/20/; s/NAME/falling/' fragment >parts && (sed '/^run/,$d' falling.in; head -n 1 parts; echo run 30) >first.in && "
                        "tail -n +2 parts >second.in && for part in first second; do grit-lmp -in $part.in -log none; done", needs="lammps"),
    ("c", "grit_contact_options options;"): World("""#include <grit/grit.h>
int main(void) {
enum { n = 2 };
grit_error error = {0};
grit_status status;
double mass_a[n] = {1, 1}, mass_b[n] = {1, 1}, normal[2 * n] = {0, -1, 0, -1}, distance[n] = {0}, gap[n] = {0};
double spacing[2] = {1, 1}, velocity_a[2 * n] = {0, -1}, velocity_b[2 * n] = {0};
grit_contact_report reports[n];
static grit_contact_sums sums;
{}
return status;
}
"""),
    ("c", "int parameters[15];"): World("""#include <grit/grit.h>
int main(void) {
enum { n = 1 };
grit_error error = {0};
grit_status status;
double strain_increment[6] = {-1e-3}, stress[6] = {-100, -100, -100}, state[GRIT_SAND_STATE_SIZE] = {0, 0, 0, 0, 0, 0, 0.55};
grit_sand_parameters p;
grit_sand_parameters_init(&p, sizeof p);
grit_sand_record_parameters(grit_sand_record_find("lausitz"), 1.0, &p);
grit_sand sand;
grit_sand_prepare(&p, &sand, &error);
grit_sand_options options;
grit_sand_options_init(&options, sizeof options);
grit_sand_points points = {0};
points.struct_size = sizeof points;
points.strain_increment = grit_view_of(strain_increment, 6, 1);
points.stress = grit_mutable_view_of(stress, 6, 1);
points.state = grit_mutable_view_of(state, GRIT_SAND_STATE_SIZE, 1);
grit_sand_report reports[n];
{}
return status;
}
"""),
    ("c", "grit_sand_parameters parameters;"): World("""#include <grit/grit.h>
int main(void) {
grit_error error = {0};
double strain_increment[6] = {-1e-3}, stress[6] = {-100, -100, -100}, state[GRIT_SAND_STATE_SIZE] = {0, 0, 0, 0, 0, 0, 0.55}, tangent[36];
grit_sand_options options;
grit_sand_options_init(&options, sizeof options);
grit_sand_report report;
{}
return report.status;
}
"""),
}
