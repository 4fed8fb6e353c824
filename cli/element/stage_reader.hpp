// SPDX-License-Identifier: BSD-3-Clause
// [[stage]] of a case file.
#pragma once

#include <string>
#include <vector>

#include "cli/table/columns.hpp"
#include "cli/toml/toml_table.hpp"
#include "element/step.hpp"

namespace cli {

struct CaseStage {
    std::string test;  // the word of the laboratory: "triaxial_drained", ...; of a group, the last
    element::Program program;
    bool zero_strain = false;  // strains count from the beginning of this stage
    bool shear = false;        // loaded by gamma_12; otherwise along 11
    bool cyclic = false;
    std::vector<std::string> until;  // conditions, those of stages within included
};

// What one stage must know of those before it.
struct StageContext {
    const Columns& columns;
    // An undrained stage has left a pore pressure that no stage has let out.
    bool pore_pressure = false;
};

CaseStage read_stage(TomlTable table, StageContext& context);

}  // namespace cli
