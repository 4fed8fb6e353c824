// SPDX-License-Identifier: BSD-3-Clause
// The nodes of one body: what particles left there, and how it moves them.
#pragma once

#include <cstdint>
#include <vector>

#include "adapters/mpm/kernel/call.hpp"

namespace grit::mpm {

// Bits of a node's constraint.
namespace fixed {
enum : std::uint8_t { none = 0, r = 1, z = 2 };
}  // namespace fixed

struct NodeSums {
    Total damping_work;  // taken by local damping [J]
    Total damping_z;     // what it gave of the momentum along z [N s]
    Total gravity_work;  // [J]
    Total change;        // 1/2 m (v - v_old)^2 [J]
    // Work of the internal nodal forces, half a step's, on the velocities that mapping took away: on
    // those that strained the particles in the step before, less those that they handed back [J]. Where
    // stress is updated first, the forces are those of the step before, and their work is gained.
    Total mapped_away;
};

struct NodeCall {
    const NodeRecord* records;
    NodeMotion* motions;
    Vector2* internal;  // nodal forces of stresses and of penalty contact [N]
    const std::uint8_t* fixed;
    std::ptrdiff_t begin, end;
    double least_mass;  // nodes with less are at rest [kg]
    double dt;          // [s]
    double dt_before;   // of the step before [s]
    Vector2 gravity;    // [m/s2]
    bool by_other;      // particles are strained by the other velocity (MUSL)
    bool stress_first;  // (USF)
    double damping;     // local damping (Cundall), share of the force [-]
    // Of drag by pore water, in the lanes other, which its own balance has at the velocities of the end [N s]; null: none.
    const NodeMotion* drag;
    // Bits of components that platens tie, whose impulses have no work in sum; null: none.
    const std::uint8_t* tied;
    // Out: velocities after damping, and its impulses [N s]; null: nothing comes after it.
    NodeMotion* damped;
    bool meets;        // contact comes after it: those of contact too
    bool fixed_point;  // of the sums
    // [nodes] 1: in the sums; where processes share a node, one of them counts it. null: all
    const std::uint8_t* counted;
    void add(Total& sum, std::ptrdiff_t node, double x) const {
        if (!counted || counted[node]) sum.add(x, fixed_point);
    }
};

// With stress first: motions, still of the step before like internal, become v = v_old = p/m.
void start_nodes(const NodeCall& call, NodeSums& sums);
// Of the forces in the records, before others are added.
void keep_internal(const NodeCall& call);
// motions, still of the step before, or as start_nodes leaves them, become v = v_old + dt (f/m + g) and
// v_old = p/m, without the fixed components.
void advance_nodes(const NodeCall& call, NodeSums& sums);
// After contact: local damping, of contact forces as well, or it would carry a share of them. What comes after it
// (damped) is accounted for when nodes are closed.
void damp_nodes(const NodeCall& call, NodeSums& sums);
// What is fixed stays so; sums the change and the work of gravity.
void close_nodes(const NodeCall& call, NodeSums& sums);
// other becomes p/m: the velocities that particles would have left now (MUSL).
void remap_nodes(const NodeCall& call, NodeSums& sums);

}  // namespace grit::mpm
