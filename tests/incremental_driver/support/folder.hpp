// SPDX-License-Identifier: BSD-3-Clause
// A folder of input files that vanishes with the test.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <element/incremental_driver/test_file.hpp>

class Folder {
  public:
    Folder();  // empty
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    // Lausitz sand at 100 kPa, e 0.7, h = 0, and one drained step of compression, into result.out
    static void fill(const Folder& folder);

    void write(const std::string& name, const std::string& text) const;
    std::set<std::string> files() const;
    std::filesystem::path path(const std::string& name = {}) const { return place / name; }

  private:
    std::filesystem::path place;
};

// Steps behind the line "out", of a law with 14 state variables.
incremental_driver::Test parse(const std::string& steps);
// The same steps' one step.
element::Step parse_one(const std::string& step);
using Table = std::vector<std::vector<double>>;

// Rows of numbers below `headings` lines.
Table read_table(const std::filesystem::path& path, int headings = 1);

// The values of parameters.inp for Lausitz sand, one a line.
std::string lausitz_parameters();
// initialconditions.inp: isotropic pressure [kPa], e, h = 0.
std::string isotropic(double pressure, double void_ratio);
