// SPDX-License-Identifier: GPL-2.0-only
#include "adapters/lammps/halo.hpp"

#include <algorithm>
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
int first_counted(const std::vector<Slice>& of_all, std::size_t i) {
    return i == 0 ? of_all[0].first_node : of_all[i - 1].last_node + 1;
}

int first_counted_cell(const std::vector<Slice>& of_all, std::size_t i) {
    return i == 0 ? of_all[0].first_cell : of_all[i - 1].last_cell + 1;
}

struct Sum {
    double operator()(double a, double b) const { return a + b; }
    // Sums that are too large wrap: as in the kernels, they have no sign here.
    std::int64_t operator()(std::int64_t a, std::int64_t b) const {
        return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) +
                                         static_cast<std::uint64_t>(b));
    }
};

// Of zeros the negative one, on both sides.
struct Least {
    double operator()(double a, double b) const {
        return a < b || (a == b && std::signbit(a)) ? a : b;
    }
};

}  // namespace

Halo::Halo(HaloLayout given) : layout(std::move(given)) {
    for (int d = 0; d < dimensions(); ++d) {
        whole_axes.axis[d] = layout.axes[d];
        whole_axes.first[d] = slice(d).first_node;
    }
    counts = counted_first(Of::nodes);
    cell_counts = counted_first(Of::cells);
}

std::size_t Halo::lines(int direction, Of what) const {
    const Slice& s = slice(direction);
    const int cells = s.axis_last - s.first_node;
    return static_cast<std::size_t>(cells) + (what == Of::nodes ? 1 : 0);
}

// Direction by direction: a line counts where all of its coordinates do.
std::vector<std::uint8_t> Halo::counted_first(Of what) const {
    std::vector<std::uint8_t> out{1};
    for (int d = 0; d < dimensions(); ++d) {
        const auto k = static_cast<std::size_t>(d);
        const auto here = static_cast<std::size_t>(layout.cuts.here[k]);
        const Slice& mine = slice(d);
        const int first = what == Of::nodes ? first_counted(layout.slices[k], here)
                                            : first_counted_cell(layout.slices[k], here);
        const int last = what == Of::nodes ? mine.last_node : mine.last_cell;
        std::vector<std::uint8_t> more;
        for (std::size_t i = 0; i < lines(d, what); ++i) {
            const int at = mine.first_node + static_cast<int>(i);
            for (const std::uint8_t before : out)
                more.push_back(before && at >= first && at <= last);
        }
        out.swap(more);
    }
    return out;
}

std::vector<Halo::Shared> Halo::shared(int direction, Of what) const {
    const auto d = static_cast<std::size_t>(direction);
    const auto here = static_cast<std::size_t>(layout.cuts.here[d]);
    const std::vector<Slice>& all = layout.slices[d];
    const Slice& mine = all[here];
    std::vector<Shared> out;
    const auto add = [&](const Slice& before, const Slice& behind, int rank) {
        const int first = what == Of::nodes ? behind.first_node : behind.first_cell;
        const int last = what == Of::nodes ? before.last_node : before.last_cell;
        if (last >= first) out.push_back({rank, first - mine.first_node, last - first + 1});
    };
    if (here > 0) add(all[here - 1], mine, layout.cuts.neighbour[d][0]);
    if (here + 1 < all.size()) add(mine, all[here + 1], layout.cuts.neighbour[d][1]);
    return out;
}

template <class Number, class Combine>
void Halo::swap(const std::vector<Shared>& with, const std::vector<Run> (&runs)[2], Number* values,
                const Combine& combine) {
    static_assert(sizeof(Number) == sizeof(std::uint64_t));
    MPI_Request requests[4];
    int count = 0;
    for (std::size_t k = 0; k < with.size(); ++k) {
        std::size_t size = 0;
        for (const Run& run : runs[k]) size += run.count;
        if (size == 0) continue;
        if (size > static_cast<std::size_t>(std::numeric_limits<int>::max()))
            throw std::runtime_error("a message to a neighbour has " + std::to_string(size) +
                                     " numbers, " +
                                     std::to_string(std::numeric_limits<int>::max()) +
                                     " is the limit: use more processors");
        outgoing[k].resize(size);
        incoming[k].resize(size);
        MPI_Irecv(incoming[k].data(), static_cast<int>(size), MPI_UINT64_T, with[k].rank, 0,
                  layout.cuts.world, &requests[count++]);
        std::uint64_t* to = outgoing[k].data();
        for (const Run& run : runs[k]) {
            std::memcpy(to, values + run.first, run.count * sizeof(Number));
            to += run.count;
        }
        MPI_Isend(outgoing[k].data(), static_cast<int>(size), MPI_UINT64_T, with[k].rank, 0,
                  layout.cuts.world, &requests[count++]);
        ++sent.messages;
        sent.bytes += static_cast<std::int64_t>(size * sizeof(Number));
    }
    MPI_Waitall(count, requests, MPI_STATUSES_IGNORE);
    for (std::size_t k = 0; k < with.size(); ++k) {
        const std::uint64_t* theirs = incoming[k].data();
        for (const Run& run : runs[k])
            for (std::size_t i = 0; i < run.count; ++i, ++theirs) {
                Number value;
                std::memcpy(&value, theirs, sizeof value);
                Number& mine = values[run.first + i];
                mine = combine(mine, value);
            }
    }
}

