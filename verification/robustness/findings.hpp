// SPDX-License-Identifier: BSD-3-Clause
// What random trials find: counts, largest numbers, and rules that were broken, each with the program that breaks it again.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "robustness/pulse.hpp"

namespace robustness {

// Names of what a kind of trial counts, measures and demands; trials refer to them by number.
struct Vocabulary {
    std::vector<std::string> counts, largest, rules;
};

class Findings {
  public:
    explicit Findings(const Vocabulary& words)
        : counts(words.counts.size()), largest(words.largest.size()), broken(words.rules.size()) {}

    void count(int what, long times = 1) {
        beat();
        counts[static_cast<std::size_t>(what)] += times;
    }
    // NaN is larger than any number.
    void measure(int what, double value) {
        double& most = largest[static_cast<std::size_t>(what)];
        if (!(value <= most) && most == most) most = value;
    }
    // program: makes the text that repeats the case; called for the first of each rule.
    template <class Program> void demand(int rule, bool holds, const Program& program) {
        beat();
        if (holds) return;
        Broken& one = broken[static_cast<std::size_t>(rule)];
        if (one.times++ == 0) one.program = program();
    }
    void add(const Findings& other);
    int rules_broken() const;
    bool clean() const { return rules_broken() == 0; }

    // One line, and back; throws std::runtime_error if it is none of these words.
    std::string line(const Vocabulary& words) const;
    static Findings of_line(const Vocabulary& words, const std::string& line);
    void print(const Vocabulary& words) const;

  private:
    struct Broken {
        long times = 0;
        std::string program;
    };
    std::vector<long> counts;
    std::vector<double> largest;
    std::vector<Broken> broken;
};

}  // namespace robustness
