// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/space/step/contact_zone.hpp"

#include <algorithm>

#include "adapters/mpm/space/kernel/place.hpp"
#include "adapters/mpm/step/keyed_items.hpp"

namespace grit::mpm::space {
namespace {

// What there is of a body, each in two halves; a part is one of these of body 0 or 1.
enum Kind {
    domain_place,
    domain_sides,
    node_now,
    node_before,
    mesh_vertex,
    domain_pressure,
    kinds
};
int part_of(Kind kind, int body) { return 2 * kind + body; }
Vector3 half(const KeyedNumbers& item, int which) {
    const double* from = item.value + 3 * which;
    return {from[0], from[1], from[2]};
}
KeyedNumbers item_of(std::uint64_t key, const Vector3& x, const Vector3& y) {
    return {key, {x[0], x[1], x[2], y[0], y[1], y[2]}};
}

Vector3 velocity_of(const double* values) {
    const double* v = values + near_node::v;
    return {v[0], v[1], v[2]};
}

}  // namespace

ContactZone::ContactZone(const Model& model)
    : here(model.grid()), whole(model.grid(), model.exchange.whole()), near(model.cells()) {}

bool ContactZone::find(const Part& a, const Part& b) {
    find_shared_nodes(a, b, shared);
    near.find(here, shared);
    return !shared.empty();
}

// Which cells of particles are near, this process knows: it has the two nodes on both sides of them. Whether a node is,
// which may be three from the one that both bodies reach, some process knows that has both.
void ContactZone::gather(const Model& model, const std::array<Part*, 2>& bodies,
                         const RiddenMesh& mesh_a, const std::array<PorePressures, 2>& pressures) {
    items.clear();
    for (const int body : {0, 1}) {
        Part& part = *bodies[static_cast<std::size_t>(body)];
        if (body == 0 && !mesh_a.empty()) add_vertices(part, mesh_a);
        else add_domains(part, body, pressures[static_cast<std::size_t>(body)]);
        if (!part.body.rigid()) add_nodes(model, part, body);
    }
    gather_sorted(model.exchange, items);
    for (const int body : {0, 1}) unpack(body);
    vertices.clear();
    for (const KeyedNumbers& item : items_of(part_of(mesh_vertex, 0)))
        vertices.push_back({number_of(item), half(item, 0)});
}

void ContactZone::add_vertices(Part& part, const RiddenMesh& mesh) {
    const ParticleView q = part.body.particles.view();
    const auto place_of = [&](int id) {
        const std::ptrdiff_t p = part.find(id);
        return p >= 0 && has(q.position(p)) ? p : -1;
    };
    mesh.each_near(q, place_of, [this](const NearVertex& v) {
        items.push_back(item_of(key_of(part_of(mesh_vertex, 0), v.number), v.at, {}));
    });
}

void ContactZone::add_domains(Part& part, int body, const PorePressures& pressures) {
    Particles& particles = part.body.particles;
    const ParticleView q = particles.view();
    for (std::ptrdiff_t p = 0; p < particles.size(); ++p) {
        if (!has(q.position(p))) continue;
        const baseline::Place place = baseline::place_of(here, q, p);
        const Vector3* r = place.domain.r;
        const int id = particles.ids()[p];
        items.push_back(item_of(key_of(part_of(domain_place, body), id), place.at, r[0]));
        items.push_back(item_of(key_of(part_of(domain_sides, body), id), r[1], r[2]));
        if (pressures.cells)
            items.push_back({key_of(part_of(domain_pressure, body), id),
                             {pressures.of(here.cell_of(place.at))}});
    }
}

void ContactZone::add_nodes(const Model& model, const Part& part, int body) {
    near.each_reached(here, [&](std::ptrdiff_t node) {
        const auto k = static_cast<std::size_t>(node);
        const double m = part.records[k][record::m];
        if (!(m > part.least_mass)) return;
        std::ptrdiff_t number = 0;
        for (int d = 0; d < 3; ++d)
            number += (node / here.step(d) % here.nodes(d) + whole.first[d]) * whole.grid.step(d);
        const double* v = part.motions[k].value;
        items.push_back({key_of(part_of(node_now, body), number), {m, v[0], v[1], v[2], 0.0, 0.0}});
        const double* before = v + motion::other_x;
        const double held = model.fixed_nodes[k];
        items.push_back({key_of(part_of(node_before, body), number),
                         {before[0], before[1], before[2], held, 0.0, 0.0}});
    });
}

std::span<const KeyedNumbers> ContactZone::items_of(int part) const {
    const auto from = [this](int first) {
        return std::lower_bound(items.begin(), items.end(), key_of(first, 0), is_before);
    };
    return {from(part), part + 1 < 2 * kinds ? from(part + 1) : items.end()};
}

void ContactZone::unpack(int body) {
    OfBody& to = of[body];
    const auto places = items_of(part_of(domain_place, body));
    const auto sides = items_of(part_of(domain_sides, body));
    to.domains.clear();
    for (std::size_t i = 0; i < places.size(); ++i)
        to.domains.push_back(
            {half(places[i], 0), {half(places[i], 1), half(sides[i], 0), half(sides[i], 1)}});
    to.pressures.clear();
    for (const KeyedNumbers& item : items_of(part_of(domain_pressure, body)))
        to.pressures.push_back(item.value[0]);
    const auto now = items_of(part_of(node_now, body));
    const auto before = items_of(part_of(node_before, body));
    to.number.clear();
    to.held.clear();
    to.gathered.clear();
    to.values.assign(near_node::size * now.size(), 0.0);
    for (std::size_t i = 0; i < now.size(); ++i) {
        double* values = &to.values[near_node::size * i];
        std::copy_n(now[i].value, 4, values + near_node::m);
        std::copy_n(before[i].value, 4, values + near_node::before);
        to.number.push_back(number_of(now[i]));
        to.gathered.push_back(velocity_of(values));
        to.held.push_back(static_cast<int>(values[near_node::fixed]));
    }
}

std::ptrdiff_t ContactZone::place_of(int body, std::ptrdiff_t node) const {
    const std::vector<std::ptrdiff_t>& all = of[body].number;
    const auto found = std::lower_bound(all.begin(), all.end(), node);
    return found != all.end() && *found == node ? found - all.begin() : -1;
}

void ContactZone::write(int body, Part& to) const {
    for (std::size_t i = 0; i < of[body].number.size(); ++i) {
        std::ptrdiff_t node = 0;
        bool is_here = true;
        for (int d = 0; d < 3; ++d) {
            const std::ptrdiff_t along =
                of[body].number[i] / whole.grid.step(d) % whole.grid.nodes(d) - whole.first[d];
            is_here = is_here && along >= 0 && along < here.nodes(d);
            node += along * here.step(d);
        }
        if (!is_here) continue;
        const Vector3 v = velocity_of(&of[body].values[near_node::size * i]);
        if (std::ranges::equal(v.c, of[body].gathered[i].c)) continue;
        std::copy_n(v.c, 3, to.motions[static_cast<std::size_t>(node)].value);
    }
}

}  // namespace grit::mpm::space
