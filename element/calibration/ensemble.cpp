// SPDX-License-Identifier: BSD-3-Clause
#include "element/calibration/ensemble.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "element/calibration/diagnostics.hpp"
#include "element/errors.hpp"
#include "support/trials/split_mix.hpp"

namespace calibration {
namespace {

struct Walker {
    Vector x;
    double sum = INFINITY;     // of rho(r^2)
    double linear = INFINITY;  // the same of linear residuals
};

struct Ensemble {
    std::vector<Walker> walkers;
    grit::SplitMix random{0};
};

// What a walker tries.
struct Proposal {
    Walker* walker = nullptr;
    Vector x;
    // It is accepted where its linear sum is no larger than the first, and its sum no larger than the second plus
    // its linear sum.
    double limit = 0.0, exact_limit = 0.0;
    double linear = 0.0;
    bool computed = false;
    std::optional<double> sum;  // found
};

// Three of ten moves stretch the line through another walker by 1/2 to 2, the others step along the difference of two
// others; these are of the half that stands still meanwhile. Accepted with the probability
// z^(d-1) exp[-(sum' - sum)/2 variance], in two parts: of the linear sums, then of what the sums differ from these. Random
// numbers are drawn before, so that a sum may be dropped on the way.
Proposal propose(Ensemble& ensemble, std::size_t number, double variance, const Vector& deviation) {
    std::vector<Walker>& walkers = ensemble.walkers;
    grit::SplitMix& random = ensemble.random;
    const std::size_t half = walkers.size() / 2;
    const std::size_t others = number < half ? half : 0;
    const auto other = [&]() -> const Vector& {
        return walkers[others + static_cast<std::size_t>(random.below(static_cast<int>(half)))].x;
    };
    Walker& walker = walkers[number];
    const auto size = static_cast<double>(walker.x.size());
    Proposal out;
    out.walker = &walker;
    double log_factor = 0.0;
    if (random.uniform() < 0.3) {
        const double z = std::pow(1.0 + random.uniform(), 2.0) / 2.0;
        const Vector& through = other();
        out.x = through + z * (walker.x - through);
        log_factor = (size - 1.0) * std::log(z);
    } else {
        const double usual = 2.38 / std::sqrt(2.0 * size);
        const double length = random.uniform() < 0.1 ? 1.0 : usual * random.uniform(0.7, 1.4);
        const Vector& from = other();
        out.x = walker.x + length * (other() - from);
        for (Eigen::Index k = 0; k < out.x.size(); ++k)
            out.x[k] += 1e-6 * deviation[k] * random.normal();
    }
    const auto chance = [&] { return -2.0 * variance * std::log(1.0 - random.uniform()); };
    out.limit = walker.linear + 2.0 * variance * log_factor + chance();
    out.exact_limit = walker.sum - walker.linear + chance();
    return out;
}

// Residuals as they are at a point and change with it there.
class Linear {
  public:
    Linear(const Problem& problem, const Vector& at, const Loss& given) : x(at), loss(given) {
        const auto found = problem.residuals(x, true);
        if (!found) throw element::BadCase("the best parameters cannot be computed again");
        residuals = *found;
    }

    double sum(const Vector& y) const {
        const Vector r = residuals.values + residuals.slopes * (y - x);
        if (!loss.function()) return r.squaredNorm();
        double out = 0.0;
        for (const double each : r) out += loss(each * each);
        return out;
    }

