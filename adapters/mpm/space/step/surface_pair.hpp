// SPDX-License-Identifier: BSD-3-Clause
// Contact of two bodies in space at their true surfaces, the free faces of their particles' domains, through the library.
#pragma once

#include <algorithm>
#include <vector>

#include <grit/contact_surface.h>

#include "adapters/mpm/space/step/contact_pair.hpp"
#include "adapters/mpm/space/step/contact_zone.hpp"
#include "adapters/mpm/space/step/ridden_mesh.hpp"
#include "adapters/mpm/space/step/water.hpp"
#include "adapters/mpm/step/surface_calls.hpp"
#include "adapters/mpm/step/sweeps.hpp"

namespace grit::mpm::space {

struct SurfaceLaw {
    std::size_t a = 0, b = 1;  // bodies; a's surface gives the normals and carries the pressure
    grit_surface_options options{};
    TriangleMesh mesh_a = {};  // at the start, in the place of a's free faces; no facets: these
    double spacing = 2.0;      // of what carries the pressure [cells]
};

SurfaceLaw surface_law(double friction_coefficient);

class SurfacePair {
  public:
    SurfacePair(const SurfaceLaw& law, Model& model);
    // Adds the call that turns velocities after the momentum update into those after contact, where surfaces are near.
    // water: of its bodies, between scatter and gather.
    void add_call(Model& model, const Water& water, SurfaceCalls& calls);
    bool was_called() const { return is_called; }
    // After it is solved, if it was added: velocities, totals and forces.
    void take_call(Model& model);
    const SurfaceLaw& law() const { return pair_law; }

    // Of the last step, on b: impulse and its moment about the origin [N s], [N m s]; what contact takes [J].
    struct Totals {
        Twist impulse = {};
        double dissipation = 0.0;
    };
    const Totals& totals() const { return step_totals; }
    // Forces on b by where a's surface points; what bears, its pressure along z, does so wherever it acts.
    const ContactPair::Measured& measured() const { return step_measured; }
    const Sweeps& sweeps() const { return swept; }
    // take(from, to, impulse on b [N s]) of each facet in the last step: along z where it is.
    template <class Take> void each_impulse(const Take& take) const {
        const TriangleMesh& mesh = skins[0].mesh;
        for (std::size_t f = 0; f < reports.size(); ++f) {
            double z[3];
            for (int k = 0; k < 3; ++k) z[k] = mesh.corner(static_cast<std::ptrdiff_t>(f), k)[2];
            const auto [low, high] = std::minmax_element(z, z + 3);
            const double* force = reports[f].force;
            const double dt = pair_law.options.time_step;
            take(*low, *high, Vector3{-dt * force[0], -dt * force[1], -dt * force[2]});
        }
    }
    // On a body of the pair, about a place.
    Twist impulse_on(std::size_t body, const Vector3& about) const;

    template <class Self, class Archive> static void visit(Self& pair, Archive& archive) {
        archive.value(pair.step_totals);
        archive.value(pair.step_measured);
        RiddenMesh::visit(pair.mesh_a, archive);
    }

  private:
    // Of a body where the other one is near: its surface, and the nodes of the zone that move it.
    struct Skin {
        TriangleMesh mesh;
        std::vector<double> weight, velocity;
        std::vector<double> pressure;  // of water in the body at each facet; empty: dry [Pa]
        std::vector<std::ptrdiff_t> node;
        std::vector<char> is_lost;  // vertices that no node moves
    };
    void leave_out_planes_of_symmetry(TriangleMesh& mesh) const;
    void forget();
    void find_mesh(int which);
    void find_nodes(int which, const Part& part);
    void find_pressures(int which);
    void find_spacing();
    grit_surface surface(int which, bool rigid);
    void add_up();

    SurfaceLaw pair_law;
    RiddenMesh mesh_a;
    bool is_held[6] = {};  // sides of the grid: no velocity across
    ContactZone zone;
    FreeFaces faces;
    Skin skins[2];
    std::vector<double> spacing;  // [facets of a] of what carries the pressure [m]
    grit_surface given[2] = {};
    bool is_called = false;
    std::vector<grit_surface_report> reports;
    grit_surface_totals call_totals{};
    Totals step_totals;
    Sweeps swept;
    ContactPair::Measured step_measured{};
};

}  // namespace grit::mpm::space
