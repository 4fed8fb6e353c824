// SPDX-License-Identifier: BSD-3-Clause
// Writes the history of a run.
#pragma once

#include "element/stage.hpp"

namespace element {

// Where a run is.
struct Place {
    int step = 0, increment = 0;
};

class Recorder {
  public:
    explicit Recorder(const Law& law, bool keep_residuals);

    // The sample as it is now, without the work that led to it.
    Record snapshot(const Sample& sample, Place place) const;
    // Work that the next record will show.
    void add(const Advance& work);
    void record(const Sample& sample, Place place, double step_time);

    void exit(Place place, const Condition& condition);
    void fail(const Step& step, const Sample& sample, Place place, int increments,
              const std::string& why);

    const std::vector<std::string>& state_names() const { return history.state_names; }
    History take() { return std::move(history); }

  private:
    const Law& law;
    bool keep_residuals;
    History history;
    Advance work;  // since the last record
};

}  // namespace element
