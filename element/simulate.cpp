// SPDX-License-Identifier: BSD-3-Clause
#include "element/simulate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

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

// What has ended, and why.
struct Ending {
    const Step* step = nullptr;
    const Condition* condition = nullptr;
};

// A direction of what is recorded.
Record change_of(const RecordSlopes& slopes, Eigen::Index k) {
    Record out;
    out.strain = slopes.strain.col(k);
    out.stress = slopes.stress.col(k);
    out.state.resize(static_cast<std::size_t>(slopes.state.rows()));
    for (Eigen::Index i = 0; i < slopes.state.rows(); ++i)
        out.state[static_cast<std::size_t>(i)] = slopes.state(i, k);
    out.void_ratio = slopes.void_ratio[k];
    out.pore_pressure = slopes.pore_pressure[k];
    out.effective_stress = slopes.effective_stress.col(k);
    out.total_stress = slopes.total_stress.col(k);
    return out;
}

// A run in progress; every function that returns bool returns false where the run is over.
class Runner {
  public:
    Runner(const Law& l, Sample& s, const Settings& set, const Listeners& who)
        : law(l), sample(s), settings(set), listeners(who), recorder(l, set, who) {}

    History run(const Program& program) {
        progress.steps = count_steps(program);
        progress.increments = count_increments(program);
        if (settings.record_start) recorder.record(sample, place);
        run_steps(program);
        return recorder.take();
    }

  private:
    bool run_steps(const Program& program) {
        for (const Step& step : program) {
            open.push_back(&step);
            const bool go_on = run_step(step);
            open.pop_back();
            if (!go_on) return false;
            if (ended == &step) ended = nullptr;
            if (ended) return true;
        }
        return true;
    }

    bool run_step(const Step& step) {
        if (const auto* repetition = std::get_if<Repetition>(&step.kind)) {
            for (int i = 0; i < repetition->times && !ended; ++i)
                if (!run_steps(repetition->steps)) return false;
            return true;
        }
        ++place.step;
        return std::holds_alternative<Perturbations>(step.kind) ? probe(step) : follow(step);
    }

    bool follow(const Step& step) {
        StageContext context{law, settings, place.step, 1};
        const auto stage = begin_stage(step, sample, context);
        const std::vector<double> knots = knots_of(step);
        const int last = static_cast<int>(knots.size()) - 1;
        const bool exactly = std::any_of(open.begin(), open.end(),
                                         [](const Step* each) { return each->exit.exactly; });
        for (int i = 1; i <= last; ++i) {
            const double from = knots[static_cast<std::size_t>(i) - 1];
            const double to = knots[static_cast<std::size_t>(i)];
            context.increment = place.increment = i;
            const Sample before = exactly ? sample : Sample{};
            KeptPart part;
            Advance work = advance(*stage, sample, from, to, settings.smallest_part,
                                   exactly && sample.slopes.wanted() ? &part : nullptr);
            if (!work.done) return fail(step, work, last);
            const Ending ending = ending_now();
            if (ending.step && ending.step->exit.exactly)
                locate(*stage, *ending.condition, before, from, to, part, work);
            accept(work);
            const bool go_on = report();
            const bool due = i % step.every == (step.record_first ? 1 % step.every : 0) ||
                             (i == last && step.record_end);
            if (due || ending.step || !go_on) record();
            if (ending.step) recorder.exit(place, *ending.condition);
            if (!go_on) return stop(step, last);
            ended = ending.step;
            if (ended) return true;
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
            if (!work.done) return fail(step, work, step.increments);
            accept(work);
            record();
            if (!report()) return stop(step, step.increments);
            const double time = sample.time;
            sample = origin;
            sample.time = time;
        }
        return true;
    }

    // Of the steps that are open, the outermost that a condition ends.
    Ending ending_now() const {
        std::optional<Record> now;
        for (const Step* step : open)
            for (const Condition& condition : step->exit.any_of) {
                if (!now) now = recorder.snapshot(sample, place);
                if (holds(condition, *now)) return {step, &condition};
            }
        return {};
    }

    bool holds_now(const Condition& condition) const {
        return holds(condition, recorder.snapshot(sample, place));
    }

    // The increment from `before` has been taken as a whole and the condition holds at its end. Leaves
    // the sample where it begins to hold.
    void locate(Stage& stage, const Condition& exit, const Sample& before, double from, double to,
                KeptPart& part_beyond, Advance& work) {
        Sample beyond = sample;
        sample = before;
        const bool held = holds_now(exit);  // before: nothing to find
        double low = from, high = held ? from : to;
        while (high - low > 1e-9 * (to - from)) {
            const double middle = 0.5 * (low + high);
            sample = before;
            KeptPart last;
            const Advance part = advance(stage, sample, from, middle, settings.smallest_part,
                                         sample.slopes.wanted() ? &last : nullptr);
            work.iterations += part.iterations;
            work.evaluations += part.evaluations;
            if (!part.done) break;
            const bool reached = holds_now(exit);
            (reached ? high : low) = middle;
            if (reached) {
                beyond = sample;
                part_beyond = std::move(last);
            }
        }
        sample = beyond;
        if (sample.slopes.wanted() && !held) follow_end(stage, exit, part_beyond);
    }

