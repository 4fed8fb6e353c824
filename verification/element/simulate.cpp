// SPDX-License-Identifier: BSD-3-Clause
#include "element/simulate.hpp"

#include <cmath>
#include <numbers>

#include "element/check.hpp"
#include "element/errors.hpp"
#include "element/path.hpp"
#include "element/recorder.hpp"
#include "element/text.hpp"

namespace element {
namespace {

// Number `index` of a step of perturbations, as a step of its own.
Step probe_of(const Step& step, int index) {
    const auto& probes = std::get<Perturbations>(step.kind);
    const double angle = 2.0 * std::numbers::pi * (index - 1) / step.increments;
    Linear kind;
    kind.rows = probes.rows;
    kind.change = std::cos(angle) * probes.first + std::sin(angle) * probes.second;
    Step probe;
    probe.kind = kind;
    probe.increments = 1;
    probe.duration = step.duration / step.increments;
    probe.iteration_limit = step.iteration_limit;
    probe.undrained = step.undrained;
    return probe;
}

// A run in progress; every function that returns bool returns false where the run is over.
class Runner {
  public:
    Runner(const Law& l, Sample& s, const Settings& set, const RunObserver& o)
        : law(l), sample(s), settings(set), observer(o), recorder(l, set.keep_residuals) {}

    History run(const Program& program) {
        progress.steps = count_steps(program);
        progress.increments = count_increments(program);
        if (settings.record_start) recorder.record(sample, place, 0.0);
        run_steps(program);
        return recorder.take();
    }

  private:
    bool run_steps(const Program& program) {
        for (const Step& step : program) {
            if (const auto* repetition = std::get_if<Repetition>(&step.kind)) {
                for (int i = 0; i < repetition->times; ++i)
                    if (!run_steps(repetition->steps)) return false;
                continue;
            }
            ++place.step;
            place.increment = 0;
            const bool go_on =
                std::holds_alternative<Perturbations>(step.kind) ? probe(step) : follow(step);
            if (!go_on) return false;
        }
        return true;
    }

    bool follow(const Step& step) {
        StageContext context{law, settings, place.step, 1};
        const auto stage = begin_stage(step, sample, context);
        const std::vector<double> knots = knots_of(step);
        const int last = static_cast<int>(knots.size()) - 1;
        for (int i = 1; i <= last; ++i) {
            const double from = knots[static_cast<std::size_t>(i) - 1];
            double to = knots[static_cast<std::size_t>(i)];
            context.increment = place.increment = i;
            const Sample before = step.exit.exactly ? sample : Sample{};
            Advance work = advance(*stage, sample, from, to, settings.smallest_part);
            if (!work.done) return fail(step, work.message, last);
            const Condition* exit = first_exit(step);
            if (exit && step.exit.exactly) to = locate(*stage, *exit, before, from, to, work);
            recorder.add(work);
            if (exit || i % step.every == 0 || (i == last && step.record_end))
                recorder.record(sample, place, stage->time(to));
            if (exit) recorder.exit(place, *exit);
            if (!report()) return fail(step, "stopped on request", last);
            if (exit) return true;
        }
        return true;
    }

    // Every increment from the same state.
    bool probe(const Step& step) {
        const Sample origin = sample;
        for (int i = 1; i <= step.increments; ++i) {
            place.increment = i;
            const Step single = probe_of(step, i);
            const StageContext context{law, settings, place.step, i};
            const auto stage = begin_stage(single, sample, context);
            const Advance work = advance(*stage, sample, 0.0, 1.0, settings.smallest_part);
            if (!work.done) return fail(step, work.message, step.increments);
            recorder.add(work);
            recorder.record(sample, place, i * single.duration);
            if (!report()) return fail(step, "stopped on request", step.increments);
            const double time = sample.time;
            sample = origin;
            sample.time = time;
        }
        return true;
    }

    bool holds_now(const Condition& condition) const {
        return holds(condition, recorder.snapshot(sample, place), recorder.state_names());
    }

    const Condition* first_exit(const Step& step) const {
        for (const Condition& condition : step.exit.any_of)
            if (holds_now(condition)) return &condition;
        return nullptr;
    }

    // The increment from `before` has been taken as a whole and the condition holds at its end. Leaves
    // the sample where it begins to hold, and returns that share.
    double locate(Stage& stage, const Condition& exit, const Sample& before, double from, double to,
                  Advance& work) {
        Sample beyond = sample;
        sample = before;
        double low = from, high = holds_now(exit) ? from : to;  // held before: nothing to find
        while (high - low > 1e-9 * (to - from)) {
            const double middle = 0.5 * (low + high);
            sample = before;
            const Advance part = advance(stage, sample, from, middle, settings.smallest_part);
            work.iterations += part.iterations;
            work.evaluations += part.evaluations;
            if (!part.done) break;
            const bool reached = holds_now(exit);
            (reached ? high : low) = middle;
            if (reached) beyond = sample;
        }
        sample = beyond;
        return high > from ? high : to;
    }

    bool report() {
        ++progress.increment;
        progress.step = place.step;
        if (!observer) return true;
        const Record now = recorder.snapshot(sample, place);
        progress.record = &now;
        const bool go_on = observer(progress);
        progress.record = nullptr;
        return go_on;
    }

    bool fail(const Step& step, const std::string& why, int increments) {
        recorder.fail(step, sample, place, increments, why);
        return false;
    }

    const Law& law;
    Sample& sample;
    const Settings& settings;
    const RunObserver& observer;
    Recorder recorder;
    Progress progress;
    Place place;
};

}  // namespace

long count_increments(const Program& program) {
    long n = 0;
    for (const Step& step : program) {
        const auto* repetition = std::get_if<Repetition>(&step.kind);
        n += repetition ? repetition->times * count_increments(repetition->steps)
                        : increments_of(step);
    }
    return n;
}

int count_steps(const Program& program) {
    int n = 0;
    for (const Step& step : program) {
        const auto* repetition = std::get_if<Repetition>(&step.kind);
        n += repetition ? repetition->times * count_steps(repetition->steps) : 1;
    }
    return n;
}

History simulate(const Law& law, Sample& sample, const Program& program, const Settings& settings,
                 const RunObserver& observer) {
    check_settings(settings);
    check_program(program, law.state_names());
    if (sample.point.state.size() != law.state_names().size())
        throw BadCase(text("the sample has %d state variables, the law has %d",
                           static_cast<int>(sample.point.state.size()),
                           static_cast<int>(law.state_names().size())));
    return Runner(law, sample, settings, observer).run(program);
}

}  // namespace element
