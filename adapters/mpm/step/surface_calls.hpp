// SPDX-License-Identifier: BSD-3-Clause
// The surface contacts of a step, solved together: what bears in one of them is the load of another of the same body.
#pragma once

#include <cstdint>
#include <vector>

#include <grit/contact_surface.h>

#include "adapters/mpm/step/require.hpp"

namespace grit::mpm {

class SurfaceCalls {
  public:
    void clear() { pairs.clear(); }
    // What it points at stays where it is until all are solved.
    void add(const grit_surface_pair& pair) { pairs.push_back(pair); }
    // Rows of the totals are in memory of this, until it solves again.
    void solve() {
        const auto n = static_cast<std::ptrdiff_t>(pairs.size());
        std::size_t needed = grit_surface_pairs_workspace_size(pairs.data(), n);
        grit_error error;
        grit_status status = GRIT_OK;
        do {
            if (workspace.size() * sizeof(std::uint64_t) < needed)
                workspace.resize(needed / sizeof(std::uint64_t) + 1);
            status = grit_surface_correct_pairs(pairs.data(), n, workspace.data(),
                                                workspace.size() * sizeof(std::uint64_t), &needed,
                                                &error);
        } while (needed > 0);
        require(status, error, "surface contact");
    }

  private:
    std::vector<grit_surface_pair> pairs;
    std::vector<std::uint64_t> workspace;
};

}  // namespace grit::mpm