template <class Number, class Combine>
void Halo::exchange(Number* values, int per_place, Of what, const Combine& combine) {
    const LifeTime watch(sent.seconds);
    const auto each = static_cast<std::size_t>(per_place);
    for (int direction = 0; direction < dimensions(); ++direction) {
        const std::vector<Shared> with = shared(direction, what);
        // What lies side by side along the directions before this one, and how often that is there behind it.
        std::size_t inner = each, outer = 1;
        for (int d = 0; d < direction; ++d) inner *= lines(d, what);
        for (int d = direction + 1; d < dimensions(); ++d) outer *= lines(d, what);
        for (std::size_t k = 0; k < with.size(); ++k) {
            runs_with[k].clear();
            for (std::size_t i = 0; i < outer; ++i)
                runs_with[k].push_back(
                    {(i * lines(direction, what) + static_cast<std::size_t>(with[k].first)) * inner,
                     static_cast<std::size_t>(with[k].count) * inner});
        }
        swap(with, runs_with, values, combine);
    }
}

void Halo::sum_nodes(double* values, std::ptrdiff_t nodes, int each) {
    if (nodes > 0) exchange(values, each, Of::nodes, Sum());
}

void Halo::sum_nodes(std::int64_t* values, std::ptrdiff_t nodes, int each) {
    if (nodes > 0) exchange(values, each, Of::nodes, Sum());
}

void Halo::sum_cells(double* values, std::ptrdiff_t cells, int each) {
    if (cells > 0) exchange(values, each, Of::cells, Sum());
}

void Halo::sum_cells(std::int64_t* values, std::ptrdiff_t cells, int each) {
    if (cells > 0) exchange(values, each, Of::cells, Sum());
}

void Halo::min_nodes(double* values, std::ptrdiff_t nodes, int each) {
    if (nodes > 0) exchange(values, each, Of::nodes, Least());
}

// Both of two neighbours name the nodes that they share: nothing tells the other one which they are.
void Halo::min_nodes(double* values, const std::vector<std::ptrdiff_t>& nodes, int per_node) {
    const LifeTime watch(sent.seconds);
    const auto each = static_cast<std::size_t>(per_node);
    in_order.clear();
    for (std::size_t i = 0; i < nodes.size(); ++i) in_order.emplace_back(nodes[i], i);
    std::sort(in_order.begin(), in_order.end());
    std::size_t step = 1;
    for (int direction = 0; direction < dimensions(); ++direction) {
        const std::size_t along = lines(direction, Of::nodes);
        const std::vector<Shared> with = shared(direction, Of::nodes);
        for (std::size_t k = 0; k < with.size(); ++k) {
            runs_with[k].clear();
            for (const auto& [node, place] : in_order) {
                const auto at = static_cast<int>(static_cast<std::size_t>(node) / step % along);
                if (at >= with[k].first && at < with[k].first + with[k].count)
                    runs_with[k].push_back({place * each, each});
            }
        }
        swap(with, runs_with, values, Least());
        step *= along;
    }
}

void Halo::max(double* values, int count) {
    const LifeTime watch(sent.seconds);
    MPI_Allreduce(MPI_IN_PLACE, values, count, MPI_DOUBLE, MPI_MAX, layout.cuts.world);
    ++sent.reductions;
}

void Halo::sum(double* values, int count) {
    const LifeTime watch(sent.seconds);
    MPI_Allreduce(MPI_IN_PLACE, values, count, MPI_DOUBLE, MPI_SUM, layout.cuts.world);
    ++sent.reductions;
}

void Halo::sum(std::int64_t* values, int count) {
    const LifeTime watch(sent.seconds);
    MPI_Allreduce(MPI_IN_PLACE, values, count, MPI_UINT64_T, MPI_SUM, layout.cuts.world);
    ++sent.reductions;
}

// By ranks.
void Halo::gather(std::vector<mpm::KeyedNumbers>& items) {
    const LifeTime watch(sent.seconds);
    constexpr int words = sizeof(mpm::KeyedNumbers) / sizeof(std::uint64_t);
    int processes = 0;
    MPI_Comm_size(layout.cuts.world, &processes);
    words_of.resize(static_cast<std::size_t>(processes));
    first_word.resize(static_cast<std::size_t>(processes));
    const int mine = static_cast<int>(items.size()) * words;
    MPI_Allgather(&mine, 1, MPI_INT, words_of.data(), 1, MPI_INT, layout.cuts.world);
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
                   first_word.data(), MPI_UINT64_T, layout.cuts.world);
    ++sent.gathers;
    sent.gathered_bytes += total * static_cast<std::int64_t>(sizeof(std::uint64_t));
}

}  // namespace grit::lammps
