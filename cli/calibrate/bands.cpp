// SPDX-License-Identifier: BSD-3-Clause
#include "cli/calibrate/bands.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "element/calibration/diagnostics.hpp"
#include "support/trials/split_mix.hpp"

namespace cli {
namespace {

// Rows evenly through the samples, or of the normal distribution at the best fit within the bounds.
calibration::Matrix draw(const CalibrationCase& file, const CalibrationResult& result, int count) {
    calibration::Matrix out(count, file.space.size());
    if (result.posterior) {
        const calibration::Matrix& samples = result.posterior->samples;
        for (int i = 0; i < count; ++i)
            out.row(i) = samples.row(
                static_cast<Eigen::Index>((i + 0.5) / count * static_cast<double>(samples.rows())));
        return out;
    }
    grit::SplitMix random(file.seed);
    const calibration::Matrix root =
        Eigen::LLT<calibration::Matrix>(result.laplace.covariance).matrixL();
    for (int i = 0; i < count; ++i) {
        calibration::Vector step(file.space.size());
        for (double& each : step) each = random.normal();
        out.row(i) = (result.fit.x + root * step)
                         .cwiseMax(file.space.lowest())
                         .cwiseMin(file.space.highest());
    }
    return out;
}

Band band_of(const calibration::Experiment& test, const CalibrationCase& file,
             const CalibrationResult& result, const calibration::Matrix& draws) {
    Band out;
    const calibration::Prediction best = calibration::predict(test, result.best);
    out.failure = best.failure;
    if (!out.failure.empty()) return out;
    out.best.assign(best.values.begin(), best.values.end());
    std::vector<std::vector<double>> values(test.readings.size());
    for (Eigen::Index i = 0; i < draws.rows(); ++i) {
        const calibration::Prediction one =
            calibration::predict(test, file.space.at(draws.row(i).transpose()));
        if (!one.failure.empty()) continue;
        for (std::size_t k = 0; k < values.size(); ++k)
            values[k].push_back(one.values[static_cast<Eigen::Index>(k)]);
    }
    for (std::size_t k = 0; k < values.size(); ++k) {
        values[k].push_back(out.best[k]);
        const double low = calibration::quantile(values[k], 0.025);
        const double high = calibration::quantile(values[k], 0.975);
        const double error =
            normal_quantile_975 * result.laplace.inflation * test.readings[k].error;
        out.lowest.push_back(low);
        out.highest.push_back(high);
        out.lowest_measured.push_back(out.best[k] - std::hypot(out.best[k] - low, error));
        out.highest_measured.push_back(out.best[k] + std::hypot(high - out.best[k], error));
    }
    return out;
}

}  // namespace

std::vector<Band> bands(const CalibrationCase& file, const CalibrationResult& result, int draws,
                        int threads) {
    const calibration::Matrix drawn = draw(file, result, draws);
    std::vector<Band> out(file.experiments.size());
    calibration::in_parallel(threads, out.size(), [&](std::size_t i) {
        out[i] = band_of(file.experiments[i], file, result, drawn);
    });
    return out;
}

}  // namespace cli
