// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/space/step/cell_means.hpp"

#include <algorithm>

namespace grit::mpm::space {

void CellMeans::add_body() {
    const Part& part = model.parts[bodies.size()];
    OfBody& body = bodies.emplace_back();
    if (!wanted() || part.body.rigid()) return;
    body.most_stress.resize(static_cast<std::size_t>(part.pencils.count()));
    body.cells.resize(model.cells());
    particles_changed(bodies.size() - 1);
}

void CellMeans::particles_changed(std::size_t body) {
    if (has(body))
        bodies[body].deferred.resize(
            static_cast<std::size_t>(model.parts[body].body.particles.size()));
}

void CellMeans::sum() {
    for (OfBody& body : bodies)
        model.exchange.sum_cells(body.cells.data(), static_cast<std::ptrdiff_t>(body.cells.size()));
}

void CellMeans::add_stresses(std::size_t body, int pencil, const CellMean& mean) {
    if (!has(body)) return;
    Part& part = model.parts[body];
    bodies[body].most_stress[static_cast<std::size_t>(pencil)] = kernels().add_mean_stresses(
        {model.grid(), part.body.particles.view(), part.pencils.begin(pencil),
         part.pencils.begin(pencil + 1), mean, part.separation});
}

void CellMeans::clear(std::size_t body) {
    std::fill(bodies[body].cells.begin(), bodies[body].cells.end(), CellIntegers{});
}

// The largest stress of a body gives the integers their scale.
void CellMeans::find_stresses() {
    model.for_pencils([this](std::size_t body, int pencil) { add_stresses(body, pencil, {}); });
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (!has(i)) continue;
        OfBody& body = bodies[i];
        clear(i);
        double largest = *std::max_element(body.most_stress.begin(), body.most_stress.end());
        model.exchange.max(&largest, 1);
        body.mean.cells = body.cells.data();
        body.mean.per_volume = 1.0 / model.parts[i].largest_volume;
        body.mean.per_stress = largest > 0.0 ? 1.0 / largest : 1.0;
    }
    model.for_pencils_apart(
        [this](std::size_t body, int pencil) { add_stresses(body, pencil, bodies[body].mean); });
    sum();
}

void CellMeans::begin_strains() {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (!has(i)) continue;
        clear(i);
        bodies[i].mean.deferred = bodies[i].deferred.data();
    }
}

}  // namespace grit::mpm::space
