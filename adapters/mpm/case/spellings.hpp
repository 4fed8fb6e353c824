// SPDX-License-Identifier: BSD-3-Clause
// How the enumerations of a case are spelt, in case files and in fix grit/mpm.
#pragma once

#include <grit/contact.h>
#include <grit/contact_distance.h>
#include <grit/contact_normals.h>

#include "adapters/mpm/case/case.hpp"
#include "adapters/mpm/step/spellings.hpp"

namespace grit::mpm {

namespace words {

enum class Geometry { plane_strain, axisymmetric, space };
inline constexpr Spelling geometries[] = {
    spelling("axisymmetric", Geometry::axisymmetric, "per radian"),
    spelling("plane_strain", Geometry::plane_strain,
             "per metre; r is then the horizontal coordinate, and may be called x in all keys"),
    spelling("space", Geometry::space, "x, y and z, see docs/space.md")};
inline constexpr Spelling sides[] = {
    spelling("left", Side::left, ""), spelling("right", Side::right, ""),
    spelling("bottom", Side::bottom, ""), spelling("top", Side::top, "")};
// Of a rigid body in space.
inline constexpr Spelling degrees_of_freedom[] = {
    spelling("x", 0, ""),       spelling("y", 1, ""),       spelling("z", 2, ""),
    spelling("about_x", 3, ""), spelling("about_y", 4, ""), spelling("about_z", 5, "")};
// Twice the direction, and one on the upper side.
inline constexpr Spelling sides_in_space[] = {spelling("left", 0, ""),   spelling("right", 1, ""),
                                              spelling("front", 2, ""),  spelling("back", 3, ""),
                                              spelling("bottom", 4, ""), spelling("top", 5, "")};
inline constexpr Spelling boundaries[] = {
    spelling("free", Boundary::free, "nothing, particles that leave end the run"),
    spelling("roller", Boundary::roller, "no velocity across"),
    spelling("fixed", Boundary::fixed, "no velocity at all"),
    only_in_files(spelling("absorbing", Boundary::absorbing,
                           "dashpots, besides what holds the bodies at the first step")),
    only_in_files(
        spelling("platen", Boundary::platen,
                 "a rigid plate without mass or friction, which tractions of bodies press"))};
inline constexpr Spelling drainages[] = {
    spelling("undrained", Drainage::undrained, "it moves with the grains"),
    spelling("flow", Drainage::flow, "it moves through them, with a velocity of its own")};
inline constexpr Spelling pore_pressures[] = {
    spelling("explicit", false, "waves of the water limit the step"),
    spelling("implicit", true, "solved for in each step, which is that of the grains")};
inline constexpr Spelling conductivity_laws[] = {
    spelling("constant", false, ""),
    spelling("kozeny_carman", true, "k ~ e³/(1 + e), as given at the void ratio of the plan")};
inline constexpr Spelling edges[] = {
    spelling("bottom", Edge::bottom, ""), spelling("right", Edge::right, ""),
    spelling("top", Edge::top, ""), spelling("left", Edge::left, "")};
inline constexpr Spelling load_bearers[] = {
    spelling("grains", false, ""),
    spelling("mixture", true,
             "and the water by its share, whose pressure at the surface it then is")};
inline constexpr Spelling pulse_forms[] = {spelling("half_sine", PulseForm::half_sine, ""),
                                           spelling("triangle", PulseForm::triangle, "")};
inline constexpr int penalty_law_word = -1, surface_law_word = -2;  // no nodal laws
inline constexpr Spelling contact_laws[] = {
    spelling("geo", GRIT_CONTACT_GEO, "at nodes, as far as s reaches"),
    spelling("frictional", GRIT_CONTACT_FRICTIONAL, "at nodes"),
    only_in_files(spelling("penalty", penalty_law_word, "along lines")),
    spelling("surface", surface_law_word, "along the free edges of particles")};
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

// A contact's law by its word; that of penalty contacts is said by their lines.
inline void set_law(ContactPlan& contact, int word) {
    contact.at_surfaces = word == surface_law_word;
    contact.law = contact.at_surfaces ? GRIT_CONTACT_FRICTIONAL : word;
}
inline int law_of(const ContactPlan& contact) {
    return contact.at_surfaces ? surface_law_word : contact.law;
}

}  // namespace words

}  // namespace grit::mpm
