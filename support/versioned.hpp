// SPDX-License-Identifier: BSD-3-Clause
// Structs of older and newer callers: the first member says how long the caller's struct is.
#pragma once

#include <cstddef>
#include <cstring>

namespace grit {

constexpr std::size_t largest_struct = 4096;

// No struct that begins with a size ends within a word, or it would be half of a pointer that is believed.
inline bool is_possible_size(std::size_t struct_size) {
    return struct_size >= sizeof(std::size_t) && struct_size <= largest_struct &&
           struct_size % alignof(std::size_t) == 0;
}

// What the first member says. The caller's struct may be shorter than ours: a pointer to it is not followed, nor
// a reference made of it, before its size is known.
inline std::size_t size_of_versioned(const void* caller) {
    std::size_t size;
    std::memcpy(&size, caller, sizeof size);
    return size;
}

// Copy the caller's struct over defaults. False if its size is impossible, or if it is longer than
// ours and asks (non-zero bytes) for something this version does not know.
template <class Struct> inline bool read_versioned(const Struct* caller, Struct& ours) {
    const std::size_t size = size_of_versioned(caller);
    if (size == sizeof(Struct)) {  // as it mostly is: a copy of known length
        ours = *caller;
        return true;
    }
    if (!is_possible_size(size)) return false;
    const auto* bytes = static_cast<const unsigned char*>(static_cast<const void*>(caller));
    for (std::size_t i = sizeof(Struct); i < size; ++i)
        if (bytes[i] != 0) return false;
    std::memcpy(static_cast<void*>(&ours), bytes, size < sizeof(Struct) ? size : sizeof(Struct));
    ours.struct_size = sizeof(Struct);
    return true;
}

// The caller's struct itself where it is as long as ours, as it mostly is; else its copy over defaults. Null where
// read_versioned says no.
template <class Struct>
inline const Struct* view_versioned(const Struct* caller, const Struct& defaults, Struct& copy) {
    if (size_of_versioned(caller) == sizeof(Struct)) return caller;
    copy = defaults;
    return read_versioned(caller, copy) ? &copy : nullptr;
}

// Copy a result into the caller's struct as far as it reaches; its struct_size stays.
template <class Struct> inline bool write_versioned(const Struct& ours, Struct* caller) {
    const std::size_t size = size_of_versioned(caller);
    if (!is_possible_size(size)) return false;
    std::memcpy(static_cast<void*>(caller), &ours, size < sizeof(Struct) ? size : sizeof(Struct));
    std::memcpy(static_cast<void*>(caller), &size, sizeof size);
    return true;
}

// What an init function does: the caller's struct becomes defaults, as far as it reaches.
template <class Struct>
inline bool init_versioned(const Struct& defaults, Struct* caller, std::size_t struct_size) {
    if (!caller || !is_possible_size(struct_size)) return false;
    std::memset(static_cast<void*>(caller), 0, struct_size);
    std::memcpy(static_cast<void*>(caller), &struct_size, sizeof struct_size);
    return write_versioned(defaults, caller);
}

}  // namespace grit
