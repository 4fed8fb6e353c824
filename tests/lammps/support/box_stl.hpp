// SPDX-License-Identifier: BSD-3-Clause
// The surface of a box as the text of an STL file.
#pragma once

#include <string>
#include <vector>

#include <adapters/mpm/case/closed_surface.hpp>

inline std::string stl_of_box(const grit::Vector3& from, const grit::Vector3& to) {
    const auto corner = [&](int n) {
        return grit::Vector3{n & 1 ? to[0] : from[0], n & 2 ? to[1] : from[1],
                             n & 4 ? to[2] : from[2]};
    };
    const int sides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                             {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    std::vector<grit::mpm::ClosedSurface::Triangle> out;
    for (const auto& side : sides)
        for (const int k : {1, 2})
            out.push_back({corner(side[0]), corner(side[k]), corner(side[k + 1])});
    return stl_text(grit::mpm::ClosedSurface(out));
}
