// SPDX-License-Identifier: BSD-3-Clause
// Surfaces in contact while an implicit pore pressure changes: what bears stays closed, no water passes it, and the
// pressure sees both.
#pragma once

#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "adapters/mpm/kernel/exchange.hpp"
#include "support/vector.hpp"

namespace grit::mpm {

// What a point of a surface that carries pressure does in a step, grit_surface_row: by nodes of bodies that move.
struct SurfaceTerm {
    std::size_t body, node;
    int side;              // 0: of a, 1: of b
    Vector2 direction[2];  // normal and tangential approach by a velocity of the node
};
struct SurfaceRow {
    std::size_t begin, end;  // terms
    double bound;            // approach that closes the gap and no more [m/s]
    Vector2 rigid;           // approach by rigid bodies [m/s]
    Vector2 impulse;         // [N s]
    double water_impulse[2];
    // Before pressures changed: of the grains along and across, of the water of a and b [N s].
    std::array<double, 4> of_contact = {impulse[0], impulse[1], water_impulse[0], water_impulse[1]};
    double on_damped = 0.0;  // work taken by half of that on what local damping left [J]
};
struct SurfaceRows {
    std::size_t a = 0, b = 0;  // bodies
    std::vector<SurfaceRow> rows = {};
    std::vector<SurfaceTerm> terms = {};
};

// How a node answers, of one direction: the grains to an impulse on them, the water's velocity against them to that, and
// to one on the water with the opposite on the grains [1/kg].
struct Mobility {
    double grains = 0.0, against_by_grains = 0.0, against = 0.0;
};

class HeldRows {
  public:
    // A condition: the approach of a row, or the flow of the water of one of its bodies.
    struct Hold {
        SurfaceRow* row;
        int water;                // -1: approach; 0, 1: of the water of a, b
        std::size_t begin, end;   // entries
        std::size_t first, last;  // pushes
        double free;              // its value without the row's impulse [m/s]
        bool bears;
        double impulse;  // [N s]
    };
    // Of a hold at a node: what it reads of the grains' velocity and of the water's against them, and what a unit of
    // its impulse takes from these.
    struct Entry {
        std::size_t body, node;
        Vector2 of_grains, of_water, takes_grains, takes_water;
    };
    // Of a hold: what an impulse of the pressure there gives, and what its own takes from the volume velocity.
    struct Push {
        std::size_t at;  // in the arrays of the pressure
        Vector2 answer;
    };
    std::vector<Hold> holds = {};
    std::vector<Entry> entries = {};
    std::vector<Push> pushes = {};

    bool empty() const { return holds.empty(); }
    // Once all holds are there: how they answer each other.
    void couple();
    // Of those that bear.
    void factor();
    // What impulses of the pressure give of those that bear; and what these then take.
    void read(const std::vector<Vector2>& impulses) const;
    void hold(std::vector<Vector2>& velocities) const;
    // ... of the volume velocity before the pressure changes.
    void hold_free(std::vector<Vector2>& velocities) const;
    // Impulses of the pressure become those of the holds. True: others bear than those that did.
    bool find_impulses(const std::vector<Vector2>& impulses);

  private:
    double read(const Hold& hold, const std::vector<Vector2>& impulses) const;
    void take(const Eigen::VectorXd& impulses, std::vector<Vector2>& from) const;
    Eigen::VectorXd solve(const Eigen::VectorXd& values) const;

    Eigen::MatrixXd coupling;  // of all
    Eigen::VectorXd scale;     // of those that bear, 1/sqrt of their own
    std::vector<std::size_t> bearing;
    Eigen::LLT<Eigen::MatrixXd> factors;
    mutable Eigen::VectorXd given;
};

}  // namespace grit::mpm
