// SPDX-License-Identifier: BSD-3-Clause
// Exact sums added to each other, and read as the nearest doubles.
#define GRIT_TARGET c_api
#include <algorithm>
#include <cmath>

#include "contact/nodal/sums.hpp"
#include "support/versioned.hpp"

namespace grit {
namespace {

// The double nearest to a sum, ties to even.
double nearest_double(const std::int64_t* word) {
    constexpr int n = c_api::exact_sum_words + 2;
    std::int64_t digit[n];
    // Once as it is, once negated if it turns out negative: digits in [0, 2^32) and a carry above.
    double sign = 1.0;
    for (int pass = 0; pass < 2; ++pass) {
        std::int64_t carry = 0;
        for (int i = 0; i < n; ++i) {
            const std::int64_t here = i < c_api::exact_sum_words ? word[i] : 0;
            const std::int64_t x = (sign < 0.0 ? -here : here) + carry;
            digit[i] = x & 0xffffffff;
            carry = x >> 32;
        }
        if (carry >= 0) break;
        sign = -1.0;
    }
    int top = n - 1;
    while (top > 0 && digit[top] == 0) --top;
    // The leading 64 bits, the lowest of them set if anything follows: more than a double needs.
    const auto at = [&](int i) { return i < 0 ? 0 : static_cast<std::uint64_t>(digit[i]); };
    if (at(top) == 0) return 0.0;
    const int zeros = std::countl_zero(static_cast<std::uint32_t>(at(top)));
    std::uint64_t leading = at(top) << 32 | at(top - 1);
    std::uint64_t rest = at(top - 2);
    if (zeros > 0) {
        leading = leading << zeros | rest >> (32 - zeros);
        rest &= (1ULL << (32 - zeros)) - 1;
    }
    for (int i = top - 3; i >= 0; --i) rest |= at(i);
    if (rest != 0) leading |= 1;
    const int exponent = 32 * (top - 1) - zeros - 1074;
    // Rounded here, to the bits that a double of this size has.
    const int lost = std::max(11, -1074 - exponent);
    const std::uint64_t half = 1ULL << (lost - 1), mask = (half << 1) - 1;
    const std::uint64_t tail = leading & mask, kept = leading >> lost;
    const bool up = tail > half || (tail == half && (kept & 1));
    return sign * std::ldexp(static_cast<double>(kept + (up ? 1 : 0)), exponent + lost);
}

}  // namespace
}  // namespace grit

using namespace grit;
using namespace grit::c_api;

extern "C" {

grit_status grit_contact_sums_add(grit_contact_sums* into, const grit_contact_sums* from) {
    if (!into || !from) return GRIT_BAD_CALL;
    for (int i = 0; i < GRIT_CONTACT_SUMS_WORDS; ++i) into->word[i] += from->word[i];
    return GRIT_OK;
}

grit_status grit_contact_sums_read(const grit_contact_sums* sums, grit_contact_totals* totals) {
    if (!sums || !totals) return GRIT_BAD_CALL;
    constexpr std::int64_t most_terms = std::int64_t{1} << 30;
    if (sums->word[counts_at + GRIT_CONTACT_STICK] + sums->word[counts_at + GRIT_CONTACT_SLIP] >
        most_terms)
        return GRIT_BAD_STATE;
    const auto read = [&](int quantity) {
        return nearest_double(sums->word + quantity * exact_sum_words);
    };
    const auto count = [&](int at) { return static_cast<std::ptrdiff_t>(sums->word[at]); };
    grit_contact_totals t{};
    for (int i = 0; i < 3; ++i) {
        t.impulse_on_b[i] = read(sum_impulse + i);
        t.force_on_b[i] = read(sum_force + i);
        t.moment_on_b[i] = read(sum_moment + i);
        t.impulse_on_a[i] = -t.impulse_on_b[i];
        t.force_on_a[i] = -t.force_on_b[i];
        t.moment_on_a[i] = -t.moment_on_b[i];
    }
    t.trial_energy_normal = read(sum_trial_normal);
    t.trial_energy_tangential = read(sum_trial_tangential);
    t.dissipation_normal = read(sum_dissipation_normal);
    t.dissipation_tangential = read(sum_dissipation_tangential);
    t.inactive = count(counts_at + GRIT_CONTACT_INACTIVE);
    t.open = count(counts_at + GRIT_CONTACT_OPEN);
    t.stick = count(counts_at + GRIT_CONTACT_STICK);
    t.slip = count(counts_at + GRIT_CONTACT_SLIP);
    t.failed = count(failed_at);
    return write_versioned(t, totals) ? GRIT_OK : GRIT_BAD_CALL;
}
}
