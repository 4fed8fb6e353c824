// SPDX-License-Identifier: BSD-3-Clause
// What the C entries ask of the views, lists, masks, switches, counts, structs and workspaces that they are given, and
// how they say that it is not so: each question and each text is here and nowhere else. Asked once a call.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>

#include "support/require.hpp"
#include "support/versioned.hpp"
#include "support/views.hpp"

namespace grit {

// What a message is about: "force", "surface a: force", "body 3: mass". Passed by value: where all is well none is made.
struct Named {
    const char* owner = nullptr;
    std::ptrdiff_t number = 0;
    const char* name;
    bool numbered = false;

    Named(const char* its_name) : name(its_name) {}
    Named(const char* of, const char* its_name) : owner(of), name(its_name) {}
    Named(const char* of, std::ptrdiff_t which, const char* its_name)
        : owner(of), number(which), name(its_name), numbered(true) {}
};

// Fill error (may be null) with the name and what is wrong with it. point: -1 for the call as a whole.
__attribute__((cold, noinline, format(printf, 4, 5))) void
word(grit_error* error, std::ptrdiff_t point, Named about, const char* format, ...);

// Leave a function that has a grit_error* error, unless the condition holds of what is named.
#define GRIT_REQUIRE_OF(about, condition, ...)                                                     \
    if (!(condition)) return grit::word(error, -1, about, __VA_ARGS__), GRIT_BAD_CALL

// Leave a function with what a check says, unless it says nothing.
#define GRIT_CHECK(...)                                                                            \
    if (const grit_status bad = (__VA_ARGS__)) return bad

inline grit_status check_given(const void* pointer, Named about, grit_error* error) {
    GRIT_REQUIRE_OF(about, pointer, " is null");
    return GRIT_OK;
}

// unit: " nodes", if it is said.
inline grit_status check_count(std::ptrdiff_t n, Named about, grit_error* error,
                               const char* unit = "") {
    GRIT_REQUIRE_OF(about, n >= 0, " must be >= 0%s, got %td", unit, n);
    return GRIT_OK;
}

inline grit_status check_switch(int x, Named about, grit_error* error) {
    GRIT_REQUIRE_OF(about, is_switch(x), " must be 0 or 1, got %d", x);
    return GRIT_OK;
}

inline grit_status check_reserved(int x, Named about, grit_error* error) {
    GRIT_REQUIRE_OF(about, x == 0, " must be 0, got %d", x);
    return GRIT_OK;
}

inline grit_status check_dimension(int components, grit_error* error) {
    GRIT_REQUIRE(components == 2 || components == 3, "components must be 2 or 3, got %d",
                 components);
    return GRIT_OK;
}

// Structs with versions.

inline constexpr const char* set_it_to_sizeof = "set it to sizeof";

// understood: what a function of versioned.hpp says of the caller's struct.
inline grit_status check_understood(bool understood, const void* caller, Named about,
                                    const char* remedy, grit_error* error) {
    GRIT_REQUIRE_OF(about, understood, ".struct_size %zu is not understood: %s",
                    size_of_versioned(caller), remedy);
    return GRIT_OK;
}

template <class Struct>
inline grit_status read_struct(const Struct* caller, Struct& ours, Named about, grit_error* error,
                               const char* remedy = set_it_to_sizeof) {
    return check_understood(read_versioned(caller, ours), caller, about, remedy, error);
}

// Where a result will be written, if at all: as it is before anything is found.
template <class Struct>
inline grit_status begin_result(const Struct& nothing, Struct* caller, Named about,
                                grit_error* error) {
    if (!caller) return GRIT_OK;
    return check_understood(write_versioned(nothing, caller), caller, about, set_it_to_sizeof,
                            error);
}

// Views.

// why: who needs it, if that is said.
template <class View>
inline grit_status check_base(const View& view, Named about, grit_error* error,
                              const char* why = "") {
    GRIT_REQUIRE_OF(about, view.base, " has no base pointer%s", why);
    return GRIT_OK;
}

template <class View>
inline grit_status check_components(const View& view, int components, Named about,
                                    grit_error* error) {
    GRIT_REQUIRE_OF(about, has_components(view, components),
                    " has %d components: component_stride must not be 0", components);
    return GRIT_OK;
}

inline grit_status check_component_strides(std::initializer_list<std::ptrdiff_t> strides,
                                           const char* whose, grit_error* error) {
    for (const std::ptrdiff_t stride : strides)
        GRIT_REQUIRE(stride != 0, "component_stride of %s must not be 0", whose);
    return GRIT_OK;
}

template <class View>
inline grit_status check_usable(const View& view, std::ptrdiff_t components, Named about,
                                grit_error* error) {
    GRIT_REQUIRE_OF(about, is_usable(view, components),
                    " needs a base pointer and a component_stride");
    return GRIT_OK;
}
// The same, needed for a value of an option.
template <class View>
inline grit_status check_usable_for(const char* option, int value, const View& view,
                                    std::ptrdiff_t components, Named about, grit_error* error) {
    GRIT_REQUIRE_OF(about, is_usable(view, components),
                    " needs a base pointer and a component_stride for %s %d", option, value);
    return GRIT_OK;
}
inline grit_status check_usable(const grit_matrix_view& view, Named about, grit_error* error) {
    GRIT_REQUIRE_OF(about, view.base && has_entries(view),
                    " needs a base pointer, a row_stride and a column_stride");
    return GRIT_OK;
}

// What is written, if at all, for several points, by name as what: nodes, points.
template <class View>
inline grit_status check_written(const View& view, std::ptrdiff_t n, Named about, const char* what,
                                 grit_error* error) {
    GRIT_REQUIRE_OF(about, has_points(view, n),
                    " is written: point_stride must not be 0 for %td %s", n, what);
    return GRIT_OK;
}
inline grit_status check_entries_written(const grit_mutable_matrix_view& view, Named about,
                                         grit_error* error) {
    GRIT_REQUIRE_OF(about, has_entries(view),
                    " is written: row_stride and column_stride must not be 0");
    return GRIT_OK;
}

// What has to be there and is written, of however many points.
inline grit_status check_output(const grit_mutable_view& view, std::ptrdiff_t components,
                                Named about, grit_error* error) {
    GRIT_CHECK(check_base(view, about, error));
    GRIT_REQUIRE_OF(about, view.point_stride != 0, " is written: point_stride must not be 0");
    GRIT_REQUIRE_OF(about, has_components(view, components),
                    " is written: component_stride must not be 0");
    return GRIT_OK;
}

inline grit_status check_apart(const grit_mutable_view& view, std::ptrdiff_t components,
                               std::ptrdiff_t n, Named about, const char* what, grit_error* error) {
    GRIT_REQUIRE_OF(about, !overlaps_itself(view, components, n),
                    " is written: strides of %td (%s) and %td (components) put two of its numbers "
                    "in one place",
                    view.point_stride, what, view.component_stride);
    return GRIT_OK;
}

// Lists and masks, of one point, which the error names: is_index, is_range and is_mask ask, these say what was found.

// instead: what an entry may be besides, as ", or -1".
inline grit_status refuse_index(std::ptrdiff_t i, std::ptrdiff_t n, std::ptrdiff_t point,
                                Named about, grit_error* error, const char* instead = "") {
    word(error, point, about, " must be in [0, %td)%s, got %td", n, instead, i);
    return GRIT_BAD_CALL;
}
// Of a list that is itself what the call goes through.
inline grit_status refuse_entry(std::ptrdiff_t i, std::ptrdiff_t n, std::ptrdiff_t at,
                                const char* list, grit_error* error) {
    return failure(error, GRIT_BAD_CALL, at, "entry %td of %s must be in [0, %td), got %td", at,
                   list, n, i);
}
inline grit_status refuse_range(std::ptrdiff_t first, std::ptrdiff_t last, std::ptrdiff_t point,
                                Named about, grit_error* error) {
    word(error, point, about, " must start at >= 0 and not decrease, got %td and %td", first, last);
    return GRIT_BAD_CALL;
}
inline grit_status refuse_mask(int bits, int components, std::ptrdiff_t point, Named about,
                               grit_error* error) {
    word(error, point, about, " must be bits of %d components in [0, %d], got %d", components,
         (1 << components) - 1, bits);
    return GRIT_BAD_CALL;
}

// Workspaces of numbers.
inline grit_status check_workspace(const void* workspace, std::size_t size, std::size_t needed,
                                   grit_error* error) {
    GRIT_REQUIRE(workspace, "workspace is null: %zu bytes are needed", needed);
    GRIT_REQUIRE(reinterpret_cast<std::uintptr_t>(workspace) % alignof(double) == 0,
                 "workspace must be aligned to %zu bytes", alignof(double));
    GRIT_REQUIRE(size >= needed, "workspace must have at least %zu bytes, got %zu", needed, size);
    return GRIT_OK;
}

}  // namespace grit
