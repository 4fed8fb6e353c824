// SPDX-License-Identifier: BSD-3-Clause
// What processes that share a grid must tell each other. The reference driver is alone: nothing to do. Every
// process makes the same calls in the same order; what it gets must be bitwise the same for all that hold a
// node.
//
//   when                        what                                            bytes
//   after a scatter, per body   sum of node records, or of integers             64 a halo node
//   ... with tractions          sum of their forces                             16 a halo node
//   means of cells, per body    sum of cells, of strains and of stresses        16 a halo cell each
//   ... of mean stresses        maximum                                         8
//   pore water, per body        sum of node records, or of integers             64 a halo node
//   ...                         sum of cells, of pressures and of strains       24 a halo cell each
//   ... fixed point             maxima of contributions, eight                  8 each
//   ... implicit                sums of patches, and of cells                   256 and 56 a halo cell
//   ... ..., each change        sums of laws, of cells, and of cells at nodes   16 a halo cell, 16 a halo node
//   ... ..., ...                sums of forces and mixed differences, two or    16 and 8 a halo node each
//                               three, and one more of the latter
//   ... ..., ..., fixed point   maxima of what is summed                        8 each
//   ... ..., once               what alternates: sums of mixed differences,     8 a halo node each
//                               two, and what cells are to neighbours, eight    24, 48, 6 of 16 a halo node
//   ... ..., ..., fixed point   maxima of what is summed, two                   8 each
//   ... ..., ...                whether any pressure is given: maxima, two      8 each
//   ... ..., each iteration     sums of forces, and of mixed differences        16 and 8 a halo node
//   ... ..., ..., fixed point   maxima of what is summed, two                   8 each
//   ... ..., each solution      sum of what cells remember                      16 a halo node
//   ... ...                     products; fixed point: maximum, too             8 each; fixed point: 40
//   ... ..., per contact        sums of forces                                  8 each; fixed point: 40
//   after MUSL's second one     sum of node records                             64 a halo node
//   contact with distances      minima of surfaces, of those beside the node,   48 a halo node
//                               and of centres, two each
//   ... that is gated           minima of surfaces along four directions        64 a halo node
//   ... with a stiffness        minima of overlaps, two                         16 a halo node
//   contact                     whether any node is in it: maximum              8
//   ...                         sums of the library, integers                   9600
//   ...                         sums of forces, maximum of gaps                 40
//   contacts at surfaces        whether any node is in one: maxima              8 each
//   ... that have one           particles near the surfaces, and nodes: all     56 each, 112 in space
//                               of all processes to each of them
//   ... on a line or triangles  in the first step: maxima, of each vertex       32, 40 in space
//   fixed point, per scatter    maxima of contributions, eight a body           8 each
//   ... with tractions          maximum of their forces                         8
//   in space                    records as above, 32 for gradients, loads 24,    a halo node
//                               32 for the force of pore water
//   ... pore water              sums of cells: pressure; strain                 16 a halo cell, each
//   ... contact                 minima: surfaces and centres two each, along     48, 80, 8 a node in contact
//                               five directions two each, overlap
//   each step, per body         maxima: c, v2, way along z, what water adds     8 each
//   each step                   sums of the energy balance, count of lost       8 each; fixed point: 40
#pragma once

#include <array>
#include <vector>

#include "adapters/mpm/kernel/call.hpp"

namespace grit::mpm {

// Of the grid of all processes, along r and z, or x, y and z: its axes, and which of their nodes is the first one here.
struct WholeAxes {
    AxisView axis[3];
    int first[3];
};

// Numbers of something that all processes call the same.
struct KeyedNumbers {
    static constexpr int size = 6;
    std::uint64_t key;
    double value[size];
};

class Exchange {
  public:
    virtual ~Exchange() = default;
    // Outlives this; null: what is here is all of it.
    virtual const WholeAxes* whole() const { return nullptr; }
    // [nodes] 1 where this process counts a node in sums over nodes, each node once; null: all.
    virtual const std::uint8_t* counted() const { return nullptr; }
    // Of so many numbers for each node or cell, what all have that hold it. Integers that are too large wrap.
    virtual void sum_nodes(double* /*values*/, std::ptrdiff_t /*nodes*/, int /*each*/) {}
    virtual void sum_nodes(std::int64_t* /*values*/, std::ptrdiff_t /*nodes*/, int /*each*/) {}
    // [cells] 1 where this process counts a cell that particles may be in, each such cell once; null: all.
    virtual const std::uint8_t* counted_cells() const { return nullptr; }
    virtual void sum_cells(double* /*values*/, std::ptrdiff_t /*cells*/, int /*each*/) {}
    virtual void sum_cells(std::int64_t* /*values*/, std::ptrdiff_t /*cells*/, int /*each*/) {}
    virtual void min_nodes(double* /*values*/, std::ptrdiff_t /*nodes*/, int /*each*/) {}
    // ... of these nodes alone, in their order; all that hold one of them name it.
    virtual void min_nodes(double* /*values*/, const std::vector<std::ptrdiff_t>& /*nodes*/,
                           int /*each*/) {}
    virtual void max(double* /*values*/, int /*count*/) {}
    virtual void sum(double* /*values*/, int /*count*/) {}
    virtual void sum(std::int64_t* /*values*/, int /*count*/) {}
    // Those of this process become those of all, in the same order for each of them.
    virtual void gather(std::vector<KeyedNumbers>& /*items*/) {}

    void sum_nodes(NodeRecord* records, std::ptrdiff_t nodes) {
        if (nodes > 0) sum_nodes(records->value, nodes, record::size);
    }
    template <int lanes> void sum_nodes(IntegersOf<lanes>* records, std::ptrdiff_t nodes) {
        if (nodes > 0) sum_nodes(records->value, nodes, lanes);
    }
    void sum_nodes(Vector2* forces, std::ptrdiff_t nodes) {
        if (nodes > 0) sum_nodes(forces->c, nodes, 2);
    }
    void sum_cells(CellIntegers* cells, std::ptrdiff_t count) {
        static_assert(sizeof *cells == 2 * sizeof(std::int64_t));
        if (count > 0) sum_cells(&cells->volume, count, 2);
    }
    void sum_cells(NodeIntegers* records, std::ptrdiff_t cells, int each) {
        if (cells > 0) sum_cells(records->value, cells, each * record::size);
    }
    template <std::size_t count> void sum(std::array<Total, count>& totals, bool fixed_point) {
        if (fixed_point) {
            std::int64_t words[count * Total::words];
            for (std::size_t i = 0; i < count; ++i) totals[i].write(words + i * Total::words);
            sum(words, static_cast<int>(count) * Total::words);
            for (std::size_t i = 0; i < count; ++i) totals[i].read(words + i * Total::words);
            return;
        }
        double values[count];
        for (std::size_t i = 0; i < count; ++i) values[i] = totals[i].value();
        sum(values, static_cast<int>(count));
        for (std::size_t i = 0; i < count; ++i) totals[i] = Total(values[i]);
    }
};

}  // namespace grit::mpm
