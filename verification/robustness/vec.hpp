// SPDX-License-Identifier: BSD-3-Clause
// Vectors of three components, in the plane the third is 0.
#pragma once

#include <array>
#include <cmath>
#include <cstring>

#include "support/trials/split_mix.hpp"

namespace robustness {

using Vec = std::array<double, 3>;

inline double dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline double norm(const Vec& a) { return std::hypot(a[0], a[1], a[2]); }  // of the smallest too
inline Vec plus(const Vec& a, double s, const Vec& b) {
    return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}
inline bool same(const Vec& a, const Vec& b) { return std::memcmp(&a, &b, sizeof a) == 0; }
inline bool all_finite(const Vec& a) {
    return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]);
}
inline Vec random_vector(grit::SplitMix& random, int components) {
    return {random.normal(), random.normal(), components == 3 ? random.normal() : 0.0};
}
inline Vec unit(Vec v) {
    const double size = norm(v);
    for (double& each : v) each /= size;
    return v;
}
// Every tenth along an axis.
inline Vec random_normal(grit::SplitMix& random, int components) {
    Vec n = unit(random_vector(random, components));
    if (random.below(10) == 0) {
        n = {};
        n[static_cast<std::size_t>(random.below(components))] = random.below(2) ? 1.0 : -1.0;
    }
    return n;
}
// About the third axis.
inline Vec turned(const Vec& a, double angle) {
    const double cosine = std::cos(angle), sine = std::sin(angle);
    return {cosine * a[0] - sine * a[1], sine * a[0] + cosine * a[1], a[2]};
}

}  // namespace robustness
