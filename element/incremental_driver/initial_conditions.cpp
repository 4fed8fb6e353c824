// SPDX-License-Identifier: BSD-3-Clause
#include "element/incremental_driver/initial_conditions.hpp"

#include "element/incremental_driver/lines.hpp"
#include "element/text.hpp"

namespace incremental_driver {
namespace {

constexpr int most_state_variables = 10000;

}  // namespace

InitialConditions read_initial_conditions(const std::filesystem::path& path) {
    Lines lines(path);
    InitialConditions out;
    const int ntens = Fields(lines, lines.next("ntens")).whole("ntens", 1, 6);
    for (int i = 1; i <= ntens; ++i) {
        const std::string what = element::text("stress(%d) of %d", i, ntens);
        out.stress[i - 1] = Fields(lines, lines.next(what)).single(what);
    }
    const Line* line = &lines.next("nstatv");
    if (const std::size_t equals = line->text.find('='); equals != std::string::npos) {
        out.temperature =
            Fields(lines, line->number, line->text.substr(equals + 1)).real("the temperature");
        line = &lines.next("nstatv");
    }
    const int nstatv = Fields(lines, *line).whole("nstatv", 0, most_state_variables);
    out.nstatv_line = line->number;
    out.statev.assign(static_cast<std::size_t>(nstatv), 0.0);
    for (int i = 1; i <= nstatv && !lines.at_end(); ++i) {
        const std::string what = element::text("statev(%d) of %d", i, nstatv);
        out.statev[static_cast<std::size_t>(i) - 1] = Fields(lines, lines.next(what)).single(what);
    }
    return out;
}

}  // namespace incremental_driver
