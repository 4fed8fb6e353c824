// SPDX-License-Identifier: BSD-3-Clause
// A column of a laboratory's sheet: which of Grit's it is, in which unit and sign, and how exact.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/toml/toml_table.hpp"

namespace cli {

// Strains and pore pressure of a test, unit: Grit's.
bool counts_from_start(const std::string& quantity, const std::string& unit);

struct LaboratoryColumn {
    std::string quantity, unit;  // Grit's: "axial_strain", "-"
    std::string name;            // theirs, as in the header
    std::size_t place = 0;       // in the row
    double factor = 1.0;         // Grit's for theirs, sign included
    bool engineering = false;    // over the first length, not logarithmic
    double error = 0.0;  // standard deviation in Grit's unit, 0 and no relative one: not compared
    double relative_error = 0.0;
    bool may_be_empty = false;
    std::optional<double> zero;  // of strains and pore pressure: Grit's, where the test starts

    bool is_change() const { return counts_from_start(quantity, unit); }
    bool compared() const { return error > 0.0 || relative_error > 0.0; }
    // Of Grit, or nothing where an engineering strain is -1 or less.
    std::optional<double> value(double theirs) const;
    double theirs(double value) const;     // of a value of Grit, as the sheet has it
    double deviation(double value) const;  // of a value of Grit
};

// [columns] of a test, a table for each quantity that the sheet has. where: words about a column that the header has
// not. Throws BadInput.
std::vector<LaboratoryColumn>
read_columns(TomlTable table, const std::vector<std::string>& header,
             const std::function<std::string(const std::string&)>& where, bool shear);

}  // namespace cli
