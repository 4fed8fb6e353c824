// SPDX-License-Identifier: BSD-3-Clause
// A step in progress: parts of it are attempted, and kept or not.
#pragma once

#include <memory>

#include "element/newton.hpp"
#include "element/simulate.hpp"

namespace element {

struct Attempt {
    Solution solution;
    Sample end;  // meaningful if the solution is done
};

// What was done last, and from where.
struct KeptPart {
    Sample start;
    Attempt attempt;
    double from = 0.0, to = 0.0;
};

class Stage {
  public:
    Stage() = default;
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;
    virtual ~Stage() = default;

    // From share `from` of the step, where the sample is now, to share `to`.
    virtual Attempt attempt(const Sample& now, double from, double to) = 0;
    // The last attempt is kept: it may guide the next.
    virtual void keep(const Attempt& attempt, double from, double to) = 0;
    // Derivatives at its end, from those at its start where the sample is now; nothing where they are undetermined.
    virtual std::optional<Slopes> slopes_after(const Sample& now, const Attempt& attempt,
                                               double from, double to) = 0;
    // Of the end of a part by the share of the step that is done there: a column; nothing where they are undetermined.
    // Throws BadCase where there are none.
    virtual std::optional<Slopes> slopes_by_share(const KeptPart& part) = 0;
    // The last attempt failed: what guided it is not to be trusted.
    virtual void forget() = 0;
};

// number: KSTEP; number of the increment: set_increment. The step outlives the stage.
struct StageContext {
    const Law& law;
    const Settings& settings;
    long step = 1;
    int increment = 1;
};

std::unique_ptr<Stage> begin_stage(const Step& step, const Sample& sample,
                                   const StageContext& context);

// Attempts from `from` to `to`, halving what fails and doubling again what succeeds.
struct Advance {
    bool done = true;
    bool moved = false;   // some part was kept: the sample is not where it was
    std::string message;  // of the failure
    long iterations = 0, evaluations = 0, cut_backs = 0;
    std::vector<double> residuals;  // of the last part
};
// last: if wanted, what was kept last.
Advance advance(Stage& stage, Sample& sample, double from, double to, double smallest_part,
                KeptPart* last = nullptr);

}  // namespace element
