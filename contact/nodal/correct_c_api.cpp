// SPDX-License-Identifier: BSD-3-Clause
// grit_contact_correct: checks the call, chooses the instruction set, words the failures.
#define GRIT_TARGET c_api
#include <cmath>

#include "contact/nodal/call_checks.hpp"
#include "contact/nodal/pair_law.hpp"
#include "contact/nodal/request.hpp"
#include "support/call_checks.hpp"
#include "support/instruction_set.hpp"

using namespace grit;

extern "C" {

grit_status grit_contact_options_init(grit_contact_options* options, size_t struct_size) {
    return init_versioned(default_contact_options(), options, struct_size) ? GRIT_OK
                                                                           : GRIT_BAD_CALL;
}

grit_status grit_contact_penalty_factor(double s, double d, double k, double* f_p) {
    if (!f_p || !(s > -INFINITY) || !(d >= 1e-100 && d <= 1e100) || !(k > 0.0 && k <= 1e6))
        return GRIT_BAD_CALL;
    *f_p = s < d ? c_api::penalty_factor<double>(s, {d, 1.0 / d}, k) : 0.0;
    return GRIT_OK;
}

grit_status grit_contact_correct(const grit_contact_options* options, ptrdiff_t n,
                                 const grit_contact_nodes* nodes, grit_contact_report* reports,
                                 grit_contact_sums* sums, grit_error* error) {
    GRIT_CHECK(check_given(nodes, {"grit_contact_correct", "nodes"}, error));
    GRIT_CHECK(check_count(n, {"grit_contact_correct", "n"}, error));
    grit_contact_options o;
    GRIT_CHECK(read_options(options, o, error));
    grit_contact_nodes q{};
    GRIT_CHECK(read_struct(nodes, q, "grit_contact_nodes", error));
    if (n == 0) return GRIT_OK;  // an empty array may have no base pointer
    GRIT_CHECK(check_nodes(q, o, n, error));

    const CorrectionRequest request{&o, &q, n, reports, sums};
    const CorrectionOutcome outcome = GRIT_DISPATCH(o.instruction_set, correct(request));
    return outcome.node < 0 ? GRIT_OK : describe_node(q, o, outcome.node, error);
}
}
