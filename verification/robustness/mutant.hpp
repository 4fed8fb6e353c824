// SPDX-License-Identifier: BSD-3-Clause
// What script/mutants puts into the source: operators and constants that are others where the environment variable
// GRIT_MUTANT names them, so that one build holds all mutants. A place that is told so says it once on stderr.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <type_traits>

namespace grit_mutant {

inline const int active = [] {
    const char* number = std::getenv("GRIT_MUTANT");
    return number ? std::atoi(number) : 0;
}();

template <int number> inline bool told = false;

// What the compiler computes is as it was.
template <int number> constexpr bool on() {
    if (std::is_constant_evaluated()) return false;
    if (active != number) [[likely]]
        return false;
    if (!told<number>) {
        told<number> = true;
        std::fprintf(stderr, "GRIT_MUTANT %d reached\n", number);
    }
    return true;
}
template <int number> constexpr bool off() { return !on<number>(); }

// a OP b is written a OP Name<number>{} OP b, of the same rank; with types that have no other operator of the same
// result nothing changes, and it says nothing.
#define GRIT_MUTANT(Name, OP, OTHER)                                                               \
    template <int number> struct Name {};                                                          \
    template <int number, class A> struct Name##Of { A&& a; };                                     \
    template <int number, class A>                                                                 \
    [[gnu::always_inline]] constexpr Name##Of<number, A> operator OP(A&& a, Name<number>) {        \
        return {static_cast<A&&>(a)};                                                              \
    }                                                                                              \
    template <int number, class A, class B>                                                        \
    [[gnu::always_inline]] constexpr auto operator OP(Name##Of<number, A> left, const B& b) {      \
        if constexpr (requires {                                                                   \
                          requires std::is_same_v<decltype(left.a OP b),                           \
                                                  decltype(left.a OTHER b)>;                       \
                      }) {                                                                         \
            if (on<number>()) return left.a OTHER b;                                               \
        }                                                                                          \
        return left.a OP b;                                                                        \
    }

GRIT_MUTANT(Plus, +, -)
GRIT_MUTANT(Minus, -, +)
GRIT_MUTANT(Times, *, /)
GRIT_MUTANT(Over, /, *)
GRIT_MUTANT(Less, <, <=)
GRIT_MUTANT(LessEqual, <=, <)
GRIT_MUTANT(More, >, >=)
GRIT_MUTANT(MoreEqual, >=, >)
GRIT_MUTANT(Equal, ==, !=)
GRIT_MUTANT(Unequal, !=, ==)
GRIT_MUTANT(And, &, |)
GRIT_MUTANT(Or, |, &)
#undef GRIT_MUTANT

// -x is written Negative<number>{} * x.
template <int number> struct Negative {};
template <int number, class B>
[[gnu::always_inline]] constexpr auto operator*(Negative<number>, const B& b) {
    if constexpr (requires { requires std::is_same_v<std::remove_cvref_t<decltype(-b)>, B>; }) {
        if (on<number>()) return B(b);
    }
    return -b;
}

}  // namespace grit_mutant
