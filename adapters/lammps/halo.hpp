// SPDX-License-Identifier: GPL-2.0-only
// The exchange of material points over a grid of processes: first along r, then along z. In each phase two
// processes share a node, no more: a + b is b + a, and all that hold a node have the same bits of its sum.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <mpi.h>

#include "adapters/lammps/slice.hpp"
#include "adapters/mpm/kernel/exchange.hpp"

namespace grit::lammps {

struct HaloLayout {
    MPI_Comm world;
    mpm::GridView grid;                        // of all; outlives the halo
    std::array<std::vector<Slice>, 2> slices;  // of all processes along r and z
    std::array<int, 2> here;                   // place of this one among them
    int neighbour[2][2];                       // rank before and behind along r and z
};

class Halo : public mpm::Exchange {
  public:
    explicit Halo(HaloLayout layout);

    const mpm::WholeGrid* whole() const override { return &whole_grid; }
    const std::uint8_t* counted() const override { return counts.data(); }
    void sum_nodes(mpm::NodeRecord* records, std::ptrdiff_t nodes) override;
    void sum_nodes(mpm::NodeIntegers* records, std::ptrdiff_t nodes) override;
    void sum_nodes(Vector2* forces, std::ptrdiff_t nodes) override;
    const std::uint8_t* counted_cells() const override { return cell_counts.data(); }
    void sum_cells(mpm::CellIntegers* cells, std::ptrdiff_t count) override;
    void sum_cells(mpm::NodeIntegers* records, std::ptrdiff_t cells, int each) override;
    void sum_cells(double* values, std::ptrdiff_t cells, int each) override;
    void min_nodes(double* values, std::ptrdiff_t nodes, int per_node) override;
    void max(double* values, int count) override;
    void sum(double* values, int count) override;
    void sum(std::int64_t* values, int count) override;
    void gather(std::vector<mpm::KeyedNumbers>& items) override;

    const Slice& slice(int direction) const {
        return layout.slices[static_cast<std::size_t>(direction)][static_cast<std::size_t>(
            layout.here[static_cast<std::size_t>(direction)])];
    }

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
    template <class Number, class Combine>
    void exchange(Number* values, int per_place, Of what, const Combine& combine);
    template <class Number, class Combine>
    void exchange_along(int direction, Number* values, int per_place, Of what,
                        const Combine& combine);

    HaloLayout layout;
    mpm::WholeGrid whole_grid;
    std::vector<std::uint8_t> counts, cell_counts;
    std::vector<mpm::KeyedNumbers> own_items;
    std::vector<int> words_of, first_word;  // of each process
    std::array<std::vector<std::uint64_t>, 2> outgoing, incoming;
    Traffic sent;
};

}  // namespace grit::lammps
