// SPDX-License-Identifier: BSD-3-Clause
// Shared libraries as a host opens them.
#pragma once

// NAME of the library of this path, loaded where it is not; null if it has none.
void* symbol_of(const char* library, const char* name);

// The next symbol_of loads it anew: a library that has said nothing yet. Functions found before are
// gone.
void unload(const char* library);
