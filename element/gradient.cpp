// SPDX-License-Identifier: BSD-3-Clause
#include "element/gradient.hpp"

#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SVD>

namespace element {
namespace {

struct Polar {
    Matrix3 R, U;
};

// F = R U by the singular values; det F > 0.
Polar polar(const Matrix3& F) {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(Eigen::Matrix3d(F),
                                                Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Matrix3d &W = svd.matrixU(), &V = svd.matrixV();
    return {W * V.transpose(), V * svd.singularValues().asDiagonal() * V.transpose()};
}

template <typename Function> Matrix3 of_symmetric(const Matrix3& A, Function f) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen{Eigen::Matrix3d(A)};
    const Eigen::Vector3d values = eigen.eigenvalues().unaryExpr(f);
    return eigen.eigenvectors() * values.asDiagonal() * eigen.eigenvectors().transpose();
}

Matrix3 part_of_rotation(const Matrix3& R, double x) {
    const Eigen::AngleAxisd whole{Eigen::Matrix3d(R)};
    return Eigen::AngleAxisd(x * whole.angle(), whole.axis()).toRotationMatrix();
}

// F_1 F_0^-1 = V R: what is strained is strained at the end. V = R U R^T.
Motion polar_motion(const Matrix3& F_0, const Matrix3& F_1) {
    const Polar p = polar(F_1 * F_0.inverse());
    const Matrix3 V = p.R * p.U * p.R.transpose();
    const Matrix3 ln_V = of_symmetric(V, [](double value) { return std::log(value); });
    return {strain_components(ln_V), p.R};
}

// Hughes & Winget (1980), doi 10.1002/nme.1620151210.
Motion midpoint_motion(const Matrix3& F_0, const Matrix3& F_1) {
    const Matrix3 one = Matrix3::Identity();
    const Matrix3 G = (F_1 - F_0) * (0.5 * (F_0 + F_1)).inverse();
    const Matrix3 W = 0.5 * (G - G.transpose());
    return {strain_components(0.5 * (G + G.transpose())),
            (one - 0.5 * W).inverse() * (one + 0.5 * W)};
}

}  // namespace

Matrix3 gradient_at(const DeformationGradient& step, double x) {
    if (step.path == DeformationGradient::Path::linear)
        return Matrix3::Identity() + x * (step.F - Matrix3::Identity());
    const Polar p = polar(step.F);
    return part_of_rotation(p.R, x) *
           of_symmetric(p.U, [x](double value) { return std::pow(value, x); });
}

Motion motion_between(const Matrix3& F_0, const Matrix3& F_1,
                      DeformationGradient::Increments increments) {
    Motion motion = increments == DeformationGradient::Increments::polar
                        ? polar_motion(F_0, F_1)
                        : midpoint_motion(F_0, F_1);
    // The roundoff of F is no strain: a law with a memory would take it for a direction.
    if (motion.strain.norm() < 1e-14) motion.strain.setZero();
    return motion;
}

}  // namespace element
