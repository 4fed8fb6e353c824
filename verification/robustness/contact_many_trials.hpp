// SPDX-License-Identifier: BSD-3-Clause
// Trials of grit_contact_correct_many: two to eight bodies at a node, at one node or at many.
#pragma once

#include "robustness/contact_node.hpp"

namespace robustness::contact {

void try_many(const Call& call, Random& random, Findings& out);

}  // namespace robustness::contact
