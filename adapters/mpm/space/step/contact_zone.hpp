// SPDX-License-Identifier: BSD-3-Clause
// Where two bodies may touch in space, of all processes that share the grid: the domains of the particles there, or
// vertices that ride on them, and the nodes that move them. Every process has all of it, in the same order and with the same bits, however the grid
// is cut.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "adapters/mpm/kernel/exchange.hpp"
#include "adapters/mpm/space/step/free_faces.hpp"
#include "adapters/mpm/space/step/near_cells.hpp"
#include "adapters/mpm/space/step/ridden_mesh.hpp"

namespace grit::mpm::space {

// The grid of all processes, and which of its nodes is the first one here.
struct WholeGrid {
    GridView grid;
    int first[3] = {0, 0, 0};

    WholeGrid(const GridView& here, const WholeAxes* whole) : grid(here) {
        for (int d = 0; whole && d < 3; ++d) {
            grid.axis[d] = whole->axis[d];
            first[d] = whole->first[d];
        }
    }
};

namespace near_node {
enum : std::size_t { m, v, before = 4, fixed = 7, size = 8 };
}  // namespace near_node

class ContactZone {
  public:
    explicit ContactZone(const Model& model);

    // False where no node of this process is reached by both.
    bool find(const Part& a, const Part& b);
    // After find, by all processes if one of them has found something. mesh_a: of body 0, in the place of its domains,
    // unless it is empty; pressures: of the water of each body.
    void gather(const Model& model, const std::array<Part*, 2>& bodies, const RiddenMesh& mesh_a,
                const std::array<PorePressures, 2>& pressures);

    const GridView& whole_grid() const { return whole.grid; }
    // Whether a node of this process is the first or the last one of the whole grid along a direction.
    bool is_at_side(std::ptrdiff_t node, int direction, bool last) const {
        const std::ptrdiff_t along =
            node / here.step(direction) % here.nodes(direction) + whole.first[direction];
        return along == (last ? whole.grid.nodes(direction) - 1 : 0);
    }
    // Of body 0 or 1, in the order of the particles' ids.
    const std::vector<NearDomain>& domains(int body) const { return of[body].domains; }
    // Of the cells that these are in [Pa]; empty: no water.
    const std::vector<double>& pressures(int body) const { return of[body].pressures; }
    const std::vector<NearVertex>& vertices_of_mesh() const { return vertices; }
    // By their numbers in the whole grid; of a rigid body there are none.
    std::size_t nodes(int body) const { return of[body].number.size(); }
    const std::ptrdiff_t* numbers(int body) const { return of[body].number.data(); }
    double* values(int body) { return of[body].values.data(); }        // [nodes][near_node::size]
    const int* fixed(int body) const { return of[body].held.data(); }  // [nodes] bits of components
    // Of a node of the whole grid among those of a body; -1: it has no mass there.
    std::ptrdiff_t place_of(int body, std::ptrdiff_t node) const;
    // The velocities of its nodes that have changed since they were gathered, to those that are here: another zone of the
    // body may have changed others.
    void write(int body, Part& to) const;

  private:
    struct OfBody {
        std::vector<NearDomain> domains;
        std::vector<double> pressures;
        std::vector<std::ptrdiff_t> number;
        std::vector<double> values;
        std::vector<Vector3> gathered;  // velocities
        std::vector<int> held;
    };
    // Whether a particle of this process is near.
    bool has(const Vector3& at) const { return near.has(here.cell_of(at)); }
    void add_domains(Part& part, int body, const PorePressures& pressures);
    void add_vertices(Part& part, const RiddenMesh& mesh);
    void add_nodes(const Model& model, const Part& part, int body);
    void unpack(int body);
    std::span<const KeyedNumbers> items_of(int part) const;

    GridView here;
    WholeGrid whole;
    NearCells near;
    std::vector<std::ptrdiff_t> shared;
    std::vector<KeyedNumbers> items;
    OfBody of[2];
    std::vector<NearVertex> vertices;
};

}  // namespace grit::mpm::space
