// SPDX-License-Identifier: BSD-3-Clause
#include "robustness/distance_trials.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include <grit/contact_distance.h>
#include <grit/contact_normals.h>

#include "robustness/layout.hpp"
#include "robustness/program_text.hpp"
#include "robustness/vec.hpp"

namespace robustness {
namespace {

enum Count { scenes, nodes_reached, nodes_between, refused };
enum Largest { distance_error, centre_error };
enum Rule {
    known_status,
    is_the_smallest,
    is_the_nearest_centre,
    same_bits,
    does_not_see_names,
    bad_adds_nothing,
    ends_as_told
};

const Vocabulary words = {
    {"calls", "nodes that a body reached", "that both reached", "particles refused"},
    {"error of a distance, over the terms of its sum", "error of the distance to a centre"},
    {"a status is one of a call",
     "a distance is the smallest of all corners in long double, to 2e-15",
     "a centre's distance is the smallest in long double, to 2e-15",
     "any order, parts that are merged, lists and strides give the same bits",
     "bodies exchanged, with opposite normals, give the same bits",
     "a particle that is refused adds nothing, the others are added",
     "distance and gap are what the header says of the minima"}};

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t most_sides = 3;

struct Particle {
    Vec x{};
    std::array<Vec, most_sides> side{};
    std::vector<std::ptrdiff_t> nodes;
    int body = 0;
};

struct Scene {
    int components = 2, sides = 2;
    std::vector<Vec> position, normal;
    std::vector<Particle> particles;

    std::ptrdiff_t nodes() const { return static_cast<std::ptrdiff_t>(position.size()); }
};

// Of both bodies at each node.
struct Minima {
    std::vector<std::array<double, 2>> surface, centre;
    grit_status status = GRIT_OK;

    bool same(const Minima& other) const {
        const std::size_t bytes = surface.size() * sizeof(surface[0]);
        return std::memcmp(surface.data(), other.surface.data(), bytes) == 0 &&
               std::memcmp(centre.data(), other.centre.data(), bytes) == 0;
    }
};

Scene random_scene(Random& random) {
    Scene s;
    s.components = 2 + random.below(2);
    s.sides = random.below(static_cast<int>(most_sides) + 1);
    const double cell = random.log_uniform(1e-60, 1e60);
    const int nodes = 1 + random.below(12), particles = 1 + random.below(24);
    const auto lengths = [&](double size) {
        Vec v = random_vector(random, s.components);
        for (double& each : v) each *= size * cell;
        return v;
    };
    for (int i = 0; i < nodes; ++i) {
        s.position.push_back(lengths(1.0));
        s.normal.push_back(random.below(8) ? random_normal(random, s.components) : Vec{});
        // Hosts' normals are as long as their roundoff lets them be.
        if (random.below(8) == 0)
            for (double& each : s.normal.back()) each *= 1.0 + random.uniform(-4e-7, 4e-7);
    }
    for (int k = 0; k < particles; ++k) {
        Particle p;
        p.body = random.below(2);
        p.x = random.below(12) ? lengths(1.0)
                               : s.position[static_cast<std::size_t>(random.below(nodes))];
        const double size = random.below(3) ? 0.5 : random.log_uniform(1e-12, 1e6);
        for (Vec& each : p.side) each = random.below(12) ? lengths(size) : Vec{};
        const int reached = random.below(nodes + 3);
        for (int j = 0; j < reached; ++j)
            p.nodes.push_back(random.below(6) ? random.below(nodes) : -1);
        if (random.below(60) == 0) p.x[0] = random.below(2) ? NAN : 1e101;
        if (s.sides > 0 && random.below(60) == 0)
            p.side[0][1] = random.below(2) ? -INFINITY : 2e100;
        if (random.below(60) == 0) p.nodes.push_back(random.below(2) ? nodes : -2);
        s.particles.push_back(p);
    }
    if (random.below(60) == 0) s.position[0][0] = NAN;
    if (random.below(60) == 0) s.normal[0] = {0.5, 0.0, 0.0};
    return s;
}

// The host's arrays of the nodes, with or without the minima's.
class Nodes {
  public:
    Nodes(Random& random, const Scene& scene)
        : s(scene), position(random, s.nodes(), s.components),
          normal(random, s.nodes(), s.components), surface(random, s.nodes(), 2),
          centre(random, s.nodes(), 2) {
        for (std::ptrdiff_t i = 0; i < s.nodes(); ++i) {
            position.put(i, s.position[static_cast<std::size_t>(i)].data());
            normal.put(i, s.normal[static_cast<std::size_t>(i)].data());
        }
        view.struct_size = sizeof view;
        view.components = s.components;
        view.nodes = s.nodes();
        view.position = position.in();
        view.normal = normal.in();
        view.surface = surface.out();
        view.centre = centre.out();
        grit_contact_surfaces_reset(&view, nullptr);
    }
    Minima minima() const {
        Minima out;
        for (std::ptrdiff_t i = 0; i < s.nodes(); ++i) {
            out.surface.push_back({});
            out.centre.push_back({});
            surface.get(i, out.surface.back().data());
            centre.get(i, out.centre.back().data());
        }
        return out;
    }
    grit_contact_surfaces view{};

