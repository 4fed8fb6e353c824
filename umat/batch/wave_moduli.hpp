// SPDX-License-Identifier: BSD-3-Clause
// Wave moduli of many points, pack by pack. Idle lanes repeat a point: a point's bits depend neither on n
// nor on its place.
#pragma once

#include <limits>

#include "umat/batch/batch.hpp"
#include "umat/model/wave_modulus.hpp"

GRIT_KERNEL_BEGIN

class WaveModuli {
  public:
    explicit WaveModuli(const WaveModuliRequest& request) : q(request) {}

    // The first point without one, or -1.
    std::ptrdiff_t run() {
        for (std::ptrdiff_t first = 0; first < q.n; first += native_lanes) pack(first);
        return bad;
    }

  private:
    void pack(std::ptrdiff_t first) {
        const Material& m = *q.material;
        const auto lane_points = LanePoints<Lanes>::from(q, first);
        const int n = q.points->components == 4 ? 4 : 6;
        const Lanes zero(0.0);
        Tensor<Lanes> T;
        Lanes sum = zero;  // 0 x is 0 for a finite x, NaN otherwise
        for (int c = 0; c < 6; ++c) {
            T[c] = c < n ? (c < 3 ? 1.0 : root_2) * read(q.points->stress, lane_points, c) : zero;
            sum = sum + zero * T[c];
        }
        Lanes e = read(q.points->state, lane_points, GRIT_SAND_VOID_RATIO);
        const auto usable = (sum >= zero) & (e > zero) & (e <= Lanes(largest_void_ratio));
        // Numbers that do no harm in a lane that is not read.
        T = select(usable, T, isotropic(zero));
        e = select(usable, e, Lanes(1.0));
        const Lanes moduli = select(usable, wave_modulus(m, q.igs, stress_in_domain(m, T), e),
                                    Lanes(std::numeric_limits<double>::quiet_NaN()));
        for (int lane = 0; lane < lane_points.count; ++lane) {
            q.moduli[first + lane] = moduli[lane];
            if (!usable[lane] && bad < 0) bad = first + lane;
        }
    }

    const WaveModuliRequest& q;
    std::ptrdiff_t bad = -1;
};

GRIT_KERNEL_END

namespace grit::GRIT_TARGET {

std::ptrdiff_t wave_moduli(const WaveModuliRequest& request) { return WaveModuli(request).run(); }

}  // namespace grit::GRIT_TARGET
