// SPDX-License-Identifier: BSD-3-Clause
// The caller's workspace, handed out piece by piece. What does not fit is counted, not written.
#pragma once

#include <cstddef>

namespace grit::surface {

class Arena {
  public:
    Arena(void* memory, std::size_t size) : at(static_cast<char*>(memory)), end(at + size) {}

    // n objects, of no particular contents; null once something did not fit.
    template <class T> T* take(std::ptrdiff_t n) {
        static_assert(alignof(T) <= alignof(double));
        const std::size_t bytes = size_of<T>(n);
        if (overrun || bytes > left()) {
            overrun = true;
            return nullptr;
        }
        T* out = reinterpret_cast<T*>(at);
        at += bytes;
        return out;
    }
    template <class T> static std::size_t size_of(std::ptrdiff_t n) {
        return (static_cast<std::size_t>(n) * sizeof(T) + 7) / 8 * 8;
    }
    std::size_t left() const { return static_cast<std::size_t>(end - at); }
    bool is_overrun() const { return overrun; }
    void refuse() { overrun = true; }

  private:
    char *at, *end;
    bool overrun = false;
};

// A list at the end of an arena, until it is closed; one at a time.
template <class T> class Growing {
  public:
    explicit Growing(Arena& of)
        : arena(of), capacity(static_cast<std::ptrdiff_t>(of.left() / sizeof(T))),
          data(reinterpret_cast<T*>(of.take<char>(0))) {}
    void add(const T& item) {
        if (!data || count == capacity) {
            arena.refuse();
            return;
        }
        data[count++] = item;
    }
    std::ptrdiff_t size() const { return count; }
    T* close() {
        arena.take<T>(count);
        return data;
    }

  private:
    Arena& arena;
    std::ptrdiff_t capacity;
    T* data;
    std::ptrdiff_t count = 0;
};

}  // namespace grit::surface
