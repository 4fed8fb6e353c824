// SPDX-License-Identifier: BSD-3-Clause
// Two processes that share a grid, here two threads: what they hand to each other.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <barrier>
#include <cstring>
#include <vector>

#include <adapters/mpm/kernel/exchange.hpp>

namespace mpm_test {

using namespace grit::mpm;

inline constexpr int halo = 2;  // cells

// Two ranges of cells along r (0) or z (1), which meet at a grid line.
struct Cut {
    int direction;
    int cell;  // the first of the upper part
};

// What both hand to each other. Both are at the same call.
class Mailbox {
  public:
    explicit Mailbox(const Cut& where) : cut(where) {}
    // Gives bytes, gets those of the other.
    std::vector<char> swap(int rank, const void* data, std::size_t size) {
        const auto* bytes = static_cast<const char*>(data);
        mail[rank].assign(bytes, bytes + size);
        both.arrive_and_wait();
        std::vector<char> out = mail[1 - rank];
        both.arrive_and_wait();
        return out;
    }
    const Cut cut;

  private:
    std::vector<char> mail[2];
    std::barrier<> both{2};
};

class Neighbour : public Exchange {
  public:
    // along_r, along_z: of the whole grid.
    Neighbour(Mailbox& with, int number, const Axis& along_r, const Axis& along_z)
        : mailbox(with), rank(number), axes{along_r, along_z} {
        const Cut& cut = mailbox.cut;
        const int cells[] = {along_r.cells(), along_z.cells()};
        for (const int k : {0, 1}) {
            const bool is_cut = k == cut.direction;
            begin[k] = is_cut && rank == 1 ? std::max(cut.cell - halo, 0) : 0;
            end[k] = is_cut && rank == 0 ? std::min(cut.cell + halo, cells[k]) : cells[k];
        }
        whole_axes = {{axes[0].view(), axes[1].view()}, {begin[0], begin[1]}};
        const auto n_r = static_cast<std::size_t>(end[0] - begin[0]) + 1;
        const auto n_z = static_cast<std::size_t>(end[1] - begin[1]) + 1;
        mine.assign(n_r * n_z, 1);
        for (std::size_t j = 0; j < n_z; ++j)
            for (std::size_t i = 0; i < n_r; ++i) {
                const int at = static_cast<int>(cut.direction == 0 ? i : j) + begin[cut.direction];
                const std::size_t node = j * n_r + i;
                mine[node] = (at < cut.cell) == (rank == 0);
                if (std::abs(at - cut.cell) <= halo) shared_nodes.push_back(node);
                const bool is_cell = i + 1 < n_r && j + 1 < n_z;
                if (is_cell) my_cells.push_back(mine[node]);
                if (is_cell && at >= cut.cell - halo && at < cut.cell + halo)
                    shared_cells.push_back(j * (n_r - 1) + i);
            }
    }
    const WholeAxes* whole() const override { return &whole_axes; }
    const std::uint8_t* counted() const override { return mine.data(); }
    void sum_nodes(double* x, std::ptrdiff_t, int each) override { add(x, shared_nodes, each); }
    void sum_nodes(std::int64_t* x, std::ptrdiff_t, int each) override {
        add(x, shared_nodes, each);
    }
    const std::uint8_t* counted_cells() const override { return my_cells.data(); }
    void sum_cells(double* x, std::ptrdiff_t, int each) override { add(x, shared_cells, each); }
    void sum_cells(std::int64_t* x, std::ptrdiff_t, int each) override {
        add(x, shared_cells, each);
    }
    void min_nodes(double* x, std::ptrdiff_t, int each) override {
        reduce(x, shared_nodes, each, [](double a, double b) { return std::min(a, b); });
    }
    void max(double* x, int count) override {
        reduce(x, all(count), 1, [](double a, double b) { return std::max(a, b); });
    }
    void sum(double* x, int count) override { add(x, all(count), 1); }
    void sum(std::int64_t* x, int count) override { add(x, all(count), 1); }
    // The lower one's first.
    void gather(std::vector<KeyedNumbers>& items) override {
        const std::vector<char> in =
            mailbox.swap(rank, items.data(), items.size() * sizeof(KeyedNumbers));
        std::vector<KeyedNumbers> others(in.size() / sizeof(KeyedNumbers));
        if (!in.empty()) std::memcpy(others.data(), in.data(), in.size());
        items.insert(rank == 0 ? items.end() : items.begin(), others.begin(), others.end());
    }

    int begin[2], end[2];  // cells

  private:
    static std::vector<std::size_t> all(int count) {
        std::vector<std::size_t> out;
        for (int i = 0; i < count; ++i) out.push_back(static_cast<std::size_t>(i));
        return out;
    }
    template <class Number> void add(Number* x, const std::vector<std::size_t>& places, int each) {
        // The lower one's first, so that both get the same.
        reduce(x, places, each, [this](Number a, Number b) { return rank == 0 ? a + b : b + a; });
    }
    template <class Number, class Operation>
    void reduce(Number* x, const std::vector<std::size_t>& places, int numbers_each,
                const Operation& operation) {
        const auto each = static_cast<std::size_t>(numbers_each);
        std::vector<Number> out;
        for (const std::size_t place : places)
            out.insert(out.end(), x + each * place, x + each * (place + 1));
        const std::vector<char> in = mailbox.swap(rank, out.data(), out.size() * sizeof(Number));
        ASSERT_EQ(in.size(), out.size() * sizeof(Number));
        std::size_t at = 0;
        for (const std::size_t place : places)
            for (std::size_t c = 0; c < each; ++c, at += sizeof(Number)) {
                Number other;
                std::memcpy(&other, in.data() + at, sizeof other);
                Number& own = x[each * place + c];
                own = operation(own, other);
            }
    }
    Mailbox& mailbox;
    int rank;
    Axis axes[2];
    WholeAxes whole_axes;
    std::vector<std::uint8_t> mine, my_cells;
    std::vector<std::size_t> shared_nodes, shared_cells;
};

}  // namespace mpm_test
