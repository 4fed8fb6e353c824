// SPDX-License-Identifier: BSD-3-Clause
#include "element/calibration/diagnostics.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace calibration {
namespace {

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double variance_of(const std::vector<double>& values, double mean) {
    double sum = 0.0;
    for (const double each : values) sum += (each - mean) * (each - mean);
    return sum / static_cast<double>(values.size() - 1);
}

}  // namespace

double split_r_hat(const std::vector<std::vector<double>>& chains) {
    std::vector<double> means;
    double within = 0.0;
    std::size_t length = 0;
    for (const std::vector<double>& chain : chains) {
        length = chain.size() / 2;
        if (length < 2) return NAN;
        for (const std::size_t from : {std::size_t{0}, chain.size() - length}) {
            const auto begin = chain.begin() + static_cast<std::ptrdiff_t>(from);
            const std::vector<double> half(begin, begin + static_cast<std::ptrdiff_t>(length));
            means.push_back(mean_of(half));
            within += variance_of(half, means.back());
        }
    }
    within /= static_cast<double>(means.size());
    if (!(within > 0.0)) return NAN;
    const auto n = static_cast<double>(length);
    const double between = variance_of(means, mean_of(means));  // over n
    return std::sqrt(((n - 1.0) / n * within + between) / within);
}

double autocorrelation_time(const std::vector<std::vector<double>>& chains) {
    double mean = 0.0, variance = 0.0;
    for (const auto& chain : chains) mean += mean_of(chain) / static_cast<double>(chains.size());
    const std::size_t length = chains.front().size();
    const auto covariance = [&](std::size_t lag) {
        double sum = 0.0;
        for (const auto& chain : chains)
            for (std::size_t i = 0; i + lag < length; ++i)
                sum += (chain[i] - mean) * (chain[i + lag] - mean);
        return sum / static_cast<double>(chains.size() * length);
    };
    variance = covariance(0);
    if (!(variance > 0.0)) return static_cast<double>(length);
    double time = 1.0;
    for (std::size_t lag = 1; lag < length; ++lag) {
        time += 2.0 * covariance(lag) / variance;
        if (static_cast<double>(lag) > 5.0 * time) break;
    }
    return std::max(1.0, time);
}

double quantile(std::vector<double>& values, double share) {
    const double place = share * static_cast<double>(values.size() - 1);
    const auto low = static_cast<std::size_t>(place);
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(low);
    std::nth_element(values.begin(), at, values.end());
    const double below = *at;
    if (low + 1 == values.size()) return below;
    const double above = *std::min_element(at + 1, values.end());
    return below + (place - static_cast<double>(low)) * (above - below);
}

void judge(Posterior& posterior) {
    const auto size = posterior.samples.cols();
    posterior.r_hat.resize(size);
    posterior.effective.resize(size);
    for (Eigen::Index k = 0; k < size; ++k) {
        std::vector<std::vector<double>> walkers, ensembles;
        long row = 0;
        for (int e = 0; e < posterior.ensembles; ++e) {
            auto& pooled = ensembles.emplace_back();
            const std::size_t first = walkers.size();
            walkers.resize(first + static_cast<std::size_t>(posterior.walkers));
            for (long step = 0; step < posterior.steps; ++step)
                for (int w = 0; w < posterior.walkers; ++w, ++row) {
                    const double value = posterior.samples(row, k);
                    pooled.push_back(value);
                    walkers[first + static_cast<std::size_t>(w)].push_back(value);
                }
        }
        posterior.r_hat[k] = split_r_hat(ensembles);
        posterior.effective[k] =
            static_cast<double>(posterior.samples.rows()) / autocorrelation_time(walkers);
    }
}

}  // namespace calibration
