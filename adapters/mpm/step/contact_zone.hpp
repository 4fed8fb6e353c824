// SPDX-License-Identifier: BSD-3-Clause
// Where two bodies may touch, of all processes that share the grid: the domains of the particles there, and the
// nodes that move them. Every process has all of it, in the same order and with the same bits, however the grid is
// cut.
#pragma once

#include <span>
#include <vector>

#include "adapters/mpm/kernel/exchange.hpp"
#include "adapters/mpm/step/near_cells.hpp"

namespace grit::mpm {

class Water;

// The grid of all processes, and which of its nodes is the first one here.
struct WholeGrid {
    GridView grid;
    int first_r = 0, first_z = 0;

    WholeGrid(const GridView& here, const WholeAxes* whole) : grid(here) {
        if (whole)
            grid = {whole->axis[0], whole->axis[1]}, first_r = whole->first[0],
            first_z = whole->first[1];
    }
};

struct SurfaceBody {
    const NodeRecord* records;
    NodeMotion* motions;
    ParticleView particles;
    const int* ids;
    std::ptrdiff_t count;
    double least_mass;  // nodes with less take no impulse [kg]
    bool rigid;
    Vector2 velocity;        // of a rigid body in this step [m/s]
    Water* water = nullptr;  // in its pores; null: none
    std::size_t number = 0;  // of the body
};

namespace near_domain {
enum : int { r, z, r1r, r1z, r2r, r2z };
}  // namespace near_domain

namespace near_node {
enum : int { m, v_r, v_z, other_r, other_z, fixed };
}  // namespace near_node

// Of water that flows, in the order of the nodes: what it has there, and its velocity against the grains.
namespace near_pores {
enum : int { m, drag, porosity, fixed };
}  // namespace near_pores
namespace near_seepage {
enum : int { now_r, now_z, before_r, before_z };
}  // namespace near_seepage

class ContactZone {
  public:
    // fixed: of the nodes of this process, outlives this.
    // whole: of all processes, outlives this; null: there is one.
    ContactZone(const GridView& grid, const WholeAxes* whole, bool axisymmetric,
                const std::vector<std::uint8_t>& fixed);

    // False where no node of this process is reached by both.
    bool find(const SurfaceBody& a, const SurfaceBody& b);
    // After find, by all processes if one of them has found something.
    void gather(const SurfaceBody& a, const SurfaceBody& b, Exchange& exchange);

    // Of body 0 or 1. Domains by the particles' ids, nodes by their numbers in the whole grid; of a rigid body there
    // are none.
    std::span<const KeyedNumbers> domains(int body) const { return of(body); }
    std::span<KeyedNumbers> nodes(int body) { return of(2 + body); }
    // Mean pore pressures of the cells that domains are in, in their order; empty: no water.
    std::span<const KeyedNumbers> pressures(int body) const { return of(4 + body); }
    // Of water that flows, in the order of nodes; empty: none.
    std::span<const KeyedNumbers> pores(int body) const { return of(6 + body); }
    std::span<KeyedNumbers> seepage(int body) { return of(8 + body); }
    // [nodes(body)] bits of components that are held; of its water.
    const int* fixed(int body) const { return held.data() + (body == 0 ? 0 : of(2).size()); }
    const int* water_fixed(int body) const {
        return water_held.data() + (body == 0 ? 0 : of(6).size());
    }
    // The particle of a domain.
    static int id_of(const KeyedNumbers& domain);
    // Of a node of the whole grid among those of a body; -1: it has no mass there.
    std::ptrdiff_t place_of(int body, std::ptrdiff_t node) const;
    const GridView& whole_grid() const { return whole.grid; }
    // Its number in the grid of this process; -1: another one has it.
    std::ptrdiff_t node_here(const KeyedNumbers& item) const;

    // The velocities of its nodes and of the water there that have changed since they were gathered, to those that are here:
    // another zone of the body may have changed others.
    void write(int body, const SurfaceBody& to) const;

  private:
    std::span<const KeyedNumbers> of(int part) const {
        return {items.data() + start[part], items.data() + start[part + 1]};
    }
    std::span<KeyedNumbers> of(int part) {
        return {items.data() + start[part], items.data() + start[part + 1]};
    }
    void add_domains(const SurfaceBody& body, int which);
    void add_nodes(const SurfaceBody& body, int which);
    // Of a node: its velocity, and the water's against it.
    struct Moving {
        double value[4];
    };
    void find_parts();
    Moving motion_of(int body, std::size_t i) const;

    GridView grid;
    WholeGrid whole;
    bool axisymmetric;
    const std::vector<std::uint8_t>& fixed_nodes;
    NearCells near;
    // Domains of both bodies, nodes of both, pressures, pores and seepage.
    static constexpr int parts = 10;
    std::vector<KeyedNumbers> items;
    std::ptrdiff_t start[parts + 1] = {};
    std::vector<Moving> gathered[2];  // [nodes(body)]
    std::vector<int> held, water_held;
};

}  // namespace grit::mpm
