// SPDX-License-Identifier: BSD-3-Clause
// Grit's own sand behind the classic STATEV (grit/classic_layout.h), so that initialconditions.inp, exit
// conditions and columns mean what they mean with the UMAT.
#pragma once

#include "element/incremental_driver/classic_props.hpp"

namespace incremental_driver {

class ClassicLaw : public element::Law {
  public:
    // nstatv >= GRIT_CLASSIC_NSTATV; what lies beyond 14 is left alone.
    ClassicLaw(ClassicSand sand, int nstatv);

    // The stress is the total stress; STATEV(8) carries the pore water.
    element::Response advance(const element::MaterialPoint& start,
                              const element::StrainIncrement& increment) const override;
    element::Observation observe(const element::MaterialPoint& point) const override;
    const std::vector<std::string>& state_names() const override { return names; }

    // Throws element::BadCase for a point that the sand cannot start from.
    void check(const element::MaterialPoint& start) const;

  private:
    element::MaterialPoint own(const element::MaterialPoint& classic) const;
    double pore_pressure(const element::MaterialPoint& classic) const;  // what bears

    ClassicSand sand;
    std::vector<std::string> names;
};

}  // namespace incremental_driver
