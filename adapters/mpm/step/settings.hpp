// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "adapters/mpm/kernel/pore_water.hpp"

namespace grit::mpm {

enum class Scheme {
    usl,   // stress last, by the velocities of the momentum update
    musl,  // ... by velocities mapped back from the particles
    usf    // stress first
};

struct Settings {
    bool axisymmetric = true;
    Shape shape = Shape::cpdi;
    Scheme scheme = Scheme::usl;
    double cfl = 0.4;                                               // share of cell / (c + v) [-]
    double largest_step = std::numeric_limits<double>::infinity();  // [s]
    double pic_rate = 0.0;                                          // 1 - FLIP = pic_rate dt [1/s]
    double local_damping = 0.0;                                     // share of the nodal force [-]
    double gravity_r = 0.0, gravity_z = 0.0;                        // [m/s2]
    // Bulk viscosity: rho l (linear c |rate| + quadratic l rate^2) in compression [-].
    double linear_viscosity = 0.0, quadratic_viscosity = 0.0;
    bool cell_mean = false;        // of the volumetric strain of a step, against locking
    bool reduced_domains = false;  // of sand, where shear draws them out
    // Sums over particles and nodes in integers: no order, no threads and no processes change a bit.
    bool fixed_point = false;
    int threads = 1;
};

struct Body {
    std::string name;
    Particles particles;
    std::unique_ptr<Material> material;
    std::optional<PoreWater> water = {};
    // A rigid body moves as this says, over time [s]; empty: free.
    std::function<Vector2(double)> prescribed_velocity;
    bool rigid() const { return static_cast<bool>(prescribed_velocity); }
};

// Sums since the start [J]; each counted where it happens.
struct Energy {
    double kinetic = 0.0, stored = 0.0;      // now
    double kinetic_0 = 0.0, stored_0 = 0.0;  // at the start
    double external_work = 0.0;  // tractions, body forces, held forces of absorbing sides
    double traction_work = 0.0;  // that of tractions alone
    double rigid_work = 0.0;     // of bodies with prescribed motion, by contact
    double contact = 0.0;        // taken in contact, leapfrog value
    double damping = 0.0;        // local damping
    double viscosity = 0.0;      // bulk viscosity
    double absorbed = 0.0;       // taken by absorbing sides
    double transfer = 0.0;       // lost between nodes and particles, PIC share included
    double pic = 0.0;            // that share alone
    double pore_water = 0.0;     // taken by the compression of pore water
    double half = 0.0;      // ... by pressures that velocities, half a step behind, do not know yet
    double drag = 0.0;      // of pore water against grains
    double implicit = 0.0;  // what an implicit pore pressure takes, of waves and of checkerboards
    double carried = 0.0;   // kinetic energy that water takes along where it leaves pores

    // The first term that is infinite or no number any more; null: none.
    const char* not_finite() const {
        const struct {
            const char* name;
            double value;
        } terms[] = {{"kinetic", kinetic},
                     {"stored", stored},
                     {"contact", contact},
                     {"damping", damping},
                     {"viscosity", viscosity},
                     {"absorbed", absorbed},
                     {"transfer", transfer},
                     {"pore water", pore_water},
                     {"drag", drag},
                     {"implicit pressure", implicit},
                     {"carried by pore water", carried},
                     {"external work", external_work},
                     {"rigid work", rigid_work}};
        for (const auto& term : terms)
            if (!std::isfinite(term.value)) return term.name;
        return nullptr;
    }
    // Throws std::runtime_error if there is one. t: of the step that it came from [s].
    void check_finite(double t) const {
        if (const char* name = not_finite())
            throw std::runtime_error("the energy balance is broken at t = " + std::to_string(t) +
                                     " s: its term " + name +
                                     " is infinite or no number; is cfl too large?");
    }
    double residual() const {
        return kinetic - kinetic_0 + stored - stored_0 + contact + damping + viscosity + absorbed +
               transfer + pore_water - half + drag + implicit + carried - external_work -
               rigid_work;
    }
};

}  // namespace grit::mpm
