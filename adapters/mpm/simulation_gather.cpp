// SPDX-License-Identifier: BSD-3-Clause
// Back to the particles: velocity, position, deformation, stress.
#include <algorithm>
#include <cmath>

#include "adapters/mpm/for_strips.hpp"
#include "adapters/mpm/kernel/material_failure.hpp"
#include "adapters/mpm/simulation.hpp"

namespace grit::mpm {

void Simulation::gather(unsigned tasks, double by) {
    if (tasks & (task::velocity | task::position))
        for (Part& part : parts)
            if (!(tasks == (task::position | task::deform_by_other)))
                std::fill(part.gather_sums.begin(), part.gather_sums.end(), GatherSums{});
    const bool deforms = tasks & (task::deformation | task::deform_by_other);
    if (!settings.cell_mean || !deforms)
        return for_strips(pool, parts, [&, this](Part& part, int strip) {
            gather_strip(part, strip, tasks, by);
        });
    for (Part& part : parts) {
        std::fill(part.cells.begin(), part.cells.end(), CellIntegers{});
        part.mean.cells = part.cells.data();
        part.mean.deferred = part.deferred.data();
    }
    for (const int colour : {0, 1})  // neighbours may add to the same cell
        for_strips(pool, parts, [&, this](Part& part, int strip) {
            if (strip % 2 == colour) gather_strip(part, strip, tasks, by);
        });
    for (Part& part : parts)
        exchange.sum_cells(part.cells.data(), static_cast<std::ptrdiff_t>(part.cells.size()));
    for_strips(pool, parts, [this](Part& part, int strip) { deform_strip(part, strip); });
}

void Simulation::gather_strip(Part& part, int strip, unsigned tasks, double by) {
    const auto s = static_cast<std::size_t>(strip);
    if (part.body.rigid()) tasks &= task::position;
    if (tasks == 0) return;
    const bool updates =
        (tasks & (task::deformation | task::deform_by_other)) && part.cells.empty();
    const std::ptrdiff_t end = part.strips.begin(strip + 1);
    double fastest = 0.0;
    for (std::ptrdiff_t begin = part.strips.begin(strip); begin < end;) {
        const std::ptrdiff_t stop = std::min<std::ptrdiff_t>(begin + Increments::capacity, end);
        const ParticleView q = part.body.particles.view();
        const GatherCall call{grid(),
                              q,
                              begin,
                              stop,
                              part.motions.data(),
                              by,
                              settings.pic_rate * by,
                              tasks,
                              part.separation,
                              part.mean};
        kernels().gather(settings.shape, settings.axisymmetric, call, part.increments[s],
                         part.gather_sums[s]);
        if (updates) fastest = std::max(fastest, update(part, strip, {q, begin, stop}));
        begin = stop;
    }
    if (updates) part.speed[s] = std::sqrt(fastest);
}

void Simulation::deform_strip(Part& part, int strip) {
    if (part.body.rigid()) return;
    const auto s = static_cast<std::size_t>(strip);
    const ParticleView q = part.body.particles.view();
    const std::ptrdiff_t end = part.strips.begin(strip + 1);
    double fastest = 0.0;
    for (std::ptrdiff_t begin = part.strips.begin(strip); begin < end;) {
        const std::ptrdiff_t stop = std::min<std::ptrdiff_t>(begin + Increments::capacity, end);
        kernels().deform(settings.axisymmetric,
                         {q, begin, stop, part.mean.cells, part.mean.deferred, part.separation},
                         part.increments[s]);
        fastest = std::max(fastest, update(part, strip, {q, begin, stop}));
        begin = stop;
    }
    part.speed[s] = std::sqrt(fastest);
}

void Simulation::update_stress(const Part& part, const Range& range,
                               const Increments& increments) const {
    try {
        part.body.material->update(range, increments);
    } catch (const MaterialFailure& failure) {
        throw failure.of(static_cast<std::size_t>(&part - parts.data()), part.body.name,
                         part.body.particles.ids()[failure.place()], t);
    }
}

// Stress of a range, and the largest M / rho in it.
double Simulation::update(Part& part, int strip, const Range& range) {
    const auto s = static_cast<std::size_t>(strip);
    const ParticleView& q = range.particles;
    const Material& material = *part.body.material;
    update_stress(part, range, part.increments[s]);
    double moduli[Increments::capacity], fastest = 0.0;
    material.wave_moduli(range, moduli);
    for (std::ptrdiff_t p = range.begin; p < range.end; ++p) {
        const double per_density = q[column::V0][p] * q.J(p) / q[column::mass][p];
        fastest = std::max(fastest, moduli[p - range.begin] * per_density);
    }
    if (part.gather_sums[s].reflected > 0)
        for (std::ptrdiff_t p = range.begin; p < range.end; ++p)
            if (q[column::r][p] < 0.0) reflect(material, q, p);
    return fastest;
}

}  // namespace grit::mpm
