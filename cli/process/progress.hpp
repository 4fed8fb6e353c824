// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>

namespace cli {

// How far a run is, on stderr: one line rewritten in place on a terminal, a plain line every tenth
// of the way, but not more than one a second, in a log.
class Progress {
  public:
    // what: one of those that are counted, "increment".
    explicit Progress(std::string name, std::string what = "increment");
    void operator()(long increment, long increments);
    // Clear the line of a terminal.
    void finish();
    double seconds() const;

  private:
    using Clock = std::chrono::steady_clock;
    std::string line(long increment, long increments) const;

    std::string name, what;
    bool terminal;
    Clock::time_point start, last;
    int tenths = 0;
    bool drawn = false;
};

}  // namespace cli
