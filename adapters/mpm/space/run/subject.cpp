// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/run/subject.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "adapters/mpm/space/case/build.hpp"
#include "adapters/mpm/space/run/checkpoint.hpp"

namespace grit::mpm {
namespace space {
namespace {

class SpaceSubject : public Subject {
  public:
    explicit SpaceSubject(Simulation& of) : simulation(of) {}
    void step() override { simulation.step(); }
    double time() const override { return simulation.time(); }
    long steps() const override { return simulation.steps(); }
    Seconds seconds() const override { return simulation.seconds(); }
    Energy energy() override { return simulation.energy(); }
    double shortest_cell() const override { return simulation.shortest_cell(); }
    void apply(const Case& plan, const StagePlan& stage) override {
        apply_stage(plan, stage, simulation);
    }
    void take_steps(const Case& plan, const StagePlan& stage) override {
        take_steps_as(plan, stage, simulation);
    }
    Bodies measure(double gravity, std::size_t driven) override;
    bool rigid(std::size_t body) const override { return simulation.body(body).rigid(); }
    double level(std::size_t body, DepthOf what) override;
    double velocity_z(std::size_t body) override;
    double stored_energy(std::size_t body) override;
    Forces forces(std::size_t body) override;
    void add_profile(std::size_t body, const ProfilePlan& profile,
                     std::vector<double>& impulses) override;
    double unbalanced_share(double dt) override;
    Extremes pore_pressures() override { return mpm::pore_pressures(simulation); }
    double water_mass() override { return NAN; }  // none flows
    void save(std::ostream& out) const override { space::save(simulation, out); }
    void restore(std::istream& in, OtherBits bits) override {
        space::restore(simulation, in, bits);
    }

  private:
    // take(pair, sign) of each contact of a body, at nodes and at surfaces: of what is on b, 1 where it is the body, else -1.
    template <class Take> void each_contact(std::size_t body, const Take& take) const {
        const auto take_one = [&](const auto& pair) {
            if (pair.law().a == body || pair.law().b == body)
                take(pair, pair.law().b == body ? 1.0 : -1.0);
        };
        for (std::size_t i = 0; i < simulation.contact_count(); ++i)
            take_one(simulation.contact(i));
        for (std::size_t i = 0; i < simulation.surface_contact_count(); ++i)
            take_one(simulation.surface_contact(i));
    }
    // Of a contact: forces on its body b, whose sign is 1, and the impulse on the body.
    static void add(Forces& to, const ContactPair::Measured& forces, const Twist& impulse,
                    double sign);
    double base_reaction() const;

