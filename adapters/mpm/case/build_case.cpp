// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/case/build_case.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "adapters/mpm/case/fill.hpp"
#include "adapters/mpm/case/initial_state.hpp"
#include "adapters/mpm/case/since.hpp"
#include "adapters/mpm/space/case/build.hpp"

namespace grit::mpm {
namespace {

template <class Plans>
std::size_t find_name(const Plans& plans, const std::string& name, const char* kind) {
    for (std::size_t i = 0; i < plans.size(); ++i)
        if (plans[i].name == name) return i;
    throw std::invalid_argument(std::string("no ") + kind + " is called \"" + name + "\"");
}

void check_inside(const BodyPlan& body, const Case& plan) {
    for (const Outline& outline : body.outlines)
        for (const Vector2& x : outline.corners)
            if (!(x[0] >= plan.r.from && x[0] <= plan.r.to() && x[1] >= plan.z.from &&
                  x[1] <= plan.z.to()))
                throw std::invalid_argument("body " + body.name + " reaches out of the grid at (" +
                                            std::to_string(x[0]) + ", " + std::to_string(x[1]) +
                                            ") m");
}

void add_bodies(const Case& plan, const Axis& r, const Axis& z, const BuiltCase& built) {
    for (const BodyPlan& body_plan : plan.bodies) {
        check_inside(body_plan, plan);
        Body body;
        body.name = body_plan.name;
        body.material = make_material(body_plan);
        if (body_plan.water) body.water = make_water(body_plan, *body.material);
        body.particles = fill(body_plan, r, z, plan.settings.axisymmetric,
                              (body.material ? body.material->own_columns() : 0) +
                                  (body.water ? body.water->columns() : 0));
        set_initial_state(body_plan, plan.gravity, body.particles);
        if (body.water) fill_pores(body_plan, plan.gravity, *body.water, body.particles);
        if (body_plan.rigid())
            body.prescribed_velocity = rigid_velocity(plan, body_plan, built.clock);
        for (std::size_t i = 0; i < built.simulation->bodies(); ++i) {
            Body& other = built.simulation->body(i);
            const std::string names = other.name + " and " + body.name;
            check_apart(other.particles, body.particles, r, z, names);
            check_apart(body.particles, other.particles, r, z, names);
            check_boxes_apart(plan.bodies[i], body_plan);
        }
        built.simulation->add_body(std::move(body));
    }
}

void add_tractions(const Case& plan, const Axis& r, const Axis& z, const BuiltCase& built) {
    for (const TractionPlan& traction : plan.tractions) {
        const std::size_t body = plan.body(traction.body);
        const auto stress = edge_stress(plan, traction, built.clock);
        for (const int id : outermost(built.simulation->body(body).particles, r, z, traction))
            built.simulation->add_traction({body, id, traction.edge, stress, traction.on_mixture});
    }
}

double stiffness_of(const ContactPlan& contact, double shortest_cell) {
    if (!(contact.contact_stiffness_multiple > 0.0)) return 0.0;
    return contact_stiffness(contact.contact_stiffness_multiple, contact.modulus, shortest_cell);
}

void add_penalty_contact(const Case& plan, const ContactPlan& contact, Simulation& simulation) {
    const PenaltyPlan& given = *contact.penalty;
    const double cell = simulation.shortest_cell();
    PenaltyLaw law =
        penalty_law(contact.friction_coefficient, given.stiffness_multiple, given.modulus, cell);
    law.a = plan.body(contact.stiff);
    law.b = plan.body(contact.soft);
    law.line_a = given.stiff_line;
    law.line_b = given.soft_line;
    simulation.add_contact(law);
}

void add_surface_contact(const Case& plan, const ContactPlan& contact, Simulation& simulation) {
    SurfaceLaw law = surface_law(contact.friction_coefficient);
    law.line_a = contact.surface_line;
    law.spacing = contact.pressure_spacing;
    law.after_damping = contact.after_damping;
    set_surface_options(contact, simulation.shortest_cell(), law.options);
    law.a = plan.body(contact.stiff);
    law.b = plan.body(contact.soft);
    simulation.add_contact(law);
}

// A side of the grid: across r (0) or z (1), its first or its last nodes.
struct SideOfGrid {
    int direction;
    bool first;
    double at;  // [m]
};

SideOfGrid place_of(const Case& plan, Side side) {
    switch (side) {
        case Side::left: return {0, true, plan.r.from};
        case Side::right: return {0, false, plan.r.to()};
        case Side::bottom: return {1, true, plan.z.from};
        default: return {1, false, plan.z.to()};
    }
}

void add_inflows(const Case& plan, const BuiltCase& built) {
    for (const InflowPlan& inflow : plan.inflows) {
        auto speed = [since = Since(plan, built.clock, inflow.from_stage),
                      table = inflow.speed](double t) {
            const double s = since(t);
            return s < 0.0 ? 0.0 : table.at(s);
        };
        const SideOfGrid edge = place_of(plan, inflow.side);
        if (edge.first) built.simulation->pour_below(edge.direction, edge.at, std::move(speed));
        else built.simulation->pour_above(edge.direction, edge.at, std::move(speed));
    }
}

// The line of the grid that a platen begins at.
int line_at(const Axis& axis, double level) {
    int nearest = 0;
    for (int i = 1; i < axis.nodes(); ++i)
        if (std::abs(axis[i] - level) < std::abs(axis[nearest] - level)) nearest = i;
    const int beside = nearest + 1 < axis.nodes() ? nearest + 1 : nearest - 1;
    if (std::abs(axis[nearest] - level) > 1e-6 * std::abs(axis[beside] - axis[nearest]))
        throw std::invalid_argument("the level of a platen, " + std::to_string(level) +
                                    " m, is no line of the grid; the nearest is at " +
                                    std::to_string(axis[nearest]) + " m");
    return nearest;
}

// Absorbing sides hold what the first step finds: weight that no stress carries yet would fall through.
void check_rest(const Case& plan, const SideOfGrid& edge) {
    if (plan.gravity == 0.0 || plan.stages.empty() || !plan.stages[0].gravity) return;
    for (const BodyPlan& body : plan.bodies) {
        if (body.rigid() || body.geostatic) continue;
        for (const Outline& outline : body.outlines)
            for (const Vector2& x : outline.corners)
                if (std::abs((edge.direction == 0 ? x[0] : x[1]) - edge.at) <
                    1e-9 * (1.0 + std::abs(edge.at)))
                    throw std::invalid_argument("body " + body.name +
                                                " has weight and reaches an absorbing side, which "
                                                "holds what rests on it at "
                                                "the first step: it needs stress_at_rest, or the "
                                                "first stage gravity = false");
    }
}

}  // namespace

bool Case::has_side(Boundary kind) const {
    return std::find(boundary, boundary + 4, kind) != boundary + 4;
}

std::size_t Case::body(const std::string& wanted) const {
    return find_name(bodies, wanted, "body");
}

StagePlan Case::plain_stage(const std::string& stage_name) const {
    StagePlan out;
    out.name = stage_name;
    out.local_damping = settings.local_damping;
    out.pic_rate = settings.pic_rate;
    out.cfl = settings.cfl;
    return out;
}

std::size_t Case::stage(const std::string& wanted) const {
    return find_name(stages, wanted, "stage");
}

std::function<Vector2(double)> rigid_velocity(const Case& plan, const BodyPlan& body,
                                              const std::shared_ptr<Clock>& clock) {
    const auto& motion = std::get<RigidPlan>(body.material);
    return [since = Since(plan, clock, motion.from_stage), motion](double t) {
        const double s = since(t);
        return s < 0.0 ? Vector2{0.0, 0.0}
                       : Vector2{motion.velocity_r.at(s), motion.velocity_z.at(s)};
    };
}

std::function<Vector2(double)> edge_stress(const Case& plan, const TractionPlan& traction,
                                           const std::shared_ptr<Clock>& clock) {
    return [since = Since(plan, clock, traction.from_stage), traction](double t) {
        const double s = since(t), size = s < 0.0 ? 0.0 : value_at(traction.stress, s);
        return Vector2{size * traction.direction[0], size * traction.direction[1]};
    };
}

void set_surface_options(const ContactPlan& contact, double shortest_cell,
                         grit_surface_options& options) {
    options.sweep_tolerance = contact.sweep_tolerance;
    options.relaxation_time = contact.relaxation_time;
    options.contact_stiffness = stiffness_of(contact, shortest_cell);
}

ContactLaw nodal_law(const Case& plan, const ContactPlan& contact, double shortest_cell) {
    ContactLaw law = contact_law(contact.law, contact.friction_coefficient, contact.penalty_power);
    law.a = plan.body(contact.stiff);
    law.b = plan.body(contact.soft);
    law.normal = contact.normal;
    law.measure = contact.measure;
    law.gated = contact.gated;
    law.options.relaxation_time = contact.relaxation_time;
    law.options.contact_stiffness = stiffness_of(contact, shortest_cell);
    return law;
}

void add_contacts(const Case& plan, Simulation& simulation) {
    for (const ContactPlan& contact : plan.contacts) {
        if (contact.penalty) {
            add_penalty_contact(plan, contact, simulation);
            continue;
        }
        if (contact.at_surfaces) {
            add_surface_contact(plan, contact, simulation);
            continue;
        }
        simulation.add_contact(nodal_law(plan, contact, simulation.shortest_cell()));
    }
}

void add_boundary(const Case& plan, Simulation& simulation) {
    for (const Side side : {Side::left, Side::right, Side::bottom, Side::top}) {
        if (plan.drained[static_cast<int>(side)]) {
            const SideOfGrid edge = place_of(plan, side);
            if (edge.first) simulation.drain_below(edge.direction, edge.at);
            else simulation.drain_above(edge.direction, edge.at);
        }
        const Boundary boundary = plan.boundary[static_cast<int>(side)];
        if (boundary == Boundary::free) continue;
        const SideOfGrid edge = place_of(plan, side);
        if (boundary == Boundary::absorbing) {
            check_rest(plan, edge);
            if (edge.first) simulation.absorb_first(edge.direction, plan.absorbing);
            else simulation.absorb_last(edge.direction, plan.absorbing);
            continue;
        }
        if (boundary == Boundary::platen) {
            const int line =
                line_at(edge.direction == 0 ? simulation.axis_r() : simulation.axis_z(),
                        plan.platen_level[static_cast<int>(side)].value_or(edge.at));
            if (edge.first) simulation.tie_below(edge.direction, line);
            else simulation.tie_above(edge.direction, line);
            continue;
        }
        const Hold hold = boundary == Boundary::fixed ? Hold::both : Hold::across;
        if (edge.first) simulation.fix_below(edge.direction, edge.at, hold);
        else simulation.fix_above(edge.direction, edge.at, hold);
    }
}

BuiltCase build_case(const Case& plan) {
    if (plan.space) {
        auto clock = std::make_shared<Clock>();
        clock->began.assign(plan.stages.size(), unlimited);
        return {clock, nullptr, space::build(plan, clock)};
    }
    const Axis r = make_axis(plan.r), z = make_axis(plan.z);
    BuiltCase out{std::make_shared<Clock>(), std::make_unique<Simulation>(r, z, plan.settings),
                  nullptr};
    out.clock->began.assign(plan.stages.size(), unlimited);
    add_bodies(plan, r, z, out);
    add_tractions(plan, r, z, out);
    // Fixed nodes are known to a contact when it is made.
    add_boundary(plan, *out.simulation);
    add_inflows(plan, out);
    add_contacts(plan, *out.simulation);
    return out;
}

void apply_stage(const Case& plan, const StagePlan& stage, Simulation& simulation) {
    simulation.set_gravity({0.0, stage.gravity ? -plan.gravity : 0.0});
    simulation.set_local_damping(stage.local_damping);
    simulation.set_pic_rate(stage.pic_rate);
    simulation.set_cfl(stage.cfl);
}

}  // namespace grit::mpm
