// SPDX-License-Identifier: BSD-3-Clause
// same_bits COUNT: random points updated alone, and in batches of every size and in every lane, on
// every instruction set of this machine: bitwise the same on one instruction set; between them, for
// published sands, within the stated bound (a factor of the tolerance). Random parameters reach
// responses that no integrator can follow, and are not bounded.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "robustness/random_points.hpp"

namespace {

using namespace robustness;

constexpr double across_bound = 10.0;  // times the tolerance

struct Results {
    Points points;
    std::vector<double> tangent;
    std::vector<grit_sand_report> reports;
};

void update(const Sand& sand, grit_sand_options options, Results& r, std::size_t first, int n) {
    grit_sand_points q{};
    q.struct_size = sizeof q;
    q.strain_increment = grit_view_of(&r.points.strain[6 * first], 6, 1);
    q.stress = grit_mutable_view_of(&r.points.stress[6 * first], 6, 1);
    q.state = grit_mutable_view_of(&r.points.state[8 * first], 8, 1);
    q.tangent = grit_mutable_matrix_view_of(&r.tangent[36 * first], 36, 6, 1);
    grit_sand_update(&sand.prepared, &options, n, &q, &r.reports[first], nullptr);
}

Results start(const Points& points, std::size_t n) {
    return {points, std::vector<double>(36 * n), std::vector<grit_sand_report>(n)};
}

bool same(const std::vector<double>& a, const std::vector<double>& b) {
    return std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

double norm(const double* a) {
    double n = 0.0;
    for (int c = 0; c < 6; ++c) n += (c < 3 ? 1.0 : 2.0) * a[c] * a[c];
    return std::sqrt(n);
}

// |a - b| over the larger of the stress norms at the start and at the end of the call, to which the
// tolerance refers.
double distance(const double* a, const double* b, const double* before) {
    double difference[6];
    for (int c = 0; c < 6; ++c) difference[c] = a[c] - b[c];
    const double apart = norm(difference);  // both may be zero
    return apart == 0.0 ? 0.0 : apart / std::max(norm(b), norm(before));
}

}  // namespace

int main(int argc, char** argv) {
    const long count = argc > 1 ? std::atol(argv[1]) : 100000;
    constexpr int random_ones = 20;  // first; published sands follow
    const auto sands = various_sands(random_ones);
    Random random(4711);
    long differing = 0, tangent_differing = 0, points_done = 0, status_differing = 0;
    double worst_across = 0.0, worst_of_random = 0.0;
    constexpr std::size_t n = 1000;
    while (points_done < count) {
        const int which = random.below(static_cast<int>(sands.size()));
        const Sand& sand = sands[static_cast<std::size_t>(which)];
        Points points(n);
        for (std::size_t i = 0; i < n; ++i)
            random_point(random, sand, (points_done / static_cast<long>(n)) % 2 == 0,
                         &points.strain[6 * i], &points.stress[6 * i], &points.state[8 * i]);
        grit_sand_options options;
        grit_sand_options_init(&options, sizeof options);
        options.tolerance = 1e-4;
        Results reference = start(points, n);
        for (int isa = grit_instruction_set(); isa >= GRIT_ISA_BASELINE; --isa) {
            options.instruction_set = isa;
            Results alone = start(points, n);
            for (std::size_t i = 0; i < n; ++i) update(sand, options, alone, i, 1);
            Results together = start(points, n);
            for (std::size_t i = 0; i < n;) {  // every batch size and so every lane
                const auto size =
                    std::min<std::size_t>(static_cast<std::size_t>(1 + random.below(23)), n - i);
                update(sand, options, together, i, static_cast<int>(size));
                i += size;
            }
            differing += !same(alone.points.stress, together.points.stress) ||
                         !same(alone.points.state, together.points.state);
            Results derived = start(points, n);
            options.tangent = GRIT_TANGENT_CONSISTENT;
            update(sand, options, derived, 0, static_cast<int>(n));
            options.tangent = GRIT_TANGENT_NONE;
            tangent_differing += !same(alone.points.stress, derived.points.stress) ||
                                 !same(alone.points.state, derived.points.state);
            if (isa == grit_instruction_set()) {
                reference = alone;
                continue;
            }
            for (std::size_t i = 0; i < n; ++i) {
                status_differing += alone.reports[i].status != reference.reports[i].status;
                if (alone.reports[i].status != GRIT_OK) continue;
                if ((alone.reports[i].flags | reference.reports[i].flags) & GRIT_SAND_STRESS_FREE)
                    continue;
                double& worst = which < random_ones ? worst_of_random : worst_across;
                const double d = distance(&alone.points.stress[6 * i],
                                          &reference.points.stress[6 * i], &points.stress[6 * i]);
                if (!(d <= worst)) worst = std::isnan(d) ? INFINITY : d;
            }
        }
        points_done += n;
    }
    std::printf("%ld points on %d instruction sets\n", points_done, grit_instruction_set());
    std::printf("blocks of 1000 where alone and in batches differ: %ld\n", differing);
    std::printf("blocks of 1000 where stress with and without tangent differ: %ld\n",
                tangent_differing);
    std::printf("largest difference between instruction sets: %.2g of |stress|, bound %.2g; "
                "other status: %ld\n",
                worst_across, across_bound * 1e-4, status_differing);
    std::printf("the same for materials of random parameters, without a bound: %.2g\n",
                worst_of_random);
    return differing || tangent_differing || status_differing || worst_across > across_bound * 1e-4
               ? EXIT_FAILURE
               : EXIT_SUCCESS;
}
