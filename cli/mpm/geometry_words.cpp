// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/geometry_words.hpp"

#include <utility>

namespace cli {

const GeometryWords& words_of(const grit::mpm::Case& plan) {
    static constexpr GeometryWords around_an_axis{
        "r", "of the whole bodies (2 pi radians)", "", "tip", "shaft", "hammer", "sideways"};
    static constexpr GeometryWords in_a_plane{"x",    "per metre", "/m",     "under",
                                              "side", "load",      "along x"};
    static constexpr GeometryWords in_space{
        "x", "of what is computed in space", "", "under", "side", "load", "sideways"};
    return plan.space ? in_space : plan.settings.axisymmetric ? around_an_axis : in_a_plane;
}

std::string name_in_plane_strain(const std::string& field) {
    static constexpr std::pair<const char*, const char*> components[] = {
        {"_rr", "_xx"}, {"_rz", "_xz"}, {"_zr", "_zx"}, {"_tt", "_yy"}};
    for (const auto& [around, plane] : components)
        if (field.ends_with(around)) return field.substr(0, field.size() - 3) + plane;
    return field;
}

}  // namespace cli
