// SPDX-License-Identifier: BSD-3-Clause
// Contact of two bodies at their true surfaces, the free edges of their particles' domains, through the library.
#pragma once

#include <cstdint>
#include <vector>

#include <grit/contact_surface.h>

#include "adapters/mpm/kernel/nodes.hpp"
#include "adapters/mpm/step/faces.hpp"
#include "adapters/mpm/step/near_cells.hpp"
#include "adapters/mpm/step/settings.hpp"

namespace grit::mpm {

struct SurfaceLaw {
    std::size_t a = 0, b = 1;  // bodies; a's surface gives the normals and carries the pressure
    grit_surface_options options{};
};

SurfaceLaw surface_law(double friction_coefficient);

struct SurfaceBody {
    const NodeRecord* records;
    NodeMotion* motions;
    ParticleView particles;
    const int* ids;
    std::ptrdiff_t count;
    double least_mass;  // nodes with less take no impulse [kg]
    bool rigid;
    Vector2 velocity;  // of a rigid body in this step [m/s]
};

class SurfacePair {
  public:
    SurfacePair(const SurfaceLaw& law, const Settings& settings, const GridView& grid,
                double shortest_cell, const std::vector<std::uint8_t>& fixed);
    // Velocities after the momentum update become those after contact.
    void correct(const GridView& grid, const SurfaceBody& a, const SurfaceBody& b, double dt);

    const SurfaceLaw& law() const { return pair_law; }
    // Of the last step.
    const grit_surface_totals& totals() const { return step_totals; }
    // Forces on b by where a's surface points.
    const Faces& faces() const { return step_faces; }

    template <class Self, class Archive> static void visit(Self& pair, Archive& archive) {
        archive.own(&pair.step_totals, 1);
        archive.own(&pair.step_faces, 1);
    }

  private:
    // Free edges of a body where the other one is near.
    struct Skin {
        std::vector<double> position, weight, domain, velocity;
        std::vector<std::ptrdiff_t> facet, node, near;
        std::ptrdiff_t vertices = 0, facets = 0;
    };
    bool find_near(const GridView& grid, const SurfaceBody& a, const SurfaceBody& b);
    void find_edges(const GridView& grid, const SurfaceBody& body, Skin& skin);
    void find_nodes(const GridView& grid, const SurfaceBody& body, Skin& skin);
    grit_surface surface(const SurfaceBody& body, Skin& skin) const;
    void solve(const grit_surface& a, const grit_surface& b);
    void sum_faces();
    static void keep_facets(const std::vector<char>& is_lost, Skin& skin);
    void forget();

    SurfaceLaw pair_law;
    bool axisymmetric;
    std::vector<int> fixed_bits;
    NearCells near;
    Skin skins[2];
    std::vector<std::uint64_t> workspace;
    std::vector<grit_surface_report> reports;
    grit_surface_totals step_totals{};
    Faces step_faces;
};

}  // namespace grit::mpm
