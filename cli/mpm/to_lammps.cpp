// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/to_lammps.hpp"

#include <algorithm>
#include <cstdio>
#include <deque>

#include <adapters/mpm/case/build_case.hpp>
#include <adapters/mpm/case/closed_surface.hpp>
#include <adapters/mpm/case/fill.hpp>
#include <adapters/mpm/space/case/solids.hpp>
#include <adapters/mpm/step/column_names.hpp>
#include <fmt/format.h>

#include "cli/mpm/lammps_script.hpp"
#include "cli/process/outputs.hpp"
#include "element/atomic_file.hpp"

namespace cli {
namespace {

using namespace grit::mpm;

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
template <class Simulated> int first_atom(Simulated& simulation, std::size_t body) {
    std::ptrdiff_t first = 1;
    for (std::size_t i = 0; i < body; ++i) first += simulation.body(i).particles.size();
    return static_cast<int>(first);
}

// Columns of particles begin with as many coordinates of their places, and velocities.
template <class Simulated> constexpr int dimensions_of = 2;
template <> constexpr int dimensions_of<space::Simulation> = 3;

// From a column on, as many as there are dimensions, and 0 for those that there are not.
template <class Simulated>
std::string numbers(const ParticleColumns& q, std::ptrdiff_t p, int first) {
    std::string out;
    for (int d = 0; d < 3; ++d)
        out += d < dimensions_of<Simulated> ? fmt::format(" {:.17g}", q(first + d, p)) : " 0";
    return out;
}

template <class Simulated>
void write_data(const Case& plan, Simulated& simulation, std::FILE* file) {
    const std::size_t bodies = simulation.bodies();
    fmt::print(file, "{}\n\n{} atoms\n{} atom types\n\n",
               plan.title.empty() ? plan.name : plan.title, first_atom(simulation, bodies) - 1,
               bodies);
    const AxisPlan* axes[] = {&plan.r, &plan.z, nullptr};
    for (std::size_t d = 0; d < 3; ++d) {
        const AxisPlan* axis = plan.space ? &plan.space->axis[d] : axes[d];
        const char name = "xyz"[d];
        if (axis)
            fmt::print(file, "{:.17g} {:.17g} {}lo {}hi\n", axis->from, axis->to(), name, name);
        else fmt::print(file, "-0.5 0.5 zlo zhi\n");
    }
    fmt::print(file, "\nMasses\n\n");
    for (std::size_t i = 0; i < bodies; ++i)
        fmt::print(file, "{} 1 # {}\n", i + 1, plan.bodies[i].name);
    const auto section = [&](const char* name, const auto& line) {
        fmt::print(file, "\n{}\n\n", name);
        for (std::size_t i = 0; i < bodies; ++i) {
            const ParticleColumns& particles = simulation.body(i).particles;
            const int first = first_atom(simulation, i);
            for (std::ptrdiff_t p = 0; p < particles.size(); ++p)
                line(first + particles.ids()[p], i + 1, particles, p);
        }
    };
    section("Atoms # atomic",
            [&](int id, std::size_t type, const ParticleColumns& q, std::ptrdiff_t p) {
                fmt::print(file, "{} {}{}\n", id, type, numbers<Simulated>(q, p, 0));
            });
    section("Velocities", [&](int id, std::size_t, const ParticleColumns& q, std::ptrdiff_t p) {
        fmt::print(file, "{}{}\n", id, numbers<Simulated>(q, p, dimensions_of<Simulated>));
    });
}

std::vector<std::string> names_of(const Body& body) {
    return column_names(body.material.get(), body.water);
}

std::vector<std::string> names_of(const space::Body& body) {
    return space::column_names(body.material.get(), body.water);
}

// What the atoms do not have: all columns from F on.
template <class Simulated>
void write_points(Simulated& simulation, std::size_t body, std::FILE* file) {
    const auto& of = simulation.body(body);
    const std::vector<std::string> names = names_of(of);
    constexpr std::size_t from_F = 2 * dimensions_of<Simulated>;
    std::string line = "id";
    for (std::size_t k = from_F; k < names.size(); ++k) line += " " + names[k];
    fmt::print(file, "{}\n", line);
    const int first = first_atom(simulation, body);
    for (std::ptrdiff_t p = 0; p < of.particles.size(); ++p) {
        line = fmt::format("{}", first + of.particles.ids()[p]);
        for (std::size_t k = from_F; k < names.size(); ++k)
            line += fmt::format(" {:.17g}", of.particles(static_cast<int>(k), p));
        fmt::print(file, "{}\n", line);
    }
}

std::vector<int> loaded(const Case& plan, Simulation& simulation, std::size_t traction) {
    const TractionPlan& of = plan.tractions[traction];
    return outermost(simulation.body(plan.body(of.body)).particles, simulation.axis_r(),
                     simulation.axis_z(), of);
}

std::vector<int> loaded(const Case& plan, space::Simulation& simulation, std::size_t traction) {
    const std::string& body = plan.tractions[traction].body;
    std::vector<int> out;
    for (const space::OuterFace& face :
         space::outermost(*plan.space, plan.body(body),
                          {simulation.axis(0), simulation.axis(1), simulation.axis(2)},
                          plan.space->faces[traction], body)) {
        if (face.share != 1.0)
            throw std::invalid_argument(fmt::format(
                "traction on body {}: its shape goes through faces of particles, of which "
                "fix grit/mpm loads the whole area",
                body));
        out.push_back(face.particle);
    }
    return out;
}

template <class Simulated> TractionAtoms traction_atoms(const Case& plan, Simulated& simulation) {
    TractionAtoms out;
    for (std::size_t i = 0; i < plan.tractions.size(); ++i) {
        const int first = first_atom(simulation, plan.body(plan.tractions[i].body));
        out.push_back(loaded(plan, simulation, i));
        for (int& id : out.back()) id += first;
        std::sort(out.back().begin(), out.back().end());
    }
    return out;
}

template <class Simulated>
void write_files(const Case& plan, Simulated& simulation, const std::filesystem::path& folder) {
    const std::string fix = lammps_fix(plan, plan.name);
    const std::string script = lammps_script(plan, plan.name, traction_atoms(plan, simulation));
    const auto named = [&](const std::string& end) { return folder / (plan.name + end); };
    const auto points = [&](std::size_t i) { return named("_" + plan.bodies[i].name + ".points"); };
    Outputs outputs;
    for (const char* end : {".data", ".fix", ".in"}) outputs.add(named(end), plan.name);
    for (std::size_t i = 0; i < plan.bodies.size(); ++i) outputs.add(points(i), plan.name);
    for (const ContactPlan& contact : plan.contacts)
        if (contact.surface_mesh) outputs.add(folder / lammps_stl(plan.name, contact), plan.name);
    const auto lock = outputs.lock();
    TextFiles files;
    write_data(plan, simulation, files.open(named(".data")));
    for (std::size_t i = 0; i < plan.bodies.size(); ++i)
        write_points(simulation, i, files.open(points(i)));
    for (const ContactPlan& contact : plan.contacts)
        if (contact.surface_mesh)
            fmt::print(files.open(folder / lammps_stl(plan.name, contact)), "{}",
                       stl_text(*contact.surface_mesh));
    fmt::print(files.open(named(".fix")), "{}", fix);
    fmt::print(files.open(named(".in")), "{}", script);
    files.complete();
}

}  // namespace

void write_lammps_files(const Case& plan, const std::filesystem::path& folder) {
    const BuiltCase built = build_case(plan);
    built.space ? write_files(plan, *built.space, folder)
                : write_files(plan, *built.simulation, folder);
}

}  // namespace cli
