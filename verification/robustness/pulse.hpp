// SPDX-License-Identifier: BSD-3-Clause
// What a thread of trials is at, for signals: that of a crash, and that of a clock which finds calls that never return.
#pragma once

#include <atomic>

namespace robustness {

struct Pulse {
    std::atomic<long> block = 0;      // its number plus 1; 0: at none
    std::atomic<bool> moved = false;  // since the clock was last heard
};

inline constinit thread_local Pulse* pulse = nullptr;  // of this thread

// A trial got on.
inline void beat() {
    if (pulse) pulse->moved.store(true, std::memory_order_relaxed);
}

}  // namespace robustness
