// SPDX-License-Identifier: BSD-3-Clause
// What the words of a case may say, in files of cases and in fix grit/mpm alike.
#pragma once

namespace grit::mpm::limits {

struct Range {
    double low, high;
};

// In SI units.
inline constexpr Range gravity{0.0, 1e6};
inline constexpr Range growth{0.5, 2.0};  // of cells
inline constexpr Range cells{1, 100000};  // of a segment
inline constexpr Range cfl{1e-3, 1.0};
inline constexpr Range pic_rate{0.0, 1e5};
inline constexpr Range local_damping{0.0, 0.95};
inline constexpr Range bulk_viscosity{0.0, 10.0};
inline constexpr Range threads{1, 1024};
inline constexpr Range energy_residual_limit{1e-6, 1e6};
inline constexpr Range friction_coefficient{0.0, 100.0};
inline constexpr Range penalty_power{1e-6, 1e6};
inline constexpr Range blows{1, 1000000};
inline constexpr Range share{0.0, 1.0};  // of what is unbalanced, and of kinetic energy
inline constexpr Range tolerance{1e-12, 0.1};
inline constexpr Range pulses{1, 1000000};
inline constexpr Range pulse_start{0.0, 1e9};

}  // namespace grit::mpm::limits
