// SPDX-License-Identifier: GPL-2.0-only
#include "adapters/lammps/node_items.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace grit::lammps {
namespace {

int processes_of(MPI_Comm world) {
    int out = 0;
    MPI_Comm_size(world, &out);
    return out;
}

// Each process hands words to each other one.
std::vector<std::uint64_t> hand_over(const std::vector<std::vector<std::uint64_t>>& to,
                                     MPI_Comm world) {
    const std::size_t n = to.size();
    std::vector<int> out(n), in(n), out_first(n), in_first(n);
    std::size_t sent = 0, got = 0;
    const auto checked = [](std::size_t words) {
        if (words > static_cast<std::size_t>(std::numeric_limits<int>::max()))
            throw std::runtime_error("the state at nodes of a process has " +
                                     std::to_string(words) + " words, " +
                                     std::to_string(std::numeric_limits<int>::max()) +
                                     " is the limit: use more processors");
        return static_cast<int>(words);
    };
    for (std::size_t i = 0; i < n; ++i) {
        out_first[i] = checked(sent);
        out[i] = checked(to[i].size());
        sent += to[i].size();
    }
    checked(sent);
    MPI_Alltoall(out.data(), 1, MPI_INT, in.data(), 1, MPI_INT, world);
    for (std::size_t i = 0; i < n; ++i) {
        in_first[i] = checked(got);
        got += static_cast<std::size_t>(in[i]);
    }
    checked(got);
    std::vector<std::uint64_t> words, all(got);
    words.reserve(sent);
    for (const std::vector<std::uint64_t>& of : to) words.insert(words.end(), of.begin(), of.end());
    MPI_Alltoallv(words.data(), out.data(), out_first.data(), MPI_UINT64_T, all.data(), in.data(),
                  in_first.data(), MPI_UINT64_T, world);
    return all;
}

// Before a process, in the order of ranks, and all together.
struct Counts {
    std::vector<std::uint64_t> first;  // [processes + 1]
    std::uint64_t all() const { return first.back(); }
};
Counts counts_of(std::uint64_t here, MPI_Comm world) {
    std::vector<std::uint64_t> of(static_cast<std::size_t>(processes_of(world)));
    MPI_Allgather(&here, 1, MPI_UINT64_T, of.data(), 1, MPI_UINT64_T, world);
    Counts out{{0}};
    for (const std::uint64_t count : of) out.first.push_back(out.first.back() + count);
    return out;
}

}  // namespace

NodeItems at_holders(const NodeItems& items, const HaloLayout& layout,
                     const std::vector<int>& nodes) {
    const Cuts& cuts = layout.cuts;
    std::vector<std::vector<std::uint64_t>> to(static_cast<std::size_t>(processes_of(cuts.world)));
    for (std::size_t item = 0; item < items.size(); ++item) {
        const std::uint64_t* words = items.words.data() + item * items.each();
        std::uint64_t rest = words[0];
        // Places in the grid of processes, direction by direction.
        std::vector<std::size_t> holders{0};
        std::size_t step = 1;
        for (std::size_t d = 0; d < static_cast<std::size_t>(cuts.dimensions); ++d) {
            const auto at = static_cast<int>(rest % static_cast<std::uint64_t>(nodes[d]));
            rest /= static_cast<std::uint64_t>(nodes[d]);
            const std::vector<Slice>& slices = layout.slices[d];
            std::vector<std::size_t> more;
            for (std::size_t i = 0; i < slices.size(); ++i)
                if (at >= slices[i].first_node && at <= slices[i].axis_last)
                    for (const std::size_t before : holders) more.push_back(before + i * step);
            holders.swap(more);
            step *= slices.size();
        }
        for (const std::size_t place : holders) {
            auto& of = to[static_cast<std::size_t>(cuts.rank[place])];
            of.insert(of.end(), words, words + items.each());
        }
    }
    return {items.words_each, hand_over(to, cuts.world)};
}

// Items and places are numbered through, process by process.
SpreadItems spread(const NodeItems& items, std::size_t places, MPI_Comm world) {
    const Counts of_items = counts_of(items.size(), world), of_places = counts_of(places, world);
    SpreadItems out;
    out.items.words_each = items.words_each;
    if (of_items.all() == 0) return out;
    if (of_places.all() == 0)
        throw std::runtime_error("the state at nodes has no atoms that could take it along");
    const std::uint64_t each = (of_items.all() + of_places.all() - 1) / of_places.all();
    out.for_each_place = static_cast<std::size_t>(each);
    int rank = 0;
    MPI_Comm_rank(world, &rank);
    std::vector<std::vector<std::uint64_t>> to(of_items.first.size() - 1);
    for (std::size_t i = 0; i < items.size(); ++i) {
        const std::uint64_t place = (of_items.first[static_cast<std::size_t>(rank)] + i) / each;
        const auto behind = std::upper_bound(of_places.first.begin(), of_places.first.end(), place);
        auto& of = to[static_cast<std::size_t>(behind - of_places.first.begin() - 1)];
        const auto* words = items.words.data() + i * items.each();
        of.insert(of.end(), words, words + items.each());
    }
    out.items.words = hand_over(to, world);
    return out;
}

}  // namespace grit::lammps
