// SPDX-License-Identifier: BSD-3-Clause
// random_updates COUNT: updates of random points, sane and insane. Prints the count of every status
// and flag; fails if a NaN comes out, a failed point was touched, or a status is not a documented one.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>

#include "robustness/random_points.hpp"

namespace {

using namespace robustness;

bool all_finite(const double* x, int n) {
    for (int i = 0; i < n; ++i)
        if (!std::isfinite(x[i])) return false;
    return true;
}

struct Tally {
    long status[6] = {}, flags[16] = {}, nan_out = 0, touched = 0, silent = 0;
    long evaluations = 0, most_evaluations = 0;
};

void run_batch(Random& random, const Sand& sand, int n, Tally& tally) {
    Points points(static_cast<std::size_t>(n));
    std::vector<double> tangent(36 * static_cast<std::size_t>(n), 7.0);
    std::vector<grit_sand_report> reports(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i)
        random_point(random, sand, true, &points.strain[6 * i], &points.stress[6 * i],
                     &points.state[8 * i]);
    const Points before = points;
    grit_sand_options options;
    grit_sand_options_init(&options, sizeof options);
    const double tolerances[] = {1e-2, 1e-3, 1e-5};
    options.tolerance = tolerances[random.below(3)];
    options.tangent = random.below(8) == 0 ? 1 + random.below(2) : GRIT_TANGENT_NONE;
    options.intergranular_off = random.below(10) == 0;
    grit_sand_points q{};
    q.struct_size = sizeof q;
    q.strain_increment = grit_view_of(points.strain.data(), 6, 1);
    q.stress = grit_mutable_view_of(points.stress.data(), 6, 1);
    q.state = grit_mutable_view_of(points.state.data(), 8, 1);
    q.tangent = grit_mutable_matrix_view_of(tangent.data(), 36, 6, 1);
    const grit_status status =
        grit_sand_update(&sand.prepared, &options, n, &q, reports.data(), nullptr);
    bool any_failed = false;
    for (int i = 0; i < n; ++i) {
        const grit_sand_report& r = reports[i];
        const std::size_t s = 6 * static_cast<std::size_t>(i), t = 8 * static_cast<std::size_t>(i);
        if (r.status < 0 || r.status > GRIT_NOT_CONVERGED || r.status == GRIT_BAD_PARAMETER) {
            ++tally.silent;
            continue;
        }
        ++tally.status[r.status];
        tally.evaluations += r.evaluations;
        if (r.evaluations > tally.most_evaluations) tally.most_evaluations = r.evaluations;
        if (r.status == GRIT_OK) {
            ++tally.flags[r.flags & 15];
            const double* M = &tangent[36 * static_cast<std::size_t>(i)];
            tally.nan_out += !all_finite(&points.stress[s], 6) ||
                             !all_finite(&points.state[t], 8) || !all_finite(M, 36);
        } else {
            any_failed = true;
            tally.touched +=
                std::memcmp(&points.stress[s], &before.stress[s], 6 * sizeof(double)) != 0 ||
                std::memcmp(&points.state[t], &before.state[t], 8 * sizeof(double)) != 0 ||
                tangent[36 * static_cast<std::size_t>(i)] != 7.0;
        }
    }
    tally.silent += any_failed != (status != GRIT_OK);
}

}  // namespace

int main(int argc, char** argv) {
    const long count = argc > 1 ? std::atol(argv[1]) : 100000;
    const auto sands = various_sands(60);
    Random random(20261121);
    Tally tally;
    for (long done = 0; done < count;) {
        const int n = static_cast<int>(std::min<long>(1 + random.below(64), count - done));
        run_batch(random,
                  sands[static_cast<std::size_t>(random.below(static_cast<int>(sands.size())))], n,
                  tally);
        done += n;
    }
    std::printf("%ld random updates, %.2f evaluations each, %ld at most\n", count,
                static_cast<double>(tally.evaluations) / static_cast<double>(count),
                tally.most_evaluations);
    for (int s = 0; s < 6; ++s)
        if (tally.status[s]) std::printf("%10ld %s\n", tally.status[s], grit_status_name(s));
    const char* names[] = {"stress-free", "void ratio clamped", "outside cone", "h clamped"};
    for (int f = 1; f < 16; ++f) {
        if (!tally.flags[f]) continue;
        std::printf("%10ld ok,", tally.flags[f]);
        for (int b = 0; b < 4; ++b)
            if (f >> b & 1) std::printf(" %s", names[b]);
        std::printf("\n");
    }
    std::printf(
        "%10ld NaN or infinite results\n%10ld failed points changed\n%10ld wrong statuses\n",
        tally.nan_out, tally.touched, tally.silent);
    return tally.nan_out || tally.touched || tally.silent ? EXIT_FAILURE : EXIT_SUCCESS;
}
