// SPDX-License-Identifier: BSD-3-Clause
// Sand of the library, called as any host would.
#pragma once

#include <grit/sand.h>

#include "adapters/mpm/kernel/material.hpp"

namespace grit::mpm {

// Material::words of a sand.
std::vector<std::string> sand_words(const grit_sand& sand, const grit_sand_options& options);
// Void ratio beyond which separated sand no longer opens: e = 1.2 e_i at zero pressure.
double opening_cap(const grit_sand& sand);

class Sand : public Material {
  public:
    static constexpr int state = column::own;  // first of the library's
    static constexpr int work = state + GRIT_SAND_STATE_SIZE;

    Sand(const grit_sand& sand, const grit_sand_options& options);
    int own_columns() const override { return GRIT_SAND_STATE_SIZE + 1; }
    std::vector<const char*> own_column_names() const override;
    std::vector<std::string> words() const override;
    void update(const Range& range, const Increments& increments) override;
    void wave_moduli(const Range& range, double* moduli) const override;
    double energy(const ParticleView& particles, std::ptrdiff_t p) const override;
    Separation separation() const override;
    bool knows_no_deformation() const override { return true; }
    void reflect(const ParticleView& particles, std::ptrdiff_t p) const override;

    const grit_sand& prepared() const { return sand; }
    const grit_sand_options& update_options() const { return options; }

  private:
    grit_sand sand;
    grit_sand_options options;
};

}  // namespace grit::mpm
