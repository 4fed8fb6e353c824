// SPDX-License-Identifier: BSD-3-Clause
// The next step, decided once, at the end of the one before: no longer than what is fastest needs for its share
// of a cell (Courant), with the springs of penalty contacts.
#pragma once

#include <string>
#include <vector>

#include "adapters/mpm/step/gather.hpp"
#include "adapters/mpm/step/model.hpp"
#include "adapters/mpm/step/penalty_contacts.hpp"
#include "adapters/mpm/step/water.hpp"

namespace grit::mpm {

class StepSize {
  public:
    StepSize(Model& of, const PenaltyContacts& springs, const Water& in_pores)
        : model(of), penalties(springs), water(in_pores) {}
    // Of what a gather has left: the largest speeds, and how far particles have drifted.
    void measure(const Gather& gather);
    // Throws std::runtime_error where nothing limits it, or a rigid body's velocity is no number.
    void decide();
    // Once, if rigid bodies would move too far at their speed at its end; true: it ends earlier now.
    bool shorten();

    template <class Self, class Archive> static void visit(Self& size, Archive& archive) {
        archive.value(size.largest_speed);
    }

  private:
    double stable(double speed) const;
    struct Fastest {
        double speed = 0.0;  // [m/s]
        const std::string* name = nullptr;
    };
    Fastest fastest_rigid(double at) const;
    std::string word_of_no_step() const;

    Model& model;
    const PenaltyContacts& penalties;
    const Water& water;
    std::vector<double> maxima;  // of each body
    double largest_speed = 0.0;  // v + c [m/s]
};

}  // namespace grit::mpm
