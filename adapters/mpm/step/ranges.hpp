// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>

namespace grit::mpm {

// work(begin, end) of no more than so many particles of a strip or pencil at a time.
template <class Blocks, class Work>
void each_range(const Blocks& blocks, int number, std::ptrdiff_t most, const Work& work) {
    const std::ptrdiff_t end = blocks.begin(number + 1);
    for (std::ptrdiff_t begin = blocks.begin(number); begin < end;) {
        const std::ptrdiff_t stop = std::min(begin + most, end);
        work(begin, stop);
        begin = stop;
    }
}

}  // namespace grit::mpm
