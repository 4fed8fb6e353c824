// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/to_lammps.hpp"

#include <algorithm>
#include <cstdio>
#include <deque>

#include <adapters/mpm/case/build_case.hpp>
#include <adapters/mpm/case/fill.hpp>
#include <adapters/mpm/step/column_names.hpp>
#include <fmt/format.h>

#include "cli/mpm/lammps_script.hpp"
#include "cli/process/outputs.hpp"
#include "element/atomic_file.hpp"

namespace cli {
namespace {

using namespace grit::mpm;
namespace c = column;

// All of them, or none.
class TextFiles {
  public:
    std::FILE* open(const std::filesystem::path& path) { return files.emplace_back(path).stream(); }
    void complete() {
        for (element::AtomicFile& file : files) file.flush();
        for (element::AtomicFile& file : files) file.complete();
    }

  private:
    std::deque<element::AtomicFile> files;
};

// Atoms are numbered from 1, body after body.
int first_atom(Simulation& simulation, std::size_t body) {
    std::ptrdiff_t first = 1;
    for (std::size_t i = 0; i < body; ++i) first += simulation.body(i).particles.size();
    return static_cast<int>(first);
}

void write_data(const Case& plan, Simulation& simulation, std::FILE* file) {
    const std::size_t bodies = simulation.bodies();
    fmt::print(file, "{}\n\n{} atoms\n{} atom types\n\n",
               plan.title.empty() ? plan.name : plan.title, first_atom(simulation, bodies) - 1,
               bodies);
    fmt::print(file,
               "{:.17g} {:.17g} xlo xhi\n{:.17g} {:.17g} ylo yhi\n-0.5 0.5 zlo zhi\n\nMasses\n\n",
               plan.r.from, plan.r.to(), plan.z.from, plan.z.to());
    for (std::size_t i = 0; i < bodies; ++i)
        fmt::print(file, "{} 1 # {}\n", i + 1, plan.bodies[i].name);
    const auto section = [&](const char* name, const auto& line) {
        fmt::print(file, "\n{}\n\n", name);
        for (std::size_t i = 0; i < bodies; ++i) {
            const Particles& particles = simulation.body(i).particles;
            const int first = first_atom(simulation, i);
            for (std::ptrdiff_t p = 0; p < particles.size(); ++p)
                line(first + particles.ids()[p], i + 1, particles, p);
        }
    };
    section("Atoms # atomic", [&](int id, std::size_t type, const Particles& q, std::ptrdiff_t p) {
        fmt::print(file, "{} {} {:.17g} {:.17g} 0\n", id, type, q(c::r, p), q(c::z, p));
    });
    section("Velocities", [&](int id, std::size_t, const Particles& q, std::ptrdiff_t p) {
        fmt::print(file, "{} {:.17g} {:.17g} 0\n", id, q(c::v_r, p), q(c::v_z, p));
    });
}

// What the atoms do not have: all columns from F on.
void write_points(Simulation& simulation, std::size_t body, std::FILE* file) {
    const Body& of = simulation.body(body);
    const std::vector<std::string> names =
        column_names(of.material.get(), of.water ? &*of.water : nullptr);
    std::string line = "id";
    for (std::size_t k = c::F_rr; k < names.size(); ++k) line += " " + names[k];
    fmt::print(file, "{}\n", line);
    const int first = first_atom(simulation, body);
    for (std::ptrdiff_t p = 0; p < of.particles.size(); ++p) {
        line = fmt::format("{}", first + of.particles.ids()[p]);
        for (std::size_t k = c::F_rr; k < names.size(); ++k)
            line += fmt::format(" {:.17g}", of.particles(static_cast<int>(k), p));
        fmt::print(file, "{}\n", line);
    }
}

TractionAtoms traction_atoms(const Case& plan, Simulation& simulation) {
    TractionAtoms out;
    for (const TractionPlan& traction : plan.tractions) {
        const std::size_t body = plan.body(traction.body);
        const int first = first_atom(simulation, body);
        out.push_back(outermost(simulation.body(body).particles, simulation.axis_r(),
                                simulation.axis_z(), traction));
        for (int& id : out.back()) id += first;
        std::sort(out.back().begin(), out.back().end());
    }
    return out;
}

}  // namespace

void write_lammps_files(const Case& plan, const std::filesystem::path& folder) {
    const BuiltCase built = build_case(plan);
    Simulation& simulation = *built.simulation;
    const std::string fix = lammps_fix(plan, plan.name);
    const std::string script = lammps_script(plan, plan.name, traction_atoms(plan, simulation));
    const auto named = [&](const std::string& end) { return folder / (plan.name + end); };
    const auto points = [&](std::size_t i) { return named("_" + plan.bodies[i].name + ".points"); };
    Outputs outputs;
    for (const char* end : {".data", ".fix", ".in"}) outputs.add(named(end), plan.name);
    for (std::size_t i = 0; i < plan.bodies.size(); ++i) outputs.add(points(i), plan.name);
    const auto lock = outputs.lock();
    TextFiles files;
    write_data(plan, simulation, files.open(named(".data")));
    for (std::size_t i = 0; i < plan.bodies.size(); ++i)
        write_points(simulation, i, files.open(points(i)));
    fmt::print(files.open(named(".fix")), "{}", fix);
    fmt::print(files.open(named(".in")), "{}", script);
    files.complete();
}

}  // namespace cli
