// SPDX-License-Identifier: BSD-3-Clause
// grit_contact_surfaces_add: the loop over particles. A particle is checked against all its nodes
// before it changes one.
#include <algorithm>
#include <cmath>

#include "contact/distance/surfaces.hpp"
#include "contact/normals/limits.hpp"
#include "support/vector.hpp"

namespace grit {
namespace {

constexpr int most_sides = 3;

struct Domain {
    Vector3 x{}, r[most_sides] = {};
    const std::ptrdiff_t* first = nullptr;
    const std::ptrdiff_t* last = nullptr;
};

struct Reach {
    double surface, centre;
    bool has_normal;
};

class Adding {
  public:
    Adding(const grit_contact_surfaces& surfaces, const grit_contact_domains& domains)
        : s(surfaces), d(domains) {}

    grit_status add(std::ptrdiff_t i, grit_error* error) const {
        Domain p;
        GRIT_CHECK(read(i, p, error));
        for (const auto* k = p.first; k != p.last; ++k) GRIT_CHECK(check_node(i, *k, error));
        for (const auto* k = p.first; k != p.last; ++k)
            if (*k >= 0) lower(*k, reach(p, *k));
        return GRIT_OK;
    }

  private:
    grit_status read(std::ptrdiff_t i, Domain& p, grit_error* error) const {
        const std::ptrdiff_t at = d.index ? d.index[i] : i;
        const std::ptrdiff_t first = d.offset ? d.offset[at] : at * d.nodes_each;
        const std::ptrdiff_t last = d.offset ? d.offset[at + 1] : first + d.nodes_each;
        if (!is_range(first, last))
            return refuse_range(first, last, i, {"particle", i, "offset"}, error);
        p.first = d.node + first;
        p.last = d.node + last;
        for (int c = 0; c < s.components; ++c) {
            p.x[c] = component(d.position, at, c);
            if (!(std::fabs(p.x[c]) <= largest_number))
                return failure(error, GRIT_BAD_STATE, i,
                               "particle %td: position component %d must be within %g, got %g", i,
                               c, largest_number, p.x[c]);
        }
        for (int j = 0; j < d.sides; ++j)
            for (int c = 0; c < s.components; ++c) {
                p.r[j][c] = d.side.base[at * d.side.point_stride + j * d.side.row_stride +
                                        c * d.side.column_stride];
                if (!(std::fabs(p.r[j][c]) <= largest_number))
                    return failure(error, GRIT_BAD_STATE, i,
                                   "particle %td: component %d of side %d must be within %g, got "
                                   "%g",
                                   i, c, j, largest_number, p.r[j][c]);
            }
        return GRIT_OK;
    }

    grit_status check_node(std::ptrdiff_t i, std::ptrdiff_t node, grit_error* error) const {
        if (node == -1) return GRIT_OK;
        if (!is_index(node, s.nodes))
            return refuse_index(node, s.nodes, i, {"particle", i, "node id"}, error, ", or -1");
        double square = 0.0;
        for (int c = 0; c < s.components; ++c) {
            const double x = component(s.position, node, c), n = component(s.normal, node, c);
            if (!(std::fabs(x) <= largest_number))
                return failure(error, GRIT_BAD_STATE, i,
                               "particle %td: position component %d of node %td must be within %g, "
                               "got %g",
                               i, c, node, largest_number, x);
            square += n * n;
        }
        if (!(square == 0.0 || std::fabs(square - 1.0) <= normal_tolerance))
            return failure(error, GRIT_BAD_STATE, i,
                           "particle %td: |normal|^2 of node %td must be within %g of 1, or 0, "
                           "got %g",
                           i, node, normal_tolerance, square);
        return GRIT_OK;
    }

    // From the farthest corner along the outward normal of the body to the node, (C4).
    Reach reach(const Domain& p, std::ptrdiff_t node) const {
        Vector3 n{};
        double to_node = 0.0, half_width = 0.0, square = 0.0, n_n = 0.0;
        const double outward = d.body == GRIT_CONTACT_BODY_A ? 1.0 : -1.0;
        for (int c = 0; c < s.components; ++c) {
            n[c] = outward * component(s.normal, node, c);
            n_n += n[c] * n[c];
            const double apart = component(s.position, node, c) - p.x[c];
            to_node += apart * n[c];
            square += apart * apart;
        }
        for (int j = 0; j < d.sides; ++j) half_width += std::fabs(dot(p.r[j], n));
        return {to_node - half_width, s.centre.base ? std::sqrt(square) : 0.0, n_n > 0.0};
    }

    void lower(std::ptrdiff_t node, const Reach& reached) const {
        if (reached.has_normal) {
            double& surface = component(s.surface, node, d.body);
            surface = std::min(surface, reached.surface);
        }
        if (s.centre.base) {
            double& centre = component(s.centre, node, d.body);
            centre = std::min(centre, reached.centre);
        }
    }

    const grit_contact_surfaces& s;
    const grit_contact_domains& d;
};

grit_status check_domains(const grit_contact_surfaces& s, const grit_contact_domains& d,
                          grit_error* error) {
    GRIT_CHECK(check_body(d.body, "body", error));
    GRIT_REQUIRE(d.sides >= 0 && d.sides <= most_sides, "sides must be in [0, %d], got %d",
                 most_sides, d.sides);
    if (!d.offset) GRIT_CHECK(check_count(d.nodes_each, "nodes_each", error));
    GRIT_CHECK(check_given(d.node, "node", error));
    const struct {
        const grit_view& view;
        const char* name;
    } inputs[] = {{s.position, "position of the nodes"},
                  {s.normal, "normal"},
                  {d.position, "position of the particles"}};
    for (const auto& input : inputs)
        GRIT_CHECK(check_usable(input.view, s.components, input.name, error));
    return d.sides == 0 ? GRIT_OK : check_usable(d.side, "side", error);
}

}  // namespace
}  // namespace grit

extern "C" grit_status grit_contact_surfaces_add(const grit_contact_surfaces* surfaces, ptrdiff_t n,
                                                 const grit_contact_domains* domains,
                                                 grit_error* error) {
    using namespace grit;
    GRIT_CHECK(check_given(domains, {"grit_contact_surfaces_add", "domains"}, error));
    GRIT_CHECK(check_count(n, {"grit_contact_surfaces_add", "n"}, error));
    grit_contact_surfaces s{};
    GRIT_CHECK(read_surfaces(surfaces, s, error));
    grit_contact_domains d{};
    GRIT_CHECK(read_struct(domains, d, "grit_contact_domains", error));
    if (n == 0) return GRIT_OK;  // an empty array may have no base pointer
    GRIT_CHECK(check_domains(s, d, error));
    const Adding adding(s, d);
    grit_status result = GRIT_OK;
    for (ptrdiff_t i = 0; i < n; ++i) {
        const grit_status status = adding.add(i, result == GRIT_OK ? error : nullptr);
        if (result == GRIT_OK) result = status;
    }
    return result;
}
