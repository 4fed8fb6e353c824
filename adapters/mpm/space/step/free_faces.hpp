// SPDX-License-Identifier: BSD-3-Clause
// The faces of domains in space that no neighbour covers, (V6), as triangles.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "adapters/mpm/space/kernel/call.hpp"

namespace grit::mpm::space {

struct TriangleMesh {
    std::vector<double> position;       // [vertices][3] [m]
    std::vector<std::ptrdiff_t> facet;  // [facets][3] vertices, counter-clockwise from outside
    // [...][4] of the last vertices: each lies in the middle of four others, and moves as their mean.
    std::vector<std::ptrdiff_t> middle;
    std::vector<std::ptrdiff_t> domain;  // of each facet; empty: the mesh is of no domains

    std::ptrdiff_t vertices() const { return static_cast<std::ptrdiff_t>(position.size() / 3); }
    std::ptrdiff_t facets() const { return static_cast<std::ptrdiff_t>(facet.size() / 3); }
    Vector3 vertex(std::ptrdiff_t v) const {
        const auto i = 3 * static_cast<std::size_t>(v);
        return {position[i], position[i + 1], position[i + 2]};
    }
    Vector3 corner(std::ptrdiff_t f, int k) const {
        return vertex(facet[3 * static_cast<std::size_t>(f) + static_cast<std::size_t>(k)]);
    }
    void clear() {
        position.clear();
        facet.clear();
        middle.clear();
        domain.clear();
    }
    // Facets that are left out by is_out(facet) make room for those behind them.
    template <class IsOut> void leave_out(const IsOut& is_out) {
        const std::ptrdiff_t all = facets();
        std::size_t kept = 0;
        for (std::ptrdiff_t f = 0; f < all; ++f) {
            if (is_out(f)) continue;
            std::copy_n(facet.begin() + 3 * f, 3,
                        facet.begin() + 3 * static_cast<std::ptrdiff_t>(kept));
            if (!domain.empty()) domain[kept] = domain[static_cast<std::size_t>(f)];
            ++kept;
        }
        facet.resize(3 * kept);
        if (!domain.empty()) domain.resize(kept);
    }
};

// A parallelepiped x +- r_1 +- r_2 +- r_3.
struct NearDomain {
    Vector3 x, r[3];
};

class FreeFaces {
  public:
    // Faces of which neighbours leave a quarter open, a quarter of a width outside; corners that are near become one
    // vertex, at their mean. A face is four triangles around its middle, so that a pressure on it has a quarter of its force
    // at each corner, as the stress of the domain has. Depends on the order of the domains.
    void find(const GridView& grid, const std::vector<NearDomain>& domains, TriangleMesh& out);

  private:
    // A domain as others ask whether a place is in it.
    struct Covering {
        Vector3 x, a[3];  // a_k . r_j = 1 where k = j, else 0
        Vector3 extent;   // of its box, from x
        double near;      // corners within this are the same vertex [m]
        bool has(const Vector3& at) const {
            const Vector3 from = at - x;
            bool in = true;
            for (const Vector3& along : a) in = in && std::fabs(dot(along, from)) <= 1.0 + 1e-9;
            return in;
        }
    };
    struct Corner {
        Vector3 x;
        std::ptrdiff_t domain, root;
        double place;  // along a direction in which few corners are alike
    };
    void list(const GridView& grid, const std::vector<NearDomain>& domains);
    void sort_by_cells(const GridView& grid);
    void find_neighbours(const GridView& grid, std::ptrdiff_t i);
    bool is_free(const NearDomain& q, int direction, double side) const;
    void add_face(const NearDomain& q, std::ptrdiff_t i, int direction, double side,
                  TriangleMesh& out);
    std::ptrdiff_t root(std::ptrdiff_t corner);
    void join(TriangleMesh& out);

    // Domains by cells, and where rows of cells along x begin among them, for rows in a range along y and z.
    std::vector<std::ptrdiff_t> cell_of, by_cell, first_of_row;
    int first_row[2], last_row[2];
    std::vector<Covering> covering;
    Vector3 largest{0.0, 0.0, 0.0};
    std::vector<std::ptrdiff_t> neighbours;     // of the domain that is looked at
    std::array<std::ptrdiff_t, 8> corner_of{};  // ... its corners in corners; -1: not there yet
    std::vector<Corner> corners;
    std::vector<std::ptrdiff_t> order;
    std::vector<double> corners_of_vertex;
};

}  // namespace grit::mpm::space
