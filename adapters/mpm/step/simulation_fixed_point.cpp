// SPDX-License-Identifier: BSD-3-Clause
// Nodal sums in fixed point. Each quantity of a body has a scale of its own, which follows the largest
// contribution: where one is too large, or all are too small, the sums are done again.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "adapters/mpm/io/column_names.hpp"
#include "adapters/mpm/io/text.hpp"
#include "adapters/mpm/step/simulation.hpp"

namespace grit::mpm {
namespace {

constexpr int aim = 48;                // bits of the largest contribution after a change of scale
constexpr double least_size = 0x1p42;  // ... and what it may shrink to
// At the coarsest scale every finite contribution is within the limit. The finest one has a reciprocal.
constexpr int coarsest = -975, finest = 1000;
static_assert(std::numeric_limits<double>::max() * 0x1p-975 < FixedPoint::limit);

constexpr double infinite = std::numeric_limits<double>::infinity();

// The scale for contributions of which the largest is so large at this one; the same: they fit. After
// at most three changes they do.
double scale_for(double largest, double scale) {
    if (largest == 0.0)
        return std::max(scale, 1.0);  // at a coarse scale it may be too small to see
    if (!(largest < infinite)) return std::ldexp(1.0, coarsest);
    if (largest >= least_size && largest < FixedPoint::limit) return scale;
    const int exponent = std::ilogb(scale) + aim - std::ilogb(largest);
    return std::ldexp(1.0, std::clamp(exponent, coarsest, finest));
}

unsigned part_of(std::size_t component) {
    switch (component) {
        case record::m: return part::mass;
        case record::p_r:
        case record::p_z: return part::momentum;
        case record::f_r:
        case record::f_z: return part::force;
        default: return part::gradient;
    }
}

const char* name_of(unsigned of_part) {
    switch (of_part) {
        case part::mass: return "mass";
        case part::momentum: return "momentum";
        case part::force: return "force";
        default: return "gradient of its mass";
    }
}

// The first number of a body that is none; another process may have it.
std::string place_of_failure(Body& body) {
    const std::vector<std::string> names = column_names(body.material.get());
    const ParticleView q = body.particles.view();
    for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p)
        for (int c = 0; c < body.particles.column_count(); ++c)
            if (!std::isfinite(q[c][p]))
                return ": particle " + std::to_string(body.particles.ids()[p]) + " has " +
                       names[static_cast<std::size_t>(c)] + " = " + text(q[c][p]);
    return {};
}

}  // namespace

// The scales that the contributions want; true if the sums must be done again. Throws where one is infinite
// or no number.
bool Simulation::rescale(unsigned parts_wanted, Into into) {
    bool again = false;
    for (Part& part : parts) {
        if (into == Into::ahead && part.ahead.empty()) continue;
        std::array<double, record::size> largest{};
        for (const FixedPoint& strip : part.fixed_points)
            for (std::size_t c = 0; c < largest.size(); ++c)
                // A maximum over processes need not know what is no number.
                largest[c] = strip.largest[c] <= infinite ? std::max(largest[c], strip.largest[c])
                                                          : infinite;
        exchange.max(largest.data(), record::size);
        for (std::size_t c = 0; c < largest.size(); ++c) {
            if (!(parts_wanted & part_of(c))) continue;
            const double scale = scale_for(largest[c], part.scale[c]);
            if (scale != part.scale[c]) again = true;
            else if (!(largest[c] < infinite))
                throw std::runtime_error("body " + part.body.name + ": a particle's share of the " +
                                         name_of(part_of(c)) +
                                         " of nodes is infinite or no number at t = " + text(t) +
                                         " s" + place_of_failure(part.body));
            part.scale[c] = scale;
        }
    }
    return again;
}

void Simulation::scatter_fixed(unsigned parts_wanted, Into into) {
    // The scale that all strips want.
    if (into == Into::ahead)
        for (Part& part : parts) std::fill(part.pressed.begin(), part.pressed.end(), 1);
    do {
        for (Part& part : parts) {
            std::fill(part.integers.begin(), part.integers.end(), NodeIntegers{});
            for (FixedPoint& strip : part.fixed_points) {
                strip = {};
                strip.nodes = part.integers.data();
                std::copy(part.scale.begin(), part.scale.end(), strip.scale);
            }
        }
        scatter_strips(parts_wanted, into);
    } while (rescale(parts_wanted, into));
    for (Part& part : parts) {
        if (into == Into::ahead && part.ahead.empty()) continue;
        std::vector<NodeRecord>& records = into == Into::ahead ? part.ahead : part.records;
        exchange.sum_nodes(part.integers.data(), static_cast<std::ptrdiff_t>(part.integers.size()));
        for (std::size_t i = 0; i < part.integers.size(); ++i)
            for (int c = 0; c < record::size; ++c)
                records[i][c] += static_cast<double>(part.integers[i].value[c]) /
                                 part.scale[static_cast<std::size_t>(c)];
    }
}

}  // namespace grit::mpm
