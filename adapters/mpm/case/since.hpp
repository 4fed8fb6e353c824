// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "adapters/mpm/case/case.hpp"

namespace grit::mpm {

// When stages began [s]; infinite: not yet. Loads and motions that start with a stage look here.
struct Clock {
    std::vector<double> began;
};

// Time since the stage began; the run's if none is named.
class Since {
  public:
    Since(const Case& plan, std::shared_ptr<Clock> clock_of_run, const std::string& stage)
        : clock(std::move(clock_of_run)), always(stage.empty()),
          number(always ? 0 : plan.stage(stage)) {}
    // Negative: not yet.
    double operator()(double t) const { return always ? t : t - clock->began[number]; }

  private:
    std::shared_ptr<Clock> clock;
    bool always;
    std::size_t number;
};

}  // namespace grit::mpm
