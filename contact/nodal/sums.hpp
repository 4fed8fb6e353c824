// SPDX-License-Identifier: BSD-3-Clause
// What grit_contact_sums holds: exact sums of the quantities of grit_contact_totals, then counts.
#pragma once

#include <grit/contact.h>

#include "contact/nodal/exact_sum.hpp"

GRIT_KERNEL_BEGIN

enum SumOf {
    sum_impulse = 0,  // on B; on A is the opposite
    sum_force = 3,
    sum_moment = 6,
    sum_trial_normal = 9,
    sum_trial_tangential = 10,
    sum_dissipation_normal = 11,
    sum_dissipation_tangential = 12,
    sum_count = 13
};
constexpr int counts_at = sum_count * exact_sum_words;  // by state, then failed
constexpr int failed_at = counts_at + GRIT_CONTACT_SLIP + 1;
static_assert(failed_at < GRIT_CONTACT_SUMS_WORDS);

inline void add_to_sums(grit_contact_sums& sums, const grit_contact_report& r,
                        const double moment[3]) {
    if (r.status != GRIT_OK) {
        ++sums.word[failed_at];
        return;
    }
    ++sums.word[counts_at + r.state];
    if (r.state < GRIT_CONTACT_STICK) return;
    const auto add = [&](int quantity, double x) {
        if (x != 0.0) add_exactly(sums.word + quantity * exact_sum_words, x);
    };
    for (int i = 0; i < 3; ++i) {
        add(sum_impulse + i, r.impulse[i]);
        add(sum_force + i, r.force[i]);
        add(sum_moment + i, moment[i]);
    }
    add(sum_trial_normal, r.trial_energy_normal);
    add(sum_trial_tangential, r.trial_energy_tangential);
    add(sum_dissipation_normal, r.dissipation_normal);
    add(sum_dissipation_tangential, r.dissipation_tangential);
}

GRIT_KERNEL_END
