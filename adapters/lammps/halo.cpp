// SPDX-License-Identifier: GPL-2.0-only
#include "adapters/lammps/halo.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace grit::lammps {
namespace {

// Adds the wall time of its life.
class LifeTime {
  public:
    explicit LifeTime(double& total) : sum(total), begin(MPI_Wtime()) {}
    LifeTime(const LifeTime&) = delete;
    LifeTime& operator=(const LifeTime&) = delete;
    ~LifeTime() { sum += MPI_Wtime() - begin; }

  private:
    double& sum;
    double begin;
};

// The first of those that have a node counts it.
int first_counted(const std::vector<Slice>& of_all, int here) {
    const auto i = static_cast<std::size_t>(here);
    return i == 0 ? of_all[0].first_node : of_all[i - 1].last_node + 1;
}

int first_counted_cell(const std::vector<Slice>& of_all, int here) {
    const auto i = static_cast<std::size_t>(here);
    return i == 0 ? of_all[0].first_cell : of_all[i - 1].last_cell + 1;
}

}  // namespace

Halo::Halo(HaloLayout given) : layout(std::move(given)) {
    const Slice &r = slice(0), &z = slice(1);
    whole_grid = {layout.grid, r.first_node, z.first_node};
    const int first_r = first_counted(layout.slices[0], layout.here[0]);
    const int first_z = first_counted(layout.slices[1], layout.here[1]);
    for (int j = z.first_node; j <= z.axis_last; ++j)
        for (int i = r.first_node; i <= r.axis_last; ++i)
            counts.push_back(i >= first_r && i <= r.last_node && j >= first_z && j <= z.last_node);
    const int cell_r = first_counted_cell(layout.slices[0], layout.here[0]);
    const int cell_z = first_counted_cell(layout.slices[1], layout.here[1]);
    for (int j = z.first_node; j < z.axis_last; ++j)
        for (int i = r.first_node; i < r.axis_last; ++i)
            cell_counts.push_back(i >= cell_r && i <= r.last_cell && j >= cell_z &&
                                  j <= z.last_cell);
}

std::vector<Halo::Shared> Halo::shared(int direction, Of what) const {
    const auto d = static_cast<std::size_t>(direction);
    const auto here = static_cast<std::size_t>(layout.here[d]);
    const std::vector<Slice>& all = layout.slices[d];
    const Slice& mine = all[here];
    std::vector<Shared> out;
    const auto add = [&](const Slice& before, const Slice& behind, int rank) {
        const int first = what == Of::nodes ? behind.first_node : behind.first_cell;
        const int last = what == Of::nodes ? before.last_node : before.last_cell;
        if (last >= first) out.push_back({rank, first - mine.first_node, last - first + 1});
    };
    if (here > 0) add(all[here - 1], mine, layout.neighbour[direction][0]);
    if (here + 1 < all.size()) add(mine, all[here + 1], layout.neighbour[direction][1]);
    return out;
}

template <class Number, class Combine>
void Halo::exchange_along(int direction, Number* values, int per_place, Of what,
                          const Combine& combine) {
    static_assert(sizeof(Number) == sizeof(std::uint64_t));
    const std::vector<Shared> with = shared(direction, what);
    const int less = what == Of::nodes ? 0 : 1;
    const int n_r = slice(0).axis_last - slice(0).first_node + 1 - less;
    const int n_z = slice(1).axis_last - slice(1).first_node + 1 - less;
    // Runs of numbers: a part of each row, or rows.
    const int runs = direction == 0 ? n_z : 1;
    const auto each = [&](const Shared& s) {
        return static_cast<std::size_t>(s.count) *
               static_cast<std::size_t>(direction == 0 ? 1 : n_r) *
               static_cast<std::size_t>(per_place);
    };
    const auto at = [&](const Shared& s, int run) {
        const std::ptrdiff_t place =
            direction == 0 ? std::ptrdiff_t{run} * n_r + s.first : std::ptrdiff_t{s.first} * n_r;
        return values + place * per_place;
    };
    MPI_Request requests[4];
    int count = 0;
    for (std::size_t k = 0; k < with.size(); ++k) {
        const std::size_t size = each(with[k]) * static_cast<std::size_t>(runs);
        outgoing[k].resize(size);
        incoming[k].resize(size);
        MPI_Irecv(incoming[k].data(), static_cast<int>(size), MPI_UINT64_T, with[k].rank, 0,
                  layout.world, &requests[count++]);
        for (int run = 0; run < runs; ++run)
            std::memcpy(outgoing[k].data() + static_cast<std::size_t>(run) * each(with[k]),
                        at(with[k], run), each(with[k]) * sizeof(Number));
        MPI_Isend(outgoing[k].data(), static_cast<int>(size), MPI_UINT64_T, with[k].rank, 0,
                  layout.world, &requests[count++]);
        ++sent.messages;
        sent.bytes += static_cast<std::int64_t>(size * sizeof(Number));
    }
    MPI_Waitall(count, requests, MPI_STATUSES_IGNORE);
    for (std::size_t k = 0; k < with.size(); ++k)
        for (int run = 0; run < runs; ++run) {
            Number* mine = at(with[k], run);
            const std::uint64_t* theirs =
                incoming[k].data() + static_cast<std::size_t>(run) * each(with[k]);
            for (std::size_t i = 0; i < each(with[k]); ++i) {
                Number value;
                std::memcpy(&value, theirs + i, sizeof value);
                mine[i] = combine(mine[i], value);
            }
        }
}

