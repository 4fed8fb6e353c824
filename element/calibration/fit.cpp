// SPDX-License-Identifier: BSD-3-Clause
#include "element/calibration/fit.hpp"

#include <algorithm>
#include <cmath>

#include <ceres/ceres.h>
#include <glog/logging.h>

#include "element/errors.hpp"

namespace calibration {
namespace {

// The tests are computed once for each point that the solver looks at, not once for each residual.
class Computed : public ceres::EvaluationCallback {
  public:
    Computed(const Problem& of, Vector& at) : problem(of), x(at) {}

    void PrepareForEvaluation(bool with_slopes, bool new_point) override {
        if (!new_point && (now ? now->slopes.rows() > 0 || !with_slopes : !failure.empty())) return;
        failure.clear();
        now = problem.residuals(x, with_slopes, &failure);
    }

    const Problem& problem;
    Vector& x;
    std::optional<Residuals> now;
    std::string failure;
};

// One residual of them.
class Row : public ceres::CostFunction {
  public:
    Row(const Computed& source, Eigen::Index number) : computed(source), row(number) {
        set_num_residuals(1);
        mutable_parameter_block_sizes()->push_back(
            static_cast<int>(computed.problem.space().size()));
    }

    bool Evaluate(const double* const*, double* residual, double** slopes) const override {
        if (!computed.now) return false;
        residual[0] = computed.now->values[row];
        if (slopes && slopes[0])
            Eigen::Map<Eigen::RowVectorXd>(slopes[0], computed.now->slopes.cols()) =
                computed.now->slopes.row(row);
        return true;
    }

  private:
    const Computed& computed;
    Eigen::Index row;
};

// Ends a descent when it is asked to.
class Watch : public ceres::IterationCallback {
  public:
    explicit Watch(const std::function<bool()>& goes_on) : asked(goes_on) {}
    ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
        return asked() ? ceres::SOLVER_CONTINUE : ceres::SOLVER_ABORT;
    }

  private:
    const std::function<bool()>& asked;
};

// As Triggs et al. 2000 weigh a residual and its slopes for Gauss-Newton, without the term of second order.
void weigh(Residuals& residuals, const Loss& loss) {
    if (!loss.function()) return;
    for (Eigen::Index i = 0; i < residuals.values.size(); ++i) {
        double rho[3];
        loss.function()->Evaluate(residuals.values[i] * residuals.values[i], rho);
        const double factor = std::sqrt(rho[1]);
        residuals.values[i] *= factor;
        residuals.slopes.row(i) *= factor;
    }
}

Descent descend(const Problem& problem, const Vector& start, const FitOptions& options,
                const std::function<bool()>& goes_on) {
    Descent out;
    out.start = start;
    Vector x = start;
    Computed computed(problem, x);
    ceres::Problem::Options setting;
    setting.evaluation_callback = &computed;
    setting.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ceres::Problem ceres_problem(setting);
    for (Eigen::Index i = 0; i < problem.rows(); ++i)
        ceres_problem.AddResidualBlock(new Row(computed, i),
                                       const_cast<ceres::LossFunction*>(options.loss.function()),
                                       x.data());
    const Vector low = problem.space().lowest(), high = problem.space().highest();
    for (int k = 0; k < static_cast<int>(x.size()); ++k) {
        ceres_problem.SetParameterLowerBound(x.data(), k, low[k]);
        ceres_problem.SetParameterUpperBound(x.data(), k, high[k]);
    }
    ceres::Solver::Options solver;
    solver.linear_solver_type = ceres::DENSE_QR;
    solver.max_num_iterations = options.iteration_limit;
    solver.max_num_consecutive_invalid_steps = 20;
    solver.function_tolerance = 1e-9;
    solver.parameter_tolerance = 1e-9;
    solver.gradient_tolerance = 1e-16;
    solver.logging_type = ceres::SILENT;
    solver.update_state_every_iteration = true;
    Watch watch(goes_on);
    solver.callbacks.push_back(&watch);
    FLAGS_minloglevel = google::GLOG_FATAL;  // what goes wrong is in the summary
    ceres::Solver::Summary summary;
    ceres::Solve(solver, &ceres_problem, &summary);
    out.end = x;
    out.sum = 2.0 * summary.final_cost;
    out.iterations = static_cast<int>(summary.iterations.size());
    out.converged = summary.termination_type == ceres::CONVERGENCE;
    out.message = summary.message;
    if (!summary.IsSolutionUsable() && summary.termination_type != ceres::USER_FAILURE) {
        out.sum = INFINITY;
        if (!computed.failure.empty()) out.message = computed.failure;
    }
    return out;
}

double radical_inverse(int i, int base) {
    double out = 0.0, digit = 1.0 / base;
    for (; i > 0; i /= base, digit /= base) out += digit * (i % base);
    return out;
}

}  // namespace

Vector start_around(const ParameterSpace& space, const Vector& x, double spread, int i) {
    static constexpr int primes[] = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43};
    Vector out = x;
    for (Eigen::Index k = 0; k < x.size(); ++k) {
        const FreeParameter& each = space.free[static_cast<std::size_t>(k)];
        const double share = 2.0 * radical_inverse(i, primes[k]) - 1.0;
        const double value = each.value(x[k]) * (1.0 + spread * share);
        out[k] = each.coordinate(std::clamp(value, each.lowest, each.highest));
    }
    return out;
}

Fit fit(Problem& problem, const Vector& start, const FitOptions& options) {
    Fit out;
    bool going = true;
    const auto goes_on = [&] {
        const auto ended = static_cast<int>(out.descents.size());
        return going = !options.progress || options.progress(ended);
    };
    out.sum = INFINITY;
    // Where a start cannot be computed, one nearer to the first takes its place.
    for (int i = 0; i < options.starts && going; ++i) {
        double spread = options.spread;
        Vector from = i == 0 ? start : start_around(problem.space(), start, spread, i);
        for (int nearer = 0; i > 0 && nearer < 6 && !problem.residuals(from, true); ++nearer)
            from = start_around(problem.space(), start, spread *= 0.5, i);
        out.descents.push_back(descend(problem, from, options, goes_on));
        if (!(out.descents.back().sum < out.sum)) continue;
        out.sum = out.descents.back().sum;
        out.best = out.descents.size() - 1;
    }
    if (!std::isfinite(out.sum))
        throw element::BadCase("no start can be computed: " + out.descents.front().message);
    out.stopped = !going;
    const double near = out.sum * (1.0 + 1e-6) + 1e-12;
    for (const Descent& each : out.descents) out.agreeing += each.sum <= near ? 1 : 0;
    out.x = out.descents[out.best].end;
    const auto at_end = problem.residuals(out.x, true);
    if (!at_end) throw element::BadCase("the best parameters cannot be computed again");
    out.residuals = *at_end;
    weigh(out.residuals, options.loss);
    return out;
}

}  // namespace calibration
