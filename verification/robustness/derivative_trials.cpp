// SPDX-License-Identifier: BSD-3-Clause
#include "robustness/derivative_trials.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>

#include "robustness/exact_rate.hpp"
#include "robustness/program_text.hpp"
#include "robustness/sand_calls.hpp"

namespace robustness {
namespace {

enum Count {
    done,
    refused,
    not_converged,
    not_finite,
    directions_carried,
    tangents,
    referred,
    referred_any,
    referred_h,
};
enum Largest { error_of_tangent, error_of_published, error_of_h, error_of_any };
enum Rule {
    of_the_sand,
    finite,
    untouched,
    same_bits,
    alone,
    twice_as_long,
    nothing_stays_nothing,
    are_tangent,
    of_reference,
    of_reference_h,
    of_reference_any
};

const Vocabulary words = {
    {"points done", "refused for their state", "not converged",
     "of these, done but for derivatives beyond numbers", "directions carried",
     "points whose directions of strain are compared with the consistent tangent",
     "directions of published sands compared with differences of the reference",
     "of any parameters, where stress is the reference's", "of h, of published sands"},
    {"error of directions of strain against the tangent, over its norm",
     "error against differences, published sands", "of h, published sands",
     "error against differences, any parameters"},
    {"stress, state, advice and evaluations are those of grit_sand_update",
     "derivatives are finite", "a failed point keeps its bits, of derivatives too",
     "a batch gives the bits of single calls, whatever its strides",
     "a direction has the bits that it has alone",
     "of a direction -4 times as long -4 times as much",
     "a direction that changes nothing changes nothing",
     "directions of strain are the consistent tangent to 1e-9",
     "of published sands they are differences of the reference's stresses within 1e-3",
     "and of its h", "of any sand they are differences of the reference's stresses within 1e-3"}};

constexpr int rows = 6 + GRIT_SAND_STATE_SIZE;
using Column = std::array<double, rows>;  // stress above state

// Columns at the start and the end, and what they are of.
struct Directions {
    std::vector<int> parameters;
    std::vector<std::array<double, 6>> strain;
    std::vector<Column> column;

