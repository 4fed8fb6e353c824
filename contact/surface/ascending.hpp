// SPDX-License-Identifier: BSD-3-Clause
// Numbers in ascending order.
#pragma once

#include <algorithm>

namespace grit::surface {

// With an order of its own: std::sort of plain pointers is a symbol that compilers leave to the whole program, and a
// library would export it.
template <class T> void sort_ascending(T* begin, T* end) {
    std::sort(begin, end, [](const T& x, const T& y) { return x < y; });
}
template <class T, class Before> void sort_ascending(T* begin, T* end, const Before& before) {
    std::sort(begin, end, before);
}

}  // namespace grit::surface
