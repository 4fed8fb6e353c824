// SPDX-License-Identifier: BSD-3-Clause
#include "cli/guide/doctor.hpp"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <thread>

#include <fmt/format.h>

#include "cli/process/standard_streams.hpp"
#include "cli/process/version.hpp"

namespace cli {
namespace {

// The first line that a command prints; empty where there is no such command.
std::string first_line_of(const char* command) {
    const std::unique_ptr<FILE, int (*)(FILE*)> out(popen(command, "r"), pclose);
    char line[256];
    if (!out || !std::fgets(line, sizeof line, out.get())) return "";
    const std::string text = line;
    return text.substr(0, text.find_last_not_of("\r\n") + 1);
}

struct Neighbour {
    const char* what;
    const char* command;  // prints its version
    const char* without;  // what cannot be done, and what brings it
};

constexpr Neighbour neighbours[] = {
    {"gnuplot", "gnuplot --version 2>/dev/null </dev/null",
     "no pictures, data only: apt-get install gnuplot-nox"},
    {"Python", "python3 --version 2>/dev/null </dev/null",
     "no scripts: apt-get install python3 python3-numpy"},
    {"grit in Python",
     "cd / && python3 -c \"import grit; print(grit.__version__, grit.__commit__, grit.__file__)\" "
     "2>/dev/null </dev/null",
     "import grit fails: install the package python3-grit, or the wheel, see docs/python.md"},
    {"MPI", "mpirun --version 2>/dev/null </dev/null", "one process: apt-get install openmpi-bin"},
    {"LAMMPS", "{ lmp -help </dev/null | grep -m 1 Simulator; } 2>/dev/null",
     "no lmp: apt-get install lammps, see docs/lammps.md"},
    {"grit-lmp", "command -v grit-lmp",
     "LAMMPS has no fix grit/mpm: install the package libgrit-lammps, see docs/lammps.md"},
};

void say_fact(const std::string& what, const std::string& fact) { say("{:<16} {}\n", what, fact); }

// What this program says as docs/....md: beside it where it is installed.
std::string documentation() {
    std::error_code none;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", none);
    for (const char* way : {"../share/doc/grit-doc/docs", "../../../docs"}) {
        const std::filesystem::path place = (program.parent_path() / way).lexically_normal();
        if (std::filesystem::exists(place / "element-tests.md", none)) return place.string();
    }
    return "missing; docs/... of these words: in the package grit-doc, or the source tree";
}

const char* calibration() {
#ifdef GRIT_CLI_HAS_CALIBRATION
    return "yes";
#else
    return "no: this grit was built without Ceres, libzip and pugixml, see docs/calibration.md";
#endif
}

const char* material_points() {
#ifdef GRIT_CLI_HAS_MPM
    return "yes";
#else
    return "no: this grit was built with GRIT_BUILD_ADAPTERS=OFF or GRIT_BUILD_MPM=OFF";
#endif
}

}  // namespace

ExitCode examine() {
    say_fact("program", version_and_instruction_set());
    say_fact("processors", std::to_string(std::thread::hardware_concurrency()));
    say_fact("grit mpm", material_points());
    say_fact("grit calibrate", calibration());
    say_fact("documentation", documentation());
    int missing = 0;
    for (const Neighbour& each : neighbours) {
        const std::string found = first_line_of(each.command);
        missing += found.empty();
        say_fact(each.what, found.empty() ? fmt::format("missing; {}", each.without) : found);
    }
    say("{}\n", missing == 0
                    ? "nothing is missing"
                    : fmt::format("{} of {} neighbours missing; grit itself needs none of them",
                                  missing, std::size(neighbours)));
    return ok;
}

}  // namespace cli
