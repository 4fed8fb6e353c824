// SPDX-License-Identifier: BSD-3-Clause
#include "element/calibration/laplace.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/SVD>

namespace calibration {
namespace {

// A uniform distribution over a range of 1 has this deviation: what is not known better is not determined.
const double uniform_deviation = 1.0 / std::sqrt(12.0);

}  // namespace

bool Laplace::determines(Eigen::Index coordinate) const {
    return std::none_of(combinations.begin(), combinations.end(), [&](const Combination& each) {
        return !each.determined && std::abs(each.weights[coordinate]) > share_that_counts;
    });
}

Laplace laplace(const Problem& problem, const Residuals& residuals, bool inflate) {
    Laplace out;
    const Vector range = problem.space().highest() - problem.space().lowest();
    const double more = problem.independent() - static_cast<double>(range.size());
    const double freedom = std::max(1.0, more);
    out.overdetermined = more > 0.0;
    out.misfit = residuals.values.squaredNorm() / freedom;
    if (inflate && out.overdetermined) out.inflation = std::sqrt(std::max(1.0, out.misfit));
    // At least as many rows as parameters: what no reading tells of has the singular value 0.
    Matrix scaled = Matrix::Zero(std::max(residuals.slopes.rows(), range.size()), range.size());
    scaled.topRows(residuals.slopes.rows()) = residuals.slopes * range.asDiagonal();
    const Eigen::JacobiSVD<Matrix> svd(scaled, Eigen::ComputeThinV);
    Matrix root(range.size(), range.size());
    for (Eigen::Index k = 0; k < range.size(); ++k) {
        Combination each;
        each.weights = svd.matrixV().col(k);
        if (each.weights.cwiseAbs().maxCoeff() > each.weights.maxCoeff()) each.weights *= -1.0;
        each.singular = svd.singularValues()[k];
        const double alone = out.inflation / each.singular;
        each.determined = alone < uniform_deviation;
        each.deviation = 1.0 / std::hypot(1.0 / alone, 1.0 / uniform_deviation);
        root.col(k) = each.deviation * range.cwiseProduct(each.weights);
        out.combinations.push_back(std::move(each));
    }
    out.covariance = root * root.transpose();
    out.deviation = out.covariance.diagonal().cwiseSqrt();
    out.correlation = out.deviation.cwiseInverse().asDiagonal() * out.covariance *
                      out.deviation.cwiseInverse().asDiagonal();
    return out;
}

}  // namespace calibration