template <class Number, class Combine>
void Halo::exchange(Number* values, int per_place, Of what, const Combine& combine) {
    const LifeTime watch(sent.seconds);
    for (const int direction : {0, 1}) exchange_along(direction, values, per_place, what, combine);
}

void Halo::sum_nodes(mpm::NodeRecord* records, std::ptrdiff_t) {
    exchange(records->value, mpm::record::size, Of::nodes,
             [](double a, double b) { return a + b; });
}

// Sums that are too large wrap: as in the kernels, they have no sign here.
void Halo::sum_nodes(mpm::NodeIntegers* records, std::ptrdiff_t) {
    exchange(reinterpret_cast<std::uint64_t*>(records->value), mpm::record::size, Of::nodes,
             [](std::uint64_t a, std::uint64_t b) { return a + b; });
}

void Halo::sum_nodes(Vector2* forces, std::ptrdiff_t nodes) {
    if (nodes > 0) exchange(forces->c, 2, Of::nodes, [](double a, double b) { return a + b; });
}

void Halo::sum_cells(mpm::CellIntegers* cells, std::ptrdiff_t count) {
    if (count > 0)
        exchange(&cells->volume, 2, Of::cells,
                 [](std::int64_t a, std::int64_t b) { return a + b; });
}

void Halo::sum_cells(mpm::NodeIntegers* records, std::ptrdiff_t cells, int each) {
    if (cells > 0)
        exchange(reinterpret_cast<std::uint64_t*>(records->value), each * mpm::record::size,
                 Of::cells, [](std::uint64_t a, std::uint64_t b) { return a + b; });
}

void Halo::sum_cells(double* values, std::ptrdiff_t cells, int each) {
    if (cells > 0) exchange(values, each, Of::cells, [](double a, double b) { return a + b; });
}

void Halo::min_nodes(double* values, std::ptrdiff_t, int per_node) {
    exchange(values, per_node, Of::nodes, [](double a, double b) {
        // Of zeros the negative one, on both sides.
        return a < b || (a == b && std::signbit(a)) ? a : b;
    });
}

void Halo::max(double* values, int count) {
    const LifeTime watch(sent.seconds);
    MPI_Allreduce(MPI_IN_PLACE, values, count, MPI_DOUBLE, MPI_MAX, layout.world);
    ++sent.reductions;
}

void Halo::sum(double* values, int count) {
    const LifeTime watch(sent.seconds);
    MPI_Allreduce(MPI_IN_PLACE, values, count, MPI_DOUBLE, MPI_SUM, layout.world);
    ++sent.reductions;
}

void Halo::sum(std::int64_t* values, int count) {
    const LifeTime watch(sent.seconds);
    MPI_Allreduce(MPI_IN_PLACE, values, count, MPI_UINT64_T, MPI_SUM, layout.world);
    ++sent.reductions;
}

// By ranks.
void Halo::gather(std::vector<mpm::KeyedNumbers>& items) {
    const LifeTime watch(sent.seconds);
    constexpr int words = sizeof(mpm::KeyedNumbers) / sizeof(std::uint64_t);
    int processes = 0;
    MPI_Comm_size(layout.world, &processes);
    words_of.resize(static_cast<std::size_t>(processes));
    first_word.resize(static_cast<std::size_t>(processes));
    const int mine = static_cast<int>(items.size()) * words;
    MPI_Allgather(&mine, 1, MPI_INT, words_of.data(), 1, MPI_INT, layout.world);
    std::int64_t total = 0;
    for (std::size_t i = 0; i < words_of.size(); ++i) {
        first_word[i] = static_cast<int>(total);
        total += words_of[i];
        if (total > std::numeric_limits<int>::max())
            throw std::runtime_error("particles and nodes at surfaces are more than a message of " +
                                     std::to_string(std::numeric_limits<int>::max()) +
                                     " words holds");
    }
    own_items.swap(items);
    items.resize(static_cast<std::size_t>(total / words));
    MPI_Allgatherv(own_items.data(), mine, MPI_UINT64_T, items.data(), words_of.data(),
                   first_word.data(), MPI_UINT64_T, layout.world);
    ++sent.gathers;
    sent.gathered_bytes += total * static_cast<std::int64_t>(sizeof(std::uint64_t));
}

}  // namespace grit::lammps
