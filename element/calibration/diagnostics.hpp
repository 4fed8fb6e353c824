// SPDX-License-Identifier: BSD-3-Clause
// How far a sample can be trusted.
#pragma once

#include "element/calibration/ensemble.hpp"

namespace calibration {

// r_hat and effective of a sample.
void judge(Posterior& posterior);

// Of a series of chains, all as long: between and within their halves (Gelman & Rubin, split; BDA3 11.4).
double split_r_hat(const std::vector<std::vector<double>>& chains);

// Integrated autocorrelation time of the mean over chains [steps], summed as far as 5 times itself (Sokal).
double autocorrelation_time(const std::vector<std::vector<double>>& chains);

// Of values in any order, which it puts into another, between neighbours linear. share in [0, 1].
double quantile(std::vector<double>& values, double share);

}  // namespace calibration
