// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/contact_zone.hpp"

#include <algorithm>

#include "adapters/mpm/kernel/nodes.hpp"
#include "adapters/mpm/kernel/place.hpp"
#include "adapters/mpm/step/keyed_items.hpp"
#include "adapters/mpm/step/water.hpp"

namespace grit::mpm {
namespace {

int mask_of(double bits) {
    const int held = static_cast<int>(bits);
    return (held & fixed::r ? 1 : 0) | (held & fixed::z ? 2 : 0);
}

}  // namespace

ContactZone::ContactZone(const GridView& here, const WholeAxes* of_all, bool with_axis,
                         const std::vector<std::uint8_t>& fixed)
    : grid(here), whole(here, of_all), axisymmetric(with_axis), fixed_nodes(fixed), near(here) {}

bool ContactZone::find(const SurfaceBody& a, const SurfaceBody& b) {
    near.clear();
    bool any = false;
    for (std::size_t i = 0; i < fixed_nodes.size(); ++i) {
        if (!NearCells::is_shared(a.records[i], b.records[i])) continue;
        any = true;
        near.add(grid, static_cast<std::ptrdiff_t>(i));
    }
    return any;
}

// Which cells of particles are near, this process knows: it has the two nodes on both sides of them. Whether a node
// is, which may be three from the one that both bodies reach, some process knows that has both.
void ContactZone::gather(const SurfaceBody& a, const SurfaceBody& b, Exchange& exchange) {
    items.clear();
    for (const int which : {0, 1}) {
        add_domains(which == 0 ? a : b, which);
        add_nodes(which == 0 ? a : b, which);
    }
    gather_sorted(exchange, items);
    find_parts();
}

void ContactZone::add_domains(const SurfaceBody& body, int which) {
    for (std::ptrdiff_t p = 0; p < body.count; ++p) {
        if (!near.has(grid, body.particles, p)) continue;
        const auto place = axisymmetric ? baseline::place_of<true>(grid, body.particles, p)
                                        : baseline::place_of<false>(grid, body.particles, p);
        items.push_back({key_of(which, body.ids[p]),
                         {place.r, place.z, place.domain.r1r, place.domain.r1z, place.domain.r2r,
                          place.domain.r2z}});
        if (body.water && body.water->has(body.number))
            items.push_back(
                {key_of(4 + which, body.ids[p]), {body.water->pressure_at(body.number, p)}});
    }
}

void ContactZone::add_nodes(const SurfaceBody& body, int which) {
    if (body.rigid) return;
    near.each_reached(grid, [&](std::ptrdiff_t node) {
        const NodeRecord& n = body.records[node];
        if (!(n[record::m] > body.least_mass)) return;
        const NodeMotion& v = body.motions[node];
        const std::ptrdiff_t r = node % grid.nodes_r() + whole.first_r;
        const std::ptrdiff_t z = node / grid.nodes_r() + whole.first_z;
        const std::uint8_t bits = fixed_nodes[static_cast<std::size_t>(node)];
        items.push_back({key_of(2 + which, z * whole.grid.nodes_r() + r),
                         {n[record::m], v[motion::v_r], v[motion::v_z], v[motion::other_r],
                          v[motion::other_z], static_cast<double>(bits)}});
        if (!body.water || !body.water->flows(body.number)) return;
        const auto here = static_cast<std::size_t>(node);
        const Water::Pores pores = body.water->pores(body.number, here);
        const Vector2 &now = pores.seepage, &before = pores.seepage_before;
        const std::ptrdiff_t number = z * whole.grid.nodes_r() + r;
        items.push_back(
            {key_of(6 + which, number),
             {pores.mass, pores.drag, pores.porosity, static_cast<double>(pores.fixed)}});
        items.push_back({key_of(8 + which, number), {now[0], now[1], before[0], before[1]}});
    });
}

void ContactZone::find_parts() {
    for (int part = 1; part < parts; ++part)
        start[part] = std::lower_bound(items.begin(), items.end(), key_of(part, 0), is_before) -
                      items.begin();
    start[parts] = static_cast<std::ptrdiff_t>(items.size());
    held.clear();
    for (const int body : {0, 1})
        for (const KeyedNumbers& node : nodes(body))
            held.push_back(mask_of(node.value[near_node::fixed]));
    for (const int body : {0, 1}) {
        gathered[body].clear();
        for (std::size_t i = 0; i < nodes(body).size(); ++i)
            gathered[body].push_back(motion_of(body, i));
    }
    water_held.clear();
    for (const int body : {0, 1})
        for (const KeyedNumbers& node : pores(body))
            water_held.push_back(mask_of(node.value[near_pores::fixed]));
}

int ContactZone::id_of(const KeyedNumbers& domain) { return static_cast<int>(number_of(domain)); }

std::ptrdiff_t ContactZone::place_of(int body, std::ptrdiff_t node) const {
    const std::span<const KeyedNumbers> all = of(2 + body);
    const std::uint64_t key = key_of(2 + body, node);
    const auto found = std::lower_bound(all.begin(), all.end(), key, is_before);
    return found != all.end() && found->key == key ? found - all.begin() : -1;
}

std::ptrdiff_t ContactZone::node_here(const KeyedNumbers& item) const {
    const std::ptrdiff_t r = number_of(item) % whole.grid.nodes_r() - whole.first_r;
    const std::ptrdiff_t z = number_of(item) / whole.grid.nodes_r() - whole.first_z;
    const bool is_here = r >= 0 && r <= grid.r.cells && z >= 0 && z <= grid.z.cells;
    return is_here ? z * grid.nodes_r() + r : -1;
}

ContactZone::Moving ContactZone::motion_of(int body, std::size_t i) const {
    const std::span<const KeyedNumbers> flow = of(8 + body);
    const double* at = of(2 + body)[i].value;
    Moving out{{at[near_node::v_r], at[near_node::v_z], 0.0, 0.0}};
    if (!flow.empty()) std::copy_n(&flow[i].value[near_seepage::now_r], 2, out.value + 2);
    return out;
}

void ContactZone::write(int body, const SurfaceBody& to) const {
    const bool flows = !of(8 + body).empty();
    for (std::size_t i = 0; i < of(2 + body).size(); ++i) {
        const std::ptrdiff_t node = node_here(of(2 + body)[i]);
        if (node < 0) continue;
        const Moving now = motion_of(body, i);
        if (std::ranges::equal(now.value, gathered[body][i].value)) continue;
        const Vector2 v{now.value[0], now.value[1]}, seepage{now.value[2], now.value[3]};
        if (flows) to.water->follow(to.number, static_cast<std::size_t>(node), v, seepage);
        to.motions[node][motion::v_r] = v[0];
        to.motions[node][motion::v_z] = v[1];
    }
}

}  // namespace grit::mpm
