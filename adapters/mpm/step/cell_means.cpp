// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/cell_means.hpp"

#include <algorithm>

namespace grit::mpm {

void CellMeans::add_body() {
    const Part& part = model.parts[bodies.size()];
    OfBody& body = bodies.emplace_back();
    body.most_stress.resize(static_cast<std::size_t>(part.strips.count()));
    if (wanted() && !part.body.rigid())
        body.cells.resize(static_cast<std::size_t>(model.r.cells()) *
                          static_cast<std::size_t>(model.z.cells()));
    particles_changed(bodies.size() - 1);
}

void CellMeans::particles_changed(std::size_t body) {
    if (has(body))
        bodies[body].deferred.resize(
            static_cast<std::size_t>(model.parts[body].body.particles.size()));
}

void CellMeans::add_stresses(std::size_t body, int strip, const CellMean& mean) {
    if (!has(body)) return;
    const Part& part = model.parts[body];
    ParticleView q = model.parts[body].body.particles.view();
    bodies[body].most_stress[static_cast<std::size_t>(strip)] = kernels().add_mean_stresses(
        model.settings.axisymmetric, {model.grid(), q, part.strips.begin(strip),
                                      part.strips.begin(strip + 1), mean, part.separation});
}

// The largest stress of a body gives the integers their scale.
void CellMeans::find_stresses() {
    model.for_strips([this](std::size_t body, int strip) { add_stresses(body, strip, {}); });
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        OfBody& body = bodies[i];
        std::fill(body.cells.begin(), body.cells.end(), CellIntegers{});
        double largest = *std::max_element(body.most_stress.begin(), body.most_stress.end());
        model.exchange.max(&largest, 1);
        body.mean.cells = body.cells.empty() ? nullptr : body.cells.data();
        body.mean.per_volume = 1.0 / model.parts[i].largest_volume;
        body.mean.per_stress = largest > 0.0 ? 1.0 / largest : 1.0;
    }
    model.for_strips_apart(
        [this](std::size_t body, int strip) { add_stresses(body, strip, bodies[body].mean); });
    sum();
}

void CellMeans::begin_strains() {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        OfBody& body = bodies[i];
        std::fill(body.cells.begin(), body.cells.end(), CellIntegers{});
        body.mean.cells = body.cells.data();
        body.mean.deferred = body.deferred.data();
        body.mean.per_volume = 1.0 / model.parts[i].largest_volume;
    }
}

void CellMeans::sum() {
    for (OfBody& body : bodies)
        if (!body.cells.empty())
            model.exchange.sum_cells(body.cells.data(),
                                     static_cast<std::ptrdiff_t>(body.cells.size()));
}

}  // namespace grit::mpm
