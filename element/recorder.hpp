// SPDX-License-Identifier: BSD-3-Clause
// Writes the history of a run.
#pragma once

#include "element/stage.hpp"

namespace element {

// Where a run is.
struct Place {
    long step = 0;
    int increment = 0;
};

class Recorder {
  public:
    Recorder(const Law& law, const Settings& settings, const Listeners& listeners);

    // The sample as it is now, without the work that led to it.
    Record snapshot(const Sample& sample, Place place) const;
    // Work that the next record will show.
    void add(const Advance& work);
    void record(const Sample& sample, Place place);

    void exit(Place place, const Condition& condition);
    void fail(const Step& step, const Sample& sample, Place place, int increments,
              const std::string& why);

    History take() { return std::move(history); }

  private:
    RecordSlopes slopes_of(const Sample& sample) const;

    const Law& law;
    const Settings& settings;
    const Listeners& listeners;
    History history;
    Advance work;  // since the last record
};

}  // namespace element
