// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/to_lammps.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>

#include <adapters/mpm/case/build_case.hpp>
#include <adapters/mpm/case/fill.hpp>
#include <adapters/mpm/step/column_names.hpp>
#include <fmt/format.h>

#include "cli/mpm/lammps_script.hpp"
#include "cli/process/exit_code.hpp"
#include "cli/process/outputs.hpp"

namespace cli {
namespace {

using namespace grit::mpm;
namespace c = column;

class TextFile {
  public:
    explicit TextFile(const std::filesystem::path& path)
        : name(path), file(std::fopen(path.c_str(), "w"), &std::fclose) {
        if (!file) throw BadInput(fmt::format("cannot write {}", path.string()));
    }
    template <class... Args> void print(fmt::format_string<Args...> text, Args&&... args) {
        fmt::print(file.get(), text, std::forward<Args>(args)...);
    }
    void close() {
        std::fflush(file.get());
        if (std::ferror(file.get())) throw BadInput(fmt::format("cannot write {}", name.string()));
    }

  private:
    std::filesystem::path name;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file;
};

// Atoms are numbered from 1, body after body.
int first_atom(Simulation& simulation, std::size_t body) {
    std::ptrdiff_t first = 1;
    for (std::size_t i = 0; i < body; ++i) first += simulation.body(i).particles.size();
    return static_cast<int>(first);
}

void write_data(const Case& plan, Simulation& simulation, const std::filesystem::path& path) {
    TextFile file(path);
    const std::size_t bodies = simulation.bodies();
    file.print("{}\n\n{} atoms\n{} atom types\n\n", plan.title.empty() ? plan.name : plan.title,
               first_atom(simulation, bodies) - 1, bodies);
    file.print("{:.17g} {:.17g} xlo xhi\n{:.17g} {:.17g} ylo yhi\n-0.5 0.5 zlo zhi\n\nMasses\n\n",
               plan.r.from, plan.r.to(), plan.z.from, plan.z.to());
    for (std::size_t i = 0; i < bodies; ++i) file.print("{} 1 # {}\n", i + 1, plan.bodies[i].name);
    const auto section = [&](const char* name, const auto& line) {
        file.print("\n{}\n\n", name);
        for (std::size_t i = 0; i < bodies; ++i) {
            const Particles& particles = simulation.body(i).particles;
            const int first = first_atom(simulation, i);
            for (std::ptrdiff_t p = 0; p < particles.size(); ++p)
                line(first + particles.ids()[p], i + 1, particles, p);
        }
    };
    section("Atoms # atomic", [&](int id, std::size_t type, const Particles& q, std::ptrdiff_t p) {
        file.print("{} {} {:.17g} {:.17g} 0\n", id, type, q(c::r, p), q(c::z, p));
    });
    section("Velocities", [&](int id, std::size_t, const Particles& q, std::ptrdiff_t p) {
        file.print("{} {:.17g} {:.17g} 0\n", id, q(c::v_r, p), q(c::v_z, p));
    });
    file.close();
}

// What the atoms do not have: all columns from F on.
void write_points(Simulation& simulation, std::size_t body, const std::filesystem::path& path) {
    TextFile file(path);
    const Body& of = simulation.body(body);
    const std::vector<std::string> names = column_names(of.material.get());
    std::string line = "id";
    for (std::size_t k = c::F_rr; k < names.size(); ++k) line += " " + names[k];
    file.print("{}\n", line);
    const int first = first_atom(simulation, body);
    for (std::ptrdiff_t p = 0; p < of.particles.size(); ++p) {
        line = fmt::format("{}", first + of.particles.ids()[p]);
        for (std::size_t k = c::F_rr; k < names.size(); ++k)
            line += fmt::format(" {:.17g}", of.particles(static_cast<int>(k), p));
        file.print("{}\n", line);
    }
    file.close();
}

void write_text(const std::string& text, const std::filesystem::path& path) {
    TextFile file(path);
    file.print("{}", text);
    file.close();
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
    make_output_folder(folder);
    write_data(plan, simulation, folder / (plan.name + ".data"));
    for (std::size_t i = 0; i < plan.bodies.size(); ++i)
        write_points(simulation, i,
                     folder / fmt::format("{}_{}.points", plan.name, plan.bodies[i].name));
    write_text(fix, folder / (plan.name + ".fix"));
    write_text(script, folder / (plan.name + ".in"));
}

}  // namespace cli
