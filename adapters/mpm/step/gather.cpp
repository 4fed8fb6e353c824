// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/gather.hpp"

#include <algorithm>
#include <cmath>

#include "adapters/mpm/kernel/material_failure.hpp"
#include "adapters/mpm/step/ranges.hpp"
#include "adapters/mpm/step/stopwatch.hpp"

namespace grit::mpm {
void Gather::add_body() {
    OfBody& body = bodies.emplace_back();
    with_half = with_half || model.parts.back().body.water;
    body.strips.resize(static_cast<std::size_t>(model.strips()));
    body.increments.resize(body.strips.size());
    for (Increments& d : body.increments) {
        d = {};
        std::fill_n(d.rotation[8], Increments::capacity, 1.0);
    }
}

void Gather::operator()(unsigned tasks) {
    const bool deforms = tasks & (task::deformation | task::deform_by_other);
    const bool moves = tasks & (task::velocity | task::position);
    for (OfBody& body : bodies)
        for (OfStrip& strip : body.strips) {
            // The second half of MUSL goes on with the sums of the first.
            if (moves && tasks != (task::position | task::deform_by_other)) strip.sums = {};
            if (deforms) strip.viscous_loss = strip.half = Total();
        }
    const auto work = [&, this](std::size_t body, int strip) { gather(body, strip, tasks); };
    const bool has_means = means.wanted() && deforms;
    if (!has_means && !water.is_anywhere()) return model.for_strips(work);
    if (has_means) means.begin_strains();
    model.for_strips_apart(work);
    if (!has_means) return;
    means.sum();
    model.for_strips([this](std::size_t body, int strip) { deform(body, strip); });
}

void Gather::gather(std::size_t body, int strip, unsigned tasks) {
    Part& part = model.parts[body];
    const Settings& settings = model.settings;
    const auto s = static_cast<std::size_t>(strip);
    OfStrip& sums = bodies[body].strips[s];
    if (part.body.rigid()) tasks &= task::position;
    if (tasks == 0) return;
    const bool updates = (tasks & (task::deformation | task::deform_by_other)) && !means.has(body);
    const ParticleView q = part.body.particles.view();
    const bool has_water = water.has(body);
    const WaterGather of_water = has_water ? water.gathered(body, strip) : WaterGather{};
    double fastest = 0.0;
    each_range(part.strips, strip, Increments::capacity,
               [&](std::ptrdiff_t begin, std::ptrdiff_t stop) {
                   const GatherCall call{model.grid(),
                                         q,
                                         begin,
                                         stop,
                                         part.motions.data(),
                                         model.dt,
                                         std::min(settings.pic_rate * model.dt, 1.0),
                                         tasks,
                                         part.separation,
                                         part.reduces_domains,
                                         means.of(body),
                                         settings.fixed_point,
                                         has_water ? &of_water : nullptr};
                   kernels().gather(settings.shape, settings.axisymmetric, call,
                                    bodies[body].increments[s], sums.sums);
                   if (updates) fastest = std::max(fastest, update(body, strip, {q, begin, stop}));
               });
    if (updates) sums.speed = std::sqrt(fastest);
}

// The rest of deformation, with the means of cells.
void Gather::deform(std::size_t body, int strip) {
    Part& part = model.parts[body];
    if (part.body.rigid()) return;
    const auto s = static_cast<std::size_t>(strip);
    const ParticleView q = part.body.particles.view();
    double fastest = 0.0;
    each_range(part.strips, strip, Increments::capacity,
               [&](std::ptrdiff_t begin, std::ptrdiff_t stop) {
                   const CellMean& mean = means.of(body);
                   kernels().deform(model.settings.axisymmetric,
                                    {q, begin, stop, mean.cells, mean.deferred, part.separation,
                                     part.reduces_domains},
                                    bodies[body].increments[s]);
                   fastest = std::max(fastest, update(body, strip, {q, begin, stop}));
               });
    bodies[body].strips[s].speed = std::sqrt(fastest);
}

void Gather::update_stress(std::size_t body, const Range& range,
                           const Increments& increments) const {
    const Body& of = model.parts[body].body;
    try {
        of.material->update(range, increments);
    } catch (const MaterialFailure& failure) {
        throw failure.of(body, of.name, of.particles.ids()[failure.place()], model.t);
    }
}

// Bulk viscosity of a range: von Neumann & Richtmyer (1950), doi 10.1063/1.1699639, with Landshoff's linear
// term; none where there is no stress, in separated sand. Returns the largest square of the speed that a
// stable step wants, c (x + sqrt(1 + x^2)) with x the damping ratio.
double Gather::update_viscosity(OfStrip& sums, const Increments& d, const Range& range,
                                const double* moduli) const {
    const ParticleView& q = range.particles;
    const GridView g = model.grid();
    const Settings& settings = model.settings;
    double fastest = 0.0;
    for (std::ptrdiff_t p = range.begin; p < range.end; ++p) {
        const std::ptrdiff_t i = p - range.begin;
        const double strain = d.strain[0][i] + d.strain[1][i] + d.strain[2][i];
        const double volume = q[column::V0][p] * q.J(p), density = q[column::mass][p] / volume;
        const double c = std::sqrt(moduli[i] / density);
        const double l = 1.0 / std::max(g.r.inverse[g.r.cell_of(q[column::r][p])],
                                        g.z.inverse[g.z.cell_of(q[column::z][p])]);
        const bool stress_free = q[column::S_rr][p] == 0.0 && q[column::S_zz][p] == 0.0;
        const double rate = strain < 0.0 && !stress_free ? -strain / model.dt : 0.0;
        const double x = c > 0.0 && rate > 0.0 ? settings.linear_viscosity +
                                                     settings.quadratic_viscosity * l * rate / c
                                               : 0.0;
        const double viscous = density * l * c * x * rate;
        sums.viscous_loss.add(-0.5 * (q[column::q][p] + viscous) * strain * volume,
                              settings.fixed_point);
        q[column::q][p] = viscous;
        const double speed = c * (x + std::sqrt(1.0 + x * x));
        fastest = std::max(fastest, speed * speed);
    }
    return fastest;
}

// Half a step's work of the stresses of the end, by which velocities are behind them (WaterSums::half).
void Gather::add_half(OfStrip& sums, const Increments& d, const Range& range) const {
    const ParticleView& q = range.particles;
    for (std::ptrdiff_t p = range.begin; p < range.end; ++p) {
        const std::ptrdiff_t i = p - range.begin;
        const double rate = (q[column::S_rr][p] - q[column::q][p]) * d.strain[0][i] +
                            (q[column::S_zz][p] - q[column::q][p]) * d.strain[1][i] +
                            (q[column::S_tt][p] - q[column::q][p]) * d.strain[2][i] +
                            q[column::S_rz][p] * d.strain[3][i];
        sums.half.add(0.5 * q[column::V0][p] * q.J(p) * rate, model.settings.fixed_point);
    }
}

// Stress of a range, and the largest M / rho in it.
double Gather::update(std::size_t body, int strip, const Range& range) {
    const auto s = static_cast<std::size_t>(strip);
    const Increments& increments = bodies[body].increments[s];
    OfStrip& sums = bodies[body].strips[s];
    const ParticleView& q = range.particles;
    const Material& material = *model.parts[body].body.material;
    const Settings& settings = model.settings;
    Stopwatch watch;
    update_stress(body, range, increments);
    double moduli[Increments::capacity], fastest = 0.0;
    material.wave_moduli(range, moduli);
    watch.lap(sums.material_seconds);
    for (std::ptrdiff_t p = range.begin; p < range.end; ++p) {
        const double per_density = q[column::V0][p] * q.J(p) / q[column::mass][p];
        fastest = std::max(fastest, moduli[p - range.begin] * per_density);
    }
    if (settings.linear_viscosity > 0.0 || settings.quadratic_viscosity > 0.0)
        fastest = update_viscosity(sums, increments, range, moduli);
    if (with_half) add_half(sums, increments, range);
    if (sums.sums.reflected > 0)
        for (std::ptrdiff_t p = range.begin; p < range.end; ++p)
            if (q[column::r][p] < 0.0) {
                reflect(material, q, p);
                if (model.parts[body].body.water) reflect(*model.parts[body].body.water, q, p);
            }
    return fastest;
}

void Gather::measure() {
    model.for_strips([this](std::size_t i, int strip) {
        Part& part = model.parts[i];
        OfStrip& sums = bodies[i].strips[static_cast<std::size_t>(strip)];
        const ParticleView q = part.body.particles.view();
        const std::ptrdiff_t end = part.strips.begin(strip + 1);
        double fastest = 0.0, most_v2 = 0.0;
        for (std::ptrdiff_t p = part.strips.begin(strip); p < end; ++p) {
            double modulus = 0.0;
            if (!part.body.rigid()) part.body.material->wave_moduli({q, p, p + 1}, &modulus);
            fastest = std::max(fastest, modulus * q[column::V0][p] * q.J(p) / q[column::mass][p]);
            const double v_r = q[column::v_r][p], v_z = q[column::v_z][p];
            most_v2 = std::max(most_v2, v_r * v_r + v_z * v_z);
        }
        sums.speed = std::sqrt(fastest);
        sums.sums.most_v2 = most_v2;
    });
}

}  // namespace grit::mpm
