// SPDX-License-Identifier: BSD-3-Clause
// Items that processes tell each other, by keys: which part of them, and a number within it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "adapters/mpm/kernel/exchange.hpp"

namespace grit::mpm {

constexpr int number_bits = 60;
inline std::uint64_t key_of(int part, std::ptrdiff_t number) {
    return static_cast<std::uint64_t>(part) << number_bits | static_cast<std::uint64_t>(number);
}
inline std::ptrdiff_t number_of(const KeyedNumbers& item) {
    return static_cast<std::ptrdiff_t>(item.key & ((std::uint64_t{1} << number_bits) - 1));
}
inline bool is_before(const KeyedNumbers& item, std::uint64_t key) { return item.key < key; }

// Those of all processes, by keys, however particles are sorted and the grid is cut. What several of them have told of is one:
// they have the same bits of it.
inline void gather_sorted(Exchange& exchange, std::vector<KeyedNumbers>& items) {
    exchange.gather(items);
    std::sort(items.begin(), items.end(),
              [](const KeyedNumbers& x, const KeyedNumbers& y) { return x.key < y.key; });
    items.erase(
        std::unique(items.begin(), items.end(),
                    [](const KeyedNumbers& x, const KeyedNumbers& y) { return x.key == y.key; }),
        items.end());
}

}  // namespace grit::mpm
