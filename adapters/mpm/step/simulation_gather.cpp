// SPDX-License-Identifier: BSD-3-Clause
// Back to the particles: velocity, position, deformation, stress.
#include <algorithm>
#include <cmath>

#include "adapters/mpm/kernel/material_failure.hpp"
#include "adapters/mpm/step/for_strips.hpp"
#include "adapters/mpm/step/simulation.hpp"

namespace grit::mpm {

void Simulation::gather(unsigned tasks, double by) {
    if (tasks & (task::velocity | task::position))
        for (Part& part : parts)
            if (!(tasks == (task::position | task::deform_by_other)))
                std::fill(part.gather_sums.begin(), part.gather_sums.end(), GatherSums{});
    const bool deforms = tasks & (task::deformation | task::deform_by_other);
    if (deforms)
        for (Part& part : parts)
            std::fill(part.viscous_loss.begin(), part.viscous_loss.end(), Total());
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
        if (!part.cells.empty())
            exchange.sum_cells(part.cells.data(), static_cast<std::ptrdiff_t>(part.cells.size()));
    for_strips(pool, parts, [this](Part& part, int strip) { deform_strip(part, strip); });
}

// work(begin, end) of no more particles than increments hold.
template <class Work> void Simulation::each_range(const Part& part, int strip, const Work& work) {
    const std::ptrdiff_t end = part.strips.begin(strip + 1);
    for (std::ptrdiff_t begin = part.strips.begin(strip); begin < end;) {
        const std::ptrdiff_t stop = std::min<std::ptrdiff_t>(begin + Increments::capacity, end);
        work(begin, stop);
        begin = stop;
    }
}

void Simulation::gather_strip(Part& part, int strip, unsigned tasks, double by) {
    const auto s = static_cast<std::size_t>(strip);
    if (part.body.rigid()) tasks &= task::position;
    if (tasks == 0) return;
    const bool updates =
        (tasks & (task::deformation | task::deform_by_other)) && part.cells.empty();
    const ParticleView q = part.body.particles.view();
    double fastest = 0.0;
    each_range(part, strip, [&](std::ptrdiff_t begin, std::ptrdiff_t stop) {
        const GatherCall call{grid(),
                              q,
                              begin,
                              stop,
                              part.motions.data(),
                              by,
                              std::min(settings.pic_rate * by, 1.0),
                              tasks,
                              part.separation,
                              part.mean,
                              settings.fixed_point};
        kernels().gather(settings.shape, settings.axisymmetric, call, part.increments[s],
                         part.gather_sums[s]);
        if (updates) fastest = std::max(fastest, update(part, strip, {q, begin, stop}));
    });
    if (updates) part.speed[s] = std::sqrt(fastest);
}

void Simulation::deform_strip(Part& part, int strip) {
    if (part.body.rigid()) return;
    const auto s = static_cast<std::size_t>(strip);
    const ParticleView q = part.body.particles.view();
    double fastest = 0.0;
    each_range(part, strip, [&](std::ptrdiff_t begin, std::ptrdiff_t stop) {
        kernels().deform(settings.axisymmetric,
                         {q, begin, stop, part.mean.cells, part.mean.deferred, part.separation},
                         part.increments[s]);
        fastest = std::max(fastest, update(part, strip, {q, begin, stop}));
    });
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

// Bulk viscosity of a range: von Neumann & Richtmyer (1950), doi 10.1063/1.1699639, with Landshoff's linear
// term; none where there is no stress, in separated sand. Returns the largest square of the speed that a
// stable step wants, c (x + sqrt(1 + x^2)) with x the damping ratio.
double Simulation::update_viscosity(Part& part, int strip, const Range& range,
                                    const double* moduli) {
    const ParticleView& q = range.particles;
    const Increments& d = part.increments[static_cast<std::size_t>(strip)];
    const GridView g = grid();
    Total& loss = part.viscous_loss[static_cast<std::size_t>(strip)];
    double fastest = 0.0;
    for (std::ptrdiff_t p = range.begin; p < range.end; ++p) {
        const std::ptrdiff_t i = p - range.begin;
        const double strain = d.strain[0][i] + d.strain[1][i] + d.strain[2][i];
        const double volume = q[column::V0][p] * q.J(p), density = q[column::mass][p] / volume;
        const double c = std::sqrt(moduli[i] / density);
        const double l = 1.0 / std::max(g.r.inverse[g.r.cell_of(q[column::r][p])],
                                        g.z.inverse[g.z.cell_of(q[column::z][p])]);
        const bool stress_free = q[column::S_rr][p] == 0.0 && q[column::S_zz][p] == 0.0;
        const double rate = strain < 0.0 && !stress_free ? -strain / dt : 0.0;
        const double x = c > 0.0 && rate > 0.0 ? settings.linear_viscosity +
                                                     settings.quadratic_viscosity * l * rate / c
                                               : 0.0;
        const double viscous = density * l * c * x * rate;
        loss.add(-0.5 * (q[column::q][p] + viscous) * strain * volume, settings.fixed_point);
        q[column::q][p] = viscous;
        const double speed = c * (x + std::sqrt(1.0 + x * x));
        fastest = std::max(fastest, speed * speed);
    }
    return fastest;
}

// Stress of a range, and the largest M / rho in it.
double Simulation::update(Part& part, int strip, const Range& range) {
    const auto s = static_cast<std::size_t>(strip);
    const ParticleView& q = range.particles;
    const Material& material = *part.body.material;
    Stopwatch watch;
    update_stress(part, range, part.increments[s]);
    double moduli[Increments::capacity], fastest = 0.0;
    material.wave_moduli(range, moduli);
    watch.lap(part.material_seconds[s]);
    for (std::ptrdiff_t p = range.begin; p < range.end; ++p) {
        const double per_density = q[column::V0][p] * q.J(p) / q[column::mass][p];
        fastest = std::max(fastest, moduli[p - range.begin] * per_density);
    }
    if (settings.linear_viscosity > 0.0 || settings.quadratic_viscosity > 0.0)
        fastest = update_viscosity(part, strip, range, moduli);
    if (part.gather_sums[s].reflected > 0)
        for (std::ptrdiff_t p = range.begin; p < range.end; ++p)
            if (q[column::r][p] < 0.0) reflect(material, q, p);
    return fastest;
}

}  // namespace grit::mpm
