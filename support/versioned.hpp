// SPDX-License-Identifier: BSD-3-Clause
// Structs of older and newer callers: the first member says how long the caller's struct is.
#pragma once

#include <cstddef>
#include <cstring>

namespace grit {

constexpr std::size_t largest_struct = 4096;

// Copy the caller's struct over defaults. False if its size is impossible, or if it is longer than
// ours and asks (non-zero bytes) for something this version does not know.
template <class Struct> inline bool read_versioned(const Struct& caller, Struct& ours) {
    const std::size_t size = caller.struct_size;
    if (size == sizeof(Struct)) {  // as it mostly is: a copy of known length
        ours = caller;
        return true;
    }
    if (size < sizeof(std::size_t) || size > largest_struct) return false;
    const auto* bytes = reinterpret_cast<const unsigned char*>(&caller);
    for (std::size_t i = sizeof(Struct); i < size; ++i)
        if (bytes[i] != 0) return false;
    std::memcpy(&ours, &caller, size < sizeof(Struct) ? size : sizeof(Struct));
    ours.struct_size = sizeof(Struct);
    return true;
}

// The caller's struct itself where it is as long as ours, as it mostly is; else its copy over defaults. Null where
// read_versioned says no.
template <class Struct>
inline const Struct* view_versioned(const Struct& caller, const Struct& defaults, Struct& copy) {
    if (caller.struct_size == sizeof(Struct)) return &caller;
    copy = defaults;
    return read_versioned(caller, copy) ? &copy : nullptr;
}

// Copy a result into the caller's struct as far as it reaches; its struct_size stays.
template <class Struct> inline bool write_versioned(const Struct& ours, Struct& caller) {
    const std::size_t size = caller.struct_size;
    if (size < sizeof(std::size_t) || size > largest_struct) return false;
    std::memcpy(&caller, &ours, size < sizeof(Struct) ? size : sizeof(Struct));
    caller.struct_size = size;
    return true;
}

// What an init function does: the caller's struct becomes defaults, as far as it reaches.
template <class Struct>
inline bool init_versioned(const Struct& defaults, Struct* caller, std::size_t struct_size) {
    if (!caller || struct_size < sizeof(std::size_t) || struct_size > largest_struct) return false;
    std::memset(static_cast<void*>(caller), 0, struct_size);
    caller->struct_size = struct_size;
    return write_versioned(defaults, *caller);
}

}  // namespace grit
