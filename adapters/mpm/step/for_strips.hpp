// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adapters/mpm/step/thread_pool.hpp"

namespace grit::mpm {

// work(part, strip) for all bodies and strips.
template <class Parts, class Work>
void for_strips(ThreadPool& pool, Parts& parts, const Work& work) {
    if (parts.empty()) return;
    const int strips = parts[0].strips.count();
    pool.run(strips * static_cast<int>(parts.size()),
             [&](int i) { work(parts[static_cast<std::size_t>(i / strips)], i % strips); });
}

}  // namespace grit::mpm
