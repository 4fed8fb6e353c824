// SPDX-License-Identifier: BSD-3-Clause
// Runs of the same test that took different ways.
#pragma once

#include "support/folder.hpp"

inline constexpr double same = 1e-8;

// Largest difference of two outputs with 14 state variables, relative to the largest value of time,
// strain, stress or h, or of any other column alone; infinite if they have not as many rows.
double difference(const Table& a, const Table& b);

// Output of a folder of input files, by Grit's own law or a UMAT.
Table of_files(const std::filesystem::path& folder, const std::string& output, int headings,
               const std::filesystem::path& umat = {});
