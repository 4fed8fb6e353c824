// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/space/case/solids.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
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

Bounds bounds_of(const SurfaceShape& of) { return {of.surface->from(), of.surface->to()}; }

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
bool has(const SurfaceShape& of, const Vector3& x) { return of.surface->has(x); }
bool is_in(const SolidShape& shape, const Vector3& x) {
    return std::visit([&x](const auto& of) { return has(of, x); }, shape.of);
}
Bounds bounds_of(const SolidShape& shape) {
    return std::visit([](const auto& of) { return bounds_of(of); }, shape.of);
}

// What one shape of a body adds to those before it.
class Region {
  public:
    Region(const SpacePlan& plan, std::size_t body, std::size_t shape)
        : within(plan.bodies[body].shapes[shape]) {
        for (std::size_t n = 0; n < shape; ++n) without.push_back(&plan.bodies[body].shapes[n]);
        for (const std::size_t other : plan.bodies[body].outside_of)
            for (const SolidShape& of : plan.bodies[other].shapes) without.push_back(&of);
    }
    bool has(const Vector3& x) const {
        return is_in(within, x) && std::none_of(without.begin(), without.end(),
                                                [&x](const auto* of) { return is_in(*of, x); });
    }
    // Surely: all corners of the brick are within a convex shape, and nothing that is left out is near.
    bool has_all(const Vector3& centre, const Vector3& half) const {
        if (std::holds_alternative<SurfaceShape>(within.of)) return false;
        constexpr double almost = 1.0 - 1e-9;
        for (int corner = 0; corner < 8; ++corner) {
            Vector3 x = centre;
            for (int d = 0; d < 3; ++d) x[d] += (corner >> d & 1 ? almost : -almost) * half[d];
            if (!is_in(within, x)) return false;
        }
        return std::none_of(without.begin(), without.end(), [&](const auto* of) {
            const Bounds b = bounds_of(*of);
            bool near = true;
            for (int d = 0; d < 3; ++d)
                near = near && centre[d] + half[d] > b.from[d] && centre[d] - half[d] < b.to[d];
            return near;
        });
    }

  private:
    const SolidShape& within;
    std::vector<const SolidShape*> without;
};

