// SPDX-License-Identifier: BSD-3-Clause
#include "cli/table/laboratory_unit.hpp"

#include <numbers>
#include <utility>

namespace cli {
namespace {

constexpr LaboratoryUnit laboratory_unit_table[] = {
    {"-", "-", 1.0},
    {"percent", "-", 0.01},
    {"%", "-", 0.01},
    {"permille", "-", 1e-3},
    {"kPa", "kPa", 1.0},
    {"Pa", "kPa", 1e-3},
    {"MPa", "kPa", 1e3},
    {"bar", "kPa", 100.0},
    {"kN/m2", "kPa", 1.0},
    {"N/mm2", "kPa", 1e3},
    {"kgf/cm2", "kPa", 98.0665},
    {"psi", "kPa", 6.894757293168},
    {"kN/m²", "kPa", 1.0},
    {"N/mm²", "kPa", 1e3},
    {"MN/m2", "kPa", 1e3},
    {"MN/m²", "kPa", 1e3},
    {"deg", "deg", 1.0},
    {"°", "deg", 1.0},
    {"rad", "deg", 180.0 / std::numbers::pi},
    {"s", "s", 1.0},
    {"min", "s", 60.0},
    {"h", "s", 3600.0},
};

}  // namespace

const LaboratoryUnit* laboratory_unit(const std::string& name, const std::string& of) {
    for (const LaboratoryUnit& each : laboratory_unit_table)
        if (name == each.name && of == each.of) return &each;
    return nullptr;
}

std::vector<std::string> laboratory_units(const std::string& of) {
    std::vector<std::string> out;
    for (const LaboratoryUnit& each : laboratory_unit_table)
        if (of == each.of) out.emplace_back(each.name);
    return out;
}

std::string unit_in_brackets(const std::string& header) {
    for (const auto& [open, close] : {std::pair{'[', ']'}, std::pair{'(', ')'}}) {
        const std::size_t from = header.rfind(open);
        if (from != std::string::npos && header.back() == close)
            return header.substr(from + 1, header.size() - from - 2);
    }
    return "";
}

std::string unit_in(const std::string& header) {
    if (std::string said = unit_in_brackets(header); !said.empty()) return said;
    const std::size_t last = header.rfind('_');
    return last == std::string::npos ? "" : header.substr(last + 1);
}

}  // namespace cli
