// SPDX-License-Identifier: BSD-3-Clause
// What passes between the C entry points and the kernels of the instruction sets.
#pragma once

#include <cstddef>

#include <grit/contact.h>

namespace grit {

inline constexpr int most_bodies = GRIT_CONTACT_MOST_BODIES;
inline constexpr int most_pairs = most_bodies * (most_bodies - 1) / 2;

struct CorrectionRequest {
    const grit_contact_options* options;
    const grit_contact_nodes* nodes;
    std::ptrdiff_t n;
    grit_contact_report* reports;  // may be null
    grit_contact_sums* sums;       // may be null
};

struct ManyRequest {
    const grit_contact_bodies* bodies;
    const grit_contact_pair* pairs;            // [pair_count]
    const grit_contact_options* pair_options;  // [pair_count], as read
    int pair_count;
    std::ptrdiff_t n;
    grit_contact_report* reports;
    grit_contact_sums* sums;
};

// The first node, in 0 ... n-1, and pair that failed its checks; -1: none did.
struct CorrectionOutcome {
    std::ptrdiff_t node = -1;
    int pair = 0;
    grit_status status = GRIT_BAD_STATE;
};

#define GRIT_DECLARE_CONTACT_KERNELS(isa)                                                          \
    namespace isa {                                                                                \
    CorrectionOutcome correct(const CorrectionRequest& request);                                   \
    CorrectionOutcome correct_many(const ManyRequest& request);                                    \
    }
GRIT_DECLARE_CONTACT_KERNELS(baseline)
GRIT_DECLARE_CONTACT_KERNELS(avx2)
GRIT_DECLARE_CONTACT_KERNELS(avx512)
#undef GRIT_DECLARE_CONTACT_KERNELS

}  // namespace grit
