// SPDX-License-Identifier: BSD-3-Clause
// Contact of two bodies at their true surfaces, the free edges of their particles' domains, through the library.
#pragma once

#include <cstdint>
#include <vector>

#include <grit/contact_surface.h>

#include "adapters/mpm/step/contact_zone.hpp"
#include "adapters/mpm/step/faces.hpp"
#include "adapters/mpm/step/held_rows.hpp"
#include "adapters/mpm/step/ridden_line.hpp"
#include "adapters/mpm/step/settings.hpp"
#include "adapters/mpm/step/surface_calls.hpp"
#include "adapters/mpm/step/sweeps.hpp"

namespace grit::mpm {

struct SurfaceLaw {
    std::size_t a = 0, b = 1;  // bodies; a's surface gives the normals and carries the pressure
    grit_surface_options options{};
    BoundaryLine line_a;  // at the start, in the place of a's free edges; empty: these
    double spacing =
        2.0;  // of what carries the pressure [cells]; at ends of a stretch two at least
    bool after_damping = false;  // once more, on velocities that local damping has changed
};

SurfaceLaw surface_law(double friction_coefficient);

class SurfacePair {
  public:
    // Throws std::invalid_argument where a stiffness would act after damping too.
    SurfacePair(const SurfaceLaw& law, double shortest_cell, ContactZone zone, bool axisymmetric);
    // Of a's line, in the first step, by all processes.
    void find_riders(const SurfaceBody& a, Exchange& exchange);
    // False where no node of this process is reached by both bodies.
    bool find(const SurfaceBody& a, const SurfaceBody& b);
    // After find, by all processes if one of them has found something: adds the call that turns velocities after the
    // momentum update into those after contact, unless no surface is there. May be done again in a step.
    void add_call(const SurfaceBody& a, const SurfaceBody& b, double dt, Exchange& exchange,
                  SurfaceCalls& calls);
    bool was_called() const { return is_called; }
    // After it is solved, if it was added: velocities, totals and faces.
    // keep: its rows, for what goes on with them.
    void take_call(const SurfaceBody& a, const SurfaceBody& b, bool keep);
    SurfaceRows& rows() { return step_rows; }
    // Normal impulses are those of the rows now: forces are theirs, too.
    void take_rows(double dt);

    const SurfaceLaw& law() const { return pair_law; }
    // Of the last call.
    const grit_surface_totals& totals_of_call() const { return call_totals; }
    // Of the last step, of all processes: impulses and dissipation of all its calls.
    const grit_surface_totals& totals() const { return step_totals; }
    // Forces on b by where a's surface points.
    const Faces& faces() const { return step_faces; }
    const Sweeps& sweeps() const { return swept; }

    template <class Self, class Archive> static void visit(Self& pair, Archive& archive) {
        archive.value(pair.step_totals);
        archive.value(pair.step_faces);
        RiddenLine::visit(pair.line_a, archive);
    }

  private:
    // Edges of a body where the other one is near.
    struct Skin {
        std::vector<double> position, weight, velocity;
        std::vector<std::ptrdiff_t> facet, node;
        std::vector<std::ptrdiff_t> number;  // of the zone's nodes in the whole grid
        std::vector<std::ptrdiff_t> owner;   // domain of each facet
        std::vector<double> pressure;        // of water in the body at each facet [Pa]
        std::vector<char> is_lost;           // vertices that no node moves
        std::ptrdiff_t vertices = 0, facets = 0;

        const double* end(std::ptrdiff_t f, int k) const {
            return &position[2 * static_cast<std::size_t>(facet[2 * static_cast<std::size_t>(f) +
                                                                static_cast<std::size_t>(k)])];
        }
    };
    void find_edges(int body, Skin& skin);
    void find_free_edges(std::span<const KeyedNumbers> domains, Skin& skin);
    void find_nodes(int body, const SurfaceBody& of, Skin& skin);
    void find_spacing();
    grit_surface surface(int body, const SurfaceBody& of);
    void keep_rows();
    void sum_faces();
    static void keep_facets(Skin& skin);
    void find_pressures(int body, Skin& skin);
    void forget();

    SurfaceLaw pair_law;
    ContactZone zone;
    RiddenLine line_a;
    Skin skins[2];
    std::vector<double> spacing;           // [facets of a] of what carries the pressure [m]
    std::vector<std::uint64_t> workspace;  // to find free edges
    std::vector<grit_surface_report> reports;
    grit_surface given[2] = {};
    bool is_called = false;
    grit_surface_totals call_totals{}, step_totals{};
    Sweeps swept;
    Faces step_faces;
    SurfaceRows step_rows;
};

}  // namespace grit::mpm
