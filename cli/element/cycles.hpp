// SPDX-License-Identifier: BSD-3-Clause
// Stiffness and damping of every cycle.
#pragma once

#include <optional>

#include "cli/element/turns.hpp"
#include "cli/table/columns.hpp"

namespace cli {

// A cycle runs from one reversal of the shear strain to the second after it, or to the end of the stage
// if that is about as far. Of each: secant shear modulus from tip to tip,
// damping ratio D = loop area/(2 pi G gamma^2), and the state at its end. Every increment counts,
// whether it is recorded or not.
class Cycles {
  public:
    Cycles(const Columns& columns);

    // start: the point from which the strains of the stage count.
    void begin_stage(int number, bool loaded_by_shear, const element::Record& start);
    void add(const element::Record& record);
    void end_stage();

    static const std::vector<std::string>& comments();
    // No columns where there is no whole cycle.
    Table take();

  private:
    // A turn of the shear strain, and the work done to the sample until then.
    struct Tip {
        element::Record record;
        ShearPair shear;
        double work = 0.0;
    };
    static double distance(const Tip& a, const Tip& b);  // in shear strain
    void add_tip(Tip tip);
    void add_cycle(const Tip& from, const Tip& middle, const Tip& to);

    const Columns& columns;
    Table table;
    int stage = 0;
    bool by_shear = false;
    double cycle = 0.0;
    double closing = 0.0;   // distance that closed the last cycle, 0: none yet
    double pressure = 0.0;  // total mean, where the stage began [kPa]
    std::optional<Turns> turns;
    Tip last, farthest;
    std::vector<Tip> tips;  // of the cycle that is going on
};

}  // namespace cli
