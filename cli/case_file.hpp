// SPDX-License-Identifier: BSD-3-Clause
// Element tests as TOML files; docs/element-tests.md describes every key.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "element/case.hpp"

namespace cli {

struct ReferenceValue {
    std::string quantity;  // key of the case file: "sigma_11", "void_ratio", ...
    double value;          // at the end of the loading
};

struct Reference {
    std::vector<ReferenceValue> values;
    std::optional<double> tolerance;  // relative; the run fails beyond it
    std::string origin;
    std::filesystem::path curve;  // CSV with the columns eps11, s11, s33, e; empty: none
};

struct CaseFile {
    element::Case test;
    Reference reference;
};

// Throws BadInput naming file, line and key.
CaseFile read_case_file(const std::filesystem::path& path);

}  // namespace cli
