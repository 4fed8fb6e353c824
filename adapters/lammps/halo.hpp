// SPDX-License-Identifier: GPL-2.0-only
// The exchange of material points over a grid of processes: first along r, or x, then along the next directions. In
// each phase two processes share a node, no more: a + b is b + a, and all that hold a node have the same bits of its sum.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <mpi.h>

#include "adapters/lammps/slice.hpp"
#include "adapters/mpm/kernel/exchange.hpp"

namespace grit::lammps {

inline constexpr int most_dimensions = 3;

// How the grid is cut: along r and z, or x, y and z.
struct Cuts {
    MPI_Comm world;
    int dimensions;
    std::array<std::vector<double>, most_dimensions> at;  // with both ends [m]
    std::array<int, most_dimensions> here;                // place of this process among all
    int neighbour[most_dimensions][2];                    // rank before and behind
    std::vector<int> rank;  // of all processes, those along the first direction one after the other
};

// Which lines of nodes each process has.
struct HaloLayout {
    Cuts cuts;
    std::array<std::vector<Slice>, most_dimensions> slices = {};  // of all processes
    mpm::AxisView axes[most_dimensions] =
        {};  // of the whole grid; what they view outlives the halo
};

class Halo : public mpm::Exchange {
  public:
    explicit Halo(HaloLayout layout);

    const mpm::WholeAxes* whole() const override { return &whole_axes; }
    const std::uint8_t* counted() const override { return counts.data(); }
    void sum_nodes(double* values, std::ptrdiff_t nodes, int each) override;
    void sum_nodes(std::int64_t* values, std::ptrdiff_t nodes, int each) override;
    const std::uint8_t* counted_cells() const override { return cell_counts.data(); }
    void sum_cells(double* values, std::ptrdiff_t cells, int each) override;
    void sum_cells(std::int64_t* values, std::ptrdiff_t cells, int each) override;
    void min_nodes(double* values, std::ptrdiff_t nodes, int each) override;
    void min_nodes(double* values, const std::vector<std::ptrdiff_t>& nodes, int each) override;
    void max(double* values, int count) override;
    void sum(double* values, int count) override;
    void sum(std::int64_t* values, int count) override;
    void gather(std::vector<mpm::KeyedNumbers>& items) override;

    int dimensions() const { return layout.cuts.dimensions; }
    const Slice& slice(int direction) const {
        const auto d = static_cast<std::size_t>(direction);
        return layout.slices[d][static_cast<std::size_t>(layout.cuts.here[d])];
    }
    const HaloLayout& of() const { return layout; }

    // What this process has sent to neighbours, what it and all others got by gathers, and the wall time of all
    // exchanges, since the start.
    struct Traffic {
        std::int64_t messages = 0, bytes = 0, reductions = 0, gathers = 0, gathered_bytes = 0;
        double seconds = 0.0;
    };
    const Traffic& traffic() const { return sent; }
    // Counts go on from those of an exchange before this one.
    void count_from(const Traffic& before) { sent = before; }

  private:
    // Lines of nodes or cells, on this process, that a neighbour has too.
    struct Shared {
        int rank, first, count;
    };
    enum class Of { nodes, cells };
    std::vector<Shared> shared(int direction, Of what) const;
    // Of nodes or cells that are held here.
    std::size_t lines(int direction, Of what) const;
    std::vector<std::uint8_t> counted_first(Of what) const;
    // Runs of numbers one after the other, those that a neighbour has too: what it gives is combined with them.
    struct Run {
        std::size_t first, count;
    };
    template <class Number, class Combine>
    void swap(const std::vector<Shared>& with, const std::vector<Run> (&runs)[2], Number* values,
              const Combine& combine);
    template <class Number, class Combine>
    void exchange(Number* values, int per_place, Of what, const Combine& combine);

    HaloLayout layout;
    mpm::WholeAxes whole_axes{};
    std::vector<std::uint8_t> counts, cell_counts;
    std::vector<mpm::KeyedNumbers> own_items;
    std::vector<int> words_of, first_word;  // of each process
    std::array<std::vector<std::uint64_t>, 2> outgoing, incoming;
    std::vector<std::pair<std::ptrdiff_t, std::size_t>> in_order;  // nodes, and their places
    std::vector<Run> runs_with[2];                                 // each neighbour
    Traffic sent;
};

}  // namespace grit::lammps
