// SPDX-License-Identifier: BSD-3-Clause
// Trials in blocks whose random numbers depend on seed and number of the block alone: on any number of threads, in pieces.
#pragma once

#include <functional>
#include <string>

#include "robustness/findings.hpp"
#include "support/trials/split_mix.hpp"

namespace robustness {

using Random = grit::SplitMix;

// A kind of trial.
struct Kind {
    std::string name;
    Vocabulary words;
    long block;  // cases in each
    std::function<void(Random&, long cases, Findings&)> run;
};

struct Campaign {
    long count = 100000;  // cases, whole blocks
    unsigned long seed = 1;
    double hours = 0.0;  // start no block after them; 0: without end
    long only = -1;      // this block alone, if it is one
    int threads = 1;
    std::string journal;  // a line per block that is done, to go on from; empty: none
};

// Runs the blocks that the journal does not have and prints what all of them have found, in the end or when interrupted.
// Says whether no rule was broken. Throws std::runtime_error if the journal is of other trials or cannot be written, and
// if a trial throws, with the number of its block; a signal that ends the program names the blocks that it was at,
// as does the end of it by a call that does not return. SIGINT and SIGTERM end it after the blocks begun, a second one at once.
bool run(const Kind& kind, const Campaign& campaign);

}  // namespace robustness
