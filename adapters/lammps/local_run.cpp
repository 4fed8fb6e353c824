// SPDX-License-Identifier: GPL-2.0-only
#include "adapters/lammps/local_run.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "adapters/mpm/case/initial_state.hpp"
#include "adapters/mpm/io/grid_state.hpp"
#include "adapters/mpm/step/column_names.hpp"

namespace grit::lammps {
namespace {

// Sizes of messages, and of what a fix leaves in a restart file, are int.
constexpr std::size_t most_bytes = 2000000000;

}  // namespace

using mpm::Body;
using mpm::BuiltCase;
using mpm::GridState;
using mpm::Simulation;

LocalRun::LocalRun(FixCase given, VariableAt values)
    : plan(std::move(given)), variables(std::move(values)), axis_r(mpm::make_axis(plan.plan.r)),
      axis_z(mpm::make_axis(plan.plan.z)), cut{} {
    if (plan.plan.settings.axisymmetric && axis_r[0] < 0.0)
        throw std::invalid_argument("the grid must not reach across the axis");
    for (const mpm::BodyPlan& body : plan.plan.bodies) {
        const auto material = mpm::make_material(body);
        auto& water = waters.emplace_back();
        if (body.water) water = mpm::make_water(body, *material);
        names_of.push_back(mpm::column_names(material.get(), water ? &*water : nullptr));
    }
}

double LocalRun::slack() const { return std::min(axis_r.shortest(), axis_z.shortest()); }

std::ptrdiff_t LocalRun::particles() const {
    auto count = static_cast<std::ptrdiff_t>(waiting.size());
    for (std::size_t b = 0; runner && b < simulation().bodies(); ++b)
        count += simulation().body(b).particles.size();
    return count;
}

std::size_t LocalRun::body_of(int id) const {
    for (std::size_t b = 0; runner && b < simulation().bodies(); ++b)
        if (simulation().find(b, id) >= 0) return b;
    throw std::runtime_error("atom " + std::to_string(id) + " is no material point of the fix");
}

PointRow LocalRun::row(int id) const {
    if (const auto found = waiting.find(id); found != waiting.end()) return found->second;
    PointRow out{body_of(id), {}};
    const mpm::Particles& particles = simulation().body(out.body).particles;
    const std::ptrdiff_t p = simulation().find(out.body, id);
    for (int c = 0; c < particles.column_count(); ++c) out.columns.push_back(particles(c, p));
    return out;
}

void LocalRun::leave(int id) {
    if (waiting.erase(id) == 0) leaving.push_back(id);
}

void LocalRun::settle() {
    if (!runner || (waiting.empty() && leaving.empty())) return;
    std::vector<std::vector<std::ptrdiff_t>> places(simulation().bodies());
    for (const int id : leaving) {
        const std::size_t body = body_of(id);
        places[body].push_back(simulation().find(body, id));
    }
    for (std::size_t b = 0; b < places.size(); ++b) {
        mpm::Particles& particles = simulation().body(b).particles;
        // From behind: the last one takes the place of one that leaves.
        std::sort(places[b].rbegin(), places[b].rend());
        for (const std::ptrdiff_t p : places[b]) particles.remove(p);
    }
    for (auto& [id, row] : waiting)
        simulation().body(row.body).particles.add(id, row.columns.data());
    leaving.clear();
    waiting.clear();
    for (std::size_t b = 0; b < places.size(); ++b) simulation().particles_changed(b);
}

bool LocalRun::is_cut(const Cuts& cuts) const { return cut.at == cuts.at && cut.here == cuts.here; }

void LocalRun::start(const Cuts& cuts, const std::vector<std::vector<int>>& traction_ids) {
    if (runner && is_cut(cuts)) return settle();
    // Cuts that are refused leave all as it was.
    HaloLayout layout{cuts.world, {axis_r.view(), axis_z.view()}, {}, cuts.here, {}};
    std::copy(&cuts.neighbour[0][0], &cuts.neighbour[0][0] + 4, &layout.neighbour[0][0]);
    layout.slices = {slices(axis_r, cuts.at[0], slack()), slices(axis_z, cuts.at[1], slack())};
    Halo::Traffic traffic;
    if (runner) {
        // Particles that came are at home on the grid as it will be, not on the one that is.
        go_on_from(store());
        take_particles_out();
        traffic = exchange->traffic();
    }
    runner.reset();
    cut = cuts;
    exchange = std::make_unique<Halo>(std::move(layout));
    exchange->count_from(traffic);
    if (stored) plan.plan.stages = stored->stages;
    runner = std::make_unique<mpm::Runner>(plan.plan, build(traction_ids));
    waiting.clear();
    if (!stored) return;
    runner->resume(stored->state);
    runner->set_energy_scale(stored->energy_scale);
    GridState::take_common(simulation(), stored->common);
    GridState::take_nodes(simulation(), nodes_here(stored->nodes));
    stored.reset();
}

void LocalRun::take_particles_out() {
    for (std::size_t b = 0; b < simulation().bodies(); ++b) {
        const mpm::Particles& particles = simulation().body(b).particles;
        for (std::ptrdiff_t p = 0; p < particles.size(); ++p) {
            const int id = particles.ids()[p];
            if (std::find(leaving.begin(), leaving.end(), id) == leaving.end())
                waiting.emplace(id, row(id));
        }
    }
    leaving.clear();
}

BuiltCase LocalRun::build(const std::vector<std::vector<int>>& traction_ids) {
    const Slice &r = exchange->slice(0), &z = exchange->slice(1);
    BuiltCase out{std::make_shared<mpm::Clock>(),
                  std::make_unique<Simulation>(axis_r.part(r.first_node, r.axis_last),
                                               axis_z.part(z.first_node, z.axis_last),
                                               plan.plan.settings, exchange.get())};
    out.clock->began.assign(plan.plan.stages.size(), mpm::unlimited);
    clock = out.clock;
    add_bodies(out);
    for (std::size_t i = 0; i < plan.plan.tractions.size(); ++i) {
        const mpm::TractionPlan& traction = plan.plan.tractions[i];
        auto stress = mpm::edge_stress(plan.plan, traction, out.clock);
        if (const std::string name = plan.traction_variables[i]; !name.empty())
            stress = [this, k = asked_variable(name, traction.from_stage, false),
                      direction = traction.direction](double) {
                const double size = asked[k].value;
                return Vector2{size * direction[0], size * direction[1]};
            };
        for (const int id : traction_ids[i])
            out.simulation->add_traction(
                {plan.plan.body(traction.body), id, traction.edge, stress});
    }
    mpm::add_boundary(plan.plan, *out.simulation);
    mpm::add_contacts(plan.plan, *out.simulation);
    return out;
}

void LocalRun::add_bodies(const BuiltCase& built) {
    for (std::size_t b = 0; b < plan.plan.bodies.size(); ++b) {
        const mpm::BodyPlan& of_plan = plan.plan.bodies[b];
        Body body;
        body.name = of_plan.name;
        body.material = mpm::make_material(of_plan);
        body.water = waters[b];
        body.particles = mpm::Particles(static_cast<int>(names_of[b].size()) - mpm::column::own);
        for (const auto& [id, row] : waiting)
            if (row.body == b) body.particles.add(id, row.columns.data());
        if (of_plan.rigid()) {
            body.prescribed_velocity = mpm::rigid_velocity(plan.plan, of_plan, built.clock);
            const MotionVariables& names = plan.motion[b];
            const std::string& stage = std::get<mpm::RigidPlan>(of_plan.material).from_stage;
            if (!names.r.empty())
                body.prescribed_velocity = [this, k = asked_variable(names.r, stage, true),
                                            other = body.prescribed_velocity](double t) {
                    return Vector2{asked[k].value, other(t)[1]};
                };
            if (!names.z.empty())
                body.prescribed_velocity = [this, k = asked_variable(names.z, stage, true),
                                            other = body.prescribed_velocity](double t) {
                    return Vector2{other(t)[0], asked[k].value};
                };
        }
        built.simulation->add_body(std::move(body));
    }
}

std::size_t LocalRun::asked_variable(const std::string& name, const std::string& stage,
                                     bool of_motion) {
    for (std::size_t k = 0; k < asked.size(); ++k)
        if (asked[k].name == name && asked[k].from_stage == stage &&
            asked[k].of_motion == of_motion)
            return k;
    asked.push_back({name, stage, of_motion, 0.0});
    return asked.size() - 1;
}

void LocalRun::ask(AskedVariable& variable, double t) {
    const std::string& stage = variable.from_stage;
    const double since = stage.empty() ? t : t - clock->began[plan.plan.stage(stage)];
    variable.value = since < 0.0 ? 0.0 : variables(variable.name, since);
}

void LocalRun::ask_for_step() {
    if (asked.empty()) return;
    if (!(simulation().next_step() > 0.0)) simulation().energy();  // it knows its step then
    const double t = simulation().time();
    for (AskedVariable& variable : asked)
        ask(variable, variable.of_motion ? t + simulation().next_step() : t);
    while (simulation().shorten_step())
        for (AskedVariable& variable : asked)
            if (variable.of_motion) ask(variable, t + simulation().next_step());
}

void LocalRun::ask_for_motion_now() {
    for (AskedVariable& variable : asked)
        if (variable.of_motion) ask(variable, simulation().time());
}

StoredRun LocalRun::store() {
    if (!runner) return *stored;
    StoredRun out{runner->state(),
                  runner->energy_scale(),
                  runner->description().stages,
                  GridState::common(simulation()),
                  {}};
    const std::vector<std::uint64_t> mine = GridState::nodes(simulation());
    const std::size_t each = GridState::words_per_node(simulation());
    const auto n_r = static_cast<std::size_t>(axis_r.nodes());
    const std::size_t words = n_r * static_cast<std::size_t>(axis_z.nodes()) * each;
    if (words * sizeof(std::uint64_t) > most_bytes)
        throw std::runtime_error("the state at nodes has " + std::to_string(words * 8) +
                                 " bytes: restart files and new cuts of the grid take " +
                                 std::to_string(most_bytes) + " at the most");
    out.nodes.resize(words);
    const Slice &r = exchange->slice(0), &z = exchange->slice(1);
    std::size_t node = 0;
    for (int j = z.first_node; j <= z.axis_last; ++j)
        for (int i = r.first_node; i <= r.axis_last; ++i, ++node)
            if (exchange->counted()[node])
                std::copy_n(mine.begin() + static_cast<std::ptrdiff_t>(node * each), each,
                            out.nodes.begin() +
                                static_cast<std::ptrdiff_t>((static_cast<std::size_t>(j) * n_r +
                                                             static_cast<std::size_t>(i)) *
                                                            each));
    MPI_Allreduce(MPI_IN_PLACE, out.nodes.data(), static_cast<int>(out.nodes.size()), MPI_UINT64_T,
                  MPI_BOR, cut.world);
    return out;
}

std::vector<std::uint64_t> LocalRun::nodes_here(const std::vector<std::uint64_t>& all) const {
    const auto n_r = static_cast<std::size_t>(axis_r.nodes());
    const std::size_t nodes = n_r * static_cast<std::size_t>(axis_z.nodes());
    if (all.size() % nodes != 0) throw std::runtime_error("the state is not that of this grid");
    const std::size_t each = all.size() / nodes;
    std::vector<std::uint64_t> out;
    const Slice &r = exchange->slice(0), &z = exchange->slice(1);
    for (int j = z.first_node; j <= z.axis_last; ++j) {
        const auto row =
            all.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(j) * n_r * each);
        out.insert(out.end(), row + static_cast<std::ptrdiff_t>(each) * r.first_node,
                   row + static_cast<std::ptrdiff_t>(each) * (r.axis_last + 1));
    }
    return out;
}

}  // namespace grit::lammps
