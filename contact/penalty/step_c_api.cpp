// SPDX-License-Identifier: BSD-3-Clause
// How stiff a contact is, and the step it allows, (S2) and (S5).
#include <limits>

#include "contact/penalty/area.hpp"
#include "contact/penalty/call_checks.hpp"

namespace grit::penalty {
namespace {

// The largest k_i / m_i of a body [1 / time^2].
grit_status largest_ratio(std::ptrdiff_t n, const grit_view* mass, const grit_view* stiffness,
                          const char* name, double& ratio, grit_error* error) {
    ratio = 0.0;
    GRIT_CHECK(check_count(n, {name, "n"}, error, " nodes"));
    if (n == 0) return GRIT_OK;
    static constexpr grit_view none{};
    GRIT_CHECK(check_base(mass ? *mass : none, {name, "mass"}, error));
    GRIT_CHECK(check_base(stiffness ? *stiffness : none, {name, "stiffness"}, error));
    for (std::ptrdiff_t i = 0; i < n; ++i) {
        const double m = component(*mass, i, 0), k = component(*stiffness, i, 0);
        if (!(k >= 0.0 && k <= std::numeric_limits<double>::max()))
            return failure(error, GRIT_BAD_STATE, i,
                           "%s node %td: stiffness must be >= 0 and finite (force / length), "
                           "got %g",
                           name, i, k);
        if (k == 0.0) continue;
        if (!(m > 0.0 && m <= std::numeric_limits<double>::max()))
            return failure(error, GRIT_BAD_STATE, i,
                           "%s node %td: mass must be > 0 and finite (mass) where there is "
                           "stiffness, got %g",
                           name, i, m);
        ratio = std::max(ratio, k / m);
    }
    return GRIT_OK;
}

}  // namespace
}  // namespace grit::penalty

using namespace grit;
using namespace grit::penalty;

extern "C" {

grit_status grit_penalty_stiffness(double multiple, double modulus, double cell_size,
                                   double* normal_stiffness) {
    if (!(multiple >= 0.0 && multiple <= 1e6 && modulus > 0.0 && cell_size > 0.0 &&
          normal_stiffness))
        return GRIT_BAD_CALL;
    const double eps_n = (multiple == 0.0 ? 1.0 : multiple) * modulus / cell_size;
    if (!(eps_n > 0.0 && eps_n <= 1e60)) return GRIT_BAD_CALL;
    *normal_stiffness = eps_n;
    return GRIT_OK;
}

grit_status grit_penalty_flush_stiffness(const grit_penalty_options* options,
                                         const grit_penalty_surface* surface, grit_error* error) {
    grit_penalty_options o{};
    grit_penalty_surface s{};
    GRIT_CHECK(read_options(options, o, error));
    GRIT_CHECK(read_surface(surface, "surface", s, error));
    GRIT_CHECK(check_output(s.stiffness, 1, {"surface", "stiffness"}, error));
    const Geometry geometry{s.count, s.closed == 1, o.axisymmetric == 1, s.position};
    GRIT_CHECK(check_vertices(geometry, "surface", error));
    const double eps =
        std::max(o.normal_stiffness, o.friction_coefficient > 0.0 ? o.tangential_stiffness : 0.0);
    const ptrdiff_t segments = s.closed ? s.count : s.count - 1;
    for (ptrdiff_t j = 0; j < segments; ++j) {
        const ptrdiff_t end = j + 1 < s.count ? j + 1 : 0;
        const Vector2 x_0 = vector_of(s.position, j), x_1 = vector_of(s.position, end);
        const double length = norm(x_1 - x_0);
        component(s.stiffness, j, 0) +=
            eps * half_segment_area(length, x_0[0], x_1[0], geometry.axisymmetric);
        component(s.stiffness, end, 0) +=
            eps * half_segment_area(length, x_1[0], x_0[0], geometry.axisymmetric);
    }
    return GRIT_OK;
}

grit_status grit_penalty_stable_step(ptrdiff_t n_a, const grit_view* mass_a,
                                     const grit_view* stiffness_a, ptrdiff_t n_b,
                                     const grit_view* mass_b, const grit_view* stiffness_b,
                                     double* step, grit_error* error) {
    GRIT_CHECK(check_given(step, "step", error));
    double ratio_a = 0.0, ratio_b = 0.0;
    GRIT_CHECK(largest_ratio(n_a, mass_a, stiffness_a, "body a", ratio_a, error));
    GRIT_CHECK(largest_ratio(n_b, mass_b, stiffness_b, "body b", ratio_b, error));
    const double squared = ratio_a + ratio_b;
    *step = squared > 0.0 ? 2.0 / std::sqrt(squared)  // (S5)
                          : std::numeric_limits<double>::infinity();
    return GRIT_OK;
}
}
