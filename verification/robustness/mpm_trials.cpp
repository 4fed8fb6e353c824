// SPDX-License-Identifier: BSD-3-Clause
#include "robustness/mpm_trials.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <variant>

#include <adapters/mpm/kernel/material_failure.hpp>
#include <adapters/mpm/run/run.hpp>

#include "cli/mpm/case_file.hpp"
#include "cli/process/exit_code.hpp"
#include "robustness/fuzz/scratch.hpp"
#include "robustness/mpm_case.hpp"

namespace robustness {
namespace {

using namespace grit::mpm;

enum Count {
    in_plane,
    in_the_space,
    refused,
    taken,
    all_steps,
    particle_steps,
    through,
    left_the_grid,
    failed_sand,
    stopped_by_energy,
    stopped_otherwise,
    floated,
    met
};
enum Largest {
    momentum_error,
    momentum_of_usf,
    residual,
    residual_of_others,
    contact_gain,
    contact_gain_of_layers
};
enum Rule {
    says_why,
    no_other_error,
    finite,
    same_in_threads,
    same_from_checkpoint,
    momentum_kept,
    energy_kept,
    contact_takes
};

const Vocabulary words = {
    {"cases in the plane and in axisymmetry", "cases in space", "refused", "taken", "steps",
     "particle steps", "ran through", "ended as particles left the grid",
     "ended as a sand could not follow", "ended by their energy balance", "ended otherwise",
     "floated freely", "had contacts that took or stored energy"},
    {"error of momentum over the largest, floating",
     "the same, stress first with convected domains",
     "residual of energy over what was turned over",
     "the same with sand, whose work is a sum of steps",
     "energy that contacts gave over what was turned over",
     "the same with a stiffness of surfaces"},
    {"a refusal names the place and the reason",
     "nothing but refusals is thrown while a case is built, and errors of a run in it",
     "all columns of particles are finite", "two threads give the bits of one",
     "a checkpoint in the middle gives the bits of a run that never stopped",
     "momentum of floating bodies changes by gravity alone, to 1e-8, where stress comes first to "
     "1e-3",
     "energies of floating bodies without sand balance within 10 % of what was turned over",
     "contacts give no more than 10 % of what was turned over"}};

constexpr int most_steps = 40;

struct Momentum {
    std::array<double, 3> now{};
    double size = 0.0;  // of the parts
};

// Of all bodies that no motion is prescribed for; r has none around an axis.
// seconds: in which stresses have pushed, whose sums have roundoff of their own.
template <class Simulated>
Momentum momentum_of(Simulated& simulation, int velocity, int components, int mass, bool all,
                     const int (&stress_volume_length)[3], double seconds) {
    Momentum out;
    for (std::size_t b = 0; b < simulation.bodies(); ++b) {
        const auto& particles = simulation.body(b).particles;
        const auto [stress, volume, length] = stress_volume_length;
        for (std::ptrdiff_t p = 0; p < particles.size(); ++p) {
            for (int c = 0; c < components + 1; ++c)
                out.size += seconds * std::fabs(particles(stress + c, p)) * particles(volume, p) /
                            particles(length, p);
            for (int c = all ? 0 : 1; c < components; ++c) {
                const double part = particles(mass, p) * particles(velocity + c, p);
                out.now[static_cast<std::size_t>(c)] += part;
                out.size += std::fabs(part);
            }
        }
    }
    return out;
}

Momentum momentum_of(Runner& runner) {
    const double seconds = runner.subject().time();
    if (space::Simulation* simulation = runner.space())
        return momentum_of(*simulation, space::column::v_x, 3, space::column::mass, true,
                           {space::column::S_xx, space::column::V0, space::column::l_z}, seconds);
    return momentum_of(runner.simulation(), column::v_r, 2, column::mass,
                       !runner.description().settings.axisymmetric,
                       {column::S_rr, column::V0, column::l_z}, seconds);
}

template <class Simulated> bool all_finite(Simulated& simulation) {
    for (std::size_t b = 0; b < simulation.bodies(); ++b) {
        const auto& particles = simulation.body(b).particles;
        for (int c = 0; c < particles.column_count(); ++c)
            for (std::ptrdiff_t p = 0; p < particles.size(); ++p)
                if (!std::isfinite(particles(c, p))) return false;
    }
    return true;
}

bool all_finite(Runner& runner) {
    return runner.space() ? all_finite(*runner.space()) : all_finite(runner.simulation());
}

std::string bytes_of(Runner& runner) {
    std::ostringstream out;
    runner.subject().save(out);
    return std::move(out).str();
}

enum class End { through, left, sand, energy, otherwise, foreign };

struct Outcome {
    End end = End::through;
    std::string words, bytes;  // why it ended; state at its end
    std::string half;          // ... and half-way
    RunState half_state;
    long steps = 0;
};

// Up to so many steps; half: where to look at the state.
Outcome go(Runner& runner, int until, int half = -1) {
    Outcome out;
    try {
        while (runner.subject().steps() < until) {
            runner.step();
            if (runner.subject().steps() != half) continue;
            out.half = bytes_of(runner);
            out.half_state = runner.state();
        }
        out.bytes = bytes_of(runner);
    } catch (const MaterialFailure& error) {
        out.end = End::sand;
        out.words = error.what();
    } catch (const std::runtime_error& error) {
        out.words = error.what();
        out.end = out.words.find("energy balance") != std::string::npos  ? End::energy
                  : out.words.find("left the grid") != std::string::npos ? End::left
                                                                         : End::otherwise;
    } catch (const std::exception& error) {
        out.words = error.what();
        out.end = End::foreign;
    }
    out.steps = runner.subject().steps();
    return out;
}

std::string program_of(const MpmCase& made, const std::string& why) {
    return "# grit mpm of this file: " + why + "\n" + made.text;
}

bool same(const Outcome& a, const Outcome& b) {
    return a.end == b.end && a.words == b.words && a.bytes == b.bytes && a.steps == b.steps;
}

// Walls that stop what flies into them within a step, sand that is released, much viscosity in long steps or any that grows with rates, and what flies into a
// soft body faster than waves leave are for the run's own check, which ends it.
bool is_gentle(const MpmCase& made, const Case& plan) {
    const auto is_sand = [](const BodyPlan& body) {
        return std::holds_alternative<SandPlan>(body.material);
    };
    return made.floating && plan.settings.linear_viscosity <= 0.1 &&
           plan.settings.quadratic_viscosity == 0.0 && made.fastest <= 0.5 * made.slowest_wave &&
           std::none_of(plan.bodies.begin(), plan.bodies.end(), is_sand);
}

void look_at_balances(const MpmCase& made, Runner& runner, const Momentum& before, Findings& out) {
    const Case& plan = runner.description();
    const Momentum after = momentum_of(runner);
    const double mass = runner.subject().measure(1.0, 0).weight;
    const double fallen = mass * plan.gravity * runner.subject().time();
    if (made.floating) {
        const std::size_t up = made.in_space ? 2 : 1;
        double error = 0.0;
        for (std::size_t c = 0; c < 3; ++c)
            error =
                std::max(error, std::fabs(after.now[c] - before.now[c] + (c == up ? fallen : 0.0)));
        const double size = std::max({before.size, after.size, fallen, 1e-300});
        // Domains that have been deformed since their mass was mapped reach nodes without any, whose forces are
        // lost.
        const bool stress_first =
            !made.in_space && plan.settings.scheme == Scheme::usf &&
            (plan.settings.shape == Shape::cpdi || plan.settings.shape == Shape::cpdi_published);
        out.measure(stress_first ? momentum_of_usf : momentum_error, error / size);
        out.demand(momentum_kept, error <= (stress_first ? 1e-3 : 1e-8) * size,
                   [&] { return program_of(made, "momentum"); });
    }
    const HistoryRow row = runner.row_so_far();
    const bool gentle = is_gentle(made, plan);
    out.measure(gentle ? residual : residual_of_others, std::fabs(row.residual_share));
    out.demand(energy_kept, !gentle || std::fabs(row.residual_share) <= 0.1,
               [&] { return program_of(made, "residual of energy"); });
    const double turned = turned_over(runner.subject().energy(), runner.energy_scale());
    const double gained = turned > 0.0 ? -runner.subject().energy().contact / turned : 0.0;
    // What is thin is seen rounded, and bricks of what is round stand out: a stiffness holds that overlap from the start.
    const bool holds = std::any_of(plan.contacts.begin(), plan.contacts.end(), [](const auto& c) {
        return c.at_surfaces && c.contact_stiffness_multiple > 0.0;
    });
    out.measure(holds ? contact_gain_of_layers : contact_gain, gained);
    out.demand(contact_takes, holds || gained <= 0.1,
               [&] { return program_of(made, "energy of contacts"); });
    out.count(met, runner.subject().energy().contact != 0.0 ? 1 : 0);
}

// One for each thread.
std::filesystem::path file_of(const std::string& text) {
    static std::atomic<int> threads = 0;
    thread_local const std::string name = "case" + std::to_string(threads++) + ".toml";
    return fuzz::scratch().write(name.c_str(), text);
}

void try_case(Random& random, const MpmCase& made, Findings& out) {
    out.count(made.in_space ? in_the_space : in_plane);
    const auto program = [&](const std::string& why) {
        return [&made, why] { return program_of(made, why); };
    };
    Case plan;
    std::unique_ptr<Runner> runner;
    try {
        plan = cli::read_mpm_case(file_of(made.text)).plan;
        plan.settings.threads = 1;
        runner = std::make_unique<Runner>(plan);
    } catch (const cli::BadInput& error) {
        out.count(refused);
        const std::string why = error.what();
        out.demand(says_why, why.find(".toml:") != std::string::npos, program(why));
        return;
    } catch (const std::invalid_argument& error) {
        out.count(refused);
        out.demand(says_why, std::string(error.what()).size() > 10, program(error.what()));
        return;
    } catch (const std::exception& error) {
        out.demand(no_other_error, false, program(error.what()));
        return;
    }
    out.count(taken);
    const int steps = 2 + random.below(most_steps), half = 1 + random.below(steps);
    const Momentum before = momentum_of(*runner);
    const Outcome alone = go(*runner, steps, half);
    out.count(all_steps, alone.steps);
    out.count(particle_steps, alone.steps * static_cast<long>(runner->particles()));
    out.count(floated, made.floating ? 1 : 0);
    switch (alone.end) {
        case End::through: out.count(through); break;
        case End::left: out.count(left_the_grid); break;
        case End::sand: out.count(failed_sand); break;
        case End::energy: out.count(stopped_by_energy); break;
        case End::otherwise:
        case End::foreign: out.count(stopped_otherwise);
    }
    out.demand(no_other_error, alone.end != End::foreign, program(alone.words));
    out.demand(energy_kept, alone.end != End::energy || !is_gentle(made, plan),
               program(alone.words));
    out.demand(finite, alone.end != End::through || all_finite(*runner), program("not finite"));
    if (alone.end == End::through) look_at_balances(made, *runner, before, out);

    Case shared = plan;
    shared.settings.threads = 2;
    Runner in_threads(shared);
    out.demand(same_in_threads, same(alone, go(in_threads, steps)), program("two threads"));

    if (alone.half.empty()) return;
    Runner again(plan);
    again.resume(alone.half_state);
    std::istringstream in(alone.half);
    again.subject().restore(in, OtherBits::refused);
    out.demand(same_from_checkpoint, same(alone, go(again, steps)),
               program("from a checkpoint after step " + std::to_string(half)));
}

void run_mpm(Random& random, long cases, Findings& out) {
    for (long i = 0; i < cases; ++i) {
        // A stream of its own: what is done with a case draws nothing from the next one.
        Random own(random.bits());
        try_case(own, random_mpm_case(own), out);
    }
}

}  // namespace

Kind mpm_trials() { return {"mpm", words, 200, run_mpm}; }

}  // namespace robustness
