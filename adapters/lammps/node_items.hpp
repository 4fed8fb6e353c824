// SPDX-License-Identifier: GPL-2.0-only
// What nodes leave for the next step, on its way between processes: each has some of it, nobody all of it.
#pragma once

#include <cstdint>
#include <vector>

#include "adapters/lammps/halo.hpp"

namespace grit::lammps {

// Nodes of the whole grid, each with its number there and so many words; no two processes have the same one.
struct NodeItems {
    std::size_t words_each = 0;
    std::vector<std::uint64_t> words;  // [size][1 + words_each]

    std::size_t each() const { return 1 + words_each; }
    std::size_t size() const { return words.size() / each(); }
    void add(std::uint64_t node, const std::uint64_t* of) {
        words.push_back(node);
        words.insert(words.end(), of, of + words_each);
    }
};

// Those of all processes that are on the lines of this one; every process must call it.
NodeItems at_holders(const NodeItems& items, const HaloLayout& layout,
                     const std::vector<int>& nodes);

// As many for each of the places that processes have, on which they lie: the least number that is enough for all, and
// those for the places here, in their order. Every process must call it.
struct SpreadItems {
    std::size_t for_each_place = 0;
    NodeItems items;
};
SpreadItems spread(const NodeItems& items, std::size_t places, MPI_Comm world);

}  // namespace grit::lammps
