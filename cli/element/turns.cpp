// SPDX-License-Identifier: BSD-3-Clause
#include "cli/element/turns.hpp"

#include <algorithm>
#include <cmath>

namespace cli {

Turns::Move Turns::add(double value) {
    const double step = value - farthest;
    if (direction == 0.0) {
        if (!(std::abs(step) > least)) return Move::back;
        direction = step;
        farthest = value;
        return Move::extreme;
    }
    if (step * direction >= 0.0) {
        farthest = value;
        return Move::extreme;
    }
    const double length = std::abs(farthest - begin);
    if (!(std::abs(step) > std::max(least, part * std::max(length, before)))) return Move::back;
    before = length;
    begin = farthest;
    farthest = value;
    direction = step;
    return Move::turned;
}

std::vector<std::size_t> turning_rows(const std::vector<double>& series, double least) {
    std::vector<std::size_t> out = {0};
    Turns turns(series.front(), least, 0.0);
    std::size_t farthest = 0;
    for (std::size_t i = 1; i < series.size(); ++i) {
        const Turns::Move move = turns.add(series[i]);
        if (move == Turns::Move::turned) out.push_back(farthest);
        if (move != Turns::Move::back) farthest = i;
    }
    out.push_back(series.size() - 1);
    return out;
}

}  // namespace cli