    int count() const { return static_cast<int>(column.size()); }
};
struct Slope {
    Point point;
    Directions along;
};

// A column as a host may carry one: of the size of what it belongs to, or nothing.
Column random_column(Random& random, const Call& call, const Point& x) {
    Column out{};
    if (random.below(2)) return out;
    const double T = std::max(norm_of_stress(x.stress), 1e-12 * call.parameters.granulate_hardness);
    const double R = std::isnan(call.parameters.elastic_strain_radius)
                         ? 1e-4
                         : call.parameters.elastic_strain_radius;
    double of_stress[6], of_h[6];
    random_tensor(random, T, 1.0, call.components, of_stress);
    random_tensor(random, R, 2.0, call.components, of_h);
    if (random.below(2)) std::copy(of_stress, of_stress + 6, out.begin());
    if (random.below(2)) std::copy(of_h, of_h + 6, out.begin() + 6);
    if (random.below(2)) out[6 + GRIT_SAND_VOID_RATIO] = random.normal();
    if (random.below(4) == 0) out[6 + GRIT_SAND_SEPARATION] = random.normal();
    if (random.below(300) == 0) out[static_cast<std::size_t>(random.below(4))] = NAN;
    return out;
}

Directions random_directions(Random& random, const Call& call, const Point& x, int count) {
    Directions out;
    const int most = with_memory(call) ? GRIT_SAND_PARAMETER_COUNT : GRIT_SAND_REVERSAL_STIFFNESS;
    for (int k = 0; k < count; ++k) {
        out.parameters.push_back(random.below(3) ? random.below(most) : GRIT_SAND_NO_PARAMETER);
        std::array<double, 6> strain{};
        if (random.below(2))
            random_tensor(random, norm_of_strain(x.strain), 2.0, call.components, strain.data());
        out.strain.push_back(strain);
        out.column.push_back(random_column(random, call, x));
    }
    return out;
}

// The directions of a call are the same for all of its points but for their columns.
struct Matrices {
    std::vector<double> strain, stress, state;
};
Matrices matrices_of(const Call& call, const Directions& d) {
    const auto n = static_cast<std::size_t>(call.components);
    const std::size_t m = d.column.size();
    Matrices out{std::vector<double>(n * m), std::vector<double>(n * m),
                 std::vector<double>(GRIT_SAND_STATE_SIZE * m)};
    for (std::size_t k = 0; k < m; ++k) {
        for (std::size_t c = 0; c < n; ++c) {
            out.strain[c * m + k] = d.strain[k][c];
            out.stress[c * m + k] = d.column[k][c];
        }
        for (std::size_t c = 0; c < GRIT_SAND_STATE_SIZE; ++c)
            out.state[c * m + k] = d.column[k][6 + c];
    }
    return out;
}
void put_back(const Call& call, const Matrices& from, Directions& d) {
    const auto n = static_cast<std::size_t>(call.components);
    const std::size_t m = d.column.size();
    for (std::size_t k = 0; k < m; ++k) {
        for (std::size_t c = 0; c < n; ++c) d.column[k][c] = from.stress[c * m + k];
        for (std::size_t c = 0; c < GRIT_SAND_STATE_SIZE; ++c)
            d.column[k][6 + c] = from.state[c * m + k];
    }
}

void update(const Call& call, Slope& x) {
    const int m = x.along.count();
    Matrices flat = matrices_of(call, x.along);
    grit_sand_derivatives d{};
    d.struct_size = sizeof d;
    d.count = m;
    d.parameters = x.along.parameters.data();
    d.strain_increment = grit_matrix_view_of(flat.strain.data(), 6 * m, m, 1);
    d.stress = grit_mutable_matrix_view_of(flat.stress.data(), 6 * m, m, 1);
    d.state = grit_mutable_matrix_view_of(flat.state.data(), GRIT_SAND_STATE_SIZE * m, m, 1);
    const grit_sand_points q = views_of(call, x.point);
    grit_sand_update_differentiated(&call.sand, &call.options, &d, 1, &q, &x.point.report, nullptr);
    put_back(call, flat, x.along);
}

void update_together(Random& random, const Call& call, std::vector<Slope>& points) {
    const auto n = static_cast<std::ptrdiff_t>(points.size());
    const std::ptrdiff_t m = points.front().along.count(), components = call.components;
    Scattered memory(random, call, n);
    Layout strain(random, memory.places(), components * m),
        stress(random, memory.places(), components * m),
        state(random, memory.places(), GRIT_SAND_STATE_SIZE * m);
    std::vector<Point> sand;
    std::vector<Matrices> flat;
    for (std::ptrdiff_t i = 0; i < n; ++i) {
        const Slope& x = points[static_cast<std::size_t>(i)];
        sand.push_back(x.point);
        flat.push_back(matrices_of(call, x.along));
        strain.put(memory.place(i), flat.back().strain.data());
        stress.put(memory.place(i), flat.back().stress.data());
        state.put(memory.place(i), flat.back().state.data());
    }
    memory.put(sand);
    grit_sand_derivatives d{};
    d.struct_size = sizeof d;
    d.count = static_cast<int>(m);
    d.parameters = points.front().along.parameters.data();
    const grit_mutable_matrix_view of_strain = strain.matrix(m);
    d.strain_increment = grit_matrix_view_of(of_strain.base, of_strain.point_stride,
                                             of_strain.row_stride, of_strain.column_stride);
    d.stress = stress.matrix(m);
    d.state = state.matrix(m);
    const grit_sand_points q = memory.views();
    std::vector<grit_sand_report> reports(points.size());
    grit_sand_update_differentiated(&call.sand, &call.options, &d, n, &q, reports.data(), nullptr);
    memory.get(sand, reports);
    for (std::ptrdiff_t i = 0; i < n; ++i) {
        Slope& x = points[static_cast<std::size_t>(i)];
        Matrices& own = flat[static_cast<std::size_t>(i)];
        x.point = sand[static_cast<std::size_t>(i)];
        stress.get(memory.place(i), own.stress.data());
        state.get(memory.place(i), own.state.data());
        put_back(call, own, x.along);
    }
}

bool same_column(const Column& a, const Column& b) {
    return std::memcmp(a.data(), b.data(), sizeof a) == 0;
}
bool same_columns(const Directions& a, const Directions& b) {
    return std::equal(a.column.begin(), a.column.end(), b.column.begin(), same_column);
}

std::string program_of(const Call& call, const Slope& x) {
    const Matrices flat = matrices_of(call, x.along);
    const std::string m = std::to_string(x.along.count());
    std::string parameters;
    for (const int each : x.along.parameters)
        parameters += (parameters.empty() ? "" : ", ") + std::to_string(each);
    const auto text = [](const std::vector<double>& v) { return numbers(v.data(), v.size()); };
    return program_of(
        call, x.point,
        "int w[] = {" + parameters + "};\n    double dE[] = " + text(flat.strain) +
            ";\n    double dT[] = " + text(flat.stress) + ";\n    double dq[] = " +
            text(flat.state) + ";\n    grit_sand_derivatives D = {sizeof D, " + m +
            "};\n    D.parameters = w; D.strain_increment = grit_matrix_view_of(dE, 0, " + m +
            ", 1);\n    D.stress = grit_mutable_matrix_view_of(dT, 0, " + m +
            ", 1); D.state = grit_mutable_matrix_view_of(dq, 0, " + m +
            ", 1);\n    grit_sand_update_differentiated(&sand, &o, &D, 1, &x, &r, 0);",
        "for (int c = 0; c < " + std::to_string(flat.stress.size()) +
            "; ++c) printf(\"%.17g\\n\", dT[c]);");
}

// What holds for every update. Says whether it was done.
bool judge(const Call& call, const Slope& before, const Slope& after, Findings& out) {
    const auto program = [&] { return program_of(call, before); };
    const grit_sand_report& r = after.point.report;
    Point plain = before.point;
    const grit_sand_points q = views_of(call, plain);
    grit_sand_update(&call.sand, &call.options, 1, &q, &plain.report, nullptr);
    const bool given_finite =
        std::all_of(before.along.column.begin(), before.along.column.end(),
                    [](const Column& each) { return all_finite(each.data(), rows); });
    if (r.status != GRIT_OK) {
        const bool of_derivatives = plain.report.status == GRIT_OK;
        out.count(r.status == GRIT_BAD_STATE ? refused : not_converged);
        out.count(not_finite, of_derivatives && given_finite ? 1 : 0);
        out.demand(untouched,
                   same(before.point, after.point) && same_columns(before.along, after.along),
                   program);
        out.demand(of_the_sand,
                   r.status == plain.report.status ||
                       (of_derivatives &&
                        r.status == (given_finite ? GRIT_NOT_CONVERGED : GRIT_BAD_STATE)) ||
                       !given_finite,
                   program);
        return false;
    }
    out.count(done);
    out.count(directions_carried, after.along.count());
    out.demand(of_the_sand,
               same(plain, after.point) && plain.report.status == GRIT_OK &&
                   plain.report.evaluations == r.evaluations && plain.report.flags == r.flags,
               program);
    out.demand(finite,
               std::all_of(after.along.column.begin(), after.along.column.end(),
                           [](const Column& each) { return all_finite(each.data(), rows); }),
               program);
    return true;
}

// One of the directions alone, -4 times as long, and one that changes nothing, in the same call.
void try_alone(const Call& call, const Slope& before, const Slope& after, Random& random,
               Findings& out) {
    const auto k = static_cast<std::size_t>(random.below(before.along.count()));
    Slope one = before;
    one.along.parameters = {before.along.parameters[k]};
    one.along.strain = {before.along.strain[k]};
    one.along.column = {before.along.column[k]};
    const auto program = [&] { return program_of(call, before); };
    update(call, one);
    out.demand(alone,
               one.point.report.status == GRIT_OK &&
                   same_column(one.along.column[0], after.along.column[k]),
               program);
    Slope two = before;
    two.along.parameters.assign(3, GRIT_SAND_NO_PARAMETER);
    two.along.strain.assign(3, before.along.strain[k]);
    two.along.column.assign(3, before.along.column[k]);
    for (double& each : two.along.strain[1]) each *= -4.0;
    for (double& each : two.along.column[1]) each *= -4.0;
    two.along.strain[2].fill(0.0);
    two.along.column[2].fill(0.0);
    update(call, two);
    if (two.point.report.status != GRIT_OK) return;  // four times as much is no number
    bool is_linear = true, is_nothing = true;
    for (std::size_t c = 0; c < rows; ++c) {
        const double x = two.along.column[0][c], y = two.along.column[1][c];
        // Below the smallest normal numbers bits are lost.
        is_linear = is_linear && (y == -4.0 * x || std::fabs(x) < 1e-250);
        is_nothing = is_nothing && two.along.column[2][c] == 0.0;
    }
    out.demand(twice_as_long, is_linear, program);
    out.demand(nothing_stays_nothing, is_nothing, program);
}

void compare_tangent(const Call& call, const Point& before, Findings& out) {
    if (norm_of_strain(before.strain) == 0.0) return;
    const int n = call.components;
    Call with = call;
    with.options.tangent = GRIT_TANGENT_CONSISTENT;
    Point x = before;
    const grit_sand_points q = views_of(with, x);
    grit_sand_update(&with.sand, &with.options, 1, &q, &x.report, nullptr);
    Slope start{before, {}};
    for (int k = 0; k < n; ++k) {
        std::array<double, 6> unit{};
        unit[static_cast<std::size_t>(k)] = 1.0;
        start.along.parameters.push_back(GRIT_SAND_NO_PARAMETER);
        start.along.strain.push_back(unit);
        start.along.column.push_back({});
    }
    Slope slope = start;
    Call without = call;
    without.options.tangent = GRIT_TANGENT_NONE;
    update(without, slope);
    // Without stress a tangent keeps a stiffness that solvers can do with; the derivative is none.
    if (x.report.status != GRIT_OK || slope.point.report.status != GRIT_OK ||
        (x.report.flags & GRIT_SAND_STRESS_FREE))
        return;
    double apart = 0.0, size = 0.0;
    for (int r = 0; r < n; ++r)
        for (int k = 0; k < n; ++k) {
            const double a = x.tangent[r * n + k],
                         b = slope.along
                                 .column[static_cast<std::size_t>(k)][static_cast<std::size_t>(r)];
            apart = std::max(apart, std::fabs(a - b));
            size = std::max(size, std::fabs(a));
        }
    if (size == 0.0 && apart == 0.0) return;
    // Sands of any parameters may magnify a strain by 1e140 on their way, and roundoff with it.
    if (!(size <= 1e12 * call.parameters.granulate_hardness)) return;
    out.count(tangents);
    const double error = apart / std::max(size, 1e-300);
    out.measure(error_of_tangent, error);
    out.demand(are_tangent, error <= 1e-9, [&] { return program_of(without, start); });
}

// The sand and the point a step along one direction.
struct Probe {
    grit_sand_parameters sand;
    double stress[6], state[GRIT_SAND_STATE_SIZE], strain[6];
};
std::optional<Probe> probe(const Call& call, const Slope& one, double step) {
    const Directions& d = one.along;
    Probe out{call.parameters, {}, {}, {}};
    if (d.parameters[0] != GRIT_SAND_NO_PARAMETER) {
        double value;
        grit_sand_parameter_get(&out.sand, d.parameters[0], &value);
        grit_sand_parameter_set(&out.sand, d.parameters[0], value + step);
        grit_sand prepared;
        if (grit_sand_prepare(&out.sand, &prepared, nullptr) != GRIT_OK) return {};
    }
    for (std::size_t c = 0; c < 6; ++c) {
        out.stress[c] = one.point.stress[c] + step * d.column[0][c];
        out.strain[c] = one.point.strain[c] + step * d.strain[0][c];
    }
    for (std::size_t c = 0; c < GRIT_SAND_STATE_SIZE; ++c)
        out.state[c] = one.point.state[c] + step * d.column[0][6 + c];
    return out;
}

double apart(const double* a, const double* b, double shear) {
    double sum = 0.0;
    for (int c = 0; c < 6; ++c) sum += (c < 3 ? 1.0 : shear) * (a[c] - b[c]) * (a[c] - b[c]);
    return std::sqrt(sum);
}

// One direction, of a size that counts, at a tight tolerance, against differences of the reference. Differences of two
// sizes that agree are the derivative; the others pass a kink.
void compare_reference(const Call& given, const Point& before, Random& random, Findings& out) {
    Call call = given;
    call.rotated = call.advised = false;
    call.options.tolerance = 1e-9;
    call.options.evaluation_limit = 200000;
    call.options.tangent = GRIT_TANGENT_NONE;
    const bool basic = !with_memory(call);
    const double length = norm_of_strain(before.strain), R = call.parameters.elastic_strain_radius;
    if (!(length >= 1e-8 && length <= 0.02) || near_axis(before.stress) ||
        (!basic && norm_of_strain(before.state) > 0.99 * R))
        return;
    Slope one{before, {}};
    one.along = random_directions(random, call, before, 1);
    if (random.below(2)) one.along.parameters[0] = GRIT_SAND_NO_PARAMETER;
    double size = 1.0;  // what the direction is measured by
    const int parameter = one.along.parameters[0];
    if (parameter != GRIT_SAND_NO_PARAMETER) {
        grit_sand_parameter_get(&call.parameters, parameter, &size);
        if (!(size > 0.0) || !std::isfinite(size)) return;
        // Of the start it is none: what it would be may be of another size.
        one.along.strain[0].fill(0.0);
        one.along.column[0].fill(0.0);
    }
    one.along.column[0][6 + GRIT_SAND_SEPARATION] = 0.0;
    const auto changes = [](const auto& of) {
        return std::any_of(of.begin(), of.end(), [](double each) { return each != 0.0; });
    };
    if (parameter == GRIT_SAND_NO_PARAMETER && !changes(one.along.strain[0]) &&
        !changes(one.along.column[0]))
        return;
    Slope x = one;
    update(call, x);
    if (x.point.report.status != GRIT_OK || x.point.report.flags || near_axis(x.point.stress))
        return;
    const auto middle =
        exact_update(call.parameters, before.stress, before.state, before.strain, basic);
    if (!middle || middle->least_h < 0.01) return;
    const double T = std::max(norm_of_stress(middle->stress), norm_of_stress(before.stress));
    if (apart(x.point.stress, middle->stress, 2.0) > 1e-7 * T)
        return;  // stiffer than it can follow
    double difference[2][12];
    for (int i = 0; i < 2; ++i) {
        const double step = (i == 0 ? 2e-4 : 1e-4) * size;
        const auto up = probe(call, one, step), down = probe(call, one, -step);
        if (!up || !down) return;
        const auto after = [&](const Probe& y) {
            return exact_update(y.sand, y.stress, y.state, y.strain, basic);
        };
        const auto plus = after(*up), minus = after(*down);
        if (!plus || !minus) return;
        for (int c = 0; c < 6; ++c) {
            difference[i][c] = (plus->stress[c] - minus->stress[c]) / (2.0 * step);
            difference[i][6 + c] = (plus->h[c] - minus->h[c]) / (2.0 * step);
        }
    }
    const auto program = [&] { return program_of(call, one); };
    const double* const given_T = x.along.column[0].data();
    const double of_T = std::max(norm_of_stress(difference[1]), 1e-3 * T / size);
    if (apart(difference[0], difference[1], 2.0) <= 1e-4 * of_T) {
        out.count(call.of_catalogue ? referred : referred_any);
        const double error = apart(given_T, difference[1], 2.0) / of_T;
        out.measure(call.of_catalogue ? error_of_published : error_of_any, error);
        out.demand(call.of_catalogue ? of_reference : of_reference_any, error <= 1e-3, program);
    }
    const double of_h = std::max(norm_of_strain(difference[1] + 6), 1e-3 * R / size);
    if (!basic && call.of_catalogue &&
        apart(difference[0] + 6, difference[1] + 6, 0.5) <= 1e-4 * of_h) {
        out.count(referred_h);
        const double error = apart(given_T + 6, difference[1] + 6, 0.5) / of_h;
        out.measure(error_of_h, error);
        out.demand(of_reference_h, error <= 1e-3, program);
    }
}

void run_derivatives(Random& random, long cases, Findings& out) {
    for (long tried = 0; tried < cases;) {
        Call call = random_call(random);
        if (call.options.tangent == GRIT_TANGENT_CONSISTENT)
            call.options.tangent = GRIT_TANGENT_NONE;
        const auto n =
            static_cast<std::size_t>(std::min<long>(1 + random.below(15), cases - tried));
        // 16 are carried at once.
        const int count = random.below(4) ? 1 + random.below(6)
                                          : 1 + random.below(GRIT_SAND_LARGEST_DIRECTION_COUNT);
        std::vector<Slope> before(n);
        for (Slope& x : before) {
            x.point = random_point(random, call);
            x.along = random_directions(random, call, x.point, count);
            x.along.parameters = before.front().along.parameters;
        }
        std::vector<Slope> single = before, together = before;
        for (Slope& x : single) update(call, x);
        update_together(random, call, together);
        for (std::size_t i = 0; i < n; ++i) {
            const Slope &x = before[i], &y = single[i];
            const bool was_done = judge(call, x, y, out);
            out.demand(same_bits,
                       same(y.point, together[i].point) &&
                           same_columns(y.along, together[i].along) &&
                           same_report(y.point, together[i].point),
                       [&] { return program_of(call, x); });
            if (was_done && random.below(8) == 0) try_alone(call, x, y, random, out);
            if (was_done && random.below(16) == 0) compare_tangent(call, x.point, out);
            if (random.below(16) == 0) compare_reference(call, x.point, random, out);
        }
        tried += static_cast<long>(n);
    }
}

}  // namespace

Kind derivative_trials() { return {"derivatives", words, 20000, run_derivatives}; }

}  // namespace robustness