// A brick, looked at in so many places, a multiple of 48: the part of it that a region has.
struct CutBrick {
    double share;                // of its volume
    Vector3 centre, half_sides;  // of the brick in its place [m]
};
CutBrick part_in(const Region& region, const Vector3& centre, const Vector3& half, int places) {
    // An additive recurrence in an eighth of the brick, no row of which lies along any side (Roberts' R3), in all orders of
    // the axes and with all signs: what is a mirror image of another brick is cut like it.
    constexpr double stride[3] = {0.8191725133961645, 0.6710436067037893, 0.5497004779019703};
    constexpr int order[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    double count = 0.0, first[3] = {}, second[3] = {};
    bool cut[3] = {};  // is some place within, but not the one half of the brick further along?
    const auto look = [&](const double(&at)[3]) {
        Vector3 x;
        for (int d = 0; d < 3; ++d) x[d] = centre[d] + at[d] * half[d];
        if (!region.has(x)) return;
        count += 1.0;
        for (int d = 0; d < 3; ++d) {
            first[d] += at[d];
            second[d] += at[d] * at[d];
            if (cut[d]) continue;
            Vector3 further = x;
            further[d] += at[d] > 0.0 ? -half[d] : half[d];
            cut[d] = !region.has(further);
        }
    };
    for (int i = 0; i < places / 48; ++i) {
        double base[3];
        for (int d = 0; d < 3; ++d) {
            const double s = 0.5 + (i + 0.5) * stride[d];
            base[d] = s - std::floor(s);
        }
        for (const auto& axes : order)
            for (int signs = 0; signs < 8; ++signs) {
                double at[3];
                for (int d = 0; d < 3; ++d) at[d] = (signs >> d & 1 ? -1.0 : 1.0) * base[axes[d]];
                look(at);
            }
    }
    CutBrick out{count / places, centre, half};
    if (count == 0.0 || out.share == 1.0) return out;
    // Sides in the ratio of radii of gyration, but for those along which nothing is cut.
    if (!cut[0] && !cut[1] && !cut[2]) cut[0] = cut[1] = cut[2] = true;  // seen in none: in all
    double side[3], product = 1.0;
    int directions = 0;
    for (int d = 0; d < 3; ++d) {
        const double mean = first[d] / count, square = 3.0 * (second[d] / count - mean * mean);
        side[d] = cut[d] ? std::sqrt(std::max(square, 0.0)) : 1.0;
        if (cut[d]) out.centre[d] += mean * half[d];
        directions += cut[d];
        product *= side[d];
    }
    const double scale = std::pow(out.share / product, 1.0 / directions);
    for (int d = 0; d < 3; ++d) out.half_sides[d] *= cut[d] ? scale * side[d] : 1.0;
    return out;
}

constexpr int few_places = 2 * 48, many_places = 125 * 48;  // of a brick
constexpr double least_share = 1.0 / 64.0;                  // of a brick: less is left out

std::optional<NewParticle> particle_in(const Region& region, const Vector3& centre,
                                       const Vector3& half, double density,
                                       const Vector3& velocity) {
    if (region.has_all(centre, half)) return NewParticle{centre, half, density, velocity};
    CutBrick part = part_in(region, centre, half, few_places);
    if (part.share > 0.0 && part.share < 1.0) part = part_in(region, centre, half, many_places);
    if (part.share < least_share) return {};
    return NewParticle{part.centre, part.half_sides, density, velocity};
}

std::string word_of(const Vector3& x) {
    std::string out = "(";
    for (int d = 0; d < 3; ++d) out.append(text(x[d])).append(d < 2 ? ", " : ") m");
    return out;
}

// Of a round shape around a plane of symmetry, a side that rolls, the half is meant.
void check_inside(const SpacePlan& plan, const SolidShape& shape, const Axes& axes,
                  const std::string& name) {
    const Bounds b = bounds_of(shape);
    const bool is_box = std::holds_alternative<BoxShape>(shape.of);
    for (std::size_t d = 0; d < 3; ++d) {
        const int k = static_cast<int>(d);
        const double middle = 0.5 * (b.from[k] + b.to[k]), size = b.to[k] - b.from[k];
        const double side[] = {axes[d][0], axes[d][axes[d].nodes() - 1]};
        const auto is_halved = [&](std::size_t upper) {
            return !is_box && d < 2 && plan.boundary[2 * d + upper] == Boundary::roller &&
                   std::fabs(middle - side[upper]) <= 1e-6 * size;  // of floats in files
        };
        if ((b.from[k] < side[0] && !is_halved(0)) || (b.to[k] > side[1] && !is_halved(1)))
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
    bool covers(const Vector3& x) const {
        for (const std::ptrdiff_t p : cells[static_cast<std::size_t>(grid.cell_of(x))]) {
            bool in = true;
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

namespace {

// take(region, centre, half) of each brick that shapes of a body may fill, or a part of it: of each shape, row by row.
template <class Take>
void each_brick(const SpacePlan& plan, std::size_t body, const std::string& name, const Axes& axes,
                const Take& take) {
    double asked = 0.0;
    const SolidPlan& solid = plan.bodies[body];
    for (std::size_t n = 0; n < solid.shapes.size(); ++n) {
        const SolidShape& shape = solid.shapes[n];
        check_inside(plan, shape, axes, name);
        const Bounds b = bounds_of(shape);
        std::vector<Slab> along[3];
        for (std::size_t d = 0; d < 3; ++d) {
            const int k = static_cast<int>(d);
            along[d] = cut(axes[d], b.from[k], b.to[k], shape.particles[d]);
        }
        asked += static_cast<double>(along[0].size()) * static_cast<double>(along[1].size()) *
                 static_cast<double>(along[2].size());
        check_particles(asked, name);
        const Region region(plan, body, n);
        for (const Slab& z : along[2])
            for (const Slab& y : along[1])
                for (const Slab& x : along[0])
                    take(region, Vector3{x.centre, y.centre, z.centre},
                         Vector3{x.half, y.half, z.half});
    }
}

// What a brick shows along a direction: where it ends in a line of sight, and nothing of the body is beyond.
struct Shown {
    double area = 0.0;   // of the brick, seen along the direction, once for each such end [m2]
    double share = 0.0;  // ... of what of its outer side is within
};
Shown shown(const Region& region, const std::vector<Region>& all, const Vector3& centre,
            const Vector3& half, const FacePlan& face) {
    constexpr int lines = 24, steps = 12;
    constexpr double almost = 1.0 - 1e-9;
    const int d = face.across, a = (d + 1) % 3, b = (d + 2) % 3;
    const double outward = face.upper ? 1.0 : -1.0;
    const auto is_of_body = [&all](const Vector3& x) {
        return std::any_of(all.begin(), all.end(), [&x](const Region& of) { return of.has(x); });
    };
    const bool is_whole = region.has_all(centre, half);
    Vector3 beyond = centre;
    beyond[d] += 2.0 * outward * half[d];
    if (is_whole && std::any_of(all.begin(), all.end(),
                                [&](const Region& of) { return of.has_all(beyond, half); }))
        return {};
    if (!is_whole) {
        const double share = part_in(region, centre, half, few_places).share;
        if (share == 0.0) return {};
        // Deep in a surface that no corner tells from its outside.
        if (share == 1.0 && std::any_of(all.begin(), all.end(), [&](const Region& of) {
                return part_in(of, beyond, half, few_places).share == 1.0;
            }))
            return {};
    }
    int seen = 0, at_side = 0, seen_at_side = 0;
    for (int i = 0; i < lines; ++i)
        for (int j = 0; j < lines; ++j) {
            Vector3 x = centre;
            x[a] += ((2 * i + 1.0) / lines - 1.0) * half[a];
            x[b] += ((2 * j + 1.0) / lines - 1.0) * half[b];
            const auto at = [&](double share) {
                x[d] = centre[d] + outward * share * half[d];
                return x;
            };
            bool is_in = is_whole || region.has(at(-almost));
            for (int k = 1; k <= steps && !is_whole; ++k) {
                const bool next = region.has(at((2.0 * k / steps - 1.0) * almost));
                seen += is_in && !next && !is_of_body(x);
                is_in = next;
            }
            const bool ends = is_in && !is_of_body(at(1.0 / almost));
            at_side += is_in;
            seen_at_side += ends;
            seen += ends;
        }
    return {4.0 * half[a] * half[b] * seen / (lines * lines),
            at_side > 0 ? double(seen_at_side) / at_side : 0.0};
}

}  // namespace

Particles fill(const SpacePlan& plan, std::size_t body, const std::string& name, double density,
               const Axes& axes, int own_columns) {
    Particles out(own_columns);
    const auto add = [&](const Region& region, const Vector3& centre, const Vector3& half) {
        if (const auto particle =
                particle_in(region, centre, half, density, plan.bodies[body].velocity))
            out.add(*particle);
    };
    each_brick(plan, body, name, axes, add);
    if (out.size() == 0)
        throw std::invalid_argument("body " + name + ": nothing is inside of its shapes");
    return out;
}

// A particle whose brick is cut along the direction has the area that the brick shows; where any is, all together have what
// all bricks show, those too of which so little is left that they have no particle.
std::vector<OuterFace> outermost(const SpacePlan& plan, std::size_t body, const Axes& axes,
                                 const FacePlan& face, const std::string& name) {
    std::vector<Region> all;
    for (std::size_t n = 0; n < plan.bodies[body].shapes.size(); ++n)
        all.emplace_back(plan, body, n);
    const int d = face.across, a = (d + 1) % 3, b = (d + 2) % 3;
    std::vector<OuterFace> out;
    int next = 0;
    double seen = 0.0, loaded = 0.0;  // [m2]
    bool any_cut = false;
    each_brick(plan, body, name, axes,
               [&](const Region& region, const Vector3& centre, const Vector3& half) {
                   const auto particle = particle_in(region, centre, half, 1.0, {0.0, 0.0, 0.0});
                   const int id = particle ? next++ : -1;
                   const Vector3 at = particle ? particle->centre : centre;
                   for (int k = 0; k < 3; ++k)
                       if (!(at[k] >= face.range[k][0] && at[k] <= face.range[k][1])) return;
                   const Shown here = shown(region, all, centre, half, face);
                   seen += here.area;
                   if (!particle) return;
                   const double area = 4.0 * particle->half_sides[a] * particle->half_sides[b];
                   const bool is_cut = particle->half_sides[d] != half[d];
                   const double share = is_cut ? here.area / area : here.share;
                   if (!(share > 0.0)) return;
                   any_cut = any_cut || is_cut;
                   loaded += share * area;
                   out.push_back({id, share});
               });
    if (out.empty())
        throw std::invalid_argument("traction on body " + name +
                                    ": no outermost face in its range");
    for (OuterFace& of : out)
        if (any_cut) of.share *= seen / loaded;
    return out;
}

bool comes_to(const SolidPlan& body, int along, double place, bool from_above, double distance) {
    return std::any_of(body.shapes.begin(), body.shapes.end(), [&](const SolidShape& shape) {
        const Bounds b = bounds_of(shape);
        return from_above ? b.from[along] <= place + distance : b.to[along] >= place - distance;
    });
}

void check_boxes_apart(const SolidPlan& one, const SolidPlan& other, const std::string& names) {
    constexpr double roundoff = 1e-9;
    for (const SolidShape& mine : one.shapes)
        for (const SolidShape& theirs : other.shapes) {
            const auto* a = std::get_if<BoxShape>(&mine.of);
            const auto* b = std::get_if<BoxShape>(&theirs.of);
            if (!a || !b) continue;
            bool meet = true;
            Vector3 from, to;
            for (int d = 0; d < 3; ++d) {
                from[d] = std::max(a->from[d], b->from[d]);
                to[d] = std::min(a->to[d], b->to[d]);
                const double least = std::min(a->to[d] - a->from[d], b->to[d] - b->from[d]);
                meet = meet && to[d] - from[d] > roundoff * least;
            }
            if (meet)
                throw std::invalid_argument("bodies " + names + " share the place from " +
                                            word_of(from) + " to " + word_of(to));
        }
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
