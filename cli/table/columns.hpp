// SPDX-License-Identifier: BSD-3-Clause
// What a row of a result holds: names, units and how they follow from a record.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/table/table.hpp"
#include "element/exit_condition.hpp"
#include "element/grit_law.hpp"
#include "element/linear_quantity.hpp"

namespace cli {

// Columns that every result has; state variables of the law follow them.
const std::vector<std::string>& standard_column_names();
// Null: there is no such column.
const char* unit_of_standard_column(const std::string& name);

// The pair that loops are made of: sigma_12 and gamma_12, or half of what sigma_11 and epsilon_11 have
// more than the mean of the other two, and the whole of it.
struct ShearPair {
    double stress = 0.0;  // tau [kPa], total
    double strain = 0.0;  // gamma [-]
};
ShearPair shear_of(const element::Record& record, bool loaded_by_shear);

// Columns that are linear in stresses, strains, void ratio and pore pressure, and how; nothing: it is no such column.
std::vector<Column> linear_columns();
std::optional<element::LinearQuantity> linear_quantity(const std::string& name,
                                                       bool loaded_by_shear);

// What a record does not know.
struct Setting {
    int stage = 0;        // from 1, 0: the start
    bool shear = false;   // loaded by gamma_12; otherwise along 11
    double secant = 0.0;  // G since the last reversal [kPa], NaN: none yet
};

class Columns {
  public:
    // sand: null where the law is not Grit's, whose internal quantities are then NaN.
    Columns(const element::GritLaw* sand, const std::vector<std::string>& state_names);

    const std::vector<Column>& names() const { return heads; }  // and units, no values
    std::vector<double> row(const element::Record& record, const Setting& setting) const;

    // Columns by name, for conditions of stages loaded by shear or not; what a point does not know
    // (stage, secant_G, the work done) is refused.
    element::Vocabulary words(bool loaded_by_shear) const;

  private:
    const element::GritLaw* sand;
    std::vector<Column> heads;
    std::vector<std::size_t> states;  // that have a column
};

}  // namespace cli
