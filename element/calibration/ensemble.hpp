// SPDX-License-Identifier: BSD-3-Clause
// A sample of the posterior distribution: ensembles of walkers that move by each other's differences (Goodman & Weare
// 2010, ter Braak & Vrugt 2008), in any coordinates alike. What residuals that are linear around the best parameters
// would refuse is not computed (delayed acceptance, Christen & Fox 2005): the distribution is the exact one all the same.
#pragma once

#include <cstdint>
#include <functional>

#include "element/calibration/laplace.hpp"
#include "element/calibration/loss.hpp"

namespace calibration {

struct SampleOptions {
    Loss loss;
    long samples = 100000;  // after what is left out at the beginning
    int ensembles = 4;      // that know nothing of each other: what R-hat compares
    double burn_in = 0.1;   // share of the samples that is computed before and left out
    std::uint64_t seed = 1;
    double inflation = 1.0;  // of the stated errors
    // So many of so many, with those that are left out. Returning false ends sampling.
    std::function<bool(long, long)> progress;
};

struct Posterior {
    Matrix samples;  // a row each, ensemble by ensemble, step by step, walker by walker
    long steps = 0;  // of each walker
    int walkers = 0, ensembles = 0;
    double acceptance = 0.0;  // share of the proposals
    Vector r_hat,
        effective;      // of each coordinate: 1 at best; independent samples that these are worth
    long computed = 0;  // proposals that were more than their linear residuals
    bool stopped = false;  // by progress, without samples

    Vector quantile(double share) const;  // of each coordinate
    Vector mean() const;
    Matrix correlation() const;
};

// Starts around x as wide as the covariance. Depends on the seed, not on the number of threads.
Posterior sample(const Problem& problem, const Vector& x, const Laplace& around,
                 const SampleOptions& options);

}  // namespace calibration
