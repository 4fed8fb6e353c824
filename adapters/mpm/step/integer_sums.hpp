// SPDX-License-Identifier: BSD-3-Clause
// Records of nodes as sums in fixed point, of so many quantities. Each quantity has a scale of its own, which follows the
// largest contribution: where one is too large, or all are too small, the sums are done again.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "adapters/mpm/kernel/exchange.hpp"
#include "adapters/mpm/kernel/particle_columns.hpp"

namespace grit::mpm {

template <int lanes> class IntegerSums {
  public:
    // parts: strips or pencils, which are added up side by side.
    void resize(std::size_t nodes, int of_parts);
    // Before particles are scattered: all of it, or its parts and each of its nodes.
    void begin();
    void begin_parts();
    void clear(std::size_t begin, std::size_t end);
    // Where those of a part are added to.
    FixedPointOf<lanes>* part(int number) { return &parts[static_cast<std::size_t>(number)]; }
    // Once all are added, of all processes.
    struct Check {
        bool again = false;  // the sums must be done again
        int failed = -1;     // component of which a share is infinite or no number; -1: none
    };
    // Once they fit: integers of nodes become those of all processes.
    void share(Exchange& exchange) {
        exchange.sum_nodes(integers.data(), static_cast<std::ptrdiff_t>(integers.size()));
    }
    // components: bits of those that are wanted.
    Check check(unsigned components, Exchange& exchange);
    // Adds the sums to nodes begin ... end - 1 of records of so many doubles.
    void add_to(double* records, std::size_t begin, std::size_t end) const;

    template <class Self, class Archive> static void visit(Self& of, Archive& archive) {
        archive.value(of.scale);
    }

  protected:
    std::vector<IntegersOf<lanes>> integers;

  private:
    std::vector<FixedPointOf<lanes>> parts;
    std::array<double, lanes> scale{};
};
extern template class IntegerSums<4>;
extern template class IntegerSums<8>;

// Throws std::runtime_error that names the first particle with a number that is none; another process may have it.
[[noreturn]] void fail_share(const std::string& body, const ParticleColumns& particles,
                             const std::vector<std::string>& columns, const char* of_what,
                             double t);

}  // namespace grit::mpm
