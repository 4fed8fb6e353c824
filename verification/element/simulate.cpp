// SPDX-License-Identifier: BSD-3-Clause
#include "element/simulate.hpp"

#include <cmath>
#include <numbers>

#include "element/check.hpp"
#include "element/errors.hpp"
#include "element/path.hpp"
#include "element/stage.hpp"
#include "element/text.hpp"

namespace element {
namespace {

// A run in progress; every function that returns bool returns false where the run is over.
class Runner {
  public:
    Runner(const Law& l, Sample& s, const Settings& set, const RunObserver& o)
        : law(l), sample(s), settings(set), observer(o) {
        history.state_names = law.state_names();
    }

    History run(const Program& program) {
        progress.steps = count_steps(program);
        progress.increments = count_increments(program);
        if (settings.record_start) record(Advance{}, 0.0);
        run_steps(program);
        return std::move(history);
    }

  private:
    bool run_steps(const Program& program) {
        for (const Step& step : program) {
            if (const auto* repetition = std::get_if<Repetition>(&step.kind)) {
                for (int i = 0; i < repetition->times; ++i)
                    if (!run_steps(repetition->steps)) return false;
                continue;
            }
            ++progress.step;
            increment = 0;
            const bool go_on =
                std::holds_alternative<Perturbations>(step.kind) ? probe(step) : follow(step);
            if (!go_on) return false;
        }
        return true;
    }

    bool follow(const Step& step) {
        StageContext context{law, settings, progress.step, 1};
        const auto stage = begin_stage(step, sample, context);
        const std::vector<double> knots = knots_of(step);
        const auto last = knots.size() - 1;
        for (std::size_t i = 1; i <= last; ++i) {
            context.increment = increment = static_cast<int>(i);
            const Sample before = step.exit.exactly ? sample : Sample{};
            Advance done = advance(*stage, sample, knots[i - 1], knots[i], settings.smallest_part);
            if (!done.done) return fail(step, done.message, static_cast<int>(last));
            double share = knots[i];
            const Condition* exit = first_exit(step);
            if (exit && step.exit.exactly)
                share = locate(step, *stage, *exit, before, knots[i - 1], knots[i], done);
            add(done);
            if (exit || i % static_cast<std::size_t>(step.every) == 0 ||
                (i == last && step.record_end))
                record(take(), stage->time(share));
            if (!report()) return stop(step, static_cast<int>(last));
            if (!exit) continue;
            history.exits.push_back(
                text("step %d, increment %d: %s", progress.step, increment, exit->text.c_str()));
            return true;
        }
        return true;
    }

    // Every increment from the same state.
    bool probe(const Step& step) {
        const auto& probes = std::get<Perturbations>(step.kind);
        const Sample origin = sample;
        const double part = step.duration / step.increments;
        for (int i = 1; i <= step.increments; ++i) {
            increment = i;
            const double angle = 2.0 * std::numbers::pi * (i - 1) / step.increments;
            Step single = step;
            single.kind = Linear{
                probes.rows, std::cos(angle) * probes.first + std::sin(angle) * probes.second, {}};
            single.increments = 1;
            single.shares.clear();
            single.first_share = 0.0;
            single.duration = part;
            const StageContext context{law, settings, progress.step, i};
            const auto stage = begin_stage(single, sample, context);
            const double time = sample.time;
            const Advance done = advance(*stage, sample, 0.0, 1.0, settings.smallest_part);
            if (!done.done) return fail(step, done.message, step.increments);
            record(done, i * part);
            if (!report()) return stop(step, step.increments);
            sample = origin;
            sample.time = time + part;
        }
        return true;
    }

    const Condition* first_exit(const Step& step) {
        if (step.exit.any_of.empty()) return nullptr;
        const Record now = snapshot();
        for (const Condition& condition : step.exit.any_of)
            if (holds(condition, now, history.state_names)) return &condition;
        return nullptr;
    }

    // Leaves the sample where the condition begins to hold, and returns that share. The increment has
    // been taken as a whole and the condition holds at its end.
    double locate(const Step& step, Stage& stage, const Condition& exit, const Sample& before,
                  double from, double to, Advance& work) {
        Sample end = sample;
        sample = before;
        if (first_exit(step)) return sample = end, to;  // held from the start
        double low = from, high = to;
        while (high - low > 1e-9 * (to - from)) {
            const double middle = 0.5 * (low + high);
            sample = before;
            stage.forget();
            const Advance part = advance(stage, sample, from, middle, settings.smallest_part);
            work.iterations += part.iterations;
            work.evaluations += part.evaluations;
            if (!part.done) break;
            const bool beyond = holds(exit, snapshot(), history.state_names);
            (beyond ? high : low) = middle;
            if (beyond) end = sample;
        }
        sample = end;
        return high;
    }

    Record snapshot() const {
        Record out;
        out.step = progress.step;
        out.increment = increment;
        out.time = sample.time;
        out.strain = sample.strain;
        out.stress = sample.point.stress;
        out.state = sample.point.state;
        const Observation seen = law.observe(sample.point);
        const double carried = std::isnan(seen.pore_pressure) ? 0.0 : seen.pore_pressure;
        out.void_ratio = seen.void_ratio;
        out.pore_pressure = carried + sample.pore_pressure;
        out.effective_stress = out.stress + carried * unit_tensor();
        out.total_stress = out.stress - sample.pore_pressure * unit_tensor();
        return out;
    }

    void record(const Advance& work, double step_time) {
        Record out = snapshot();
        out.step_time = step_time;
        out.iterations = work.iterations;
        out.evaluations = work.evaluations;
        out.cut_backs = work.cut_backs;
        if (settings.keep_residuals) out.residuals = work.residuals;
        history.records.push_back(std::move(out));
    }

    void add(const Advance& work) {
        unrecorded.iterations += work.iterations;
        unrecorded.evaluations += work.evaluations;
        unrecorded.cut_backs += work.cut_backs;
        unrecorded.residuals = work.residuals;
    }

    Advance take() {
        Advance out = std::move(unrecorded);
        unrecorded = Advance{};
        return out;
    }

    bool report() {
        ++progress.increment;
        if (!observer) return true;
        const Record now = snapshot();
        progress.record = &now;
        const bool go_on = observer(progress);
        progress.record = nullptr;
        return go_on;
    }

    bool fail(const Step& step, const std::string& why, int increments) {
        const std::string name = step.name.empty() ? "" : " (" + step.name + ")";
        const Vector6& e = sample.strain;
        history.failure = Failure{
            progress.step, increment,
            text("step %d%s, increment %d of %d, at strain %.6g %.6g %.6g %.6g %.6g %.6g: %s",
                 progress.step, name.c_str(), increment, increments, e[0], e[1], e[2], e[3], e[4],
                 e[5], why.c_str())};
        return false;
    }

    bool stop(const Step& step, int increments) {
        return fail(step, "stopped on request", increments);
    }

    const Law& law;
    Sample& sample;
    const Settings& settings;
    const RunObserver& observer;
    History history;
    Progress progress;
    Advance unrecorded;  // work since the last record
    int increment = 0;
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
