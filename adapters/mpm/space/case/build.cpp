// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/space/case/build.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include "adapters/mpm/case/build_case.hpp"
#include "adapters/mpm/case/case_words.hpp"
#include "adapters/mpm/case/initial_state.hpp"
#include "adapters/mpm/space/case/solids.hpp"
#include "adapters/mpm/space/kernel/elastic.hpp"
#include "adapters/mpm/space/kernel/sand.hpp"
#include "adapters/mpm/step/text.hpp"

namespace grit::mpm::space {

std::unique_ptr<Material> material_of(const BodyPlan& body) {
    if (const auto* sand = std::get_if<SandPlan>(&body.material))
        return std::make_unique<Sand>(prepared_sand(body, *sand), sand->options);
    const auto* elastic = std::get_if<ElasticPlan>(&body.material);
    if (!elastic) return nullptr;
    if (elastic->neo_hooke)
        return std::make_unique<NeoHooke>(elastic->youngs_modulus, elastic->poissons_ratio);
    return std::make_unique<LinearElastic>(elastic->youngs_modulus, elastic->poissons_ratio);
}

std::optional<PoreWater> water_of(const BodyPlan& body, const Material* material) {
    if (!body.water) return {};
    if (body.water->implicit || body.water->drainage == Drainage::flow)
        throw std::invalid_argument(
            "body " + body.name + ": in space pore water is undrained, and its pressure explicit");
    return make_water(body, column::own + material->own_columns(), material->separation());
}

namespace {

void set_start(const BodyPlan& body, double gravity, const PoreWater* water, Particles& particles) {
    check_stress_at_rest(body);
    const auto* plan = std::get_if<SandPlan>(&body.material);
    const grit_sand sand = plan ? prepared_sand(body, *plan) : grit_sand{};
    const ParticleView q = particles.view();
    std::optional<StressAtRest> at_rest;
    if (body.geostatic)
        at_rest.emplace(
            body, gravity,
            std::span<const double>(q[column::z], static_cast<std::size_t>(particles.size())));
    for (std::ptrdiff_t p = 0; p < particles.size(); ++p) {
        const double z = q[column::z][p];
        double stress[6] = {};
        if (at_rest) at_rest->find(z, 2, stress);
        for (int k = 0; k < 6; ++k) q[column::S_xx + k][p] = stress[k];
        if (plan) {
            double state[GRIT_SAND_STATE_SIZE];
            find_start(body, *plan, sand, -(stress[0] + stress[1] + stress[2]) / 3.0, z, state);
            for (int k = 0; k < GRIT_SAND_STATE_SIZE; ++k) q[Sand::state + k][p] = state[k];
        }
        if (!water) continue;
        const FullPores pores = full_pores(body, gravity, water->void_ratio(q, p), z);
        q[column::mass][p] = pores.density * q[column::V0][p];
        q[water->first][p] = pores.pressure;
    }
}

}  // namespace

namespace {

// What is told is not free, and begins as it is told.
void check_told(const RigidPlan& motion, const BodyPlan& body, const Vector3& start) {
    const TimeTable* told[] = {&motion.velocity_r, &motion.velocity_y, &motion.velocity_z,
                               &motion.spin[0],    &motion.spin[1],    &motion.spin[2]};
    for (std::size_t i = 0; i < 6; ++i) {
        const std::vector<double>& values = told[i]->value;
        const bool moves =
            std::any_of(values.begin(), values.end(), [](double x) { return x != 0.0; });
        const std::string what =
            std::string(i < 3 ? "the velocity along " : "the rotation about ") + "xyz"[i % 3];
        if (motion.free[i] && moves)
            throw std::invalid_argument("body " + body.name + ": " + what +
                                        " is free, and a table tells it");
        const bool turns_freely = motion.free[3] || motion.free[4] || motion.free[5];
        if (i >= 3 && moves && turns_freely)
            throw std::invalid_argument("body " + body.name + ": " + what +
                                        " is told, and that about another axis free: what the one "
                                        "would take from the other is not known");
        if (i < 3 && !motion.free[i] && start[static_cast<int>(i)] != 0.0)
            throw std::invalid_argument(
                "body " + body.name + ": " + what + " at the start is " +
                text(start[static_cast<int>(i)]) +
                " m/s, but that of a rigid body is told by a table unless it is free");
    }
}

}  // namespace

void check_free_at_sides(const Case& plan, std::size_t number, const Body& body,
                         Exchange* exchange) {
    const auto& motion = std::get<RigidPlan>(plan.bodies[number].material);
    const Particles& q = body.particles;
    double lies_at_it[6] = {};
    for (int side = 0; side < 6; ++side) {
        const int d = side / 2;
        const AxisPlan& axis = plan.space->axis[d];
        const double at = side % 2 == 0 ? axis.from : axis.to();
        // Particles that a shape cuts are in the middle of what they have, away from the side; hosts may have no shapes.
        const double near = 1e-5 * (axis.to() - axis.from);
        if (number < plan.space->bodies.size() &&
            comes_to(plan.space->bodies[number], d, at, side % 2 == 0, near))
            lies_at_it[side] = 1.0;
        for (std::ptrdiff_t p = 0; p < q.size() && lies_at_it[side] == 0.0; ++p)
            lies_at_it[side] = std::fabs(std::fabs(q(column::x + d, p) - at) -
                                         q(column::l_x + d, p)) <= 1e-6 * q(column::l_x + d, p);
    }
    if (exchange) exchange->max(lies_at_it, 6);
    for (int side = 0; side < 6; ++side) {
        const auto across = static_cast<std::size_t>(side / 2);
        const bool moves_out = motion.free[across] || motion.free[(across + 1) % 3 + 3] ||
                               motion.free[(across + 2) % 3 + 3];
        if (lies_at_it[side] == 0.0 || !moves_out || plan.space->boundary[side] == Boundary::free)
            continue;
        throw std::invalid_argument(
            "body " + body.name + " lies at the " +
            std::string(word_of(words::sides_in_space, side)) +
            " side, which is held: it may not be free across it, nor about axes within it");
    }
}

RigidCourse course_of(const Case& plan, std::size_t body, const std::shared_ptr<Clock>& clock) {
    const auto& motion = std::get<RigidPlan>(plan.bodies[body].material);
    check_told(motion, plan.bodies[body], plan.space->bodies[body].velocity);
    const auto over_time = [since = Since(plan, clock, motion.from_stage)](
                               const TimeTable& x, const TimeTable& y, const TimeTable& z) {
        return [since, x, y, z](double t) {
            const double s = since(t);
            return s < 0.0 ? Vector3{0.0, 0.0, 0.0} : Vector3{x.at(s), y.at(s), z.at(s)};
        };
    };
    RigidCourse out;
    out.velocity = over_time(motion.velocity_r, motion.velocity_y, motion.velocity_z);
    out.spin = over_time(motion.spin[0], motion.spin[1], motion.spin[2]);
    out.free = motion.free;
    if (!motion.from_stage.empty())
        out.has_begun = [since = Since(plan, clock, motion.from_stage)](double t) {
            return since(t) >= 0.0;
        };
    out.centre = motion.centre;
    out.start.along = plan.space->bodies[body].velocity;
    return out;
}

std::function<Vector3(double)> face_stress(const Case& plan, std::size_t traction,
                                           const std::shared_ptr<Clock>& clock) {
    const TractionPlan& of = plan.tractions[traction];
    return [since = Since(plan, clock, of.from_stage), stress = of.stress,
            direction = plan.space->faces[traction].direction](double t) {
        const double s = since(t);
        return (s < 0.0 ? 0.0 : value_at(stress, s)) * direction;
    };
}

namespace {

void add_bodies(const Case& plan, const Axes& axes, const std::shared_ptr<Clock>& clock,
                Simulation& simulation) {
    for (std::size_t b = 0; b < plan.bodies.size(); ++b) {
        const BodyPlan& body_plan = plan.bodies[b];
        Body body;
        body.name = body_plan.name;
        body.material = material_of(body_plan);
        body.water = water_of(body_plan, body.material.get());
        body.particles = fill(*plan.space, b, body.name, body_plan.density, axes,
                              (body.material ? body.material->own_columns() : 0) +
                                  (body.water ? body.water->columns() : 0));
        if (!body_plan.rigid())
            set_start(body_plan, plan.gravity, body.water ? &*body.water : nullptr, body.particles);
        else {
            body.make_rigid(course_of(plan, b, clock), plan.settings.fixed_point);
            check_free_at_sides(plan, b, body, nullptr);
        }
        for (std::size_t i = 0; i < b; ++i) {
            const auto& left_out =
                plan.space->bodies[b].outside_of;  // bricks of cut particles overlap
            if (std::find(left_out.begin(), left_out.end(), i) != left_out.end()) continue;
            Body& other = simulation.body(i);
            const std::string names = other.name + " and " + body.name;
            check_boxes_apart(plan.space->bodies[i], plan.space->bodies[b], names);
            check_apart(other.particles, body.particles, axes, names);
            check_apart(body.particles, other.particles, axes, names);
        }
        simulation.add_body(std::move(body));
    }
}

void add_tractions(const Case& plan, const Axes& axes, const std::shared_ptr<Clock>& clock,
                   Simulation& simulation) {
    for (std::size_t i = 0; i < plan.tractions.size(); ++i) {
        const TractionPlan& traction = plan.tractions[i];
        const FacePlan& face = plan.space->faces[i];
        const std::size_t body = plan.body(traction.body);
        const auto stress = face_stress(plan, i, clock);
        for (const OuterFace& of : outermost(*plan.space, body, axes, face, traction.body))
            simulation.add_traction(
                {body, of.particle, {face.across, face.upper}, stress, of.share});
    }
}

// Corners that have the same place are one vertex.
TriangleMesh mesh_of(const ClosedSurface& surface) {
    TriangleMesh out;
    std::map<std::array<double, 3>, std::ptrdiff_t> vertex;
    for (const ClosedSurface::Triangle& t : surface.outward())
        for (const Vector3& x : t) {
            const auto [place, is_new] = vertex.insert({{x[0], x[1], x[2]}, out.vertices()});
            if (is_new) out.position.insert(out.position.end(), x.c, x.c + 3);
            out.facet.push_back(place->second);
        }
    return out;
}

SurfaceLaw surface_law_of(const Case& plan, const ContactPlan& contact, double shortest_cell) {
    SurfaceLaw law = surface_law(contact.friction_coefficient);
    law.a = plan.body(contact.stiff);
    law.b = plan.body(contact.soft);
    if (contact.surface_mesh) law.mesh_a = mesh_of(*contact.surface_mesh);
    law.spacing = contact.pressure_spacing;
    set_surface_options(contact, shortest_cell, law.options);
    return law;
}

}  // namespace

void hold_sides(const Case& plan, Simulation& simulation) {
    for (int side = 0; side < 6; ++side) {
        const Boundary boundary = plan.space->boundary[side];
        if (boundary == Boundary::free) continue;
        if (boundary != Boundary::roller && boundary != Boundary::fixed)
            throw std::invalid_argument("absorbing sides and platens are not there in space");
        const int d = side / 2;
        const AxisPlan& axis = plan.space->axis[d];
        const Hold hold = boundary == Boundary::fixed ? Hold::all : Hold::across;
        if (side % 2 == 0) simulation.fix_below(d, axis.from, hold);
        else simulation.fix_above(d, axis.to(), hold);
    }
}

void add_contacts(const Case& plan, Simulation& simulation) {
    for (const ContactPlan& contact : plan.contacts) {
        if (contact.penalty)
            throw std::invalid_argument("contact of " + contact.stiff + " and " + contact.soft +
                                        ": penalty contact is not there in space");
        if (contact.at_surfaces) {
            simulation.add_contact(surface_law_of(plan, contact, simulation.shortest_cell()));
            continue;
        }
        const bool pushes = std::any_of(plan.bodies.begin(), plan.bodies.end(), [&](const auto& b) {
            return (b.name == contact.stiff || b.name == contact.soft) && b.rigid() &&
                   !b.prescribed();
        });
        if (pushes && contact.contact_stiffness_multiple > 0.0)
            throw std::invalid_argument("contact of " + contact.stiff + " and " + contact.soft +
                                        ": a rigid body that is free has no contact stiffness");
        simulation.add_contact(nodal_law(plan, contact, simulation.shortest_cell()));
    }
}

std::unique_ptr<Simulation> build(const Case& plan, const std::shared_ptr<Clock>& clock) {
    const SpacePlan& space = *plan.space;
    const Axes axes{make_axis(space.axis[0]), make_axis(space.axis[1]), make_axis(space.axis[2])};
    auto out = std::make_unique<Simulation>(axes, plan.settings);
    add_bodies(plan, axes, clock, *out);
    add_tractions(plan, axes, clock, *out);
    // Fixed nodes are known to a contact when it is made.
    hold_sides(plan, *out);
    add_contacts(plan, *out);
    return out;
}

void apply_stage(const Case& plan, const StagePlan& stage, Simulation& simulation) {
    simulation.set_gravity({0.0, 0.0, stage.gravity ? -plan.gravity : 0.0});
    simulation.set_local_damping(stage.local_damping);
    simulation.set_pic_rate(stage.pic_rate);
    simulation.set_cfl(stage.cfl);
}

}  // namespace grit::mpm::space
