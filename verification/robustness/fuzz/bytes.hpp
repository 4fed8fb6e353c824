// SPDX-License-Identifier: BSD-3-Clause
// What a fuzzer makes of the bytes that it is given: counts, choices and numbers, of which some are those that break things.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <string>

namespace fuzz {

class Bytes {
  public:
    Bytes(const std::uint8_t* data, std::size_t size) : at(data), end(data + size) {}

    std::size_t left() const { return static_cast<std::size_t>(end - at); }
    int byte() { return at == end ? 0 : *at++; }
    int below(int n) { return byte() % n; }
    bool one_in(int n) { return byte() % n == 1; }
    template <class Number> Number raw() {
        Number out{};
        const std::size_t some = left() < sizeof out ? left() : sizeof out;
        std::memcpy(&out, at, some);
        at += some;
        return out;
    }
    // usual: what a host would say.
    double number(double usual) {
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        constexpr double infinite = std::numeric_limits<double>::infinity();
        constexpr double others[] = {0.0,    -0.0,  1.0,  -1.0, 1e-300,   1e300,
                                     5e-324, 1e-15, 1e15, nan,  infinite, -infinite};
        const int how = byte();
        if (how < 128) return usual * (1.0 + (how - 64) / 256.0);
        if (how < 160) return usual * (how - 144);
        if (how < 240) return others[static_cast<std::size_t>(how) % std::size(others)];
        return raw<double>();
    }
    std::string rest() {
        const std::string out(reinterpret_cast<const char*>(at), left());
        at = end;
        return out;
    }

  private:
    const std::uint8_t *at, *end;
};

// A struct of a caller of a later version: there is memory, of zeros or not, as long as any struct_size that is believed.
template <class Struct> struct Padded {
    Struct here{};
    unsigned char behind[4096] = {};
};

// What must hold whatever the bytes are; a fuzzer ends where it does not.
inline void demand(bool holds) {
    if (!holds) __builtin_trap();
}

}  // namespace fuzz
