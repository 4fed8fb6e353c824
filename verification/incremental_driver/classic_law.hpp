// SPDX-License-Identifier: BSD-3-Clause
// Grit's own sand behind the classic STATEV, so that initialconditions.inp, exit conditions and columns
// mean what they mean with the UMAT: 1-6 h (11 22 33 12 13 23), 7 e, 8 minus the excess pore pressure,
// 9 p', 10 evaluations, 11 mobilised friction angle [deg], 12 rho, 13 substep, 14 separation.
#pragma once

#include "incremental_driver/classic_props.hpp"

namespace incremental_driver {

inline constexpr int classic_nstatv = 13;  // the least; with 14 the separation is kept

class ClassicLaw : public element::Law {
  public:
    // nstatv >= classic_nstatv; what lies beyond 14 is left alone.
    ClassicLaw(ClassicSand sand, int nstatv);

    // The stress is the total stress; STATEV(8) carries the pore water.
    element::Response advance(const element::MaterialPoint& start,
                              const element::StrainIncrement& increment) const override;
    element::Observation observe(const element::MaterialPoint& point) const override;
    const std::vector<std::string>& state_names() const override { return names; }

    // Throws element::BadCase for a point that the sand cannot start from.
    void check(const element::MaterialPoint& start) const;

  private:
    element::MaterialPoint effective(const element::MaterialPoint& classic) const;

    ClassicSand sand;
    std::vector<std::string> names;
};

}  // namespace incremental_driver
