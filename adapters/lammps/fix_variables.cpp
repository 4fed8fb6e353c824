// SPDX-License-Identifier: GPL-2.0-only
// fix grit/mpm: variables of the script as loads and motions.
#include <stdexcept>
#include <string>
#include <vector>

#include "adapters/lammps/guarded.hpp"

namespace grit::lammps {

void FixGritMpm::check_variables() const {
    std::vector<std::string> names = run->description().traction_variables;
    for (const MotionVariables& motion : run->description().motion)
        names.insert(names.end(), {motion.r, motion.z});
    for (const std::string& name : names) {
        if (name.empty()) continue;
        const int number = input->variable->find(name.c_str());
        if (number < 0 || !input->variable->equalstyle(number))
            error->all(FLERR, "Fix grit/mpm: there is no equal-style variable \"" + name + '"');
    }
}

// All processes ask, also those without a loaded particle: what a variable reads may need all of them.
void FixGritMpm::ask_variables(void (LocalRun::*ask)()) {
    if (!run->has_variables()) return;
    modify->clearstep_compute();
    is_asking = true;
    guarded_here([&] { (run.get()->*ask)(); });
    is_asking = false;
    modify->addstep_compute(update->ntimestep + 1);
}

double FixGritMpm::variable_at(const std::string& name, double t) {
    const int number = input->variable->find(name.c_str());
    if (number < 0) throw std::runtime_error("variable \"" + name + "\" is gone");
    const double time = update->atime;
    const LAMMPS_NS::bigint step = update->atimestep;
    update->atime = t;
    update->atimestep = update->ntimestep;
    const double value = input->variable->compute_equal(number);
    update->atime = time;
    update->atimestep = step;
    return value;
}

}  // namespace grit::lammps