    Simulation& simulation;
};

Subject::Bodies SpaceSubject::measure(double gravity, std::size_t driven) {
    enum { weight, stiffness, mass, count };
    const bool fixed_point = simulation.current_settings().fixed_point;
    std::array<Total, count> sums;
    Bodies out;
    for (std::size_t i = 0; i < simulation.bodies(); ++i) {
        Body& body = simulation.body(i);
        const ParticleView q = body.particles.view();
        out.particles += body.particles.size();
        for (std::ptrdiff_t p = 0; p < body.particles.size() && !body.rigid(); ++p) {
            double modulus = 0.0;
            body.material->wave_moduli({q, p, p + 1}, &modulus);
            const double m = q[column::mass][p], V = q[column::V0][p];
            sums[weight].add(gravity * m, fixed_point);
            sums[stiffness].add(modulus * V, fixed_point);
            if (i == driven) sums[mass].add(m, fixed_point);
            out.fastest2 = std::max(out.fastest2, modulus * V / m);
        }
    }
    simulation.shared().sum(sums, fixed_point);
    simulation.shared().max(&out.fastest2, 1);
    out.weight = sums[weight].value();
    out.stiffness = sums[stiffness].value();
    out.mass = sums[mass].value();
    return out;
}

double SpaceSubject::level(std::size_t body, DepthOf what) {
    Particles& particles = simulation.body(body).particles;
    const ParticleView q = particles.view();
    const bool fixed_point = simulation.current_settings().fixed_point;
    double highest = -INFINITY;  // of what is below zero, that is the lowest
    std::array<Total, 2> sums;   // mass, moment
    for (std::ptrdiff_t p = 0; p < particles.size(); ++p) {
        double reach = 0.0;
        for (int k = 0; k < 3; ++k) reach += std::fabs(q.F(2, k, p)) * q[column::l_x + k][p];
        highest = std::max(highest, reach - q[column::z][p]);
        sums[0].add(q[column::mass][p], fixed_point);
        sums[1].add(q[column::mass][p] * q[column::z][p], fixed_point);
    }
    simulation.shared().max(&highest, 1);
    simulation.shared().sum(sums, fixed_point);
    return what == DepthOf::lowest_point ? -highest : sums[1].value() / sums[0].value();
}

double SpaceSubject::velocity_z(std::size_t body) {
    Body& of = simulation.body(body);
    if (of.rigid()) return of.motion->velocity().along[2];
    const ParticleView q = of.particles.view();
    const bool fixed_point = simulation.current_settings().fixed_point;
    std::array<Total, 2> sums;  // mass, momentum
    for (std::ptrdiff_t p = 0; p < of.particles.size(); ++p) {
        sums[0].add(q[column::mass][p], fixed_point);
        sums[1].add(q[column::mass][p] * q[column::v_z][p], fixed_point);
    }
    simulation.shared().sum(sums, fixed_point);
    return sums[1].value() / sums[0].value();
}

double SpaceSubject::stored_energy(std::size_t body) {
    Body& of = simulation.body(body);
    const bool fixed_point = simulation.current_settings().fixed_point;
    std::array<Total, 1> sum;
    for (std::ptrdiff_t p = 0; p < of.particles.size() && !of.rigid(); ++p)
        sum[0].add(of.material->energy(of.particles.view(), p), fixed_point);
    simulation.shared().sum(sum, fixed_point);
    return sum[0].value();
}

// What keeps the nodes of the bottom from moving down, weight and all.
double SpaceSubject::base_reaction() const {
    const auto count = static_cast<std::size_t>(simulation.axis(0).nodes()) *
                       static_cast<std::size_t>(simulation.axis(1).nodes());
    const std::uint8_t* mine = simulation.shared().counted();
    const bool fixed_point = simulation.current_settings().fixed_point;
    std::array<Total, 1> sum;
    for (std::size_t body = 0; body < simulation.bodies(); ++body) {
        if (simulation.body(body).rigid()) continue;
        const std::vector<NodeRecord>& nodes = simulation.records(body);
        for (std::size_t i = 0; i < count; ++i)
            if ((simulation.constraints()[i] & fixed::along(2)) && (!mine || mine[i]))
                sum[0].add(-(nodes[i][record::f_z] + simulation.gravity()[2] * nodes[i][record::m]),
                           fixed_point);
    }
    simulation.shared().sum(sum, fixed_point);
    return sum[0].value();
}

void SpaceSubject::add(Forces& to, const ContactPair::Measured& forces, const Twist& impulse,
                       double sign) {
    to.tip += sign * forces.along_z[2];
    to.shaft += sign * forces.sideways[2];
    to.largest_gap = std::fmax(to.largest_gap, forces.largest_gap);
    for (int k = 0; k < 3; ++k) {
        to.contact_impulse[static_cast<std::size_t>(k)] += impulse.along[k];
        to.contact_impulse[static_cast<std::size_t>(k) + 3] += impulse.about[k];
    }
}

Subject::Forces SpaceSubject::forces(std::size_t body) {
    Forces out;
    out.largest_gap = NAN;
    each_contact(body, [&](const auto& pair, double sign) {
        add(out, pair.measured(), pair.impulse_on(body, {0.0, 0.0, 0.0}), sign);
    });
    out.traction = simulation.traction_force(body)[2];
    out.base = base_reaction();
    out.damping_impulse = simulation.damping_impulse(body);
    return out;
}

void SpaceSubject::add_profile(std::size_t body, const ProfilePlan& profile,
                               std::vector<double>& impulses) {
    each_contact(body, [&](const auto& pair, double sign) {
        pair.each_impulse([&](double low, double high, const Vector3& on_b) {
            profile.add(low, high, sign * on_b, impulses);
        });
    });
}

double SpaceSubject::unbalanced_share(double dt) {
    double share = 0.0;
    for (std::size_t body = 0; body < simulation.bodies(); ++body) {
        if (simulation.body(body).rigid()) {
            share = std::max(share, simulation.body(body).motion->unbalanced_share());
            continue;
        }
        double largest[] = {0.0, 0.0};  // resultant, force
        const std::vector<NodeRecord>& nodes = simulation.records(body);
        const std::vector<NodeMotion>& motions = simulation.motions(body);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const NodeRecord& n = nodes[i];
            const NodeMotion& v = motions[i];
            if (!(n[record::m] > simulation.least_mass(body))) continue;
            Vector3 change, f;
            for (int k = 0; k < 3; ++k) {
                change[k] = v[motion::v_x + k] - v[motion::other_x + k];
                f[k] = n[record::f_x + k];
            }
            largest[0] = std::max(largest[0], n[record::m] * norm(change) / dt);
            largest[1] = std::max({largest[1], norm(f), n[record::m] * norm(simulation.gravity())});
        }
        simulation.shared().max(largest, 2);
        if (largest[1] > 0.0) share = std::max(share, largest[0] / largest[1]);
    }
    return share;
}

}  // namespace
}  // namespace space

std::unique_ptr<Subject> subject_of(space::Simulation& simulation) {
    return std::make_unique<space::SpaceSubject>(simulation);
}

}  // namespace grit::mpm
