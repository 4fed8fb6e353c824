// SPDX-License-Identifier: BSD-3-Clause
// What is asked of the surfaces of nodes: domains, or corners of them, that are near.
#pragma once

#include <cstddef>
#include <vector>

#include <grit/contact.h>

#include "adapters/mpm/step/require.hpp"
#include "support/vector.hpp"

namespace grit::mpm::space {

// Parallelepipeds, or points, each with nodes of its own, for one call of the library.
class DomainList {
  public:
    void clear() {
        position.clear();
        sides.clear();
        offset.assign(1, 0);
        node.clear();
    }
    void add(const Vector3& x, const std::ptrdiff_t* nodes, int count) {
        if (count == 0) return;
        position.insert(position.end(), x.c, x.c + 3);
        node.insert(node.end(), nodes, nodes + count);
        offset.push_back(static_cast<std::ptrdiff_t>(node.size()));
    }
    void add(const Vector3& x, const double (&side)[9], const std::ptrdiff_t* nodes, int count) {
        if (count > 0) sides.insert(sides.end(), side, side + 9);
        add(x, nodes, count);
    }
    void send(const grit_contact_surfaces& to, int body) const {
        grit_contact_domains d{};
        d.struct_size = sizeof d;
        d.body = body;
        d.offset = offset.data();
        d.node = node.data();
        d.position = grit_view_of(position.data(), 3, 1);
        if (!sides.empty()) {
            d.sides = 3;
            d.side = grit_matrix_view_of(sides.data(), 9, 3, 1);
        }
        const auto n = static_cast<std::ptrdiff_t>(offset.size()) - 1;
        if (n == 0) return;
        grit_error error;
        require(grit_contact_surfaces_add(&to, n, &d, &error), error, "contact");
    }

  private:
    std::vector<double> position, sides;
    std::vector<std::ptrdiff_t> offset{0}, node;
};

}  // namespace grit::mpm::space
