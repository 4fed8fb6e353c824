// SPDX-License-Identifier: BSD-3-Clause
// Pressures of cells on nodes, and how cells swell, against sums node by node; the same bits by every instruction set.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <random>
#include <vector>

#include <adapters/mpm/kernel/call.hpp>
#include <adapters/mpm/kernel/pore_water.hpp>

namespace {

using namespace grit::mpm;
using grit::Vector2;

// Cells with gaps between them and more patches than cells, the last one at the end of all nodes.
struct Patches {
    static constexpr std::size_t row = 9, rows = 7;
    std::vector<CellPatch> patches;
    std::vector<PatchedCell> cells;
    std::vector<double> pressure;
    // No longer than what may be read.
    std::unique_ptr<NodeAnswer[]> answers{new NodeAnswer[row * rows]};
    std::unique_ptr<Vector2[]> velocity{new Vector2[row * rows]};

    explicit Patches(unsigned seed) {
        std::mt19937_64 random(seed);
        const auto any = [&random] {
            return 2.0 * (static_cast<double>(random() >> 11) * 0x1p-53) - 1.0;
        };
        for (std::size_t j = 0; j + 3 < rows; ++j)
            for (std::size_t i = 0; i + 3 < row; ++i) {
                patches.emplace_back();
                for (double& f : patches.back().force) f = any();
                const bool is_last = j + 4 == rows && i + 4 == row;
                if (!is_last && any() > 0.6) continue;
                cells.push_back({patches.size() - 1, j * row + i});
                pressure.push_back(1e5 * any());
            }
        for (std::size_t node = 0; node < row * rows; ++node) {
            answers[node] = {any(), any(), any()};
            velocity[node] = {any(), any()};
        }
    }
    PatchCall call() const { return {patches.data(), cells.data(), cells.size(), row}; }
    std::size_t nodes() const { return row * rows; }
    // take(node, its force for 1 Pa) of a cell.
    template <class Take> void each_node(const PatchedCell& cell, const Take& take) const {
        for (std::size_t k = 0; k < 16; ++k) {
            const double* f = patches[cell.patch].force + 2 * k;
            take(cell.first + k / 4 * row + k % 4, Vector2{f[0], f[1]});
        }
    }
};

TEST(CellPatches, PushAndSwellAsTheirNodesDo) {
    for (unsigned seed = 1; seed < 20; ++seed) {
        const Patches of(seed);
        std::vector<Vector2> pushed(of.nodes(), Vector2{}), expected = pushed;
        std::vector<double> swelling(of.cells.size()), own(of.cells.size());
        kernels().push_by_pressures(of.call(), of.pressure.data(), pushed.data()->c);
        kernels().find_swelling(of.call(), of.velocity.get()->c, swelling.data());
        kernels().find_own_swelling(of.call(), of.answers.get(), own.data());
        for (std::size_t c = 0; c < of.cells.size(); ++c) {
            double swells = 0.0, by_itself = 0.0;
            of.each_node(of.cells[c], [&](std::size_t node, const Vector2& f) {
                expected[node] = expected[node] + of.pressure[c] * f;
                swells += dot(f, of.velocity[node]);
                by_itself += dot(f, of.answers[node](f));
            });
            EXPECT_NEAR(swelling[c], swells, 1e-13);
            EXPECT_NEAR(own[c], by_itself, 1e-13);
        }
        for (std::size_t node = 0; node < of.nodes(); ++node)
            for (int k = 0; k < 2; ++k) EXPECT_NEAR(pushed[node][k], expected[node][k], 1e-9);
    }
}

TEST(CellPatches, HaveTheSameBitsByEveryInstructionSet) {
    for (unsigned seed = 1; seed < 20; ++seed)
        for (const double largest : {0.0, 1e5}) {
            const Patches of(seed);
            PatchCall call = of.call();
            call.rounding = Rounding::of_sums(largest, 5);
            std::vector<double> found[2];
            const Kernels* sets[2] = {&kernels(), &baseline_kernels};
            for (const std::size_t k : {0u, 1u}) {
                found[k].assign(2 * of.nodes() + 2 * of.cells.size(), 0.0);
                double* at = found[k].data();
                sets[k]->push_by_pressures(call, of.pressure.data(), at);
                at += 2 * of.nodes();
                sets[k]->find_swelling(call, of.velocity.get()->c, at);
                sets[k]->find_own_swelling(call, of.answers.get(), at + of.cells.size());
            }
            EXPECT_EQ(
                std::memcmp(found[0].data(), found[1].data(), found[0].size() * sizeof(double)), 0);
        }
}

}  // namespace
