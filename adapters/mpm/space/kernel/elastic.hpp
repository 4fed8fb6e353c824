// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adapters/mpm/kernel/elastic.hpp"
#include "adapters/mpm/space/kernel/material.hpp"

namespace grit::mpm::space {

// Linear isotropic law of the objective stress rate, for small strains and any rotation.
class LinearElastic : public Material {
  public:
    LinearElastic(double youngs_modulus, double poissons_ratio);
    std::vector<std::string> words() const override { return elastic_words("linear elastic", law); }
    void update(const Range& range, const Increments& increments) override;
    void wave_moduli(const Range& range, double* moduli) const override;
    double energy(const ParticleView& particles, std::ptrdiff_t p) const override;

  private:
    LameConstants law;
    double per_E, nu;
};

// Compressible neo-Hooke: J sigma = mu (B - I) + lambda ln J I.
class NeoHooke : public Material {
  public:
    NeoHooke(double youngs_modulus, double poissons_ratio);
    std::vector<std::string> words() const override { return elastic_words("neo-Hooke", law); }
    void update(const Range& range, const Increments& increments) override;
    void wave_moduli(const Range& range, double* moduli) const override;
    double energy(const ParticleView& particles, std::ptrdiff_t p) const override;

  private:
    LameConstants law;
};

}  // namespace grit::mpm::space
