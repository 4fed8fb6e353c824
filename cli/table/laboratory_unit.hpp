// SPDX-License-Identifier: BSD-3-Clause
// Units in which laboratories write, in those of Grit.
#pragma once

#include <string>
#include <vector>

namespace cli {

struct LaboratoryUnit {
    const char* name;
    const char* of;  // Grit's unit
    double size;     // in it
};

// Null: it is unknown, or no unit of what Grit has in unit `of`.
const LaboratoryUnit* laboratory_unit(const std::string& name, const std::string& of);
std::vector<std::string> laboratory_units(const std::string& of);

// "eps [%]", "eps (%)", "eps_percent", "q_kPa": what the header says of the unit, empty if nothing.
std::string unit_in(const std::string& header);
// The same, between brackets alone.
std::string unit_in_brackets(const std::string& header);

}  // namespace cli