  private:
    const Scene& s;
    Layout position, normal, surface, centre;
};

// Adds those of one body among the particles that are named, by one call.
grit_status add(Random& random, const Scene& s, const Nodes& nodes, int body,
                const std::vector<std::size_t>& which) {
    std::vector<const Particle*> mine;
    for (const std::size_t k : which)
        if (s.particles[k].body == body) mine.push_back(&s.particles[k]);
    if (mine.empty()) return GRIT_OK;
    const auto n = static_cast<std::ptrdiff_t>(mine.size()), places = n + random.below(3);
    const std::vector<std::ptrdiff_t> index = shuffled(random, places);
    std::vector<const Particle*> at(static_cast<std::size_t>(places), nullptr);
    for (std::size_t i = 0; i < mine.size(); ++i) at[static_cast<std::size_t>(index[i])] = mine[i];
    // Rows that are as long as the longest, or one after the other.
    std::size_t longest = 0;
    for (const Particle* p : mine) longest = std::max(longest, p->nodes.size());
    const bool listed = random.below(2);
    std::vector<std::ptrdiff_t> offset = {0}, node;
    Layout x(random, places, s.components);
    std::vector<double> side(static_cast<std::size_t>(places) * 9, NAN);
    for (std::ptrdiff_t i = 0; i < places; ++i) {
        const Particle* const p = at[static_cast<std::size_t>(i)];
        if (p) {
            node.insert(node.end(), p->nodes.begin(), p->nodes.end());
            x.put(i, p->x.data());
            for (std::size_t j = 0; j < most_sides; ++j)
                std::copy(p->side[j].begin(), p->side[j].end(),
                          side.begin() + static_cast<std::ptrdiff_t>(
                                             9 * i + 3 * static_cast<std::ptrdiff_t>(j)));
        }
        if (!listed) node.resize(static_cast<std::size_t>(i + 1) * longest, -1);
        offset.push_back(static_cast<std::ptrdiff_t>(node.size()));
    }
    node.push_back(-1);  // an empty array may have no base pointer
    grit_contact_domains d{};
    d.struct_size = sizeof d;
    d.body = body;
    d.sides = s.sides;
    d.index = index.data();
    if (listed) d.offset = offset.data();
    d.nodes_each = static_cast<std::ptrdiff_t>(longest);
    d.node = node.data();
    d.position = x.in();
    d.side = grit_matrix_view_of(side.data(), 9, 3, 1);
    return grit_contact_surfaces_add(&nodes.view, n, &d, nullptr);
}

Minima add_all(Random& random, const Scene& s) {
    Nodes nodes(random, s);
    std::vector<std::size_t> all(s.particles.size());
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = k;
    grit_status first = GRIT_OK;
    for (const int body : {0, 1}) {
        const grit_status status = add(random, s, nodes, body, all);
        if (first == GRIT_OK) first = status;
    }
    Minima out = nodes.minima();
    out.status = first;
    return out;
}

// One by one in any order, in two parts that are merged.
Minima add_in_parts(Random& random, const Scene& s) {
    Nodes one(random, s), other(random, s);
    for (const std::ptrdiff_t k :
         shuffled(random, static_cast<std::ptrdiff_t>(s.particles.size()))) {
        const auto p = static_cast<std::size_t>(k);
        add(random, s, random.below(2) ? one : other, s.particles[p].body, {p});
    }
    grit_contact_surfaces_merge(&one.view, &other.view, nullptr);
    return one.minima();
}

bool is_within(double x) { return std::fabs(x) <= 1e100; }

bool is_good(const Scene& s, const Particle& p) {
    for (std::size_t c = 0; c < 3; ++c) {
        if (!is_within(p.x[c])) return false;
        for (std::size_t j = 0; j < static_cast<std::size_t>(s.sides); ++j)
            if (!is_within(p.side[j][c])) return false;
    }
    for (const std::ptrdiff_t i : p.nodes) {
        if (i == -1) continue;
        if (i < 0 || i >= s.nodes()) return false;
        const auto at = static_cast<std::size_t>(i);
        const double square = dot(s.normal[at], s.normal[at]);
        if (!is_within(s.position[at][0]) || !(square == 0.0 || std::fabs(square - 1.0) <= 1e-6))
            return false;
    }
    return true;
}

std::string program_of(const Scene& s) {
    std::string nodes, normals, particles, sides, lists;
    for (const Vec& x : s.position) nodes += numbers(x.data(), 3, "") + ", ";
    for (const Vec& n : s.normal) normals += numbers(n.data(), 3, "") + ", ";
    std::string out =
        "#include <grit/grit.h>\n#include <stdio.h>\nint main(void) {\n    double x[] = {" + nodes +
        "}, n[] = {" + normals + "}, s[" + std::to_string(2 * s.nodes()) + "], c[" +
        std::to_string(2 * s.nodes()) + "];\n    grit_contact_surfaces q = {sizeof q, " +
        std::to_string(s.components) + ", 0, " + std::to_string(s.nodes()) +
        "};\n    q.position = grit_view_of(x, 3, 1); q.normal = grit_view_of(n, 3, 1);\n"
        "    q.surface = grit_mutable_view_of(s, 2, 1); q.centre = grit_mutable_view_of(c, 2, 1);\n"
        "    grit_contact_surfaces_reset(&q, 0);\n";
    for (const Particle& p : s.particles) {
        std::string ids;
        for (const std::ptrdiff_t i : p.nodes) ids += std::to_string(i) + ", ";
        out +=
            "    { double p[] = " + numbers(p.x.data(), 3) +
            ", r[] = " + numbers(p.side[0].data(), 9) + "; ptrdiff_t i[] = {" + ids +
            "-1}; grit_contact_domains d = {sizeof d, " + std::to_string(p.body) + ", " +
            std::to_string(s.sides) + "}; d.nodes_each = " + std::to_string(p.nodes.size()) +
            "; d.node = i; d.position = grit_view_of(p, 3, 1); d.side = "
            "grit_matrix_view_of(r, 9, 3, 1);\n      grit_contact_surfaces_add(&q, 1, &d, 0); }\n";
    }
    return out + "    for (int i = 0; i < " + std::to_string(s.nodes()) +
           "; ++i) printf(\"%.17g %.17g %.17g %.17g\\n\", s[2 * i], s[2 * i + 1], c[2 * i], c[2 * "
           "i + 1]);\n}\n";
}

// (C4) in long double over all corners of all domains.
void judge_minima(const Scene& s, const Minima& found, Findings& out) {
    using Real = long double;
    const auto program = [&] { return program_of(s); };
    for (std::size_t i = 0; i < s.position.size(); ++i) {
        const Vec& n = s.normal[i];
        std::array<Real, 2> smallest = {infinity, infinity}, nearest = smallest;
        Real terms = 0.0L, far = 0.0L;
        for (const Particle& p : s.particles) {
            if (!is_good(s, p)) continue;
            if (std::find(p.nodes.begin(), p.nodes.end(), static_cast<std::ptrdiff_t>(i)) ==
                p.nodes.end())
                continue;
            const auto body = static_cast<std::size_t>(p.body);
            const Real outward = p.body == GRIT_CONTACT_BODY_A ? 1.0L : -1.0L;
            Real square = 0.0L;
            for (std::size_t c = 0; c < 3; ++c) {
                const Real apart = static_cast<Real>(s.position[i][c]) - p.x[c];
                square += apart * apart;
                far = std::max({far, std::fabs(static_cast<Real>(s.position[i][c])),
                                std::fabs(static_cast<Real>(p.x[c]))});
            }
            nearest[body] = std::min(nearest[body], std::sqrt(square));
            for (unsigned corner = 0; corner < 1u << s.sides; ++corner) {
                Real along = 0.0L;
                for (std::size_t c = 0; c < 3; ++c) {
                    Real x = p.x[c];
                    for (std::size_t j = 0; j < static_cast<std::size_t>(s.sides); ++j) {
                        x += (corner >> j & 1u ? 1.0L : -1.0L) * p.side[j][c];
                        terms = std::max(terms, std::fabs(static_cast<Real>(p.side[j][c])));
                    }
                    along += (s.position[i][c] - x) * outward * n[c];
                }
                smallest[body] = std::min(smallest[body], along);
            }
        }
        terms += far;
        if (same(n, Vec{})) smallest = {infinity, infinity};
        const auto told = [&](double is, Real should, Real size, int most, int rule) {
            if (std::isinf(should)) {
                out.demand(rule, std::isinf(is) && is > 0.0, program);
                return;
            }
            const double error =
                size > 0.0L ? static_cast<double>(std::fabs(is - should) / size) : 0.0;
            out.measure(most, error);
            out.demand(rule, error <= 2e-15, program);
        };
        for (std::size_t body = 0; body < 2; ++body) {
            told(found.surface[i][body], smallest[body], terms, distance_error, is_the_smallest);
            told(found.centre[i][body], nearest[body], far, centre_error, is_the_nearest_centre);
        }
        const bool any = std::isfinite(nearest[0]) || std::isfinite(nearest[1]);
        if (any) out.count(nodes_reached);
        if (std::isfinite(nearest[0]) && std::isfinite(nearest[1])) out.count(nodes_between);
    }
}

void judge_end(Random& random, const Scene& s, const Minima& minima, Findings& out) {
    const auto program = [&] { return program_of(s); };
    Minima m = minima;
    grit_contact_surfaces q{};
    q.struct_size = sizeof q;
    q.components = s.components;
    q.nodes = s.nodes();
    q.surface = grit_mutable_view_of(m.surface[0].data(), 2, 1);
    q.centre = grit_mutable_view_of(m.centre[0].data(), 2, 1);
    const std::vector<std::ptrdiff_t> index = shuffled(random, s.nodes());
    Layout distance(random, s.nodes(), 1), gap(random, s.nodes(), 1);
    grit_contact_distances d{};
    d.struct_size = sizeof d;
    d.stiffer = random.below(2);
    d.measure = random.below(3);
    d.index = index.data();
    d.distance = distance.out();
    d.gap = gap.out();
    out.demand(known_status, grit_contact_surfaces_finish(&q, s.nodes(), &d, nullptr) == GRIT_OK,
               program);
    for (std::ptrdiff_t i = 0; i < s.nodes(); ++i) {
        const auto at = static_cast<std::size_t>(i), stiffer = static_cast<std::size_t>(d.stiffer);
        double is = 0.0, between = 0.0;
        distance.get(i, &is);
        gap.get(i, &between);
        const double surface = minima.surface[at][stiffer];
        const double should = d.measure == GRIT_CONTACT_SUPPORT ? surface
                              : d.measure == GRIT_CONTACT_EDGE  ? std::fabs(surface)
                                                                : minima.centre[at][stiffer];
        out.demand(ends_as_told,
                   is == should && between == minima.surface[at][0] + minima.surface[at][1],
                   program);
    }
}

void try_scene(Random& random, Findings& out) {
    const Scene s = random_scene(random);
    const auto program = [&] { return program_of(s); };
    out.count(scenes);
    const Minima found = add_all(random, s);
    const auto bad = std::count_if(s.particles.begin(), s.particles.end(),
                                   [&](const Particle& p) { return !is_good(s, p); });
    out.count(refused, bad);
    out.demand(known_status,
               found.status == GRIT_OK || found.status == GRIT_BAD_STATE ||
                   found.status == GRIT_BAD_CALL,
               program);
    out.demand(bad_adds_nothing, (found.status == GRIT_OK) == (bad == 0), program);
    judge_minima(s, found, out);
    out.demand(same_bits, add_in_parts(random, s).same(found), program);

    Scene exchanged = s;
    for (Vec& n : exchanged.normal)
        for (double& each : n) each = -each;
    for (Particle& p : exchanged.particles) p.body = 1 - p.body;
    Minima other = add_all(random, exchanged);
    for (std::vector<std::array<double, 2>>* each : {&other.surface, &other.centre})
        for (std::array<double, 2>& of : *each) std::swap(of[0], of[1]);
    out.demand(does_not_see_names, other.same(found), program);
    judge_end(random, s, found, out);
}

void run_distances(Random& random, long cases, Findings& out) {
    for (long i = 0; i < cases; ++i) try_scene(random, out);
}

}  // namespace

Kind distance_trials() { return {"distances", words, 20000, run_distances}; }

}  // namespace robustness
