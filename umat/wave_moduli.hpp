// SPDX-License-Identifier: BSD-3-Clause
// Wave moduli of many points, pack by pack. Idle lanes repeat a point: a point's bits depend neither on n
// nor on its place.
#pragma once

#include <limits>

#include "umat/batch.hpp"
#include "umat/wave_modulus.hpp"

GRIT_KERNEL_BEGIN

class WaveModuli {
  public:
    explicit WaveModuli(const WaveModuliRequest& request) : q(request) {}

    // The first point without one, or -1.
    std::ptrdiff_t run() {
        for (std::ptrdiff_t first = 0; first < q.n; first += native_lanes) {
            const auto left = q.n - first;
            const int count = left < native_lanes ? static_cast<int>(left) : native_lanes;
            pack(first, count);
        }
        return bad;
    }

  private:
    void pack(std::ptrdiff_t first, int count) {
        Tensor<Lanes> T;
        Lanes e;
        bool usable[native_lanes];
        for (int lane = 0; lane < native_lanes; ++lane) {
            const std::ptrdiff_t i = first + (lane < count ? lane : 0);
            double stress[6], void_ratio;
            usable[lane] = read(q.points->index ? q.points->index[i] : i, stress, void_ratio);
            if (!usable[lane]) set_resting(stress, void_ratio);
            const Tensor<double> of_lane = stress_from_voigt(stress);
            for (int c = 0; c < 6; ++c) T[c].set(lane, of_lane[c]);
            e.set(lane, void_ratio);
        }
        const Material& m = *q.material;
        const Lanes moduli = wave_modulus(m, q.igs, stress_in_domain(m, T), e);
        for (int lane = 0; lane < count; ++lane) {
            q.moduli[first + lane] =
                usable[lane] ? moduli[lane] : std::numeric_limits<double>::quiet_NaN();
            if (!usable[lane] && bad < 0) bad = first + lane;
        }
    }

    bool read(std::ptrdiff_t at, double stress[6], double& void_ratio) const {
        const grit_mutable_view &t = q.points->stress, &s = q.points->state;
        const int n = q.points->components == 4 ? 4 : 6;
        for (int c = 0; c < 6; ++c)
            stress[c] = c < n ? element(t.base, t.point_stride, t.component_stride, at, c) : 0.0;
        void_ratio = element(s.base, s.point_stride, s.component_stride, at, GRIT_SAND_VOID_RATIO);
        return finite(stress, 6) && void_ratio > 0.0 && void_ratio <= largest_void_ratio;
    }
    // Numbers that do no harm in a lane that is not read.
    static void set_resting(double stress[6], double& void_ratio) {
        for (int c = 0; c < 6; ++c) stress[c] = 0.0;
        void_ratio = 1.0;
    }

    const WaveModuliRequest& q;
    std::ptrdiff_t bad = -1;
};

GRIT_KERNEL_END

namespace grit::GRIT_TARGET {

std::ptrdiff_t wave_moduli(const WaveModuliRequest& request) { return WaveModuli(request).run(); }

}  // namespace grit::GRIT_TARGET
