// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/integer_sums.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

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

}  // namespace

void fail_share(const std::string& body, const ParticleColumns& particles,
                const std::vector<std::string>& columns, const char* of_what, double t) {
    std::string place;
    for (std::ptrdiff_t p = 0; p < particles.size() && place.empty(); ++p)
        for (int c = 0; c < particles.column_count() && place.empty(); ++c)
            if (!std::isfinite(particles(c, p)))
                place = ": particle " + std::to_string(particles.ids()[p]) + " has " +
                        columns[static_cast<std::size_t>(c)] + " = " + text(particles(c, p));
    throw std::runtime_error("body " + body + ": a particle's share of the " + of_what +
                             " of nodes is infinite or no number at t = " + text(t) + " s" + place);
}

template <int lanes> void IntegerSums<lanes>::resize(std::size_t nodes, int of_parts) {
    integers.resize(nodes);
    parts.resize(static_cast<std::size_t>(of_parts));
    scale.fill(1.0);
}

template <int lanes> void IntegerSums<lanes>::begin() {
    clear(0, integers.size());
    begin_parts();
}

template <int lanes> void IntegerSums<lanes>::clear(std::size_t begin, std::size_t end) {
    std::fill(integers.data() + begin, integers.data() + end, IntegersOf<lanes>{});
}

template <int lanes> void IntegerSums<lanes>::begin_parts() {
    for (FixedPointOf<lanes>& part : parts) {
        part = {};
        part.nodes = integers.data();
        std::copy(scale.begin(), scale.end(), part.scale);
    }
}

template <int lanes>
auto IntegerSums<lanes>::check(unsigned components, Exchange& exchange) -> Check {
    std::array<double, lanes> largest{};
    for (const FixedPointOf<lanes>& part : parts)
        for (std::size_t c = 0; c < largest.size(); ++c)
            // A maximum over processes need not know what is no number.
            largest[c] =
                part.largest[c] <= infinite ? std::max(largest[c], part.largest[c]) : infinite;
    exchange.max(largest.data(), lanes);
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

template <int lanes>
void IntegerSums<lanes>::add_to(double* records, std::size_t begin, std::size_t end) const {
    for (std::size_t i = begin; i < end; ++i)
        for (std::size_t c = 0; c < lanes; ++c)
            records[lanes * i + c] += static_cast<double>(integers[i].value[c]) / scale[c];
}

template class IntegerSums<4>;
template class IntegerSums<8>;

}  // namespace grit::mpm
