// SPDX-License-Identifier: BSD-3-Clause
#include "cli/element/stage_rows.hpp"

#include <algorithm>

namespace cli {

StageRows rows_of_stage(const Table& table, int stage) {
    const std::vector<double>& stages = table.at("stage");
    StageRows out{0, stages.size() - 1};
    if (stage == 0) return out;
    // Stages rise with the rows.
    const auto [begin, end] = std::equal_range(stages.begin(), stages.end(), stage);
    out.first = static_cast<std::size_t>(begin - stages.begin());
    out.last = static_cast<std::size_t>(end - stages.begin()) - 1;
    if (out.first > 0 && table.at("increment")[out.first] != 0.0) --out.first;
    return out;
}

}  // namespace cli
