// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace grit::mpm {

Model::Model(Axis along_r, Axis along_z, const Settings& given, Exchange* others)
    : settings(given), r(std::move(along_r)), z(std::move(along_z)),
      fixed_nodes(static_cast<std::size_t>(r.nodes()) * static_cast<std::size_t>(z.nodes())),
      closed_nodes(fixed_nodes.size()), exchange(others ? *others : nobody),
      pool(usable_threads(given.threads)) {
    if (settings.axisymmetric && r[0] < 0.0)
        throw std::invalid_argument("the grid must not reach across the axis");
    double longest = -std::min(r.shortest(), z.shortest());
    exchange.max(&longest, 1);
    shortest = -longest;
}

void Model::add_body(Body body) {
    Part part{.body = std::move(body), .strips = Strips(grid())};
    part.records.resize(fixed_nodes.size());
    part.motions.resize(fixed_nodes.size());
    const ParticleView q = part.body.particles.view();
    double extremes[] = {-std::numeric_limits<double>::infinity(), 0.0};  // -mass, volume
    for (std::ptrdiff_t p = 0; p < part.body.particles.size(); ++p) {
        extremes[0] = std::max(extremes[0], -q[column::mass][p]);
        extremes[1] = std::max(extremes[1], q[column::V0][p]);
    }
    exchange.max(extremes, 2);
    part.least_mass = std::isfinite(extremes[0]) ? -1e-12 * extremes[0] : 0.0;
    part.largest_volume = extremes[1];
    if (part.body.material) {
        part.separation = part.body.material->separation();
        part.reduces_domains =
            settings.reduced_domains && part.body.material->knows_no_deformation();
    }
    parts.push_back(std::move(part));
    particles_changed(parts.size() - 1);
}

void Model::particles_changed(std::size_t body) {
    Part& part = parts[body];
    part.index_ids();
    drift = std::numeric_limits<double>::infinity();  // sorts before the next step
}

void Model::sort_if_moved() {
    if (drift > 0.5 * z.shortest()) sort();
}

void Model::sort() {
    for (Part& part : parts) {
        part.strips.sort(grid(), part.body.particles);
        part.index_ids();
    }
    drift = 0.0;
}

Model::Rows Model::nodes_of(int strip) const {
    const int first = strip * Strips::rows;
    const bool last = first + Strips::rows >= z.cells();
    const int end = last ? z.nodes() : first + Strips::rows;
    return {static_cast<std::ptrdiff_t>(first) * r.nodes(),
            static_cast<std::ptrdiff_t>(end) * r.nodes()};
}

}  // namespace grit::mpm