    // The share x of the step at which a condition g just holds depends on the directions: dg/dx dx = -dg.
    void follow_end(Stage& stage, const Condition& exit, const KeptPart& part) {
        const auto by_share = stage.slopes_by_share(part);
        if (!by_share)
            throw BadCase("the restrictions do not determine the derivatives (singular)");
        const Record now = recorder.snapshot(sample, place);
        Sample along = sample;
        along.slopes = *by_share;
        Record rate = change_of(recorder.snapshot(along, place).slopes, 0);
        rate.time = (sample.time - part.start.time) / (part.to - part.from);
        const double slope = change(exit, now, rate);
        Slopes& s = sample.slopes;
        Eigen::RowVectorXd share(s.strain.cols());
        for (Eigen::Index k = 0; k < share.size(); ++k)
            share[k] = -change(exit, now, change_of(now.slopes, k)) / slope;
        if (!share.allFinite())
            throw BadCase(
                text("%s does not change where it begins to hold: where the step ends has "
                     "no derivative",
                     exit.text.c_str()));
        s.strain += by_share->strain * share;
        s.point.stress += by_share->point.stress * share;
        s.point.state += by_share->point.state * share;
        s.pore_pressure += by_share->pore_pressure * share;
    }

    void accept(const Advance& work) {
        recorder.add(work);
        accepted = place;
        recorded = false;
    }

    void record() {
        recorder.record(sample, accepted);
        recorded = true;
    }

    bool report() {
        ++progress.increment;
        progress.step = place.step;
        if (!listeners.increment) return true;
        const Record now = recorder.snapshot(sample, place);
        progress.record = &now;
        const bool go_on = listeners.increment(progress);
        progress.record = nullptr;
        return go_on;
    }

    // What has been reached is recorded, be it within an increment.
    bool fail(const Step& step, const Advance& work, int increments) {
        if (work.moved) accept(work);
        if (!recorded) record();
        recorder.fail(step, sample, place, increments, work.message);
        return false;
    }

    bool stop(const Step& step, int increments) {
        recorder.fail(step, sample, place, increments, "stopped on request");
        return false;
    }

    const Law& law;
    Sample& sample;
    const Settings& settings;
    const Listeners& listeners;
    Recorder recorder;
    Progress progress;
    Place place, accepted;          // accepted: of the state that the sample has now
    bool recorded = true;           // that state
    std::vector<const Step*> open;  // outermost first
    const Step* ended = nullptr;    // by a condition: what is left of it is left out
};

// A deformation gradient that a condition ends exactly, its own or that of a repetition around it.
bool ends_gradient_exactly(const Program& program, bool around = false) {
    return std::any_of(program.begin(), program.end(), [&](const Step& step) {
        const bool exactly = around || step.exit.exactly;
        const auto* repetition = std::get_if<Repetition>(&step.kind);
        return (exactly && std::holds_alternative<DeformationGradient>(step.kind)) ||
               (repetition && ends_gradient_exactly(repetition->steps, exactly));
    });
}

void check_slopes(const Sample& sample, const Program& program) {
    const Slopes& s = sample.slopes;
    if (!s.wanted()) return;
    const auto count = static_cast<Eigen::Index>(s.by.size());
    const auto states = static_cast<Eigen::Index>(sample.point.state.size());
    if (s.point.stress.cols() != count || s.strain.cols() != count ||
        s.pore_pressure.cols() != count || s.point.state.cols() != count ||
        s.point.state.rows() != states)
        throw BadCase(text("the derivatives at the start must have %d columns, and %d rows of "
                           "state variables",
                           static_cast<int>(count), static_cast<int>(states)));
    if (ends_gradient_exactly(program))
        throw BadCase("an exit that ends a deformation gradient exactly where it holds depends on "
                      "the parameters: it cannot be differentiated");
}

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

long count_steps(const Program& program) {
    long n = 0;
    for (const Step& step : program) {
        const auto* repetition = std::get_if<Repetition>(&step.kind);
        n += repetition ? repetition->times * count_steps(repetition->steps) : 1;
    }
    return n;
}

History simulate(const Law& law, Sample& sample, const Program& program, const Settings& settings,
                 const Listeners& listeners) {
    check_settings(settings);
    check_program(program);
    if (sample.point.state.size() != law.state_names().size())
        throw BadCase(text("the sample has %d state variables, the law has %d",
                           static_cast<int>(sample.point.state.size()),
                           static_cast<int>(law.state_names().size())));
    check_slopes(sample, program);
    return Runner(law, sample, settings, listeners).run(program);
}

}  // namespace element
