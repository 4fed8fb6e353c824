// SPDX-License-Identifier: BSD-3-Clause
// Calls of the sand as no sane host makes them: parameters over their whole ranges, states and strains far beyond what one
// asks for, in memory of any layout; and the program that makes such a call again.
#pragma once

#include <string>
#include <vector>

#include <grit/grit.h>

#include "robustness/campaign.hpp"
#include "robustness/layout.hpp"

namespace robustness {

// What one call is told, and one point.
struct Call {
    grit_sand_parameters parameters;
    grit_sand sand;
    grit_sand_options options;
    int components = 6;
    bool rotated = false, advised = false, of_catalogue = false;
};
struct Point {
    double strain[6] = {}, rotation[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, stress[6] = {},
           state[GRIT_SAND_STATE_SIZE] = {}, substep = 0.0, tangent[36] = {};
    grit_sand_report report{};
};

Call random_call(Random& random);
Point random_point(Random& random, const Call& call);
grit_sand_points views_of(const Call& call, Point& x);

// The same stress, state, tangent and substep, to the bit.
bool same(const Point& a, const Point& b);
bool same_report(const Point& a, const Point& b);

bool with_memory(const Call& call);
double norm_of_stress(const double* T);
double norm_of_strain(const double* E);
// Where F has the tip of a cone.
bool near_axis(const double* T);
bool all_finite(const double* x, int n);
// What a call takes for a rotation: orthogonal, by a margin within its 1e-8.
bool is_rotation(const double* Q);

// A random symmetric tensor of this norm, as stress (1) or engineering strain (2); four components in the plane.
void random_tensor(Random& random, double length, double shear_factor, int components,
                   double out[6]);

// Points in memory as a host may have it and in any order.
class Scattered {
  public:
    Scattered(Random& random, const Call& call, std::ptrdiff_t n);
    std::ptrdiff_t places() const { return static_cast<std::ptrdiff_t>(index.size()); }
    std::ptrdiff_t place(std::ptrdiff_t i) const { return index[static_cast<std::size_t>(i)]; }
    void put(const std::vector<Point>& points);
    grit_sand_points views() const;
    void get(std::vector<Point>& points, const std::vector<grit_sand_report>& reports) const;

  private:
    std::ptrdiff_t components;
    bool rotated, advised, listed = false;
    std::vector<std::ptrdiff_t> index;
    Layout strain, rotation, stress, state, tangent, substep;
};

// A program that makes this call and prints what it says. calls: the statements that make it, of sand, o, the point x and
// its report r; says: those that print more of it.
std::string program_of(const Call& call, const Point& x,
                       const std::string& calls = "grit_sand_update(&sand, &o, 1, &x, &r, 0);",
                       const std::string& says = "");

}  // namespace robustness
