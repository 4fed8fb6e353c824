// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/integer_records.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "adapters/mpm/step/column_names.hpp"
#include "adapters/mpm/step/text.hpp"

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

// The first number of a body that is none; another process may have it.
std::string place_of_failure(Body& body) {
    const std::vector<std::string> names =
        column_names(body.material.get(), body.water ? &*body.water : nullptr);
    const ParticleView q = body.particles.view();
    for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p)
        for (int c = 0; c < body.particles.column_count(); ++c)
            if (!std::isfinite(q[c][p]))
                return ": particle " + std::to_string(body.particles.ids()[p]) + " has " +
                       names[static_cast<std::size_t>(c)] + " = " + text(q[c][p]);
    return {};
}

}  // namespace

void fail_share(Body& body, const char* of_what, double t) {
    throw std::runtime_error("body " + body.name + ": a particle's share of the " + of_what +
                             " of nodes is infinite or no number at t = " + text(t) + " s" +
                             place_of_failure(body));
}

void IntegerRecords::resize(std::size_t nodes, int of_strips) {
    integers.resize(nodes);
    strips.resize(static_cast<std::size_t>(of_strips));
    scale.fill(1.0);
}

void IntegerRecords::begin() {
    std::fill(integers.begin(), integers.end(), NodeIntegers{});
    for (FixedPoint& strip : strips) {
        strip = {};
        strip.nodes = integers.data();
        std::copy(scale.begin(), scale.end(), strip.scale);
    }
}

IntegerRecords::Check IntegerRecords::check(unsigned components, Exchange& exchange) {
    std::array<double, record::size> largest{};
    for (const FixedPoint& strip : strips)
        for (std::size_t c = 0; c < largest.size(); ++c)
            // A maximum over processes need not know what is no number.
            largest[c] =
                strip.largest[c] <= infinite ? std::max(largest[c], strip.largest[c]) : infinite;
    exchange.max(largest.data(), record::size);
    Check out;
    for (std::size_t c = 0; c < largest.size(); ++c) {
        if (!(components & 1u << c)) continue;
        const double wanted = scale_for(largest[c], scale[c]);
        if (wanted != scale[c]) out.again = true;
        else if (!(largest[c] < infinite) && out.failed < 0) out.failed = static_cast<int>(c);
        scale[c] = wanted;
    }
    return out;
}

void IntegerRecords::add_to(std::vector<NodeRecord>& records, Exchange& exchange) {
    exchange.sum_nodes(integers.data(), static_cast<std::ptrdiff_t>(integers.size()));
    add_to(records.data());
}

void IntegerRecords::add_to(NodeRecord* records, int each, Exchange& exchange) {
    exchange.sum_cells(integers.data(), static_cast<std::ptrdiff_t>(integers.size()) / each, each);
    add_to(records);
}

void IntegerRecords::add_to(NodeRecord* records) const {
    for (std::size_t i = 0; i < integers.size(); ++i)
        for (int c = 0; c < record::size; ++c)
            records[i][c] +=
                static_cast<double>(integers[i].value[c]) / scale[static_cast<std::size_t>(c)];
}

}  // namespace grit::mpm
