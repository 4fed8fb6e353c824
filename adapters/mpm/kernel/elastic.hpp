// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adapters/mpm/kernel/material.hpp"

namespace grit::mpm {

struct LameConstants {
    double lambda, mu;  // [Pa]
    double wave_modulus() const { return lambda + 2.0 * mu; }
};
LameConstants lame_constants(double youngs_modulus, double poissons_ratio);
// Material::words of such a law.
std::vector<std::string> elastic_words(const char* law, const LameConstants& constants);

// Linear isotropic law of the objective stress rate, for small strains and any rotation.
class LinearElastic : public Material {
  public:
    LinearElastic(double youngs_modulus, double poissons_ratio);
    std::vector<std::string> words() const override;
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
    std::vector<std::string> words() const override;
    void update(const Range& range, const Increments& increments) override;
    void wave_moduli(const Range& range, double* moduli) const override;
    double energy(const ParticleView& particles, std::ptrdiff_t p) const override;

  private:
    LameConstants law;
};

}  // namespace grit::mpm
