// SPDX-License-Identifier: BSD-3-Clause
// A calibration as a TOML file; docs/calibration.md explains every key.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "element/calibration/ensemble.hpp"
#include "element/calibration/estimates.hpp"
#include "element/calibration/fit.hpp"

namespace cli {

constexpr long most_samples = 10'000'000;  // with 13 parameters 1 GB

struct CalibrationCase {
    std::filesystem::path path;
    std::string name;   // of the files it writes
    std::string title;  // for people
    calibration::ParameterSpace space;
    std::vector<calibration::Experiment> experiments;
    std::vector<std::string> sources;          // of each: file, sheet, rows
    std::vector<std::string> doubts;           // about what was read, sentences
    std::vector<calibration::Direct> direct;   // measured by themselves, with an error
    std::vector<calibration::Estimate> start;  // of every parameter, and where it comes from
    std::string loss = "squares";
    double loss_scale = 2.0;
    int starts = 5;
    double spread = 0.3;
    bool inflate = true;
    long samples = 0;  // of the posterior, 0: Laplace alone
    std::uint64_t seed = 1;
    std::string beside;  // a sand to compare with, empty: none
    grit_sand_parameters beside_parameters{};
    std::vector<std::filesystem::path> inputs;  // all files that were read
};

// Throws BadInput naming file, line and key, or file, row and column.
CalibrationCase read_calibration_case(const std::filesystem::path& path);

}  // namespace cli
