// SPDX-License-Identifier: BSD-3-Clause
#include "element/increment.hpp"

#include <vector>

#include "element/text.hpp"

namespace element {
namespace {

constexpr int iteration_limit = 12;  // quadratic from a good guess: 2 to 4 are usual

std::vector<int> stress_controlled(const std::array<Control, 6>& control) {
    std::vector<int> components;
    for (int i = 0; i < 6; ++i)
        if (control[static_cast<std::size_t>(i)] == Control::stress) components.push_back(i);
    return components;
}

}  // namespace

Increment solve_increment(const Material& material, const Goal& goal, Point& point) {
    const std::vector<int> free = stress_controlled(goal.control);
    Increment out;
    out.strain_increment = goal.strain_increment;
    for (;;) {
        Point trial = point;
        Matrix6 tangent = Matrix6::Zero();
        const UpdateResult update = material.update(out.strain_increment, trial, tangent);
        out.evaluations += update.evaluations;
        if (update.status != GRIT_OK) {
            // A wild iterate may leave the domain too: only the first one condemns the state.
            out.retry_smaller = update.status == GRIT_NOT_CONVERGED || out.iterations > 0;
            out.reason = update.message;
            return out;
        }
        const Eigen::VectorXd residual = (goal.stress - trial.stress)(free);
        const double limit = goal.tolerance * goal.stress.norm();
        if (residual.norm() <= limit) {
            out.converged = true;
            point = trial;
            return out;
        }
        const Eigen::FullPivLU<Eigen::MatrixXd> system(tangent(free, free));
        if (out.iterations == iteration_limit || !system.isInvertible()) {
            out.retry_smaller = true;
            out.reason =
                text("residual of the prescribed stress must be <= %.3g kPa, is %.3g kPa%s", limit,
                     residual.norm(),
                     update.stress_free      ? ": the point has separated"
                     : system.isInvertible() ? ""
                                             : ": the tangent is singular");
            return out;
        }
        out.strain_increment(free) += system.solve(residual);
        ++out.iterations;
    }
}

}  // namespace element
