// SPDX-License-Identifier: BSD-3-Clause
// Nodal records of a body in the plane as sums in fixed point, of all processes.
#pragma once

#include <vector>

#include "adapters/mpm/step/integer_sums.hpp"
#include "adapters/mpm/step/settings.hpp"

namespace grit::mpm {

class IntegerRecords : public IntegerSums<record::size> {
  public:
    // Adds the sums of all processes.
    void add_to(std::vector<NodeRecord>& records, Exchange& exchange);
    // ... that are those of cells, with so many records each.
    void add_to(NodeRecord* records, int each, Exchange& exchange);

  private:
    using IntegerSums<record::size>::add_to;
};

// Throws std::runtime_error that names the particle, if it is here.
[[noreturn]] void fail_share(const Body& body, const char* of_what, double t);

}  // namespace grit::mpm