  private:
    Vector x;
    Loss loss;
    Residuals residuals;
};

std::size_t walkers_of(Eigen::Index size) {
    return 2 * static_cast<std::size_t>(std::max<Eigen::Index>(8, size + 2));
}

// Mirrored at the bounds: a best point in a corner of them has walkers around it, too.
Vector reflected(const ParameterSpace& space, Vector x) {
    const Vector low = space.lowest(), high = space.highest();
    for (Eigen::Index k = 0; k < x.size(); ++k) {
        if (x[k] < low[k]) x[k] = 2.0 * low[k] - x[k];
        if (x[k] > high[k]) x[k] = 2.0 * high[k] - x[k];
        x[k] = std::clamp(x[k], low[k], high[k]);
    }
    return x;
}

}  // namespace

Posterior sample(const Problem& problem, const Vector& x, const Laplace& around,
                 const SampleOptions& options) {
    const ParameterSpace& space = problem.space();
    const double variance = options.inflation * options.inflation;
    const Linear linear(problem, x, options.loss);
    const auto find = [&](Proposal& proposal) {
        if (!space.contains(proposal.x)) return;
        proposal.linear = linear.sum(proposal.x);
        if (proposal.linear > proposal.limit) return;
        proposal.computed = true;
        proposal.sum =
            problem.sum(proposal.x, proposal.exact_limit + proposal.linear, options.loss);
    };

    // Walkers start around the best point, where it can be computed.
    const std::size_t count = walkers_of(space.size());
    std::vector<Ensemble> ensembles(static_cast<std::size_t>(options.ensembles));
    const Matrix root = Eigen::LLT<Matrix>(around.covariance).matrixL();
    std::vector<Proposal> proposals;
    for (std::size_t i = 0; i < ensembles.size(); ++i) {
        ensembles[i].random = grit::SplitMix(options.seed * 1000003 + i);
        ensembles[i].walkers.resize(count);
        for (Walker& walker : ensembles[i].walkers) {
            proposals.emplace_back();
            proposals.back().walker = &walker;
            proposals.back().limit = proposals.back().exact_limit = INFINITY;
        }
    }
    in_parallel(problem.threads(), proposals.size(), [&](std::size_t i) {
        grit::SplitMix random(options.seed * 7919 + i);
        for (double width = 1.0; width > 1e-3 && !proposals[i].sum; width *= 0.8) {
            Vector step(x.size());
            for (double& each : step) each = width * random.normal();
            proposals[i].x = reflected(space, x + root * step);
            find(proposals[i]);
        }
    });
    for (Proposal& each : proposals) {
        if (!each.sum)
            throw element::BadCase("no sample can be computed around the best parameters: they lie "
                                   "at the edge of what the tests allow");
        *each.walker = {each.x, *each.sum, each.linear};
    }

    Posterior out;
    out.walkers = static_cast<int>(count);
    out.ensembles = options.ensembles;
    const auto all = static_cast<long>(count) * options.ensembles;
    out.steps = (options.samples + all - 1) / all;
    const auto burn_in = static_cast<long>(options.burn_in * static_cast<double>(out.steps));
    out.samples.resize(out.steps * all, x.size());
    long accepted = 0;
    for (long step = -burn_in; step < out.steps; ++step) {
        for (const std::size_t begin : {std::size_t{0}, count / 2}) {
            proposals.clear();
            for (Ensemble& each : ensembles)
                for (std::size_t i = begin; i < begin + count / 2; ++i)
                    proposals.push_back(propose(each, i, variance, around.deviation));
            in_parallel(problem.threads(), proposals.size(),
                        [&](std::size_t i) { find(proposals[i]); });
            for (Proposal& each : proposals) {
                if (each.computed) ++out.computed;
                if (!each.sum) continue;
                *each.walker = {std::move(each.x), *each.sum, each.linear};
                if (step >= 0) ++accepted;
            }
        }
        if (step >= 0) {
            for (std::size_t e = 0; e < ensembles.size(); ++e)
                for (std::size_t i = 0; i < count; ++i)
                    out.samples.row((static_cast<long>(e) * out.steps + step) *
                                        static_cast<long>(count) +
                                    static_cast<long>(i)) = ensembles[e].walkers[i].x;
        }
        if (options.progress &&
            !options.progress((step + 1 + burn_in) * all, (out.steps + burn_in) * all) &&
            step + 1 < out.steps) {
            out.stopped = true;
            out.samples.resize(0, x.size());
            return out;
        }
    }
    out.acceptance = static_cast<double>(accepted) / static_cast<double>(out.samples.rows());
    judge(out);
    return out;
}

Vector Posterior::quantile(double share) const {
    Vector out(samples.cols());
    for (Eigen::Index k = 0; k < samples.cols(); ++k) {
        std::vector<double> values(samples.col(k).begin(), samples.col(k).end());
        out[k] = calibration::quantile(values, share);
    }
    return out;
}

Vector Posterior::mean() const { return samples.colwise().mean(); }

Matrix Posterior::correlation() const {
    const Matrix centred = samples.rowwise() - samples.colwise().mean();
    const Matrix covariance = centred.transpose() * centred;
    const Vector inverse = covariance.diagonal().cwiseSqrt().cwiseInverse();
    return inverse.asDiagonal() * covariance * inverse.asDiagonal();
}

}  // namespace calibration
