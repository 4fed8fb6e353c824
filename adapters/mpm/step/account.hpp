// SPDX-License-Identifier: BSD-3-Clause
// Energies: each counted where it happens, added up over strips, bodies and processes.
#pragma once

#include "adapters/mpm/step/absorbing.hpp"
#include "adapters/mpm/step/gather.hpp"
#include "adapters/mpm/step/loads.hpp"
#include "adapters/mpm/step/model.hpp"
#include "adapters/mpm/step/momentum.hpp"
#include "adapters/mpm/step/water.hpp"

namespace grit::mpm {

class Account {
  public:
    explicit Account(Model& of) : model(of) {}
    // What a step has cost. Throws std::runtime_error if particles have left the grid.
    void add_step(const Gather& gather, const Momentum& momentum, const Loads& loads,
                  const AbsorbingSides& sides, const Water& water);
    // Kinetic and stored energy as they are; at the start.
    void measure();
    void start();
    // To which contacts add theirs.
    Energy& sums() { return energies; }

    template <class Self, class Archive> static void visit(Self& account, Archive& archive) {
        archive.value(account.energies);
    }

  private:
    [[noreturn]] void report_lost(long count) const;

    Model& model;
    Energy energies;
};

}  // namespace grit::mpm
