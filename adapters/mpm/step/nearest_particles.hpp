// SPDX-License-Identifier: BSD-3-Clause
// What rides on particles: each place on the one of all processes that is nearest to it.
#pragma once

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "adapters/mpm/kernel/exchange.hpp"

namespace grit::mpm {

// A place that rides on a particle, where from it the process that has that one told.
template <int numbers> struct Rider {
    static constexpr std::int64_t none = -1;
    std::int64_t id = none;
    double from[numbers] = {};
};

// Of several particles that are as near the one with the least id; all processes that share the grid call it, with
// count particles of their own. way(place, particle): from that to the place [m]; from(place, particle, numbers) of the
// rider; across(particle): where it is along the first direction. Where there is no particle, riders stay as they are.
template <int numbers, class Across, class Way, class From>
void find_nearest(std::vector<Rider<numbers>>& riders, std::ptrdiff_t count, const int* ids,
                  Exchange& exchange, const Across& across, const Way& way, const From& from) {
    constexpr double unknown = -std::numeric_limits<double>::infinity();
    const std::size_t places = riders.size();
    // By maxima: of what is near, of what comes first, and of what one process alone knows.
    std::vector<std::ptrdiff_t> mine(places, -1);
    std::vector<double> close(places, unknown), first(places, unknown);
    std::vector<double> told(numbers * places, unknown);
    std::vector<std::ptrdiff_t> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    // An order of what is no number, too, as a state from outside may have.
    std::sort(order.begin(), order.end(), [&](std::ptrdiff_t p, std::ptrdiff_t q) {
        return std::strong_order(across(p), across(q)) < 0;
    });
    for (std::size_t v = 0; v < places && count > 0; ++v) {
        // False: this one is farther along one direction than another one is in all, as are those behind it.
        const auto look_at = [&](std::ptrdiff_t p) {
            const auto x = way(v, p);
            if (std::fabs(x[0]) > -close[v]) return false;
            const double here = -norm(x);
            const bool is_first = mine[v] >= 0 && here == close[v] && ids[p] < ids[mine[v]];
            if (here > close[v] || is_first) {
                close[v] = here;
                mine[v] = p;
            }
            return true;
        };
        const double at = across(order[0]) + way(v, order[0])[0];
        const auto middle =
            std::lower_bound(order.begin(), order.end(), at,
                             [&](std::ptrdiff_t p, double x) { return across(p) < x; });
        for (auto up = middle; up != order.end() && look_at(*up);) ++up;
        for (auto down = middle; down != order.begin() && look_at(*(down - 1));) --down;
    }
    const std::vector<double> close_here = close;
    exchange.max(close.data(), static_cast<int>(places));
    for (std::size_t v = 0; v < places; ++v)
        if (mine[v] >= 0 && close_here[v] == close[v]) first[v] = -ids[mine[v]];
    const std::vector<double> first_here = first;
    exchange.max(first.data(), static_cast<int>(places));
    for (std::size_t v = 0; v < places; ++v)
        if (first_here[v] != unknown && first_here[v] == first[v])
            from(v, mine[v], &told[numbers * v]);
    exchange.max(told.data(), static_cast<int>(told.size()));
    for (std::size_t v = 0; v < places; ++v) {
        if (first[v] == unknown) continue;
        riders[v].id = static_cast<std::int64_t>(-first[v]);
        std::copy_n(&told[numbers * v], numbers, riders[v].from);
    }
}

}  // namespace grit::mpm
