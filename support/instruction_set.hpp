// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace grit {

// The best GRIT_ISA_... of this machine that this build has a kernel for.
int best_instruction_set();

}  // namespace grit
