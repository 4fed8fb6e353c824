// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/space/step/model.hpp"

#include <cmath>
#include <utility>

namespace grit::mpm::space {

Model::Model(std::array<Axis, 3> axes, const Settings& given, Exchange* others)
    : settings(given), axis(std::move(axes)), exchange(others ? *others : nobody),
      pool(usable_threads(given.threads)) {
    check_there(settings);
    fixed_nodes.resize(static_cast<std::size_t>(axis[0].nodes()) *
                       static_cast<std::size_t>(axis[1].nodes()) *
                       static_cast<std::size_t>(axis[2].nodes()));
    double longest = -std::min({axis[0].shortest(), axis[1].shortest(), axis[2].shortest()});
    exchange.max(&longest, 1);
    shortest = -longest;
    const Pencils pencils(grid());
    for (int i = 0; i < pencils.count(); ++i)
        of_colour[static_cast<std::size_t>(pencils.colour(i))].push_back(i);
}

void Model::add_body(Body body) {
    Part part{.body = std::move(body), .pencils = Pencils(grid())};
    part.records.resize(nodes());
    part.motions.resize(nodes());
    const ParticleView q = part.body.particles.view();
    double extremes[] = {-std::numeric_limits<double>::infinity(), 0.0};  // -mass, volume
    for (std::ptrdiff_t p = 0; p < part.body.particles.size(); ++p) {
        extremes[0] = std::max(extremes[0], -q[column::mass][p]);
        extremes[1] = std::max(extremes[1], q[column::V0][p]);
    }
    exchange.max(extremes, 2);
    part.least_mass = std::isfinite(extremes[0]) ? -1e-12 * extremes[0] : 0.0;
    part.largest_volume = extremes[1];
    if (part.body.material) part.separation = part.body.material->separation();
    parts.push_back(std::move(part));
    particles_changed(parts.size() - 1);
}

void Model::particles_changed(std::size_t body) {
    parts[body].index_ids();
    drift[0] = drift[1] = std::numeric_limits<double>::infinity();  // sorts before the next step
}

void Model::set_rigid_nodes(Part& part, std::size_t begin, std::size_t end) const {
    const RigidMotion& rigid = *part.body.motion;
    for (std::size_t node = begin; node < end; ++node) {
        if (!(part.records[node][record::m] > 0.0)) continue;
        const Vector3 x = place_of_node(node);
        const Vector3 now = rigid.velocity_at(x), before = rigid.velocity_before_at(x);
        part.motions[node] = {now[0], now[1], now[2], 0.0, before[0], before[1], before[2], 0.0};
    }
}

void Model::sort_if_moved() {
    if (drift[0] > 0.5 * axis[1].shortest() || drift[1] > 0.5 * axis[2].shortest()) sort();
}

void Model::sort() {
    for (Part& part : parts) {
        part.pencils.sort(grid(), part.body.particles);
        part.index_ids();
    }
    drift[0] = drift[1] = 0.0;
}

}  // namespace grit::mpm::space
