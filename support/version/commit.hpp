// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace grit {

// Of the tree that this was built from: twelve digits, of an archive all forty, "+" where files differ from it; empty where
// nobody knows.
const char* commit();

}  // namespace grit
