// SPDX-License-Identifier: BSD-3-Clause
#include "element/stage.hpp"

#include <algorithm>

#include "element/differentiate.hpp"
#include "element/errors.hpp"
#include "element/gradient.hpp"
#include "element/path.hpp"

namespace element {
namespace {

StrainIncrement increment_of(const Step& step, const Sample& now, const StageContext& context,
                             double from, double to, double time_from, double time_to) {
    StrainIncrement out;
    out.total_strain = now.strain;
    out.step_time = time_from;
    out.total_time = now.time;
    out.duration = time_to - time_from;
    out.temperature = now.temperature;
    out.temperature_change = (to - from) * step.temperature_change;
    out.step = static_cast<int>(context.step);
    out.number = context.increment;
    return out;
}

Sample after(const Sample& now, const StrainIncrement& increment, const Solution& solution) {
    Sample end;
    end.point = solution.end;
    end.strain = increment.total_strain + solution.strain_increment;
    end.pore_pressure = solution.pore_pressure;
    end.time = now.time + increment.duration;
    end.temperature = now.temperature + increment.temperature_change;
    return end;
}

// Of the rows of a sample as it is.
Matrix6X slopes_of(const Restrictions& rows, const Slopes& slopes) {
    if (!slopes.wanted()) return {};
    Matrix6X total = slopes.point.stress;
    total.topRows<3>().rowwise() -= slopes.pore_pressure;
    return rows.stress * total + rows.strain * slopes.strain;
}

class ControlledStage : public Stage {
  public:
    ControlledStage(const Step& s, const Sample& start, const StageContext& c)
        : step(s), context(c), path(path_of(s, start)),
          origin(path.rows.stress * (start.point.stress - start.pore_pressure * unit_tensor()) +
                 path.rows.strain * start.strain),
          first_pore_pressure(start.pore_pressure),
          origin_slopes(slopes_of(path.rows, start.slopes)),
          first_pore_pressure_slopes(start.slopes.pore_pressure) {}

    Attempt attempt(const Sample& now, double from, double to) override {
        const Task task = task_between(now, from, to);
        Attempt out;
        out.solution = solve(context.law, task);
        out.end = after(now, task.increment, out.solution);
        return out;
    }

    std::optional<Slopes> slopes_after(const Sample& now, const Attempt& attempt, double from,
                                       double to) override {
        TaskSlopes given{now.slopes, origin_slopes, now.slopes.pore_pressure};
        // Rows that are absolute go to values that do not depend on where they start.
        if (const auto* linear = std::get_if<Linear>(&step.kind))
            for (int r = 0; r < 6; ++r)
                if (linear->absolute[static_cast<std::size_t>(r)]) given.goal.row(r) *= 1.0 - to;
        if (step.drains) given.pore_pressure = (1.0 - to) * first_pore_pressure_slopes;
        return differentiate(context.law, task_between(now, from, to), attempt.solution, given);
    }

    std::optional<Slopes> slopes_by_share(const KeptPart& part) override {
        const Sample& now = part.start;
        Slopes none;  // what it starts from does not depend on how far it goes
        none.by = {by_void_ratio};
        none.point.stress = none.strain = Matrix6X::Zero(6, 1);
        none.point.state = MatrixX::Zero(static_cast<Eigen::Index>(now.point.state.size()), 1);
        none.pore_pressure = Eigen::RowVectorXd::Zero(1);
        TaskSlopes given{none, path.rate(part.to), none.pore_pressure};
        if (step.drains) given.pore_pressure[0] = -first_pore_pressure;
        return differentiate(context.law, task_between(now, part.from, part.to),
                             part.attempt.solution, given);
    }

    void keep(const Attempt& attempt, double from, double to) override {
        if (path.straight) slope = attempt.solution.strain_increment / (to - from);
        else tangent = attempt.solution.tangent;
    }

    void forget() override {
        slope.reset();
        tangent.reset();
    }

  private:
    Task task_between(const Sample& now, double from, double to) const {
        Task task;
        task.point = now.point;
        task.strain = now.strain;
        task.pore_pressure = step.drains ? (1.0 - to) * first_pore_pressure : now.pore_pressure;
        task.increment = increment_of(step, now, context, from, to, path.time(from), path.time(to));
        task.rows = path.rows;
        task.goal = origin + path.change(to);
        task.undrained = step.undrained;
        task.tolerance = context.settings.tolerance;
        task.iteration_limit =
            step.iteration_limit > 0 ? step.iteration_limit : context.settings.iteration_limit;
        task.guess = guess(task, to - from);
        return task;
    }

