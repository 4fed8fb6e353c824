// SPDX-License-Identifier: BSD-3-Clause
// The motion of a rigid body in space. Each of its six degrees of freedom is prescribed over time, or free: then weight,
// loads and contact move it, by Newton's and Euler's laws for the mass of its particles.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "adapters/mpm/kernel/exchange.hpp"
#include "adapters/mpm/space/kernel/particles.hpp"

namespace grit::mpm::space {

using Matrix6 = std::array<std::array<double, 6>, 6>;  // along and about x, y and z

// Velocity of a body and its angular velocity about the centre [m/s], [rad/s]; or impulse and its moment [N s], [N m s].
struct Twist {
    Vector3 along{0.0, 0.0, 0.0}, about{0.0, 0.0, 0.0};
};

// The sum of many, in double or in fixed point.
class TwistSum {
  public:
    explicit TwistSum(bool in_fixed_point) : fixed_point(in_fixed_point) {}
    void add(const Twist& more) {
        for (std::size_t k = 0; k < 3; ++k) {
            of[k].add(more.along[static_cast<int>(k)], fixed_point);
            of[k + 3].add(more.about[static_cast<int>(k)], fixed_point);
        }
    }
    Twist of_all(Exchange& exchange) {
        exchange.sum(of, fixed_point);
        return {{of[0].value(), of[1].value(), of[2].value()},
                {of[3].value(), of[4].value(), of[5].value()}};
    }

  private:
    std::array<Total, 6> of;
    bool fixed_point;
};

struct RigidCourse {
    std::function<Vector3(double)> velocity = {};  // over time [m/s]
    std::function<Vector3(double)> spin = {};      // about the centre [rad/s]; empty: none
    std::array<bool, 6> free = {};                 // ... but these, which ask for neither
    std::function<bool(double)> has_begun = {};    // before, nothing moves; empty: always
    std::optional<Vector3> centre = {};            // at the start [m]; none: of mass
    Twist start = {};                              // of what is free
};

class RigidMotion {
  public:
    // Mass and inertia are those of the particles of all processes, as bricks. exchange: of these; null: there is one.
    RigidMotion(const RigidCourse& plan, const ParticleView& particles, std::ptrdiff_t count,
                bool fixed_point = false, Exchange* exchange = nullptr);
    // At the start. Throws std::invalid_argument where something is free and the centre is not that of mass.
    void check_centre() const;

    bool any_free() const;
    // Once it has begun.
    const std::array<bool, 6>& to_be_free() const { return plan.free; }
    // To the velocities of the end of a step of dt that ends at t: prescribed ones as they are then, free ones as weight
    // and loads (force and moment about the centre, over dt) leave them.
    void begin(double t, double dt, const Vector3& gravity, const Twist& load_impulse);
    // An impulse of contact in this step, its moment about the centre.
    void push(const Twist& impulse);
    // What a unit of each free velocity takes of impulse: the mass matrix; rows and columns of what is prescribed are
    // those of the unit matrix.
    Matrix6 mass_matrix() const;
    // Moves centre and orientation on to the end of the step.
    void finish(double dt);

    // Now, at the end of the step that has begun; before its weight, loads and contact.
    const Twist& velocity() const { return now; }
    const Twist& velocity_before() const { return before; }
    Vector3 velocity_at(const Vector3& x) const { return at(now, x); }
    Vector3 velocity_before_at(const Vector3& x) const { return at(before, x); }
    // Of the last step that was finished: x -> centre + turn (x - centre before).
    Vector3 moved(const Vector3& x) const;
    Vector3 turned(const Vector3& r) const;

    // Now; before it has begun nothing is.
    const std::array<bool, 6>& free() const { return is_free; }
    const Vector3& centre() const { return middle; }
    double mass() const { return total; }
    double kinetic_energy() const;
    // What of it a body that begins in this step brings along with what it starts with.
    double energy_of_start() const { return brought; }
    // What changes its free velocities in this step, as a share of all that acts on it: 1 where it falls, 0 at rest.
    double unbalanced_share() const;
    // No point of it is faster [m/s]: as prescribed at t, as free now.
    double speed(double t) const;

    template <class Self, class Archive> static void visit(Self& body, Archive& archive) {
        archive.value(body.total);
        archive.value(body.reach);
        archive.value(body.inertia_at_start);
        archive.value(body.middle);
        archive.value(body.now);
        archive.value(body.spin_momentum);
        archive.value(body.orientation);
        archive.value(body.is_free);
    }

  private:
    using Matrix3 = std::array<Vector3, 3>;  // rows
    bool has_begun(double t) const;
    // What is free as given, the others as they are told at t.
    Twist as_told(double t, const Twist& given, const std::array<bool, 6>& free) const;
    Vector3 at(const Twist& u, const Vector3& x) const;
    Matrix3 inertia() const;
    void find_spin();

    RigidCourse plan;
    std::array<bool, 6> is_free = {};
    double total = 0.0, reach = 0.0;
    Matrix3 inertia_at_start = {};
    double off_mass = 0.0;  // of the centre at the start [m]
    Vector3 middle{0.0, 0.0, 0.0}, middle_before{0.0, 0.0, 0.0};
    Matrix3 orientation = {}, turn = {};
    Twist now, before;
    // About the centre; of what is free alone it is kept [kg m2/s].
    Vector3 spin_momentum{0.0, 0.0, 0.0}, spin_momentum_before{0.0, 0.0, 0.0};
    double brought = 0.0;  // [J]
    double acted = 0.0;    // sum of the impulses of this step [N s]
};

}  // namespace grit::mpm::space
