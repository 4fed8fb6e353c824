// SPDX-License-Identifier: BSD-3-Clause
// What processes that share a grid must tell each other. The reference driver is alone: nothing to do.
//
//   when                        what                                            bytes
//   after a scatter, per body   sum of node records, or of integers             64 a halo node
//   means of cells, per body    sum of cells, of strains and of stresses        16 a halo cell each
//   ... of mean stresses        maximum                                         8
//   after MUSL's second one     sum of node records                             64 a halo node
//   contact with distances      minima of surfaces, of those beside the node,   48 a halo node
//                               and of centres, two each
//   fixed point, per scatter    maxima of contributions, eight a body           8 each
//   each step                   maxima: v + c, way along z; counts of lost      8 each
//   each step                   sums of the energy balance                      8 each
#pragma once

#include "adapters/mpm/kernel/call.hpp"

namespace grit::mpm {

class Exchange {
  public:
    virtual ~Exchange() = default;
    virtual void sum_nodes(NodeRecord* /*records*/, std::ptrdiff_t /*nodes*/) {}
    virtual void sum_nodes(NodeIntegers* /*records*/, std::ptrdiff_t /*nodes*/) {}
    virtual void sum_cells(CellIntegers* /*cells*/, std::ptrdiff_t /*count*/) {}
    virtual void min_nodes(double* /*values*/, std::ptrdiff_t /*nodes*/, int /*per_node*/) {}
    virtual void max(double* /*values*/, int /*count*/) {}
    virtual void sum(double* /*values*/, int /*count*/) {}
};

}  // namespace grit::mpm
