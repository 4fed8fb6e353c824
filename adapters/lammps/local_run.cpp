// SPDX-License-Identifier: GPL-2.0-only
#include "adapters/lammps/local_run.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <stdexcept>
#include <utility>

#include "adapters/mpm/case/initial_state.hpp"
#include "adapters/mpm/io/grid_state.hpp"
#include "adapters/mpm/space/case/build.hpp"
#include "adapters/mpm/step/column_names.hpp"
#include "adapters/mpm/step/text.hpp"

namespace grit::lammps {
using mpm::BuiltCase;
using mpm::GridState;

LocalRun::LocalRun(FixCase given, VariableAt values)
    : plan(std::move(given)), variables(std::move(values)), cut{} {
    if (in_space()) {
        for (const mpm::AxisPlan& axis : plan.plan.space->axis)
            axes.push_back(mpm::make_axis(axis));
        for (const mpm::BodyPlan& body : plan.plan.bodies) {
            const auto material = mpm::space::material_of(body);
            const auto& water = waters.emplace_back(mpm::space::water_of(body, material.get()));
            names_of.push_back(mpm::space::column_names(material.get(), water));
        }
        return;
    }
    axes = {mpm::make_axis(plan.plan.r), mpm::make_axis(plan.plan.z)};
    if (plan.plan.settings.axisymmetric && axes[0][0] < 0.0)
        throw std::invalid_argument("the grid must not reach across the axis");
    for (const mpm::BodyPlan& body : plan.plan.bodies) {
        const auto material = mpm::make_material(body);
        auto& water = waters.emplace_back();
        if (body.water) water = mpm::make_water(body, *material);
        names_of.push_back(mpm::column_names(material.get(), water));
    }
}

double LocalRun::slack() const {
    double out = axes[0].shortest();
    for (const mpm::Axis& axis : axes) out = std::min(out, axis.shortest());
    return out;
}

std::ptrdiff_t LocalRun::particles() const {
    auto count = static_cast<std::ptrdiff_t>(waiting.size());
    if (runner)
        each_body([&count](std::size_t, const mpm::ParticleColumns& of) { count += of.size(); });
    return count;
}

double LocalRun::next_step() const {
    return with([](const auto& simulation) { return simulation.next_step(); });
}

std::size_t LocalRun::body_of(int id) const {
    for (std::size_t b = 0; runner && b < plan.plan.bodies.size(); ++b)
        if (with([&](const auto& simulation) { return simulation.find(b, id) >= 0; })) return b;
    throw std::runtime_error("atom " + std::to_string(id) + " is no material point of the fix");
}

PointRow LocalRun::row(int id) const {
    if (const auto found = waiting.find(id); found != waiting.end()) return found->second;
    PointRow out{body_of(id), {}};
    with([&](const auto& simulation) {
        const mpm::ParticleColumns& particles = simulation.body(out.body).particles;
        const std::ptrdiff_t p = simulation.find(out.body, id);
        for (int c = 0; c < particles.column_count(); ++c) out.columns.push_back(particles(c, p));
    });
    return out;
}

void LocalRun::leave(int id) {
    if (waiting.erase(id) == 0) leaving.push_back(id);
}

void LocalRun::settle(const LoadedIds& loaded) {
    if (!runner) return;
    with([&, this](auto& simulation) {
        // Groups may have changed where no particle has come.
        if (waiting.empty() && leaving.empty())
            return simulation.set_tractions(tractions(simulation, loaded));
        std::vector<std::vector<std::ptrdiff_t>> places(simulation.bodies());
        for (const int id : leaving) {
            const std::size_t body = body_of(id);
            places[body].push_back(simulation.find(body, id));
        }
        for (std::size_t b = 0; b < places.size(); ++b) {
            mpm::ParticleColumns& particles = simulation.body(b).particles;
            // From behind: the last one takes the place of one that leaves.
            std::sort(places[b].rbegin(), places[b].rend());
            for (const std::ptrdiff_t p : places[b]) particles.remove(p);
        }
        for (const auto& [id, row] : waiting) {
            mpm::ParticleColumns& particles = simulation.body(row.body).particles;
            particles.add(id, row.columns.data());
        }
        leaving.clear();
        waiting.clear();
        for (std::size_t b = 0; b < places.size(); ++b) simulation.particles_changed(b);
        simulation.set_tractions(tractions(simulation, loaded));
    });
}

bool LocalRun::is_cut(const Cuts& cuts) const { return cut.at == cuts.at && cut.here == cuts.here; }

void LocalRun::start(const Cuts& cuts, const LoadedIds& loaded) {
    if (runner && is_cut(cuts)) return settle(loaded);
    // Cuts that are refused leave all as it was.
    HaloLayout layout{cuts};
    for (std::size_t d = 0; d < axes.size(); ++d) {
        layout.slices[d] = slices(axes[d], cuts.at[d], slack());
        layout.axes[d] = axes[d].view();
    }
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
    runner = std::make_unique<mpm::Runner>(plan.plan, build());
    waiting.clear();
    with([&](auto& simulation) { simulation.set_tractions(tractions(simulation, loaded)); });
    if (!stored) return;
    runner->resume(stored->state);
    runner->set_energy_scale(stored->energy_scale);
    with([this](auto& simulation) {
        if (stored->nodes.words_each != GridState::words_per_node(simulation))
            throw std::runtime_error("the state is not that of these bodies");
        GridState::take_common(simulation, stored->common);
        GridState::take_nodes(simulation, nodes_here(stored->nodes));
    });
    stored.reset();
}

void LocalRun::take_particles_out() {
    const std::set<int> gone(leaving.begin(), leaving.end());
    each_body([&](std::size_t body, const mpm::ParticleColumns& particles) {
        for (std::ptrdiff_t p = 0; p < particles.size(); ++p) {
            const int id = particles.ids()[p];
            if (gone.contains(id)) continue;
            PointRow of{body, {}};
            for (int c = 0; c < particles.column_count(); ++c)
                of.columns.push_back(particles(c, p));
            waiting.emplace(id, std::move(of));
        }
    });
    leaving.clear();
}

mpm::Axis LocalRun::axis_here(int direction) const {
    const Slice& slice = exchange->slice(direction);
    return axes[static_cast<std::size_t>(direction)].part(slice.first_node, slice.axis_last);
}

BuiltCase LocalRun::build() {
    const mpm::Settings& settings = plan.plan.settings;
    BuiltCase out{std::make_shared<mpm::Clock>(), nullptr, nullptr};
    out.clock->began.assign(plan.plan.stages.size(), mpm::unlimited);
    clock = out.clock;
    if (in_space()) {
        out.space = std::make_unique<mpm::space::Simulation>(
            std::array{axis_here(0), axis_here(1), axis_here(2)}, settings, exchange.get());
        build_space(out);
    } else {
        out.simulation =
            std::make_unique<mpm::Simulation>(axis_here(0), axis_here(1), settings, exchange.get());
        build_plane(out);
    }
    return out;
}

void LocalRun::build_plane(const BuiltCase& out) {
    for (std::size_t b = 0; b < plan.plan.bodies.size(); ++b)
        out.simulation->add_body(plane_body(b));
    edge_stress.clear();
    for (std::size_t i = 0; i < plan.plan.tractions.size(); ++i) {
        const mpm::TractionPlan& traction = plan.plan.tractions[i];
        auto stress = mpm::edge_stress(plan.plan, traction, out.clock);
        if (const std::string name = plan.traction_variables[i]; !name.empty())
            stress = [this, k = asked_variable(name, traction.from_stage, false),
                      direction = traction.direction](double) {
                const double size = asked[k].value;
                return Vector2{size * direction[0], size * direction[1]};
            };
        edge_stress.push_back(stress);
        out.simulation->expect_tractions(plan.plan.body(traction.body), traction.on_mixture);
    }
    mpm::add_boundary(plan.plan, *out.simulation);
    mpm::add_contacts(plan.plan, *out.simulation);
}

void LocalRun::build_space(const BuiltCase& out) {
    for (std::size_t b = 0; b < plan.plan.bodies.size(); ++b) out.space->add_body(space_body(b));
    face_stress.clear();
    for (std::size_t i = 0; i < plan.plan.tractions.size(); ++i) {
        const mpm::TractionPlan& traction = plan.plan.tractions[i];
        const mpm::FacePlan& face = plan.plan.space->faces[i];
        auto stress = mpm::space::face_stress(plan.plan, i, out.clock);
        if (const std::string name = plan.traction_variables[i]; !name.empty())
            stress = [this, k = asked_variable(name, traction.from_stage, false),
                      direction = face.direction](double) { return asked[k].value * direction; };
        face_stress.push_back(stress);
        out.space->expect_tractions(plan.plan.body(traction.body));
    }
    mpm::space::hold_sides(plan.plan, *out.space);
    mpm::space::add_contacts(plan.plan, *out.space);
}

std::vector<mpm::Traction> LocalRun::tractions(const mpm::Simulation&,
                                               const LoadedIds& loaded) const {
    std::vector<mpm::Traction> out;
    for (std::size_t i = 0; i < loaded.size(); ++i) {
        const mpm::TractionPlan& of = plan.plan.tractions[i];
        for (const int id : loaded[i])
            out.push_back({plan.plan.body(of.body), id, of.edge, edge_stress[i], of.on_mixture});
    }
    return out;
}

std::vector<mpm::space::Traction> LocalRun::tractions(const mpm::space::Simulation&,
                                                      const LoadedIds& loaded) const {
    std::vector<mpm::space::Traction> out;
    for (std::size_t i = 0; i < loaded.size(); ++i) {
        const mpm::FacePlan& face = plan.plan.space->faces[i];
        const std::size_t body = plan.plan.body(plan.plan.tractions[i].body);
        for (const int id : loaded[i])
            out.push_back({body, id, {face.across, face.upper}, face_stress[i], 1.0});
    }
    return out;
}

template <class Particles> Particles LocalRun::particles_of(std::size_t body, int first_own) const {
    Particles out(static_cast<int>(names_of[body].size()) - first_own);
    mpm::ParticleColumns& columns = out;
    for (const auto& [id, row] : waiting)
        if (row.body == body) columns.add(id, row.columns.data());
    return out;
}

mpm::Body LocalRun::plane_body(std::size_t b) {
    const mpm::BodyPlan& of_plan = plan.plan.bodies[b];
    mpm::Body body;
    body.name = of_plan.name;
    body.material = mpm::make_material(of_plan);
    body.water = waters[b];
    body.particles = particles_of<mpm::Particles>(b, mpm::column::own);
    if (of_plan.rigid()) body.prescribed_velocity = velocity_of(b);
    if (plan.plan.settings.axisymmetric && !stored) check_beside_axis(body);
    return body;
}

// At the start; later a particle may cross it.
void LocalRun::check_beside_axis(const mpm::Body& body) const {
    namespace column = mpm::column;
    const mpm::Particles& q = body.particles;
    double beyond = 0.0;
    for (std::ptrdiff_t p = 0; p < q.size(); ++p)
        if (!(q(column::r, p) >= q(column::l_r, p) * (1.0 - 1e-12)))
            beyond = std::max(beyond, q(column::l_r, p) - q(column::r, p));
    exchange->max(&beyond, 1);
    if (beyond > 0.0)
        throw std::invalid_argument(
            "body " + body.name +
            ": half side l_r of a point must not reach across the axis, it does so by " +
            mpm::text(beyond) + " m");
}

mpm::space::Body LocalRun::space_body(std::size_t b) {
    const mpm::BodyPlan& of_plan = plan.plan.bodies[b];
    mpm::space::Body body;
    body.name = of_plan.name;
    body.material = mpm::space::material_of(of_plan);
    body.water = waters[b];
    body.particles = particles_of<mpm::space::Particles>(b, mpm::space::column::own);
    if (!of_plan.rigid()) return body;
    const MotionVariables& names = plan.motion[b];
    const std::string& stage = std::get<mpm::RigidPlan>(of_plan.material).from_stage;
    mpm::space::RigidCourse course = mpm::space::course_of(plan.plan, b, clock);
    course.velocity = with_variables(course.velocity, names.along, stage);
    course.spin = with_variables(course.spin, names.about, stage);
    body.make_rigid(course, plan.plan.settings.fixed_point, exchange.get());
    if (!stored) {
        body.motion->check_centre();
        mpm::space::check_free_at_sides(plan.plan, b, body, exchange.get());
    }
    return body;
}

std::function<Vector2(double)> LocalRun::velocity_of(std::size_t b) {
    const mpm::BodyPlan& of_plan = plan.plan.bodies[b];
    const auto planned = mpm::rigid_velocity(plan.plan, of_plan, clock);
    const std::string& stage = std::get<mpm::RigidPlan>(of_plan.material).from_stage;
    const auto all = with_variables(
        [planned](double t) {
            const Vector2 v = planned(t);
            return Vector3{v[0], 0.0, v[1]};
        },
        plan.motion[b].along, stage);
    return [all](double t) {
        const Vector3 v = all(t);
        return Vector2{v[0], v[2]};
    };
}

// Components of another function, but those that are asked for.
std::function<Vector3(double)> LocalRun::with_variables(std::function<Vector3(double)> other,
                                                        const std::string (&names)[3],
                                                        const std::string& stage) {
    std::array<std::optional<std::size_t>, 3> of;
    for (std::size_t k = 0; k < 3; ++k)
        if (!names[k].empty()) of[k] = asked_variable(names[k], stage, true);
    return [this, other = std::move(other), of](double t) {
        Vector3 out = other(t);
        for (std::size_t k = 0; k < 3; ++k)
            if (of[k]) out[static_cast<int>(k)] = asked[*of[k]].value;
        return out;
    };
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
    with([this](auto& simulation) {
        if (!(simulation.next_step() > 0.0)) simulation.energy();  // it knows its step then
        const double t = simulation.time();
        for (AskedVariable& variable : asked)
            ask(variable, variable.of_motion ? t + simulation.next_step() : t);
        while (simulation.shorten_step())
            for (AskedVariable& variable : asked)
                if (variable.of_motion) ask(variable, t + simulation.next_step());
    });
}

void LocalRun::ask_for_motion_now() {
    for (AskedVariable& variable : asked)
        if (variable.of_motion) ask(variable, time());
}

void LocalRun::take_nodes(const std::vector<std::uint64_t>& words) {
    if (stored) stored->nodes.words.insert(stored->nodes.words.end(), words.begin(), words.end());
}

StoredRun LocalRun::store() const {
    if (!runner) return *stored;
    return {runner->state(), runner->energy_scale(), runner->description().stages,
            with([](const auto& simulation) { return GridState::common(simulation); }), items()};
}

std::vector<int> LocalRun::nodes_along() const {
    std::vector<int> out;
    for (const mpm::Axis& axis : axes) out.push_back(axis.nodes());
    return out;
}

// work(node here, its number in the whole grid) for all that are here.
template <class Work> void LocalRun::each_node(const Work& work) const {
    const std::vector<int> whole = nodes_along();
    std::vector<int> first, count;
    std::uint64_t nodes = 1;
    for (int d = 0; d < exchange->dimensions(); ++d) {
        const Slice& slice = exchange->slice(d);
        first.push_back(slice.first_node);
        count.push_back(slice.axis_last - slice.first_node + 1);
        nodes *= static_cast<std::uint64_t>(count.back());
    }
    for (std::uint64_t node = 0; node < nodes; ++node) {
        std::uint64_t rest = node, number = 0, step = 1;
        for (std::size_t d = 0; d < whole.size(); ++d) {
            const auto lines = static_cast<std::uint64_t>(count[d]);
            number += step * (rest % lines + static_cast<std::uint64_t>(first[d]));
            rest /= lines;
            step *= static_cast<std::uint64_t>(whole[d]);
        }
        work(static_cast<std::size_t>(node), number);
    }
}

// Of nodes that this process counts.
NodeItems LocalRun::items() const {
    NodeItems out;
    out.words_each =
        with([](const auto& simulation) { return GridState::words_per_node(simulation); });
    const std::vector<std::uint64_t> mine =
        with([](const auto& simulation) { return GridState::nodes(simulation); });
    each_node([&](std::size_t node, std::uint64_t number) {
        const std::uint64_t* words = mine.data() + node * out.words_each;
        const auto is_set = [](std::uint64_t word) { return word != 0; };
        if (exchange->counted()[node] && std::any_of(words, words + out.words_each, is_set))
            out.add(number, words);
    });
    return out;
}

std::vector<std::uint64_t> LocalRun::nodes_here(const NodeItems& all) const {
    const NodeItems mine = at_holders(all, exchange->of(), nodes_along());
    std::vector<std::uint64_t> order(mine.size());
    std::iota(order.begin(), order.end(), 0);
    const auto number_of = [&mine](std::uint64_t i) { return mine.words[i * mine.each()]; };
    std::sort(order.begin(), order.end(),
              [&](std::uint64_t i, std::uint64_t j) { return number_of(i) < number_of(j); });
    std::vector<std::uint64_t> out;
    auto next = order.begin();
    // Both ascend.
    each_node([&](std::size_t node, std::uint64_t number) {
        out.resize((node + 1) * mine.words_each, 0);
        if (next == order.end() || number_of(*next) != number) return;
        const auto words =
            mine.words.begin() + static_cast<std::ptrdiff_t>(*next * mine.each()) + 1;
        std::copy_n(words, mine.words_each,
                    out.end() - static_cast<std::ptrdiff_t>(mine.words_each));
        ++next;
    });
    if (next != order.end()) throw std::runtime_error("the state is not that of this grid");
    return out;
}

}  // namespace grit::lammps
