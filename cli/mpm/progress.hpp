// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>

#include <adapters/mpm/run/run.hpp>

namespace cli {

// How far a material-point run is, on stderr: one line rewritten in place on a terminal, a plain line
// every half minute in a log.
class MpmProgress {
  public:
    explicit MpmProgress(bool quiet);
    // After a step; true about once a second.
    bool operator()(grit::mpm::Runner& runner);
    // Clear the line of a terminal.
    void finish();
    double seconds() const;

  private:
    using Clock = std::chrono::steady_clock;
    std::string line(grit::mpm::Runner& runner);

    bool quiet, terminal;
    Clock::time_point start, last, last_line, stage_start;
    long first_step = -1;
    int stage = -1;
    double stage_share = 0.0;  // when this progress first saw the stage
    bool drawn = false;
};

}  // namespace cli
