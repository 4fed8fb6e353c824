// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/space/step/gather.hpp"

#include <algorithm>
#include <cmath>

#include "adapters/mpm/kernel/material_failure.hpp"
#include "adapters/mpm/step/ranges.hpp"
#include "adapters/mpm/step/stopwatch.hpp"

namespace grit::mpm::space {
void Gather::add_body() { bodies.emplace_back(static_cast<std::size_t>(model.pencils())); }

void Gather::operator()() {
    for (std::vector<OfPencil>& body : bodies)
        for (OfPencil& pencil : body) {
            pencil.sums = {};
            pencil.viscous_loss = pencil.half = {};
        }
    const auto work = [this](std::size_t body, int pencil) { gather(body, pencil); };
    if (means.wanted()) {
        means.begin_strains();
        model.for_pencils_apart(work);
        means.sum();
        model.for_pencils([this](std::size_t body, int pencil) { deform(body, pencil); });
    } else {
        model.for_pencils(work);
    }
    water.update();
}

void Gather::gather(std::size_t body, int pencil) {
    Part& part = model.parts[body];
    const Settings& settings = model.settings;
    OfPencil& sums = bodies[body][static_cast<std::size_t>(pencil)];
    const ParticleView q = part.body.particles.view();
    if (part.body.rigid()) return carry(part, pencil, sums.sums);
    const bool updates = !means.has(body);
    double fastest = 0.0;
    Increments increments;
    each_range(
        part.pencils, pencil, Increments::capacity, [&](std::ptrdiff_t begin, std::ptrdiff_t stop) {
            const GatherCall call{model.grid(),
                                  q,
                                  begin,
                                  stop,
                                  part.motions.data(),
                                  model.dt,
                                  std::min(settings.pic_rate * model.dt, 1.0),
                                  part.separation,
                                  means.of(body),
                                  settings.fixed_point,
                                  water.strains(body)};
            kernels().gather(settings.shape, call, increments, sums.sums);
            if (updates)
                fastest = std::max(fastest, update(body, sums, {q, begin, stop}, increments));
        });
    if (updates) sums.speed = std::sqrt(fastest);
}

// Particles of a rigid body.
void Gather::carry(Part& part, int pencil, GatherSums& sums) const {
    const RigidMotion& motion = *part.body.motion;
    const ParticleView q = part.body.particles.view();
    const GridView grid = model.grid();
    for (std::ptrdiff_t p = part.pencils.begin(pencil); p < part.pencils.begin(pencil + 1); ++p) {
        const Vector3 from = q.position(p), to = motion.moved(from), v = motion.velocity_at(to);
        for (int k = 0; k < 3; ++k) {
            const Vector3 side = motion.turned({q.F(0, k, p), q.F(1, k, p), q.F(2, k, p)});
            for (int j = 0; j < 3; ++j) q[column::F_xx + 3 * j + k][p] = side[j];
            q[column::x + k][p] = to[k];
            q[column::v_x + k][p] = v[k];
        }
        for (int k = 1; k < 3; ++k) {
            double& farthest = sums.farthest[k - 1];
            farthest = std::max(farthest, std::fabs(to[k] - from[k]));
        }
        sums.outside += !grid.has(to);
    }
}

// The rest of deformation, with the means of cells.
void Gather::deform(std::size_t body, int pencil) {
    if (!means.has(body)) return;
    Part& part = model.parts[body];
    OfPencil& sums = bodies[body][static_cast<std::size_t>(pencil)];
    const ParticleView q = part.body.particles.view();
    const CellMean& mean = means.of(body);
    double fastest = 0.0;
    Increments increments;
    each_range(part.pencils, pencil, Increments::capacity,
               [&](std::ptrdiff_t begin, std::ptrdiff_t stop) {
                   kernels().deform({q, begin, stop, mean.cells, mean.deferred, part.separation},
                                    increments);
                   fastest = std::max(fastest, update(body, sums, {q, begin, stop}, increments));
               });
    sums.speed = std::sqrt(fastest);
}

// Stress of a range, and the largest square of the speed that a stable step wants.
double Gather::update(std::size_t body, OfPencil& sums, const Range& range, const Increments& d) {
    const Body& of = model.parts[body].body;
    const ParticleView& q = range.particles;
    Stopwatch watch;
    try {
        of.material->update(range, d);
    } catch (const MaterialFailure& failure) {
        throw failure.of(body, of.name, of.particles.ids()[failure.place()], model.t);
    }
    double moduli[Increments::capacity], fastest = 0.0;
    of.material->wave_moduli(range, moduli);
    watch.lap(sums.material_seconds);
    if (model.settings.linear_viscosity > 0.0 || model.settings.quadratic_viscosity > 0.0) {
        fastest = update_viscosity(sums, d, range, moduli);
    } else {
        for (std::ptrdiff_t p = range.begin; p < range.end; ++p)
            fastest = std::max(fastest, moduli[p - range.begin] * q.volume(p) / q[column::mass][p]);
    }
    if (water.is_anywhere()) add_half(sums, d, range);
    return fastest;
}

// Half a step's work of the stresses of the end, by which velocities are behind them (WaterSums::half).
void Gather::add_half(OfPencil& sums, const Increments& d, const Range& range) const {
    const ParticleView& q = range.particles;
    for (std::ptrdiff_t p = range.begin; p < range.end; ++p) {
        double rate = 0.0;
        for (int k = 0; k < 6; ++k)
            rate += (q[column::S_xx + k][p] - (k < 3 ? q[column::q][p] : 0.0)) *
                    d.strain[k][p - range.begin];
        sums.half.add(0.5 * q.volume(p) * rate, model.settings.fixed_point);
    }
}

// Bulk viscosity of a range, as in the plane.
double Gather::update_viscosity(OfPencil& sums, const Increments& d, const Range& range,
                                const double* moduli) const {
    const ParticleView& q = range.particles;
    const GridView g = model.grid();
    const Settings& settings = model.settings;
    double fastest = 0.0;
    for (std::ptrdiff_t p = range.begin; p < range.end; ++p) {
        const std::ptrdiff_t i = p - range.begin;
        const double strain = d.strain[0][i] + d.strain[1][i] + d.strain[2][i];
        const double volume = q.volume(p), density = q[column::mass][p] / volume;
        const double c = std::sqrt(moduli[i] / density);
        double per_l = 0.0;
        for (int k = 0; k < 3; ++k)
            per_l = std::max(per_l, g.axis[k].inverse[g.axis[k].cell_of(q[column::x + k][p])]);
        const double l = 1.0 / per_l;
        bool stress_free = true;
        for (int k = 0; k < 6; ++k) stress_free = stress_free && q[column::S_xx + k][p] == 0.0;
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

void Gather::measure() {
    model.for_pencils([this](std::size_t i, int pencil) {
        Part& part = model.parts[i];
        OfPencil& sums = bodies[i][static_cast<std::size_t>(pencil)];
        const ParticleView q = part.body.particles.view();
        const std::ptrdiff_t end = part.pencils.begin(pencil + 1);
        double fastest = 0.0, most_v2 = 0.0;
        for (std::ptrdiff_t p = part.pencils.begin(pencil); p < end; ++p) {
            double modulus = 0.0;
            if (!part.body.rigid()) part.body.material->wave_moduli({q, p, p + 1}, &modulus);
            fastest = std::max(fastest, modulus * q.volume(p) / q[column::mass][p]);
            const Vector3 v = q.vector(column::v_x, p);
            most_v2 = std::max(most_v2, dot(v, v));
        }
        sums.speed = std::sqrt(fastest);
        sums.sums.most_v2 = most_v2;
    });
}

}  // namespace grit::mpm::space
