// SPDX-License-Identifier: BSD-3-Clause
// How the enumerations of a case are spelt, in case files and in fix grit/mpm.
#pragma once

#include <span>
#include <string_view>

#include <grit/contact.h>
#include <grit/contact_distance.h>
#include <grit/contact_normals.h>

#include "adapters/mpm/case/case.hpp"

namespace grit::mpm {

// A word of an enumeration.
struct Spelling {
    std::string_view word;
    int value;
    const char* text;
    bool in_fix = true;  // fix grit/mpm has it too
};
using Spellings = std::span<const Spelling>;

template <class Value>
constexpr Spelling spelling(const char* word, Value value, const char* text) {
    return {word, static_cast<int>(value), text};
}
constexpr Spelling only_in_files(Spelling spelling) {
    spelling.in_fix = false;
    return spelling;
}

namespace words {

inline constexpr Spelling geometries[] = {
    spelling("axisymmetric", true, "per radian"),
    spelling("plane_strain", false, "per metre; r is then the horizontal coordinate")};
inline constexpr Spelling sides[] = {
    spelling("left", Side::left, ""), spelling("right", Side::right, ""),
    spelling("bottom", Side::bottom, ""), spelling("top", Side::top, "")};
inline constexpr Spelling boundaries[] = {
    spelling("free", Boundary::free, "nothing, particles that leave end the run"),
    spelling("roller", Boundary::roller, "no velocity across"),
    spelling("fixed", Boundary::fixed, "no velocity at all"),
    only_in_files(spelling("absorbing", Boundary::absorbing,
                           "dashpots, besides what holds the bodies at the first step"))};
inline constexpr Spelling shapes[] = {
    spelling("cpdi", Shape::cpdi, "corners weighted by their radii"),
    spelling("cpdi_published", Shape::cpdi_published, "unweighted corners"),
    spelling("ugimp", Shape::ugimp, "the undeformed, upright domain"),
    spelling("linear", Shape::point, "at the particle: the original method")};
inline constexpr Spelling schemes[] = {
    spelling("usl", Scheme::usl, "stress last"),
    spelling("musl", Scheme::musl, "stress last, by velocities mapped back from the particles"),
    spelling("usf", Scheme::usf, "stress first")};
inline constexpr Spelling edges[] = {
    spelling("bottom", Edge::bottom, ""), spelling("right", Edge::right, ""),
    spelling("top", Edge::top, ""), spelling("left", Edge::left, "")};
inline constexpr Spelling pulse_forms[] = {spelling("half_sine", PulseForm::half_sine, ""),
                                           spelling("triangle", PulseForm::triangle, "")};
inline constexpr int penalty_law_word = -1;  // no nodal law
inline constexpr Spelling contact_laws[] = {
    spelling("geo", GRIT_CONTACT_GEO, "at nodes, as far as s reaches"),
    spelling("frictional", GRIT_CONTACT_FRICTIONAL, "at nodes"),
    only_in_files(spelling("penalty", penalty_law_word, "along lines"))};
inline constexpr Spelling normals[] = {spelling("stiff", GRIT_CONTACT_NORMAL_OF_A, ""),
                                       spelling("soft", GRIT_CONTACT_NORMAL_OF_B, ""),
                                       spelling("average", GRIT_CONTACT_NORMAL_AVERAGE, "")};
inline constexpr Spelling distances[] = {
    spelling("support", GRIT_CONTACT_SUPPORT, "of the stiffer body's surface to the node"),
    spelling("edge", GRIT_CONTACT_EDGE, "the absolute value of that"),
    spelling("nearest_centre", GRIT_CONTACT_NEAREST_CENTRE, "of the stiffer body's particles")};
inline constexpr Spelling depths[] = {spelling("lowest_point", DepthOf::lowest_point, ""),
                                      spelling("centre_of_mass", DepthOf::centre_of_mass, "")};
enum class IntergranularStart { mobilised, zero, off };
inline constexpr Spelling intergranular_starts[] = {
    spelling("mobilised", IntergranularStart::mobilised, "|h| = R"),
    spelling("zero", IntergranularStart::zero, "h = 0"),
    spelling("off", IntergranularStart::off, "the basic model")};
inline constexpr Spelling on_off[] = {spelling("on", 0, ""), spelling("off", 1, "")};

}  // namespace words

// The word of a value that is among them.
std::string_view word_of(Spellings words, int value);
template <class Value> std::string_view word_of(Spellings words, Value value) {
    return word_of(words, static_cast<int>(value));
}

}  // namespace grit::mpm
