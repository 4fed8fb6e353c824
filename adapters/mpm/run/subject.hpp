// SPDX-License-Identifier: BSD-3-Clause
// What a run moves on and looks at: a simulation in the plane or in space. Forces and energies are per radian or per
// metre in the plane, and of all that is computed in space; forces are along z.
#pragma once

#include <array>
#include <iosfwd>
#include <memory>

#include "adapters/mpm/case/build_case.hpp"
#include "adapters/mpm/io/checkpoint.hpp"
#include "adapters/mpm/run/measures.hpp"
#include "adapters/mpm/step/stopwatch.hpp"

namespace grit::mpm {

class Subject {
  public:
    virtual ~Subject() = default;
    virtual void step() = 0;
    virtual double time() const = 0;
    virtual long steps() const = 0;
    virtual Seconds seconds() const = 0;
    virtual Energy energy() = 0;
    virtual double shortest_cell() const = 0;
    virtual void apply(const Case& plan, const StagePlan& stage) = 0;
    // Of what is restored: how steps are taken, where the case says that otherwise now.
    virtual void take_steps(const Case& plan, const StagePlan& stage) = 0;

    // Sums over all particles of free bodies.
    struct Bodies {
        std::ptrdiff_t particles = 0;  // rigid ones too
        double weight = 0.0;           // [N]
        double stiffness = 0.0;        // wave moduli times volumes [J]
        double mass = 0.0;             // of the driven body [kg]
        double fastest2 = 0.0;         // largest square of a wave's speed [m2/s2]
    };
    virtual Bodies measure(double gravity, std::size_t driven) = 0;
    virtual bool rigid(std::size_t body) const = 0;
    virtual double level(std::size_t body, DepthOf what) = 0;
    // Of a rigid body as it is prescribed now, of another one of its centre of mass.
    virtual double velocity_z(std::size_t body) = 0;
    virtual double stored_energy(std::size_t body) = 0;
    // Of the last step, upwards [N]: of contacts on a body where it faces down or up and where it faces sideways, of
    // tractions on it, of the bottom of the grid on all bodies; of local damping [N s].
    struct Forces {
        double tip = 0.0, shaft = 0.0, traction = 0.0, base = 0.0, damping_impulse = 0.0;
        double largest_gap = 0.0;  // between bodies at a node of both [m]; NaN: not measured
        // In space, of contacts along x, y and z [N s] and their moments about the origin [N m s].
        std::array<double, 6> contact_impulse{};
    };
    virtual Forces forces(std::size_t body) = 0;
    // Impulses of contacts on a body in the last step, of this process [N s]; in the plane none.
    virtual void add_profile(std::size_t /*body*/, const ProfilePlan& /*profile*/,
                             std::vector<double>& /*impulses*/) {}
    virtual double unbalanced_share(double dt) = 0;
    virtual Extremes pore_pressures() = 0;
    virtual double water_mass() = 0;

    // As in checkpoint.hpp.
    virtual void save(std::ostream& out) const = 0;
    virtual void restore(std::istream& in, OtherBits bits) = 0;
};

template <class Simulated>
void take_steps_as(const Case& plan, const StagePlan& stage, Simulated& simulation) {
    const auto was = simulation.current_settings();
    if (was.local_damping != stage.local_damping) simulation.set_local_damping(stage.local_damping);
    if (was.pic_rate != stage.pic_rate) simulation.set_pic_rate(stage.pic_rate);
    if (was.cfl != stage.cfl) simulation.set_cfl(stage.cfl);
    if (was.largest_step != plan.settings.largest_step)
        simulation.set_largest_step(plan.settings.largest_step);
}

// They outlive it.
std::unique_ptr<Subject> subject_of(Simulation& simulation);
std::unique_ptr<Subject> subject_of(space::Simulation& simulation);

}  // namespace grit::mpm
