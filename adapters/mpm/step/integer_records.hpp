// SPDX-License-Identifier: BSD-3-Clause
// Nodal records of a body as sums in fixed point. Each quantity has a scale of its own, which follows the largest
// contribution: where one is too large, or all are too small, the sums are done again.
#pragma once

#include <array>
#include <vector>

#include "adapters/mpm/kernel/exchange.hpp"
#include "adapters/mpm/step/settings.hpp"

namespace grit::mpm {

class IntegerRecords {
  public:
    void resize(std::size_t nodes, int of_strips);
    // Before particles are scattered.
    void begin();
    // Where those of a strip are added to.
    FixedPoint* strip(int number) { return &strips[static_cast<std::size_t>(number)]; }
    // Once all are added, of all processes.
    struct Check {
        bool again = false;  // the sums must be done again
        int failed = -1;     // component of which a share is infinite or no number; -1: none
    };
    // components: bits of those that are wanted.
    Check check(unsigned components, Exchange& exchange);
    // Adds the sums of all processes.
    void add_to(std::vector<NodeRecord>& records, Exchange& exchange);
    // ... that are those of cells, with so many records each.
    void add_to(NodeRecord* records, int each, Exchange& exchange);

    template <class Self, class Archive> static void visit(Self& of, Archive& archive) {
        archive.value(of.scale);
    }

  private:
    void add_to(NodeRecord* records) const;
    std::vector<NodeIntegers> integers;
    std::vector<FixedPoint> strips;
    std::array<double, record::size> scale{};
};

// Throws std::runtime_error that names the particle, if it is here.
[[noreturn]] void fail_share(Body& body, const char* of_what, double t);

}  // namespace grit::mpm
