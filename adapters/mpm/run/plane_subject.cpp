// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/run/subject.hpp"

#include <algorithm>
#include <array>

namespace grit::mpm {
namespace {

class PlaneSubject : public Subject {
  public:
    explicit PlaneSubject(Simulation& of) : simulation(of) {}
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
    bool rigid(std::size_t body) const override { return simulation.rigid(body); }
    double level(std::size_t body, DepthOf what) override {
        return level_of(simulation, body, what);
    }
    double velocity_z(std::size_t body) override {
        return rigid(body) ? simulation.body(body).prescribed_velocity(time())[1]
                           : mean_velocity(simulation, body)[1];
    }
    double stored_energy(std::size_t body) override { return mpm::stored_energy(simulation, body); }
    Forces forces(std::size_t body) override {
        const ContactForces contact = contact_forces(simulation, body);
        return {contact.tip[1],
                contact.shaft[1],
                simulation.traction_force(body)[1],
                base_reaction(simulation),
                simulation.damping_impulse(body),
                contact.largest_gap};
    }
    double unbalanced_share(double dt) override { return mpm::unbalanced_share(simulation, dt); }
    Extremes pore_pressures() override { return mpm::pore_pressures(simulation); }
    double water_mass() override { return mpm::water_mass(simulation); }
    void save(std::ostream& out) const override { mpm::save(simulation, out); }
    void restore(std::istream& in, OtherBits bits) override { mpm::restore(simulation, in, bits); }

  private:
    Simulation& simulation;
};

Subject::Bodies PlaneSubject::measure(double gravity, std::size_t driven) {
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
            sums[weight].add(gravity * q[column::mass][p], fixed_point);
            sums[stiffness].add(modulus * q[column::V0][p], fixed_point);
            if (i == driven) sums[mass].add(q[column::mass][p], fixed_point);
            out.fastest2 = std::max(out.fastest2, modulus * q[column::V0][p] / q[column::mass][p]);
        }
    }
    simulation.shared().sum(sums, fixed_point);
    simulation.shared().max(&out.fastest2, 1);
    out.weight = sums[weight].value();
    out.stiffness = sums[stiffness].value();
    out.mass = sums[mass].value();
    return out;
}

}  // namespace

std::unique_ptr<Subject> subject_of(Simulation& simulation) {
    return std::make_unique<PlaneSubject>(simulation);
}

}  // namespace grit::mpm
