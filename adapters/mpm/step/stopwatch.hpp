// SPDX-License-Identifier: BSD-3-Clause
// Where the time of steps goes.
#pragma once

#include <chrono>

namespace grit::mpm {

// Of the steps that this process did [s]. material: of the threads together, by their number; a part of
// what gather took, the others are apart.
struct Seconds {
    long steps = 0;
    double scatter = 0.0, nodes = 0.0, contact = 0.0, gather = 0.0, material = 0.0;
    double total() const { return scatter + nodes + contact + gather; }
};

class Stopwatch {
  public:
    // Adds what has passed since the last lap, or the start.
    void lap(double& seconds) {
        const Clock::time_point now = Clock::now();
        seconds += std::chrono::duration<double>(now - last).count();
        last = now;
    }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point last = Clock::now();
};

}  // namespace grit::mpm
