// SPDX-License-Identifier: BSD-3-Clause
// Programs run to their end.
#pragma once

#include <gtest/gtest.h>

#include "support/elastic.hpp"
#include "support/lausitz.hpp"

namespace tests {

struct Finished {
    element::History history;
    element::Sample sample;
};

inline Finished run_elastic(const element::Program& program) {
    const Elastic law;
    Finished out;
    out.sample.point = elastic_point();
    out.history = element::simulate(law, out.sample, program);
    EXPECT_FALSE(out.history.failure) << out.history.failure->message;
    return out;
}

// Lausitz sand, isotropic 100 kPa, mobilised by isotropic compression.
inline Finished run_sand(const element::Program& program, double e = 0.7) {
    const element::GritLaw law = lausitz_law();
    Finished out;
    out.sample = isotropic_sample(law, 100.0, e);
    out.history = element::simulate(law, out.sample, program);
    EXPECT_FALSE(out.history.failure) << out.history.failure->message;
    return out;
}

template <typename Kind> element::Step step_of(const Kind& kind, int increments) {
    element::Step step;
    step.kind = kind;
    step.increments = increments;
    return step;
}

}  // namespace tests
