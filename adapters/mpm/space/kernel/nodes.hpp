// SPDX-License-Identifier: BSD-3-Clause
// The nodes of one body in space: what particles left there, and how it moves them (stress last).
#pragma once

#include <cstdint>

#include "adapters/mpm/space/kernel/call.hpp"

namespace grit::mpm::space {

// Bits of a node's constraint: no velocity along that direction.
namespace fixed {
constexpr std::uint8_t none = 0, all = 7;
constexpr std::uint8_t along(int direction) { return static_cast<std::uint8_t>(1 << direction); }
}  // namespace fixed

struct NodeSums {
    Total damping_work;  // taken by local damping [J]
    Total damping_z;     // what it gave of the momentum along z [N s]
    Total gravity_work;  // [J]
    Total change;        // 1/2 m (v - v_old)^2 [J]
    // Work of the internal nodal forces, half a step's, on the velocities that mapping took away, see the plane's [J].
    Total mapped_away;
};

struct NodeCall {
    NodeRecord* records;
    NodeMotion* motions;
    const Vector3* loads;  // [nodes] forces besides those of stresses [N]; null: none
    const std::uint8_t* fixed;
    std::ptrdiff_t begin, end;
    double least_mass;  // nodes with less are at rest [kg]
    double dt;          // [s]
    double dt_before;   // of the step before [s]
    Vector3 gravity;    // [m/s2]
    double damping;     // local damping (Cundall), share of the force [-]
    bool fixed_point;   // of the sums
    // [nodes] 1: in the sums; where processes share a node, one of them counts it. null: all
    const std::uint8_t* counted;
    void add(Total& sum, std::ptrdiff_t node, double x) const {
        if (!counted || counted[node]) sum.add(x, fixed_point);
    }
};

// motions, still of the step before, become v = v_old + dt (f/m + g) and v_old = p/m, without the fixed components;
// forces in the records become those with loads.
void advance_nodes(const NodeCall& call, NodeSums& sums);
// After contact: local damping, of contact forces as well, or it would carry a share of them.
void damp_nodes(const NodeCall& call, NodeSums& sums);
// What is fixed stays so; sums the change and the work of gravity.
void close_nodes(const NodeCall& call, NodeSums& sums);

}  // namespace grit::mpm::space
