// SPDX-License-Identifier: BSD-3-Clause
// A straight bar of one column of particles across the contact: elastic along the line and in shear, so
// that it can be pushed, be slid, and rest on something.
#pragma once

#include <cstddef>
#include <vector>

namespace bars {

struct Particle {
    double x;              // centre [m], along the line
    double length;         // current [m]
    double mass;           // per cross-section [kg/m2]
    double volume;         // initial length [m]
    double v = 0.0;        // velocity along the line [m/s]
    double slip_v = 0.0;   // velocity across it [m/s]
    double slip = 0.0;     // displacement across the line [m]
    double stretch = 1.0;  // F [-]
    double sigma = 0.0;    // stress along the line, tension + [Pa]
    double tau = 0.0;      // shear stress [Pa]
};

struct Bar {
    std::vector<Particle> particles;  // from left to right
    double modulus = 0.0;             // E [Pa]
    double shear_modulus = 0.0;       // G [Pa]
    double weight = 0.0;              // acceleration along the line [m/s2]
    double slip_weight = 0.0;         // acceleration across it [m/s2]
    bool rigid = false;               // keeps its velocity

    double left() const { return particles.front().x - 0.5 * particles.front().length; }
    double right() const { return particles.back().x + 0.5 * particles.back().length; }
    double mass() const;
    double momentum() const;
    double energy() const;  // kinetic and elastic [J/m2]
    double mean_slip() const;
    double mean_slip_v() const;
};

Bar make_bar(double from, double to, int particles, double density);

}  // namespace bars
