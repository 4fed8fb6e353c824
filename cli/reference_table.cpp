// SPDX-License-Identifier: BSD-3-Clause
#include "cli/reference_table.hpp"

#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace cli {
namespace {

struct Quantity {
    const char* key;
    const char* label;
    double (*of)(const element::Row&);
};

constexpr Quantity quantities[] = {
    {"sigma_11", "sigma_11 [kPa]", [](const element::Row& row) { return row.stress[0]; }},
    {"p", "p [kPa]", [](const element::Row& row) { return row.invariants.p; }},
    {"q", "q [kPa]", [](const element::Row& row) { return row.invariants.q; }},
    {"void_ratio", "void ratio [-]", [](const element::Row& row) { return row.void_ratio; }},
};

const Quantity& quantity(const std::string& key) {
    for (const Quantity& q : quantities)
        if (key == q.key) return q;
    throw std::logic_error("no such reference quantity: " + key);
}

}  // namespace

const std::vector<std::string>& reference_quantities() {
    static const std::vector<std::string> keys = [] {
        std::vector<std::string> out;
        for (const Quantity& q : quantities) out.emplace_back(q.key);
        return out;
    }();
    return keys;
}

Comparison compare(const std::vector<CaseFile>& cases, const std::vector<element::Run>& runs) {
    Comparison out;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        if (!runs[i].failure.empty()) continue;  // the end was not reached
        const Reference& reference = cases[i].reference;
        for (const ReferenceValue& expected : reference.values) {
            const Quantity& q = quantity(expected.quantity);
            const double computed = q.of(runs[i].rows.back());
            const double difference = (computed - expected.value) / std::abs(expected.value);
            const bool within = std::abs(difference) <= reference.tolerance.value_or(INFINITY);
            out.within = out.within && within;
            const std::string limit =
                reference.tolerance ? fmt::format("{:.0e}", *reference.tolerance) : "-";
            out.text += fmt::format("{:<16} {:<14} {:>10.6g} {:>10.6g} {:>+10.1e} {:>7}{}\n",
                                    cases[i].test.name, q.label, computed, expected.value,
                                    difference, limit, within ? "" : "  EXCEEDED");
        }
    }
    if (!out.text.empty())
        out.text = fmt::format("{:<16} {:<14} {:>10} {:>10} {:>10} {:>7}\n", "case", "at the end",
                               "computed", "reference", "difference", "limit") +
                   out.text;
    return out;
}

}  // namespace cli
