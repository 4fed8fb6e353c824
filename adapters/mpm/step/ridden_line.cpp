// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/ridden_line.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "adapters/mpm/step/contact_zone.hpp"
#include "adapters/mpm/step/text.hpp"

namespace grit::mpm {
namespace {

constexpr int most_points = 1 << 18;  // far more than a body of particles has cells at its surface

// Points of a line, none farther from the next one than this.
std::vector<Vector2> divided(const BoundaryLine& line, double longest) {
    std::vector<Vector2> out;
    const std::size_t n = line.points.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vector2 from = line.points[i], along = line.points[(i + 1) % n] - from;
        out.push_back(from);
        if (i + 1 == n && !line.closed) break;
        const double parts = std::ceil(norm(along) / longest * (1.0 - 1e-9));
        if (!(static_cast<double>(out.size()) + parts <= most_points))
            throw std::invalid_argument("the surface line of a contact has a segment of " +
                                        text(norm(along)) + " m: without any beyond " +
                                        text(longest) + " m, the shortest cell, it has more than " +
                                        std::to_string(most_points) + " points");
        for (double k = 1.0; k < parts; k += 1.0) out.push_back(from + (k / parts) * along);
    }
    return out;
}

}  // namespace

RiddenLine::RiddenLine(const BoundaryLine& line, double longest)
    : start(divided(line, longest)), riders(start.size()), closed(line.closed) {}

void RiddenLine::find_riders(const ParticleView& q, std::ptrdiff_t count, const int* ids,
                             Exchange& exchange) {
    if (empty() || has_riders()) return;
    const auto way = [&](std::size_t v, std::ptrdiff_t p) {
        return Vector2{start[v][0] - q[column::r][p], start[v][1] - q[column::z][p]};
    };
    find_nearest(
        riders, count, ids, exchange, [&](std::ptrdiff_t p) { return q[column::r][p]; }, way,
        [&](std::size_t v, std::ptrdiff_t p, double* from) {
            from[0] = way(v, p)[0] / q[column::l_r][p];
            from[1] = way(v, p)[1] / q[column::l_z][p];
        });
}

void RiddenLine::place(std::span<const KeyedNumbers> domains, std::vector<double>& position,
                       std::vector<std::ptrdiff_t>& facet,
                       std::vector<std::ptrdiff_t>& owner) const {
    position.clear();
    facet.clear();
    owner.clear();
    constexpr std::ptrdiff_t lost = -1;
    std::ptrdiff_t first = lost, before = lost, count = 0, first_domain = lost;
    for (std::size_t i = 0; i < riders.size(); ++i) {
        const Seat& rider = riders[i];
        const auto found = std::lower_bound(
            domains.begin(), domains.end(), rider.id,
            [](const KeyedNumbers& x, std::int64_t id) { return ContactZone::id_of(x) < id; });
        if (found == domains.end() || ContactZone::id_of(*found) != rider.id) {
            before = lost;
            continue;
        }
        const auto& d = found->value;
        using namespace near_domain;
        position.push_back(d[r] + rider.from[0] * d[r1r] + rider.from[1] * d[r2r]);
        position.push_back(d[z] + rider.from[0] * d[r1z] + rider.from[1] * d[r2z]);
        const std::ptrdiff_t domain = found - domains.begin();
        if (before != lost) {
            facet.insert(facet.end(), {before, count});
            owner.push_back(domain);
        }
        if (i == 0) {
            first = count;
            first_domain = domain;
        }
        before = count++;
    }
    if (closed && first != lost && before != lost && before != first) {
        facet.insert(facet.end(), {before, first});
        owner.push_back(first_domain);
    }
}

}  // namespace grit::mpm
