// SPDX-License-Identifier: BSD-3-Clause
#include "bars/bar.hpp"

namespace bars {
namespace {

template <class Quantity> double sum(const Bar& bar, Quantity quantity) {
    double total = 0.0;
    for (const Particle& p : bar.particles) total += quantity(p);
    return total;
}

}  // namespace

double Bar::mass() const {
    return sum(*this, [](const Particle& p) { return p.mass; });
}

double Bar::momentum() const {
    return sum(*this, [](const Particle& p) { return p.mass * p.v; });
}

double Bar::energy() const {
    return sum(*this, [&](const Particle& p) {
        double stored = 0.5 * p.sigma * p.sigma / modulus;
        if (shear_modulus > 0.0) stored += 0.5 * p.tau * p.tau / shear_modulus;
        return 0.5 * p.mass * (p.v * p.v + p.slip_v * p.slip_v) + p.volume * stored;
    });
}

double Bar::mean_slip() const {
    return sum(*this, [](const Particle& p) { return p.mass * p.slip; }) / mass();
}

double Bar::mean_slip_v() const {
    return sum(*this, [](const Particle& p) { return p.mass * p.slip_v; }) / mass();
}

Bar make_bar(double from, double to, int particles, double density) {
    Bar bar;
    const double length = (to - from) / particles;
    for (int i = 0; i < particles; ++i) {
        Particle p{};
        p.x = from + (i + 0.5) * length;
        p.length = p.volume = length;
        p.mass = density * length;
        p.stretch = 1.0;
        bar.particles.push_back(p);
    }
    return bar;
}

}  // namespace bars
