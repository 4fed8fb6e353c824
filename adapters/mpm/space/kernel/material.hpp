// SPDX-License-Identifier: BSD-3-Clause
// What a body in space is made of: stress from increments or from F, a range of particles at a time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "adapters/mpm/space/kernel/call.hpp"

namespace grit::mpm::space {

// Particles begin ... end - 1; their increments start at 0.
struct Range {
    ParticleView particles;
    std::ptrdiff_t begin, end;
};

class Material {
  public:
    virtual ~Material() = default;
    virtual int own_columns() const { return 0; }
    // As many as there are.
    virtual std::vector<const char*> own_column_names() const { return {}; }
    // Its law and each of its numbers, exactly: materials with the same words are the same.
    virtual std::vector<std::string> words() const = 0;
    // F is already that of the end of the step.
    virtual void update(const Range& range, const Increments& increments) = 0;
    // P-wave modulus of each particle, an upper bound [Pa].
    virtual void wave_moduli(const Range& range, double* moduli) const = 0;
    // Energy that the stress has stored, or taken, since the start [J].
    virtual double energy(const ParticleView& particles, std::ptrdiff_t p) const = 0;
    virtual Separation separation() const { return {}; }
};

// Beside columns, where hosts show particles: of water (total: effective - pore pressure, tension positive).
inline constexpr const char* pore_fields[] = {"pore_pressure", "total_xx", "total_yy", "total_zz"};

// Of the columns of a body's particles; null: rigid; no water: dry.
inline std::vector<std::string> column_names(const Material* material,
                                             const std::optional<PoreWater>& water = {}) {
    std::vector<std::string> out(std::begin(column::names), std::end(column::names));
    if (material)
        for (const char* name : material->own_column_names()) out.emplace_back(name);
    if (water)
        for (const char* name : water->column_names()) out.emplace_back(name);
    return out;
}

}  // namespace grit::mpm::space
