// SPDX-License-Identifier: BSD-3-Clause
// grit_contact_surfaces_add: the loop over particles. A particle is checked against all its nodes
// before it changes one.
#define GRIT_TARGET c_api
#include <algorithm>
#include <cmath>

#include "contact/distance/surfaces.hpp"
#include "contact/nodal/node_checks.hpp"

namespace grit {
namespace {

constexpr int most_sides = 3;

struct Domain {
    double x[3] = {0.0, 0.0, 0.0};
    double r[most_sides][3] = {};
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
        if (const grit_status status = read(i, p, error)) return status;
        for (const auto* k = p.first; k != p.last; ++k)
            if (const grit_status status = check_node(i, *k, error)) return status;
        for (const auto* k = p.first; k != p.last; ++k)
            if (*k >= 0) lower(*k, reach(p, *k));
        return GRIT_OK;
    }

  private:
    grit_status read(std::ptrdiff_t i, Domain& p, grit_error* error) const {
        const std::ptrdiff_t at = d.index ? d.index[i] : i;
        const std::ptrdiff_t first = d.offset ? d.offset[at] : at * d.nodes_each;
        const std::ptrdiff_t last = d.offset ? d.offset[at + 1] : first + d.nodes_each;
        if (!(first >= 0 && first <= last))
            return failure(error, GRIT_BAD_CALL, i,
                           "particle %td: offset must start at >= 0 and not decrease, got %td and "
                           "%td",
                           i, first, last);
        p.first = d.node + first;
        p.last = d.node + last;
        for (int c = 0; c < s.components; ++c) {
            p.x[c] = component(d.position, at, c);
            if (!(std::fabs(p.x[c]) <= c_api::largest_number))
                return failure(error, GRIT_BAD_STATE, i,
                               "particle %td: position component %d must be within %g, got %g", i,
                               c, c_api::largest_number, p.x[c]);
        }
        for (int j = 0; j < d.sides; ++j)
            for (int c = 0; c < s.components; ++c) {
                p.r[j][c] = d.side.base[at * d.side.point_stride + j * d.side.row_stride +
                                        c * d.side.column_stride];
                if (!(std::fabs(p.r[j][c]) <= c_api::largest_number))
                    return failure(error, GRIT_BAD_STATE, i,
                                   "particle %td: component %d of side %d must be within %g, got "
                                   "%g",
                                   i, c, j, c_api::largest_number, p.r[j][c]);
            }
        return GRIT_OK;
    }

    grit_status check_node(std::ptrdiff_t i, std::ptrdiff_t node, grit_error* error) const {
        if (node == -1) return GRIT_OK;
        if (!(node >= 0 && node < s.nodes))
            return failure(error, GRIT_BAD_CALL, i,
                           "particle %td: node id must be in [0, %td), or -1, got %td", i, s.nodes,
                           node);
        double square = 0.0;
        for (int c = 0; c < s.components; ++c) {
            const double x = component(s.position, node, c), n = component(s.normal, node, c);
            if (!(std::fabs(x) <= c_api::largest_number))
                return failure(error, GRIT_BAD_STATE, i,
                               "particle %td: position component %d of node %td must be within %g, "
                               "got %g",
                               i, c, node, c_api::largest_number, x);
            square += n * n;
        }
        if (!(square == 0.0 || std::fabs(square - 1.0) <= c_api::normal_tolerance))
            return failure(error, GRIT_BAD_STATE, i,
                           "particle %td: |normal|^2 of node %td must be within %g of 1, or 0, "
                           "got %g",
                           i, node, c_api::normal_tolerance, square);
        return GRIT_OK;
    }

    // From the farthest corner along the outward normal of the body to the node, (C4).
    Reach reach(const Domain& p, std::ptrdiff_t node) const {
        double n[3] = {0.0, 0.0, 0.0}, to_node = 0.0, half_width = 0.0, square = 0.0, n_n = 0.0;
        const double outward = d.body == GRIT_CONTACT_BODY_A ? 1.0 : -1.0;
        for (int c = 0; c < s.components; ++c) {
            n[c] = outward * component(s.normal, node, c);
            n_n += n[c] * n[c];
            const double apart = component(s.position, node, c) - p.x[c];
            to_node += apart * n[c];
            square += apart * apart;
        }
        for (int j = 0; j < d.sides; ++j)
            half_width += std::fabs(p.r[j][0] * n[0] + p.r[j][1] * n[1] + p.r[j][2] * n[2]);
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
    GRIT_REQUIRE(d.body == GRIT_CONTACT_BODY_A || d.body == GRIT_CONTACT_BODY_B,
                 "body must be 0 (A) or 1 (B), got %d", d.body);
    GRIT_REQUIRE(d.sides >= 0 && d.sides <= most_sides, "sides must be in [0, %d], got %d",
                 most_sides, d.sides);
    GRIT_REQUIRE(d.offset || d.nodes_each >= 0, "nodes_each must be >= 0, got %td", d.nodes_each);
    GRIT_REQUIRE(d.node, "node is null");
    const struct {
        const grit_view& view;
        const char* name;
    } inputs[] = {{s.position, "position of the nodes"},
                  {s.normal, "normal"},
                  {d.position, "position of the particles"}};
    for (const auto& input : inputs)
        if (const grit_status bad = check_usable(input.view, s.components, input.name, error))
            return bad;
    GRIT_REQUIRE(d.sides == 0 ||
                     (d.side.base && d.side.row_stride != 0 && d.side.column_stride != 0),
                 "side needs a base pointer, a row_stride and a column_stride");
    return GRIT_OK;
}

}  // namespace
}  // namespace grit

extern "C" grit_status grit_contact_surfaces_add(const grit_contact_surfaces* surfaces, ptrdiff_t n,
                                                 const grit_contact_domains* domains,
                                                 grit_error* error) {
    using namespace grit;
    GRIT_REQUIRE(domains, "grit_contact_surfaces_add: domains is null");
    GRIT_REQUIRE(n >= 0, "grit_contact_surfaces_add: n must be >= 0, got %td", n);
    grit_contact_surfaces s{};
    if (const grit_status status = read_surfaces(surfaces, s, error)) return status;
    grit_contact_domains d{};
    GRIT_REQUIRE(read_versioned(domains, d),
                 "grit_contact_domains.struct_size %zu is not understood: set it to sizeof",
                 domains->struct_size);
    if (n == 0) return GRIT_OK;  // an empty array may have no base pointer
    if (const grit_status status = check_domains(s, d, error)) return status;
    const Adding adding(s, d);
    grit_status result = GRIT_OK;
    for (ptrdiff_t i = 0; i < n; ++i) {
        const grit_status status = adding.add(i, result == GRIT_OK ? error : nullptr);
        if (result == GRIT_OK) result = status;
    }
    return result;
}
