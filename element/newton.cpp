// SPDX-License-Identifier: BSD-3-Clause
#include "element/newton.hpp"

#include <algorithm>
#include <cmath>

#include "element/text.hpp"

namespace element {
namespace {

using System = Eigen::Matrix<double, 7, 7, Eigen::RowMajor>;
using Values = Eigen::Matrix<double, 7, 1>;

// Unknowns: six strains and the change of pore pressure, in units of `stiffness`. Equations: six rows and constant
// volume if undrained, else constant pore pressure. Each is divided by its size at the present level of stress.
class Equations {
  public:
    Equations(const Task& t, const MaterialPoint& at, const Matrix6& C) : task(t), tangent(C) {
        level = std::max(at.stress.norm(), t.point.stress.norm());
        stiffness = C.cwiseAbs().maxCoeff();
        if (!(stiffness > 0.0)) stiffness = 1.0;
        if (!(level > 0.0)) level = stiffness;
    }

    Values residual(const Vector6& stress, const Vector6& strain_increment, double p_w) const {
        Values r = Values::Zero();
        r.head<6>() = task.rows.stress * (stress - p_w * unit_tensor()) +
                      task.rows.strain * (task.strain + strain_increment) - task.goal;
        if (task.undrained) r[6] = strain_increment.head<3>().sum();
        return r.cwiseQuotient(sizes());
    }

    // Pore pressure with which the rows are met best; it enters them linearly.
    double pore_pressure(const Vector6& stress, const Vector6& strain_increment) const {
        if (!task.undrained) return task.pore_pressure;
        const Values at_zero = residual(stress, strain_increment, 0.0);
        const Vector6 slope =
            (task.rows.stress * unit_tensor()).cwiseQuotient(Vector6(sizes().head<6>()));
        return slope.dot(at_zero.head<6>()) / slope.squaredNorm();
    }

    // Correction of the strain; nothing if the rows do not determine it.
    std::optional<Vector6> correction(const Values& residual) const {
        System J = System::Zero();
        J.topLeftCorner<6, 6>() = task.rows.stress * tangent + task.rows.strain;
        if (task.undrained) {
            J.topRightCorner<6, 1>() = -stiffness * (task.rows.stress * unit_tensor());
            J.bottomLeftCorner<1, 3>().setOnes();
        } else J(6, 6) = 1.0;
        const System scaled = sizes().cwiseInverse().asDiagonal() * J;
        const Eigen::FullPivLU<System> factors(scaled);
        if (!factors.isInvertible()) return std::nullopt;
        const Values x = factors.solve(-residual);
        return Vector6(x.head<6>());
    }

    double stress_level() const { return level; }

  private:
    Values sizes() const {
        Values s;
        s.head<6>() = level * (task.rows.stress.rowwise().norm() +
                               task.rows.strain.rowwise().norm() / stiffness);
        s[6] = level / stiffness;
        return s;
    }

    const Task& task;
    const Matrix6& tangent;
    double level, stiffness;
};

// What it means where stress is prescribed: the number alone helps nobody.
std::string consequence(const Task& task) {
    return task.rows.stress.isZero(0.0)
               ? ""
               : "the prescribed stress cannot be reached (beyond the strength, or tension?): ";
}

const char* undetermined(bool stress_free) {
    return stress_free ? "the point has separated and the restrictions need its stress"
                       : "the restrictions do not determine the strain increment (singular)";
}

}  // namespace

Solution solve(const Law& law, const Task& task) {
    Solution out;
    out.strain_increment = task.guess;
    out.pore_pressure = task.pore_pressure;
    StrainIncrement increment = task.increment;
    Vector6 last = Vector6::Zero();  // correction
    int damped = 0;
    for (;;) {
        increment.strain = out.strain_increment;
        Response response = law.advance(task.point, increment);
        out.evaluations += response.evaluations;
        if (response.outcome != Outcome::done) {
            // A wild iterate may leave the domain: go half the way back before the step is cut.
            if (out.iterations > 0 && damped < 4) {
                ++damped;
                last *= 0.5;
                out.strain_increment -= last;
                continue;
            }
            out.outcome = out.iterations > 0 ? Outcome::retry_smaller : response.outcome;
            out.reduction = response.reduction;
            out.message = (out.iterations > 0 ? consequence(task) : "") + response.message;
            return out;
        }
        const Equations equations(task, response.end, response.tangent);
        out.pore_pressure = equations.pore_pressure(response.end.stress, out.strain_increment);
        const Values residual =
            equations.residual(response.end.stress, out.strain_increment, out.pore_pressure);
        out.residuals.push_back(residual.norm());
        if (residual.norm() <= task.tolerance) {
            out.end = std::move(response.end);
            out.tangent = response.tangent;
            return out;
        }
        const std::optional<Vector6> correction = equations.correction(residual);
        if (!correction || out.iterations == task.iteration_limit) {
            out.outcome = Outcome::retry_smaller;
            out.reduction = 0.5;
            out.message =
                correction
                    ? consequence(task) +
                          text("residual of the restrictions must be <= %.3g of the stress norm "
                               "(%.4g), is %.3g after %d iterations",
                               task.tolerance, equations.stress_level(), residual.norm(),
                               out.iterations)
                    : undetermined(response.stress_free);
            return out;
        }
        last = *correction;
        damped = 0;
        out.strain_increment += last;
        ++out.iterations;
    }
}

std::optional<Vector6> linear_guess(const Task& task, const Matrix6& tangent) {
    const Equations equations(task, task.point, tangent);
    return equations.correction(
        equations.residual(task.point.stress, Vector6::Zero(), task.pore_pressure));
}

}  // namespace element
