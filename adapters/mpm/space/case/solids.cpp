// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/space/case/solids.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "adapters/mpm/case/slabs.hpp"
#include "adapters/mpm/space/kernel/call.hpp"
#include "adapters/mpm/step/text.hpp"

namespace grit::mpm::space {
namespace {

struct Bounds {
    Vector3 from, to;
};

Bounds bounds_of(const BoxShape& box) { return {box.from, box.to}; }
Bounds bounds_of(const ConeShape& cone) {
    const double r = std::max(cone.radius[0], cone.radius[1]);
    return {{cone.centre[0] - r, cone.centre[1] - r, cone.z[0]},
            {cone.centre[0] + r, cone.centre[1] + r, cone.z[1]}};
}
Bounds bounds_of(const SphereShape& sphere) {
    const Vector3 r{sphere.radius, sphere.radius, sphere.radius};
    return {sphere.centre - r, sphere.centre + r};
}

bool has(const BoxShape& box, const Vector3& x) {
    bool in = true;
    for (int d = 0; d < 3; ++d) in = in && x[d] > box.from[d] && x[d] < box.to[d];
    return in;
}
bool has(const ConeShape& cone, const Vector3& x) {
    const double share = (x[2] - cone.z[0]) / (cone.z[1] - cone.z[0]);
    const double r = cone.radius[0] + share * (cone.radius[1] - cone.radius[0]);
    return share > 0.0 && share < 1.0 &&
           std::hypot(x[0] - cone.centre[0], x[1] - cone.centre[1]) < r;
}
bool has(const SphereShape& sphere, const Vector3& x) {
    return norm(x - sphere.centre) < sphere.radius;
}
bool is_in(const Shape3& shape, const Vector3& x) {
    return std::visit([&x](const auto& of) { return has(of, x); }, shape);
}

std::string word_of(const Vector3& x) {
    std::string out = "(";
    for (int d = 0; d < 3; ++d) out.append(text(x[d])).append(d < 2 ? ", " : ") m");
    return out;
}

// A quarter or a half of a round shape may be meant: what lies beyond the grid is cut off, its centre must not.
void check_inside(const Shape3& shape, const Axes& axes, const std::string& name) {
    const Bounds b = std::visit([](const auto& of) { return bounds_of(of); }, shape);
    const bool is_box = std::holds_alternative<BoxShape>(shape);
    for (std::size_t d = 0; d < 3; ++d) {
        const int k = static_cast<int>(d);
        const double middle = 0.5 * (b.from[k] + b.to[k]), first = axes[d][0];
        const double last = axes[d][axes[d].nodes() - 1];
        const bool inside = is_box || d == 2 ? b.from[k] >= first && b.to[k] <= last
                                             : middle >= first && middle <= last;
        if (!inside)
            throw std::invalid_argument("body " + name + " reaches out of the grid between " +
                                        word_of(b.from) + " and " + word_of(b.to));
    }
}

// Undeformed particles by the cell of their centre.
class CellList {
  public:
    CellList(Particles& particles, const Axes& axes)
        : q(particles.view()), grid{{axes[0].view(), axes[1].view(), axes[2].view()}},
          cells(static_cast<std::size_t>(axes[0].cells()) *
                static_cast<std::size_t>(axes[1].cells()) *
                static_cast<std::size_t>(axes[2].cells())) {
        for (std::ptrdiff_t p = 0; p < particles.size(); ++p)
            cells[static_cast<std::size_t>(grid.cell_of(q.position(p)))].push_back(p);
    }
    // A particle covers this place, but none that is left out.
    bool covers(const Vector3& x, std::ptrdiff_t left_out = -1) const {
        for (const std::ptrdiff_t p : cells[static_cast<std::size_t>(grid.cell_of(x))]) {
            bool in = p != left_out;
            for (int d = 0; d < 3; ++d)
                in = in && std::fabs(q[column::x + d][p] - x[d]) <= q[column::l_x + d][p];
            if (in) return true;
        }
        return false;
    }

  private:
    ParticleView q;
    GridView grid;
    std::vector<std::vector<std::ptrdiff_t>> cells;
};

}  // namespace

Particles fill(const SolidPlan& plan, const std::string& name, double density, const Axes& axes,
               int own_columns) {
    Particles out(own_columns);
    double asked = 0.0;
    for (std::size_t n = 0; n < plan.shapes.size(); ++n) {
        check_inside(plan.shapes[n], axes, name);
        const Bounds b = std::visit([](const auto& of) { return bounds_of(of); }, plan.shapes[n]);
        std::vector<Slab> along[3];
        for (std::size_t d = 0; d < 3; ++d) {
            const int k = static_cast<int>(d);
            along[d] = cut(axes[d], b.from[k], b.to[k], plan.particles[d]);
        }
        asked += static_cast<double>(along[0].size()) * static_cast<double>(along[1].size()) *
                 static_cast<double>(along[2].size());
        check_particles(asked, name);
        for (const Slab& z : along[2])
            for (const Slab& y : along[1])
                for (const Slab& x : along[0]) {
                    const Vector3 centre{x.centre, y.centre, z.centre};
                    const auto here = [&](const Shape3& shape) { return is_in(shape, centre); };
                    const auto before = plan.shapes.begin() + static_cast<std::ptrdiff_t>(n);
                    if (here(*before) && std::none_of(plan.shapes.begin(), before, here))
                        out.add({centre, {x.half, y.half, z.half}, density, plan.velocity});
                }
    }
    if (out.size() == 0)
        throw std::invalid_argument("body " + name + ": no particle has its centre inside");
    return out;
}

std::vector<int> outermost(Particles& particles, const Axes& axes, const FacePlan& face,
                           const std::string& name) {
    const ParticleView q = particles.view();
    const CellList list(particles, axes);
    std::vector<int> out;
    for (std::ptrdiff_t p = 0; p < particles.size(); ++p) {
        Vector3 beyond = q.position(p);
        bool in = true;
        for (int d = 0; d < 3; ++d)
            in = in && beyond[d] >= face.range[d][0] && beyond[d] <= face.range[d][1];
        beyond[face.across] += (face.upper ? 1.001 : -1.001) * q[column::l_x + face.across][p];
        if (in && !list.covers(beyond, p)) out.push_back(particles.ids()[p]);
    }
    if (out.empty())
        throw std::invalid_argument("traction on body " + name +
                                    ": no outermost face in its range");
    return out;
}

void check_apart(Particles& one, Particles& other, const Axes& axes, const std::string& names) {
    const CellList list(other, axes);
    for (std::ptrdiff_t p = 0; p < one.size(); ++p) {
        const Vector3 at = one.view().position(p);
        if (list.covers(at))
            throw std::invalid_argument("bodies " + names + " share the place " + word_of(at));
    }
}

}  // namespace grit::mpm::space
