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
    double damping_work = 0.0;  // taken by local damping [J]
    double change = 0.0;        // 1/2 m (v - v_old)^2 [J]
};

struct NodeCall {
    const NodeRecord* records;
    NodeMotion* motions;
    const std::uint8_t* fixed;
    std::ptrdiff_t begin, end;
    double least_mass;  // nodes with less are at rest [kg]
    double dt;          // [s]
    double damping;     // local damping (Cundall), share of the force [-]
};

// motions become v = v_old + dt f/m and v_old = p/m, both without the fixed components.
void advance_nodes(const NodeCall& call, NodeSums& sums);
// After contact: what is fixed stays so; sums the change.
void close_nodes(const NodeCall& call, NodeSums& sums);
// other becomes p/m: the velocities that particles would have left now (MUSL).
void remap_nodes(const NodeCall& call);

}  // namespace grit::mpm
