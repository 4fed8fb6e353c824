// SPDX-License-Identifier: BSD-3-Clause
// Turning points of a series of values as it comes in.
#pragma once

#include <vector>

namespace cli {

// A turn is an extreme from which the series has come back by more than `least`, and by more than the
// share `part` of the longer of the two stretches around it: noise is no turn.
class Turns {
  public:
    enum class Move {
        extreme,  // the value is the farthest of its stretch
        back,     // it lies behind the farthest, not far enough for a turn
        turned    // the farthest was a turn; the value is the farthest of the next stretch
    };

    Turns(double first, double least_back, double least_part)
        : begin(first), farthest(first), least(least_back), part(least_part) {}

    Move add(double value);

  private:
    double begin, farthest;  // of this stretch
    double before = 0.0;     // length of the last one
    double direction = 0.0;
    double least, part;
};

// Rows where the series turns, with its first and its last.
std::vector<std::size_t> turning_rows(const std::vector<double>& series, double least);

}  // namespace cli
