// SPDX-License-Identifier: BSD-3-Clause
// The vectors of g++ and clang by their number of lanes. InPlace: aligned memory of other types is read and written
// as such a vector where it lies.
#pragma once

#include <cstdint>

#include "support/kernel.hpp"

GRIT_KERNEL_BEGIN

template <int W> struct VectorTypes;
template <> struct VectorTypes<2> {
    typedef double Real __attribute__((vector_size(16)));
    typedef std::int64_t Bits __attribute__((vector_size(16)));
    typedef std::uint64_t Unsigned __attribute__((vector_size(16)));
    typedef double RealInPlace __attribute__((vector_size(16), may_alias));
    typedef std::uint64_t UnsignedInPlace __attribute__((vector_size(16), may_alias));
};
template <> struct VectorTypes<4> {
    typedef double Real __attribute__((vector_size(32)));
    typedef std::int64_t Bits __attribute__((vector_size(32)));
    typedef std::uint64_t Unsigned __attribute__((vector_size(32)));
    typedef double RealInPlace __attribute__((vector_size(32), may_alias));
    typedef std::uint64_t UnsignedInPlace __attribute__((vector_size(32), may_alias));
};
template <> struct VectorTypes<8> {
    typedef double Real __attribute__((vector_size(64)));
    typedef std::int64_t Bits __attribute__((vector_size(64)));
    typedef std::uint64_t Unsigned __attribute__((vector_size(64)));
    typedef double RealInPlace __attribute__((vector_size(64), may_alias));
    typedef std::uint64_t UnsignedInPlace __attribute__((vector_size(64), may_alias));
};

GRIT_KERNEL_END
