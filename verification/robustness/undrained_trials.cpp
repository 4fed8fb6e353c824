// SPDX-License-Identifier: BSD-3-Clause
#include "robustness/undrained_trials.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "robustness/program_text.hpp"
#include "robustness/sand_calls.hpp"

namespace robustness {
namespace {

enum Count { done, refused, refused_for_water, cavitated, of_constant_porosity, with_tangent };
enum Largest { error_of_pressure };
enum Rule {
    of_the_sand,
    pressure_exact,
    total_is_sum,
    flagged,
    tangent_has_water,
    stiffness_is_that,
    untouched,
    same_bits
};

const Vocabulary words = {
    {"points done", "refused as the sand is", "refused for their water", "of those done, cavitated",
     "of those done, with a constant porosity", "of those done, with a tangent"},
    {"error of p_w over what roundoff of the strain and of e is worth"},
    {"stress, state, advice and evaluations are those of grit_sand_update",
     "p_w is (W1) in long double, within what roundoff is worth",
     "the total stress is the effective one less what bears",
     "GRIT_SAND_CAVITATED is told where p_w is at the largest tension or below",
     "the tangent is that of the sand and K_w/n on its normal entries",
     "grit_sand_water_stiffness gives that K_w/n", "a failed point keeps its bits, of water too",
     "a batch gives the bits of single calls, whatever its strides"}};

constexpr double untouched_total = 5.0;

struct Wet {
    Point sand;
    double p_w = 0.0, total[6];
    Wet() { std::fill(total, total + 6, untouched_total); }
};

grit_sand_water random_water(Random& random, const Call& call) {
    grit_sand_water w;
    grit_sand_water_init(&w, sizeof w);
    w.bulk_modulus =
        random.below(8) ? call.parameters.granulate_hardness * random.log_uniform(1e-6, 1e3) : 0.0;
    const int porosity = random.below(4);
    if (porosity == 0) w.porosity = random.log_uniform(1e-3, 1.0);
    if (porosity == 1) w.porosity = 1.0;
    const int tension = random.below(4);
    if (tension == 0) w.largest_tension = 0.0;
    if (tension == 1) w.largest_tension = w.bulk_modulus * random.log_uniform(1e-9, 1.0);
    return w;
}

double random_pressure(Random& random, const grit_sand_water& water) {
    if (random.below(300) == 0) {
        const double bad[] = {NAN, INFINITY, -INFINITY, 1e308};
        return bad[random.below(4)];
    }
    if (random.below(10) == 0) return 0.0;
    if (random.below(10) == 0) return -std::min(water.largest_tension, 1e300);  // just there
    return (random.below(2) ? 1.0 : -1.0) * water.bulk_modulus * random.log_uniform(1e-9, 10.0);
}

void update(const Call& call, const grit_sand_water& water, Wet& x) {
    grit_sand_water w = water;
    w.pore_pressure = grit_mutable_view_of(&x.p_w, 1, 1);
    w.total_stress = grit_mutable_view_of(x.total, 6, 1);
    const grit_sand_points q = views_of(call, x.sand);
    grit_sand_update_undrained(&call.sand, &call.options, &w, 1, &q, &x.sand.report, nullptr);
}

void update_together(Random& random, const Call& call, const grit_sand_water& water,
                     std::vector<Wet>& points) {
    const auto n = static_cast<std::ptrdiff_t>(points.size());
    Scattered memory(random, call, n);
    Layout pressure(random, memory.places(), 1), total(random, memory.places(), call.components);
    std::vector<Point> sand;
    for (std::ptrdiff_t i = 0; i < n; ++i) {
        const Wet& x = points[static_cast<std::size_t>(i)];
        sand.push_back(x.sand);
        pressure.put(memory.place(i), &x.p_w);
        total.put(memory.place(i), x.total);
    }
    memory.put(sand);
    grit_sand_water w = water;
    w.pore_pressure = pressure.out();
    w.total_stress = total.out();
    const grit_sand_points q = memory.views();
    std::vector<grit_sand_report> reports(points.size());
    grit_sand_update_undrained(&call.sand, &call.options, &w, n, &q, reports.data(), nullptr);
    memory.get(sand, reports);
    for (std::ptrdiff_t i = 0; i < n; ++i) {
        Wet& x = points[static_cast<std::size_t>(i)];
        x.sand = sand[static_cast<std::size_t>(i)];
        pressure.get(memory.place(i), &x.p_w);
        total.get(memory.place(i), x.total);
    }
}

bool same_water(const Wet& a, const Wet& b) {
    return std::memcmp(&a.p_w, &b.p_w, sizeof a.p_w) == 0 &&
           std::memcmp(a.total, b.total, sizeof a.total) == 0;
}

std::string program_of(const Call& call, const grit_sand_water& w, const Wet& x) {
    return program_of(
        call, x.sand,
        "double u = " + number_text(x.p_w) +
            ", t[6];\n    grit_sand_water w; grit_sand_water_init(&w, sizeof w);\n"
            "    w.bulk_modulus = " +
            number_text(w.bulk_modulus) + "; w.porosity = " + number_text(w.porosity) +
            "; w.largest_tension = " + number_text(w.largest_tension) +
            ";\n    w.pore_pressure = grit_mutable_view_of(&u, 1, 1); w.total_stress = "
            "grit_mutable_view_of(t, 6, 1);\n"
            "    grit_sand_update_undrained(&sand, &o, &w, 1, &x, &r, 0);",
        "printf(\"%.17g\\n\", u);");
}

// p_w by (W1), and what half a bit in every number that enters it is worth.
struct ExactPressure {
    long double p_w, roundoff;
};
ExactPressure exact_pressure(const grit_sand_water& w, const Wet& x) {
    const double* const d = x.sand.strain;
    const long double e_0 = x.sand.state[GRIT_SAND_VOID_RATIO], K = w.bulk_modulus,
                      tr = static_cast<long double>(d[0]) + d[1] + d[2],
                      of_strain = std::fabs(d[0]) + std::fabs(d[1]) + std::fabs(d[2]);
    long double closing, slope, of_e = 0.0L;
    if (w.porosity > 0.0) {
        closing = -tr / w.porosity;
        slope = 1.0L / w.porosity;
    } else {
        const long double e = e_0 + (1.0L + e_0) * std::expm1(tr);
        closing = -std::log1p((1.0L + e_0) / e_0 * std::expm1(tr));
        slope = (1.0L + e) / e;
        of_e = std::fabs((e - e_0) / e);  // what of e / e_0 is left at the end
    }
    constexpr long double half_a_bit = std::numeric_limits<double>::epsilon() / 2.0L;
    return {x.p_w + K * closing,
            half_a_bit * (std::fabs(x.p_w) + std::fabs(x.p_w + K * closing) +
                          K * (std::fabs(closing) + slope * of_strain + of_e))};
}

void judge(const Call& call, const grit_sand_water& water, const Wet& before, const Wet& after,
           Findings& out) {
    const auto program = [&] { return program_of(call, water, before); };
    Point dry = before.sand;
    const grit_sand_points q = views_of(call, dry);
    grit_sand_update(&call.sand, &call.options, 1, &q, &dry.report, nullptr);
    const grit_sand_report& r = after.sand.report;
    if (r.status != GRIT_OK) {
        out.count(r.status == dry.report.status ? refused : refused_for_water);
        out.demand(untouched, same(before.sand, after.sand) && same_water(before, after), program);
        const bool overflows =
            r.status == GRIT_BAD_STATE &&
            !std::isfinite(static_cast<double>(exact_pressure(water, before).p_w));
        out.demand(of_the_sand, r.status == dry.report.status || overflows, program);
        return;
    }
    out.count(done);
    out.count(of_constant_porosity, water.porosity > 0.0 ? 1 : 0);
    // The tangent has a rule of its own.
    Wet as_sand = after;
    std::copy(dry.tangent, dry.tangent + 36, as_sand.sand.tangent);
    out.demand(of_the_sand,
               same(dry, as_sand.sand) && dry.report.status == GRIT_OK &&
                   dry.report.evaluations == r.evaluations &&
                   dry.report.flags == (r.flags & ~GRIT_SAND_CAVITATED),
               program);

    const ExactPressure exact = exact_pressure(water, before);
    const auto error =
        static_cast<double>(std::fabs(after.p_w - exact.p_w) / std::max(exact.roundoff, 1e-300L));
    out.measure(error_of_pressure, error);
    out.demand(pressure_exact, error <= 8.0, program);

    const bool bears = after.p_w > -water.largest_tension;
    out.count(cavitated, bears ? 0 : 1);
    out.demand(flagged, bears != ((r.flags & GRIT_SAND_CAVITATED) != 0), program);
    const double borne = bears ? after.p_w : -water.largest_tension;
    bool is_sum = borne == grit_sand_water_borne(&water, after.p_w);
    for (int c = 0; c < 6; ++c)
        is_sum = is_sum && after.total[c] == (c >= call.components ? untouched_total
                                              : c < 3              ? after.sand.stress[c] - borne
                                                                   : after.sand.stress[c]);
    out.demand(total_is_sum, is_sum, program);

    const double e = after.sand.state[GRIT_SAND_VOID_RATIO];
    double K = -1.0;
    grit_sand_water_stiffness(&water, after.p_w, e, &K);
    const double n = water.porosity > 0.0 ? water.porosity : e / (1.0 + e);
    const double expected = bears ? water.bulk_modulus / n : 0.0;
    out.demand(stiffness_is_that, std::fabs(K - expected) <= 1e-15 * expected, program);
    if (call.options.tangent == GRIT_TANGENT_NONE) {
        out.demand(tangent_has_water,
                   std::memcmp(after.sand.tangent, before.sand.tangent, sizeof dry.tangent) == 0,
                   program);
        return;
    }
    out.count(with_tangent);
    bool has_water = true;
    for (int k = 0; k < 36; ++k) {
        const bool normal = k < call.components * call.components && k / call.components < 3 &&
                            k % call.components < 3;
        const double of_sand = dry.tangent[k];
        has_water = has_water && after.sand.tangent[k] == (normal ? of_sand + K : of_sand);
    }
    out.demand(tangent_has_water, has_water, program);
}

void run_undrained(Random& random, long cases, Findings& out) {
    for (long tried = 0; tried < cases;) {
        const Call call = random_call(random);
        const grit_sand_water water = random_water(random, call);
        // Beyond 256 a call goes in pieces.
        const long most = random.below(64) ? 1 + random.below(31) : 250 + random.below(300);
        const auto n = static_cast<std::size_t>(std::min(most, cases - tried));
        std::vector<Wet> before(n);
        for (Wet& x : before) {
            x.sand = random_point(random, call);
            x.p_w = random_pressure(random, water);
        }
        std::vector<Wet> alone = before, together = before;
        for (Wet& x : alone) update(call, water, x);
        update_together(random, call, water, together);
        for (std::size_t i = 0; i < n; ++i) {
            judge(call, water, before[i], alone[i], out);
            out.demand(same_bits,
                       same(alone[i].sand, together[i].sand) && same_water(alone[i], together[i]) &&
                           same_report(alone[i].sand, together[i].sand),
                       [&] { return program_of(call, water, before[i]); });
        }
        tried += static_cast<long>(n);
    }
}

}  // namespace

Kind undrained_trials() { return {"undrained", words, 50000, run_undrained}; }

}  // namespace robustness
