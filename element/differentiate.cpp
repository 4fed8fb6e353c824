// SPDX-License-Identifier: BSD-3-Clause
#include "element/differentiate.hpp"

#include <vector>

#include "element/errors.hpp"
#include "element/text.hpp"

namespace element {
namespace {

// What strain alone says of the strain increment: rows without stress, and constant volume.
struct StrainRows {
    Matrix6 rows = Matrix6::Zero();  // of the restrictions, 0 for those with stress
    std::vector<int> others;         // those with stress
    bool undrained;

    explicit StrainRows(const Task& task) : undrained(task.undrained) {
        for (int r = 0; r < 6; ++r) {
            if (task.rows.stress.row(r).isZero(0.0)) rows.row(r) = task.rows.strain.row(r);
            else others.push_back(r);
        }
    }

    MatrixX matrix() const {
        MatrixX all = MatrixX::Zero(7, 6);
        all.topRows<6>() = rows;
        if (undrained) all.row(6) = unit_tensor().transpose();
        return all;
    }
};

}  // namespace

std::optional<Slopes> differentiate(const Law& law, const Task& task, const Solution& solution,
                                    const TaskSlopes& given) {
    const Slopes& start = given.start;
    const auto count = static_cast<Eigen::Index>(start.by.size());
    const StrainRows strain_rows(task);
    const MatrixX by_strain = strain_rows.matrix();
    const Eigen::FullPivLU<MatrixX> factors(by_strain);
    const Eigen::Index free = factors.dimensionOfKernel();
    const auto& rows = task.rows;

    // What strain alone prescribes, and directions that it leaves free.
    Matrix6X strain_slopes = Matrix6X::Zero(6, count + free);
    MatrixX prescribed = MatrixX::Zero(7, count);
    prescribed.topRows<6>() = given.goal - rows.strain * start.strain;
    for (const int r : strain_rows.others) prescribed.row(r).setZero();
    if (!prescribed.isZero(0.0)) strain_slopes.leftCols(count) = factors.solve(prescribed);
    if (free > 0) strain_slopes.rightCols(free) = factors.kernel();

    PointSlopes slopes;
    slopes.stress = Matrix6X::Zero(6, count + free);
    slopes.stress.leftCols(count) = start.point.stress;
    slopes.state = MatrixX::Zero(start.point.state.rows(), count + free);
    slopes.state.leftCols(count) = start.point.state;
    StrainIncrement increment = task.increment;
    increment.strain = solution.strain_increment;
    const Response response =
        law.differentiate(task.point, increment, start.by, strain_slopes, slopes);
    if (response.outcome != Outcome::done) throw BadCase(response.message);

    // Unknowns: how much of the free directions, and the pore pressure in units of a stiffness.
    const Eigen::Index unknowns = free + (task.undrained ? 1 : 0);
    MatrixX y = MatrixX::Zero(unknowns, count);
    Eigen::RowVectorXd pore_pressure = given.pore_pressure;
    if (unknowns > 0) {
        const Vector6 mean = rows.stress * unit_tensor();
        const Matrix6X J = rows.stress * slopes.stress.rightCols(free) +
                           rows.strain * strain_slopes.rightCols(free);
        Matrix6X left = given.goal - rows.stress * slopes.stress.leftCols(count) -
                        rows.strain * (start.strain + strain_slopes.leftCols(count));
        if (!task.undrained) left += mean * pore_pressure;
        const auto equations = static_cast<Eigen::Index>(strain_rows.others.size());
        const double stiffness = free > 0 ? J.cwiseAbs().maxCoeff() : 1.0;
        MatrixX system(equations, unknowns), right(equations, count);
        for (Eigen::Index i = 0; i < equations; ++i) {
            const int r = strain_rows.others[static_cast<std::size_t>(i)];
            system.row(i).head(free) = J.row(r);
            if (task.undrained) system(i, free) = -stiffness * mean[r];
            const double size = system.row(i).norm();
            system.row(i) /= size;
            right.row(i) = left.row(r) / size;
        }
        const Eigen::FullPivLU<MatrixX> solver(system);
        if (!system.allFinite() || solver.rank() < unknowns) return std::nullopt;
        y = solver.solve(right);
        if (task.undrained) pore_pressure = stiffness * y.row(free);
    }

    Slopes end;
    end.by = start.by;
    const auto with_free = [&](const auto& all) {
        return all.leftCols(count) + all.rightCols(free) * y.topRows(free);
    };
    end.point.stress = with_free(slopes.stress);
    end.point.state = with_free(slopes.state);
    end.strain = start.strain + with_free(strain_slopes);
    end.pore_pressure = pore_pressure;
    return end;
}

}  // namespace element
