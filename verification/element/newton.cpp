// SPDX-License-Identifier: BSD-3-Clause
#include "element/newton.hpp"

#include <algorithm>
#include <cmath>

#include "element/text.hpp"

namespace element {
namespace {

using System = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, 7, 7>;
using Values = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 7, 1>;

// Unknowns: six strains, and pore pressure in units of `stiffness` if undrained. Equations: six rows
// and, if undrained, constant volume. Each is divided by its size at the present level of stress.
class Equations {
  public:
    Equations(const Task& t, const MaterialPoint& at, const Matrix6& C)
        : task(t), tangent(C), n(t.undrained ? 7 : 6) {
        level = std::max(at.stress.norm(), t.point.stress.norm());
        stiffness = C.cwiseAbs().maxCoeff();
        if (!(stiffness > 0.0)) stiffness = 1.0;
        if (!(level > 0.0)) level = stiffness;
    }

    Values residual(const Vector6& stress, const Vector6& strain_increment, double p_w) const {
        Values r(n);
        r.head<6>() = task.rows.stress * (stress - p_w * unit_tensor()) +
                      task.rows.strain * (task.strain + strain_increment) - task.goal;
        if (task.undrained) r[6] = strain_increment.head<3>().sum();
        return r.cwiseQuotient(sizes());
    }

    // Correction of strain and pore pressure; nothing if the rows do not determine it.
    std::optional<Values> correction(const Values& residual) const {
        System J = System::Zero(n, n);
        J.topLeftCorner<6, 6>() = task.rows.stress * tangent + task.rows.strain;
        if (task.undrained) {
            J.topRightCorner<6, 1>() = -stiffness * (task.rows.stress * unit_tensor());
            J.bottomLeftCorner<1, 3>().setOnes();
        }
        const System scaled = sizes().cwiseInverse().asDiagonal() * J;
        const Eigen::FullPivLU<System> factors(scaled);
        if (!factors.isInvertible()) return std::nullopt;
        Values x = factors.solve(-residual);
        if (task.undrained) x[6] *= stiffness;
        return x;
    }

    double stress_level() const { return level; }

  private:
    Values sizes() const {
        Values s(n);
        s.head<6>() = level * (task.rows.stress.rowwise().norm() +
                               task.rows.strain.rowwise().norm() / stiffness);
        if (task.undrained) s[6] = level / stiffness;
        return s;
    }

    const Task& task;
    const Matrix6& tangent;
    int n;
    double level, stiffness;
};

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
    Values last;  // correction
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
                out.strain_increment -= last.head<6>();
                if (task.undrained) out.pore_pressure -= last[6];
                continue;
            }
            out.outcome = out.iterations > 0 ? Outcome::retry_smaller : response.outcome;
            out.reduction = response.reduction;
            out.message = response.message;
            return out;
        }
        const Equations equations(task, response.end, response.tangent);
        const Values residual =
            equations.residual(response.end.stress, out.strain_increment, out.pore_pressure);
        out.residuals.push_back(residual.norm());
        if (residual.norm() <= task.tolerance) {
            out.end = std::move(response.end);
            out.tangent = response.tangent;
            return out;
        }
        const std::optional<Values> correction = equations.correction(residual);
        if (!correction || out.iterations == task.iteration_limit) {
            out.outcome = Outcome::retry_smaller;
            out.reduction = 0.5;
            out.message =
                correction ? text("residual of the restrictions must be <= %.3g of the stress norm "
                                  "(%.4g), is %.3g after %d iterations",
                                  task.tolerance, equations.stress_level(), residual.norm(),
                                  out.iterations)
                           : undetermined(response.stress_free);
            return out;
        }
        last = *correction;
        damped = 0;
        out.strain_increment += last.head<6>();
        if (task.undrained) out.pore_pressure += last[6];
        ++out.iterations;
    }
}

std::optional<Vector6> linear_guess(const Task& task, const Matrix6& tangent) {
    const Equations equations(task, task.point, tangent);
    const auto x = equations.correction(
        equations.residual(task.point.stress, Vector6::Zero(), task.pore_pressure));
    if (!x) return std::nullopt;
    return Vector6(x->head<6>());
}

Vector6 strain_only_guess(const Task& task) {
    Vector6 missing = task.goal - task.rows.strain * task.strain;
    for (int r = 0; r < 6; ++r)
        if (!task.rows.stress.row(r).isZero(0.0)) missing[r] = 0.0;
    Matrix6 rows = task.rows.strain;
    for (int r = 0; r < 6; ++r)
        if (!task.rows.stress.row(r).isZero(0.0)) rows.row(r).setZero();
    return rows.completeOrthogonalDecomposition().solve(missing);
}

}  // namespace element
