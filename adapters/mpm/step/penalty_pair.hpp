// SPDX-License-Identifier: BSD-3-Clause
// Penalty contact of two bodies along the lines that bound them (PCA), through the library.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include <grit/contact_penalty.h>

#include "adapters/mpm/kernel/nodes.hpp"
#include "adapters/mpm/step/boundary_line.hpp"
#include "adapters/mpm/step/faces.hpp"

namespace grit::mpm {

struct PenaltyLaw {
    std::size_t a = 0, b = 1;        // bodies
    grit_penalty_options options{};  // axisymmetric and time_step are the driver's
    BoundaryLine line_a, line_b;     // at the start
    double longest = 0.0;            // segments are split above it [m]
    double shortest = 0.0;           // ... and merged below it [m]; 0: never
};

// eps_n = multiple M / cell (S2), M the P-wave modulus of the softer body [Pa].
PenaltyLaw penalty_law(double friction_coefficient, double multiple, double modulus, double cell);

struct PenaltyBody {
    NodeRecord* records;
    const NodeMotion* motions;
    double least_mass;  // nodes with less take no force [kg]
    bool rigid;
    const std::string& name;
};

class PenaltyPair {
  public:
    PenaltyPair(const PenaltyLaw& law, bool axisymmetric, std::size_t nodes);
    // Between steps: the forces of the lines where they are now, for the next push; dt: of the step before.
    void find_forces(double dt);
    // z of all vertices that press, of the lines that move.
    template <class Take> void each_pressed(const Take& take) const {
        for (const Line& line : lines)
            for (std::size_t v = 0; v < line.stiffness.size(); ++v)
                if (line.stiffness[v] > 0.0) take(line.position[2 * v + 1]);
    }
    // What stable_step() says of the forces found, with the mass of nodes as it is now.
    void find_step(const GridView& grid, const PenaltyBody& a, const PenaltyBody& b);
    // Throws std::runtime_error where a vertex is that has no mass of its body around it, of those that press
    // or of all: its force would be lost, and it would not move.
    enum class Vertices { pressed, all };
    void check_mass(const GridView& grid, const PenaltyBody& a, const PenaltyBody& b,
                    Vertices which) const;
    // ... or where one has moved far off the grid, or nowhere.
    void check_place(const GridView& grid, const PenaltyBody& a, const PenaltyBody& b) const;
    // Adds the forces found to those of the nodes.
    void push(const GridView& grid, const PenaltyBody& a, const PenaltyBody& b);
    // Vertices move with their bodies.
    void move(const GridView& grid, const PenaltyBody& a, const PenaltyBody& b, double dt);

    const PenaltyLaw& law() const { return pair_law; }
    // Of the last push.
    const grit_penalty_totals& totals() const { return step_totals; }
    // Energy that the forces of the last step took from the bodies, on both together: what friction
    // dissipates and springs hold, and what the areas of vertices lose or give as they change [J].
    double energy_taken() const { return taken; }
    double stable_step() const { return step; }  // (S5), of the next step [s]
    // Forces on the body of line 0 or 1 in the last push, apart by the component that is larger at a vertex.
    const Faces& faces(int line) const { return step_faces[line]; }
    // Vertices of line 0 or 1, two coordinates each.
    const std::vector<double>& vertices(int line) const { return lines[line].position; }

    template <class Self, class Archive> static void visit(Self& pair, Archive& archive) {
        archive.own(&pair.step_totals, 1);
        archive.own(&pair.next_totals, 1);
        archive.own(&pair.step_faces[0], 2);
        for (auto* number : {&pair.step, &pair.taken, &pair.dt_before}) archive.own(number, 1);
        for (auto& line : pair.lines) Line::visit(line, archive);
    }

  private:
    struct Line {
        std::vector<double> position, velocity, history, force, stiffness;
        bool closed = false;
        template <class Self, class Archive> static void visit(Self& line, Archive& archive) {
            for (auto* of_vertices :
                 {&line.position, &line.velocity, &line.history, &line.force, &line.stiffness})
                archive.list(*of_vertices);
        }
        std::ptrdiff_t count() const { return static_cast<std::ptrdiff_t>(position.size() / 2); }
    };
    static grit_penalty_surface surface(Line& line);
    void find_stiffness(const GridView& grid, const Line& line, const PenaltyBody& body,
                        std::vector<double>& touched_mass, std::vector<double>& touched);
    static void scatter(const GridView& grid, const Line& line, const PenaltyBody& body);
    double advance(const GridView& grid, const PenaltyBody& body, double dt, Line& line) const;
    static Faces faces_of(const Line& line);
    void remesh(Line& line);

    PenaltyLaw pair_law;
    Line lines[2], spare;
    std::vector<double> nodal_stiffness, mass[2], stiffness[2], weight;
    std::vector<std::ptrdiff_t> parents;
    std::vector<std::uint64_t> workspace;
    Faces step_faces[2];
    grit_penalty_totals step_totals,
        next_totals;  // of the last step, and of the forces found since
    double taken = 0.0, dt_before = 0.0;
    double step = std::numeric_limits<double>::infinity();
};

}  // namespace grit::mpm
