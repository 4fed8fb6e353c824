// SPDX-License-Identifier: BSD-3-Clause
// Sand of the library in space, called as any host would.
#pragma once

#include "adapters/mpm/kernel/sand.hpp"
#include "adapters/mpm/space/kernel/material.hpp"

namespace grit::mpm::space {

class Sand : public Material {
  public:
    static constexpr int state = column::own;  // first of the library's
    static constexpr int work = state + GRIT_SAND_STATE_SIZE;

    Sand(const grit_sand& prepared, const grit_sand_options& given)
        : sand(prepared), options(given) {}
    int own_columns() const override { return GRIT_SAND_STATE_SIZE + 1; }
    std::vector<const char*> own_column_names() const override {
        return {"h_xx", "h_yy", "h_zz", "h_xy", "h_xz", "h_yz", "e", "separation", "work"};
    }
    std::vector<std::string> words() const override { return sand_words(sand, options); }
    void update(const Range& range, const Increments& increments) override;
    void wave_moduli(const Range& range, double* moduli) const override;
    double energy(const ParticleView& q, std::ptrdiff_t p) const override { return q[work][p]; }
    Separation separation() const override {
        return {state + GRIT_SAND_VOID_RATIO, opening_cap(sand)};
    }

    const grit_sand& prepared() const { return sand; }
    const grit_sand_options& update_options() const { return options; }

  private:
    grit_sand sand;
    grit_sand_options options;
};

}  // namespace grit::mpm::space
