// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "cli/element/case_run.hpp"

namespace cli {

// Names of the pictures that draw_cases may make, without ending, and which case each is of.
std::vector<std::pair<std::string, std::string>> pictures_of(const std::vector<CaseFile>& cases);

// Whether one picture shows them all.
bool are_compared(const std::vector<CaseFile>& cases);
// The first that cannot be in a picture with the first of all; null: none.
const CaseFile* stranger_among(const std::vector<CaseFile>& cases);
std::string title_of_comparison(const std::vector<CaseFile>& cases);
// What the points beside a case are.
std::string reference_label(const CaseFile& file);

// A picture for every case, one over all where they may be together, and sheets of the samples of a
// file. What went wrong is said on stderr; false if a picture could not be written.
bool draw_cases(const std::filesystem::path& folder, const std::vector<CaseFile>& cases,
                const std::vector<CaseResult>& results, bool quiet);

}  // namespace cli
