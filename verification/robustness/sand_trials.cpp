// SPDX-License-Identifier: BSD-3-Clause
#include "robustness/sand_trials.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <grit/grit.h>

#include "robustness/exact_rate.hpp"
#include "robustness/program_text.hpp"
#include "robustness/pulse.hpp"
#include "robustness/sand_calls.hpp"

namespace robustness {
namespace {

enum Count {
    updates,
    done,
    bad_states,
    not_converged,
    stress_free,
    void_clamped,
    outside_cone,
    h_clamped,
    rate_evaluations,
    published,
    retried,
    retried_through,
    retried_to_a_billionth,
    retried_out_of_states,
    retried_on_its_way,
    retried_published,
    retried_published_through,
    compared,
    over_tolerance,
    referred,
    referred_over,
    differences,
    differences_of_any,
    cycles,
    cycles_with_energy
};
enum Largest {
    evaluations_of_a_call,
    error_of_published,
    error_of_any,
    error_of_flagged,
    error_of_reference,
    h_of_reference,
    tangent_error,
    tangent_error_of_any,
    steps_of_a_retry
};
enum Rule {
    finite,
    untouched,
    at_rest,
    only_turned,
    same_bits,
    known_status,
    bounded,
    in_cone,
    h_in_its_radius,
    e_of_volume,
    estimate_positive,
    taken_again,
    retry_ends,
    retry_gets_through,
    error_bounded,
    estimate_tells,
    exact_stress,
    tangent_is_difference,
    tangent_is_that_of_reference,
    no_energy_of_nothing
};

const Vocabulary words = {
    {"updates of a point",
     "cases done",
     "refused for their state",
     "not converged",
     "done, stress-free",
     "done, e beyond its limits",
     "done, scaled back to the cone",
     "done, h scaled to R",
     "evaluations of the rate",
     "of published sands",
     "not converged, followed by smaller steps",
     "of these, done in the end",
     "of these, ended at a billionth of the strain",
     "of these, ended out of the range of states",
     "of these, on their way after 100000 steps",
     "of published sands, not converged, followed by smaller steps",
     "of these, done in the end",
     "compared with a tolerance of 1e-11",
     "of these, error above the tolerance",
     "compared with the long double reference",
     "of these, error above the tolerance of 1e-9",
     "tangents compared with differences",
     "tangents of any parameters compared with differences of the reference",
     "closed cycles from nothing",
     "of these, energy given"},
    {"evaluations of a call", "error over tolerance, published sands",
     "error over tolerance, any parameters",
     "error over tolerance, where the cone, h or nothing limits",
     "error against the reference, published sands", "error of h over R, published sands",
     "error of a tangent, published sands", "error of a tangent, any parameters",
     "steps that a failed strain was cut into"},
    {"results are finite",
     "a failed point keeps its bits",
     "without strain and rotation nothing changes",
     "without strain a rotation turns stress and h within 1e-12, no more",
     "a batch gives the bits of single calls, whatever its strides",
     "a status is one of a point's",
     "evaluations stay within their limit",
     "stress ends within the cone",
     "|h| ends within R (1 + 1e-12)",
     "e follows the volume to 1e-12",
     "the error estimate is not negative",
     "the next call takes the result",
     "following step_reduction ends",
     "following step_reduction takes published sands through, unless stress or e leave their range",
     "the error of published sands stays below 10 tolerances",
     "the error estimate of published sands is above a hundredth of an error above the tolerance",
     "stress and h of published sands are those of the reference within 1e-7",
     "the tangent of published sands is the difference of stresses within 1 %",
     "the tangent of any sand is the difference of the reference's stresses within 1 %",
     "no closed cycle of a published sand from nothing gives energy"}};

thread_local long updates_made = 0;

void update(const Call& call, const grit_sand_options& options, Point& x) {
    ++updates_made;
    beat();
    const grit_sand_points q = views_of(call, x);
    grit_sand_update(&call.sand, &options, 1, &q, &x.report, nullptr);
}
void update(const Call& call, Point& x) { update(call, call.options, x); }

// The same points in one call, in memory as a host may have it and in any order.
void update_together(Random& random, const Call& call, std::vector<Point>& points) {
    const auto n = static_cast<std::ptrdiff_t>(points.size());
    Scattered memory(random, call, n);
    memory.put(points);
    const grit_sand_points q = memory.views();
    std::vector<grit_sand_report> reports(points.size());
    grit_sand_update(&call.sand, &call.options, n, &q, reports.data(), nullptr);
    memory.get(points, reports);
}

// How far stresses are apart, over the larger of the norms that the tolerance refers to.
double stress_error(const Point& a, const Point& exact, const Point& before) {
    double apart[6];
    for (int c = 0; c < 6; ++c) apart[c] = a.stress[c] - exact.stress[c];
    return norm_of_stress(apart) /
           std::max({norm_of_stress(exact.stress), norm_of_stress(before.stress), 1e-300});
}

// Q A Q^T; shear: of the components over that of the tensor.
void turn(const double* Q, const double* a, double shear, double out[6]) {
    const double A[3][3] = {{a[0], a[3] / shear, a[4] / shear},
                            {a[3] / shear, a[1], a[5] / shear},
                            {a[4] / shear, a[5] / shear, a[2]}};
    constexpr int row[] = {0, 1, 2, 0, 0, 1}, column[] = {0, 1, 2, 1, 2, 2};
    for (int c = 0; c < 6; ++c) {
        out[c] = 0.0;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                out[c] += Q[3 * row[c] + i] * A[i][j] * Q[3 * column[c] + j];
        if (c >= 3) out[c] *= shear;
    }
}

// Without strain: stress and h follow the rotation, |h| above R is scaled to it.
bool is_only_turned(const Call& call, const Point& before, const Point& after) {
    double stress[6], h[6];
    std::copy(before.stress, before.stress + 6, stress);
    std::copy(before.state, before.state + 6, h);
    if (!call.options.stress_is_rotated) turn(before.rotation, before.stress, 1.0, stress);
    if (with_memory(call)) {
        turn(before.rotation, before.state, 2.0, h);
        const double length = norm_of_strain(h), R = call.parameters.elastic_strain_radius;
        for (double& each : h) each *= length > R ? R / length : 1.0;
    }
    const double size = norm_of_stress(stress), size_of_h = norm_of_strain(h);
    for (int c = 0; c < 6; ++c) {
        stress[c] -= after.stress[c];
        h[c] -= after.state[c];
    }
    return norm_of_stress(stress) <= 1e-12 * size && norm_of_strain(h) <= 1e-12 * size_of_h &&
           after.state[GRIT_SAND_VOID_RATIO] == before.state[GRIT_SAND_VOID_RATIO] &&
           after.state[GRIT_SAND_SEPARATION] == before.state[GRIT_SAND_SEPARATION];
}

// What holds for every update.
void judge(const Call& call, const Point& before, const Point& after, Findings& out) {
    const auto program = [&] { return program_of(call, before); };
    const grit_sand_report& r = after.report;
    out.count(rate_evaluations, r.evaluations);
    out.measure(evaluations_of_a_call, r.evaluations);
    out.demand(bounded, r.evaluations >= 0 && r.evaluations <= call.options.evaluation_limit,
               program);
    if (r.status != GRIT_OK) {
        out.count(r.status == GRIT_BAD_STATE ? bad_states : not_converged);
        const bool bad_call = !all_finite(before.strain, 6) ||
                              norm_of_strain(before.strain) > 1e3 ||
                              (call.rotated && !is_rotation(before.rotation));
        out.demand(known_status,
                   r.status == GRIT_BAD_STATE || r.status == GRIT_NOT_CONVERGED ||
                       (bad_call && r.status == GRIT_BAD_CALL),
                   program);
        out.demand(untouched, same(before, after), program);
        return;
    }
    out.count(done);
    const bool strained = norm_of_strain(before.strain) > 0.0;
    if (!strained && !call.rotated) {
        Point stress_and_state = after;
        std::copy(before.tangent, before.tangent + 36, stress_and_state.tangent);
        stress_and_state.substep = before.substep;
        out.demand(at_rest, same(before, stress_and_state), program);
        return;
    }
    const int flags[] = {GRIT_SAND_STRESS_FREE, GRIT_SAND_VOID_CLAMPED, GRIT_SAND_OUTSIDE_CONE,
                         GRIT_SAND_H_CLAMPED};
    for (int i = 0; i < 4; ++i)
        if (r.flags & flags[i]) out.count(stress_free + i);
    const int entries = call.components * call.components;
    out.demand(
        finite,
        all_finite(after.stress, 6) && all_finite(after.state, GRIT_SAND_STATE_SIZE) &&
            std::isfinite(after.substep) && std::isfinite(r.error_estimate) &&
            (call.options.tangent == GRIT_TANGENT_NONE || all_finite(after.tangent, entries)),
        program);
    out.demand(estimate_positive, r.error_estimate >= 0.0, program);
    grit_sand_invariants invariants{};
    invariants.struct_size = sizeof invariants;
    grit_sand_invariants_of(&call.sand, after.stress, after.state, &invariants);
    const double p = invariants.p + call.parameters.pressure_shift;
    if (!strained) out.demand(only_turned, is_only_turned(call, before, after), program);
    const bool free = norm_of_stress(after.stress) == 0.0;
    // Without strain a stress outside the cone stays there.
    out.demand(in_cone,
               !strained || free ||
                   (p >= 0.0 && invariants.tan_psi <= std::sqrt(2.0) * (1.0 + 1e-12)),
               program);
    if (with_memory(call)) {
        const double R = call.parameters.elastic_strain_radius;
        out.demand(h_in_its_radius, norm_of_strain(after.state) <= R * (1.0 + 1e-12), program);
    }
    const double volume = before.strain[0] + before.strain[1] + before.strain[2];
    const double e_0 = before.state[GRIT_SAND_VOID_RATIO];
    const double e = (1.0 + e_0) * std::exp(volume) - 1.0;
    out.demand(e_of_volume,
               std::fabs(after.state[GRIT_SAND_VOID_RATIO] - e) <=
                   1e-12 * (1.0 + e_0) * std::exp(std::fabs(volume)),
               program);
}

// A host that follows the advice gets through the strain, or down to a billionth of it, where void ratios end. What has taken
// too many steps is on its way if most calls of its last tenth were done: stresses of some sands change by their size within
// 1e-9 of strain, where e_c/e is taken to a high power.
void follow_advice(const Call& call, const Point& before, const Point& failed, Findings& out) {
    constexpr int evaluations = 2000;  // of a call, of which 100 000 take seconds then
    if (call.options.evaluation_limit < evaluations || call.options.tolerance < 1e-8) return;
    out.count(retried);
    Point x = before;
    Call part = call;
    part.options.evaluation_limit = evaluations;
    bool is_out_of_states = false;
    double left = 1.0, share = std::clamp(failed.report.step_reduction, 1e-6, 0.9);
    int steps = 0, done_late = 0;
    constexpr int most_steps = 100000, late = most_steps - most_steps / 10;
    while (left > 0.0 && share > 1e-9 && steps < most_steps) {
        Point next = x;
        const double taken = std::min(share, left);
        for (int c = 0; c < 6; ++c) next.strain[c] = taken * before.strain[c];
        update(part, next);
        ++steps;
        if (next.report.status == GRIT_OK) {
            x = next;
            done_late += steps > late;
            part.rotated = false;  // it has been turned
            left = taken == left ? 0.0 : left - taken;
            share = 1.5 * taken;
        } else if (next.report.status == GRIT_NOT_CONVERGED && next.report.step_reduction > 0.0 &&
                   next.report.step_reduction < 1.0) {
            share = taken * next.report.step_reduction;
        } else {
            is_out_of_states = true;  // no step helps
            break;
        }
    }
    out.measure(steps_of_a_retry, steps);
    const bool on_its_way = steps == most_steps && 2 * done_late > most_steps - late;
    out.count(left == 0.0        ? retried_through
              : is_out_of_states ? retried_out_of_states
              : share <= 1e-9    ? retried_to_a_billionth
                                 : retried_on_its_way,
              left == 0.0 || is_out_of_states || share <= 1e-9 || on_its_way ? 1 : 0);
    out.demand(retry_ends,
               (steps < most_steps || on_its_way) && failed.report.step_reduction > 0.0 &&
                   failed.report.step_reduction < 1.0,
               [&] { return program_of(call, before); });
    if (!call.of_catalogue) return;
    out.count(retried_published);
    out.count(retried_published_through, left == 0.0 ? 1 : 0);
    const double largest = std::fabs(*std::max_element(
        x.stress, x.stress + 6, [](double a, double b) { return std::fabs(a) < std::fabs(b); }));
    const bool at_an_end = largest > 5.0 * call.parameters.granulate_hardness ||
                           x.state[GRIT_SAND_VOID_RATIO] < 1e-6 ||
                           !(norm_of_strain(before.strain) < 1e3);
    out.demand(retry_gets_through, left == 0.0 || at_an_end,
               [&] { return program_of(call, before); });
}

// Against the same integrator at 1e-11.
void compare_tolerance(const Call& call, const Point& before, const Point& after, Findings& out) {
    grit_sand_options tight = call.options;
    tight.tolerance = 1e-11;
    tight.evaluation_limit = 200000;
    Point exact = before;
    update(call, tight, exact);
    // Where one of them opens and the other does not, stress jumps (docs/adr/0002).
    if (exact.report.status != GRIT_OK ||
        ((exact.report.flags ^ after.report.flags) & GRIT_SAND_STRESS_FREE) ||
        norm_of_stress(before.stress) == 0.0)
        return;
    const double tolerance = call.options.tolerance, error = stress_error(after, exact, before);
    out.count(compared);
    out.count(over_tolerance, error > tolerance && error > 1e-10 ? 1 : 0);
    const bool clean = ((exact.report.flags | after.report.flags) & ~GRIT_SAND_VOID_CLAMPED) == 0;
    out.measure(!clean              ? error_of_flagged
                : call.of_catalogue ? error_of_published
                                    : error_of_any,
                std::max(0.0, error - 1e-10) / tolerance);
    if (!call.of_catalogue || !clean) return;
    const auto program = [&] { return program_of(call, before); };
    out.demand(error_bounded, error <= 10.0 * tolerance + 1e-10, program);
    out.demand(estimate_tells,
               error <= std::max(tolerance, 100.0 * after.report.error_estimate) + 1e-10, program);
}

void compare_reference(const Call& call, const Point& before, Findings& out) {
    if (norm_of_strain(before.strain) > 0.02 || call.rotated) return;
    const bool basic = !with_memory(call);
    if (!basic && norm_of_strain(before.state) > call.parameters.elastic_strain_radius) return;
    const auto exact =
        exact_update(call.parameters, before.stress, before.state, before.strain, basic);
    if (!exact) return;
    grit_sand_options tight = call.options;
    tight.tolerance = 1e-9;
    tight.evaluation_limit = 200000;
    Point x = before, reference = before;
    update(call, tight, x);
    if (x.report.status != GRIT_OK || (x.report.flags & GRIT_SAND_STRESS_FREE)) return;
    std::copy(exact->stress, exact->stress + 6, reference.stress);
    const double error = stress_error(x, reference, before);
    double apart[6];
    for (int c = 0; c < 6; ++c) apart[c] = basic ? 0.0 : x.state[c] - exact->h[c];
    const double of_h = basic ? 0.0 : norm_of_strain(apart) / call.parameters.elastic_strain_radius;
    out.count(referred);
    out.count(referred_over, error > 1e-9 ? 1 : 0);
    if (!call.of_catalogue) return;
    out.measure(error_of_reference, error);
    out.measure(h_of_reference, of_h);
    out.demand(exact_stress, error <= 1e-7 && of_h <= 1e-7,
               [&] { return program_of(call, before); });
}

// As it is asked where stresses are differentiated: exactly, and with a tangent.
Call to_differentiate(const Call& call) {
    Call out = call;
    out.options.tolerance = 1e-9;
    out.options.evaluation_limit = 200000;
    out.options.tangent = GRIT_TANGENT_CONSISTENT;
    out.advised = false;
    return out;
}

// Where what is found is written down.
struct OfTangent {
    int count, measure, rule;
};

// Is the tangent of x the derivative of stress_after, which gives the stress after a strain or nothing, along a random
// way? Differences of two sizes that agree are that; the others pass a kink.
template <class StressAfter>
void compare_along_a_way(const Call& call, const Point& before, const Point& x,
                         const StressAfter& stress_after, const OfTangent& of, Random& random,
                         Findings& out) {
    const int n = call.components;
    double way[6], difference[2][6];
    random_tensor(random, 1.0, 2.0, n, way);
    for (int i = 0; i < 2; ++i) {
        const double h = (i == 0 ? 1e-3 : 5e-4) * norm_of_strain(before.strain);
        double plus[6], minus[6];
        for (int c = 0; c < 6; ++c) {
            plus[c] = before.strain[c] + h * way[c];
            minus[c] = before.strain[c] - h * way[c];
        }
        const auto after_plus = stress_after(plus), after_minus = stress_after(minus);
        if (!after_plus || !after_minus) return;
        for (std::size_t c = 0; c < 6; ++c)
            difference[i][c] = ((*after_plus)[c] - (*after_minus)[c]) / (2.0 * h);
    }
    double between[6], apart[6] = {};
    for (int r = 0; r < 6; ++r) between[r] = difference[0][r] - difference[1][r];
    for (int r = 0; r < n; ++r) {
        for (int c = 0; c < n; ++c) apart[r] += x.tangent[r * n + c] * way[c];
        apart[r] -= difference[1][r];
    }
    const double size = norm_of_stress(difference[1]);
    if (norm_of_stress(between) > 1e-4 * size) return;
    out.count(of.count);
    const double error = norm_of_stress(apart) / size;
    out.measure(of.measure, error);
    out.demand(of.rule, error <= 1e-2, [&] { return program_of(call, before); });
}

using Stress = std::array<double, 6>;

// Of published sands, against differences of its own stresses.
void compare_tangent(const Call& call, const Point& before, Random& random, Findings& out) {
    if (!call.of_catalogue || norm_of_strain(before.strain) < 1e-8 || near_axis(before.stress))
        return;
    const Call tight = to_differentiate(call);
    Point x = before;
    update(tight, x);
    if (x.report.status != GRIT_OK || x.report.flags || near_axis(x.stress)) return;
    Call without = tight;
    without.options.tangent = GRIT_TANGENT_NONE;
    const auto stress_after = [&](const double* strain) -> std::optional<Stress> {
        Point y = before;
        std::copy(strain, strain + 6, y.strain);
        update(without, y);
        if (y.report.status != GRIT_OK || y.report.flags) return {};
        return std::to_array(y.stress);
    };
    compare_along_a_way(tight, before, x, stress_after,
                        {differences, tangent_error, tangent_is_difference}, random, out);
}

// Of sands of any parameters, where the stress is that of the reference: against its differences.
void compare_tangent_with_reference(const Call& call, const Point& before, Random& random,
                                    Findings& out) {
    const double length = norm_of_strain(before.strain);
    const bool basic = !with_memory(call);
    if (call.of_catalogue || call.rotated || !(length >= 1e-8 && length <= 0.02) ||
        near_axis(before.stress) ||
        (!basic && norm_of_strain(before.state) > call.parameters.elastic_strain_radius))
        return;
    const Call tight = to_differentiate(call);
    Point x = before, reference = before;
    update(tight, x);
    if (x.report.status != GRIT_OK || x.report.flags || near_axis(x.stress)) return;
    const auto stress_after = [&](const double* strain) -> std::optional<Stress> {
        const auto exact =
            exact_update(call.parameters, before.stress, before.state, strain, basic);
        if (!exact || exact->least_h < 0.01) return {};
        return std::to_array(exact->stress);
    };
    const auto exact = stress_after(before.strain);
    if (!exact) return;
    std::copy(exact->begin(), exact->end(), reference.stress);
    if (stress_error(x, reference, before) > 1e-7) return;  // stiffer than it can follow
    compare_along_a_way(tight, before, x, stress_after,
                        {differences_of_any, tangent_error_of_any, tangent_is_that_of_reference},
                        random, out);
}

// Work of a closed path of strain that starts without stress.
void try_cycle(const Call& call, Random& random, Findings& out) {
    if (!call.of_catalogue || !with_memory(call)) return;
    Point x;
    double limits[3];
    grit_sand_void_ratios(&call.sand, 0.0, limits);
    x.state[GRIT_SAND_VOID_RATIO] = random.uniform(limits[2], limits[0]);
    const int corners = 2 + random.below(4);
    const double amplitude = random.log_uniform(1e-6, 3e-2);
    std::vector<std::array<double, 6>> corner(static_cast<std::size_t>(corners) + 1);
    for (int i = 1; i < corners; ++i)
        random_tensor(random, amplitude * random.uniform(), 2.0, 6,
                      corner[static_cast<std::size_t>(i)].data());
    Call plain = call;
    plain.components = 6;
    plain.rotated = plain.advised = false;
    plain.options.tangent = GRIT_TANGENT_NONE;
    plain.options.tolerance = 1e-5;
    plain.options.evaluation_limit = 20000;
    constexpr int increments = 200;
    double work = 0.0, largest = 0.0;
    for (std::size_t i = 1; i < corner.size(); ++i)
        for (int k = 0; k < increments; ++k) {
            double old[6];
            std::copy(x.stress, x.stress + 6, old);
            for (std::size_t c = 0; c < 6; ++c)
                x.strain[c] = (corner[i][c] - corner[i - 1][c]) / increments;
            update(plain, x);
            if (x.report.status != GRIT_OK) return;
            for (int c = 0; c < 6; ++c) work += 0.5 * (old[c] + x.stress[c]) * x.strain[c];
            largest = std::max(largest, norm_of_stress(x.stress));
        }
    if (largest == 0.0) return;  // nothing ever bears
    out.count(cycles);
    const bool gives = work < -1e-3 * largest * amplitude;
    out.count(cycles_with_energy, gives ? 1 : 0);
    out.demand(no_energy_of_nothing, !gives, [&] {
        std::string text = program_of(plain, x) + "/* corners:";
        for (const auto& each : corner) text += ' ' + numbers(each.data(), 6);
        return text + " */\n";
    });
}

void run_sand(Random& random, long cases, Findings& out) {
    updates_made = 0;
    for (long tried = 0; tried < cases;) {
        const Call call = random_call(random);
        const auto n =
            static_cast<std::size_t>(std::min<long>(1 + random.below(31), cases - tried));
        std::vector<Point> before, alone, together;
        for (std::size_t i = 0; i < n; ++i) before.push_back(random_point(random, call));
        alone = together = before;
        for (Point& x : alone) update(call, x);
        update_together(random, call, together);
        for (std::size_t i = 0; i < n; ++i) {
            const Point &x = before[i], &y = alone[i];
            const auto program = [&] { return program_of(call, x); };
            out.count(published, call.of_catalogue ? 1 : 0);
            judge(call, x, y, out);
            out.demand(same_bits, same(y, together[i]) && same_report(y, together[i]), program);
            if (y.report.status == GRIT_NOT_CONVERGED && random.below(64) == 0)
                follow_advice(call, x, y, out);
            if (y.report.status != GRIT_OK) continue;
            Point next = y;
            for (double& each : next.strain) each *= -1e-3;
            Call plain = call;
            plain.rotated = false;
            update(plain, next);
            out.demand(taken_again,
                       next.report.status == GRIT_OK || next.report.status == GRIT_NOT_CONVERGED,
                       program);
            if (random.below(256) == 0) compare_tolerance(call, x, y, out);
            if (random.below(2048) == 0) compare_reference(call, x, out);
            if (random.below(1024) == 0) compare_tangent(call, x, random, out);
            if (random.below(1024) == 0) compare_tangent_with_reference(call, x, random, out);
        }
        if (random.below(2048) == 0) try_cycle(call, random, out);
        tried += static_cast<long>(n);
        updates_made += static_cast<long>(n);  // together
    }
    out.count(updates, updates_made);
}

}  // namespace

Kind sand_trials() { return {"sand", words, 100000, run_sand}; }

}  // namespace robustness