    // On a straight path the strain goes on as it went; otherwise the stress answers as it did.
    Vector6 guess(const Task& task, double share) const {
        if (slope) return share * *slope;
        if (tangent)
            if (const auto linear = linear_guess(task, *tangent)) return *linear;
        return strain_only_guess(task);
    }

    const Step& step;
    const StageContext& context;
    Path path;
    Vector6 origin;  // of the rows, at the start of the step
    double first_pore_pressure;
    Matrix6X origin_slopes;
    Eigen::RowVectorXd first_pore_pressure_slopes;
    std::optional<Vector6> slope;
    std::optional<Matrix6> tangent;
};

class GradientStage : public Stage {
  public:
    GradientStage(const Step& s, const StageContext& c)
        : step(s), context(c), gradient(std::get<DeformationGradient>(s.kind)) {}

    Attempt attempt(const Sample& now, double from, double to) override {
        const StrainIncrement increment = increment_between(now, from, to);
        Response response = context.law.advance(now.point, increment);
        Attempt out;
        out.solution.outcome = response.outcome;
        out.solution.message = response.message;
        out.solution.reduction = response.reduction;
        out.solution.end = std::move(response.end);
        out.solution.strain_increment = increment.strain;
        out.solution.evaluations = response.evaluations;
        out.solution.pore_pressure = now.pore_pressure;
        out.end = after(now, increment, out.solution);
        return out;
    }

    // The strain increment depends on nothing.
    std::optional<Slopes> slopes_after(const Sample& now, const Attempt&, double from,
                                       double to) override {
        const StrainIncrement increment = increment_between(now, from, to);
        Slopes end = now.slopes;
        const Eigen::Index count = end.strain.cols();
        const Response response = context.law.differentiate(now.point, increment, end.by,
                                                            Matrix6X::Zero(6, count), end.point);
        if (response.outcome != Outcome::done) throw BadCase(response.message);
        const Matrix3& Q = increment.rotation;
        for (Eigen::Index k = 0; k < count; ++k)
            end.strain.col(k) =
                strain_components(Q * strain_tensor(now.slopes.strain.col(k)) * Q.transpose());
        return end;
    }

    std::optional<Slopes> slopes_by_share(const KeptPart&) override {
        throw BadCase("derivatives by the share of a deformation gradient are not known");
    }

    void keep(const Attempt&, double, double) override {}
    void forget() override {}

  private:
    StrainIncrement increment_between(const Sample& now, double from, double to) const {
        StrainIncrement increment =
            increment_of(step, now, context, from, to, from * step.duration, to * step.duration);
        increment.gradient_before = gradient_at(gradient, from);
        increment.gradient_after = gradient_at(gradient, to);
        const Motion motion = motion_between(increment.gradient_before, increment.gradient_after,
                                             gradient.increments);
        const Matrix3& Q = motion.rotation;
        increment.strain = motion.strain;
        increment.rotation = Q;
        increment.total_strain = strain_components(Q * strain_tensor(now.strain) * Q.transpose());
        return increment;
    }

    const Step& step;
    const StageContext& context;
    const DeformationGradient& gradient;
};

}  // namespace

std::unique_ptr<Stage> begin_stage(const Step& step, const Sample& sample,
                                   const StageContext& context) {
    if (std::holds_alternative<DeformationGradient>(step.kind))
        return std::make_unique<GradientStage>(step, context);
    return std::make_unique<ControlledStage>(step, sample, context);
}

Advance advance(Stage& stage, Sample& sample, double from, double to, double smallest_part,
                KeptPart* last) {
    Advance out;
    const double whole = to - from;
    double part = whole;
    while (from < to) {
        const double next = from + part >= to - 1e-9 * part ? to : from + part;
        Attempt attempt = stage.attempt(sample, from, next);
        const Solution& solution = attempt.solution;
        out.iterations += solution.iterations;
        out.evaluations += solution.evaluations;
        if (solution.outcome == Outcome::done) {
            if (sample.slopes.wanted()) {
                auto slopes = stage.slopes_after(sample, attempt, from, next);
                if (!slopes) {
                    out.done = false;
                    out.message = "the restrictions do not determine the derivatives (singular)";
                    return out;
                }
                attempt.end.slopes = std::move(*slopes);
            }
            stage.keep(attempt, from, next);
            if (last) *last = {sample, attempt, from, next};
            out.residuals = solution.residuals;
            sample = std::move(attempt.end);
            out.moved = true;
            from = next;
            part *= 2.0;
            continue;
        }
        stage.forget();
        part = std::clamp(solution.reduction, 0.1, 0.5) * (next - from);
        ++out.cut_backs;
        if (solution.outcome == Outcome::hopeless || part < smallest_part * whole) {
            out.done = false;
            out.message = solution.message;
            return out;
        }
    }
    return out;
}

}  // namespace element
