// SPDX-License-Identifier: BSD-3-Clause
// One case in both hosts: the reference driver, and LAMMPS.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "support/folder.hpp"

// What both hosts tell: the history, a row for each step, and all columns of particles at the end by the
// numbers of the atoms.
struct Told {
    std::vector<std::vector<double>> rows;
    std::map<int, std::vector<double>> points;
};

class BothHosts {
  public:
    // A TOML case; its history has a row for each step. beside: other files that it needs, by name.
    explicit BothHosts(const std::string& toml,
                       const std::map<std::string, std::string>& beside = {});

    // steps: the most of them.
    Told in_driver(long steps) const;
    // processors: of LAMMPS along r and z, or x, y and z. script: that of the case unless another one is wanted. The test
    // fails if LAMMPS does.
    Told in_lammps(const std::array<int, 3>& processors, const std::string& script = "") const;
    Told in_lammps(int r, int z, const std::string& other_script = "") const {
        return in_lammps({r, z, 1}, other_script);
    }
    // ... as a program is run that may fail.
    Answer lammps(int processes, const std::string& script) const;
    // How a program is started on so many processes, more than processors too.
    static std::string start(int processes, const std::string& program);
    // From what LAMMPS has printed and dumped.
    Told read_told(const std::string& printed) const;
    std::string script() const { return "include " + name + ".in\n"; }
    // ... from a restart file, with words of the stage behind it.
    std::string go_on(const std::string& file, const std::string& stage = "") const {
        return "atom_modify map yes\nread_restart " + file + "\ninclude " + name +
               ".fix\nthermo 1\n" + stage + "run 2000000000\n";
    }

    const Folder folder;
    std::string name;

  private:
    std::string toml_name;
    bool in_space;
};

// A text with other words in the place of the first of these; the test fails if there are none.
std::string replaced(std::string text, const std::string& words, const std::string& other);

// It ended by LAMMPS's own kind of error, which says why.
void expect_error(const Answer& answer, const std::string& why);

// For messages: where a row differs, bit for bit; empty: nowhere.
std::string first_difference(const Told& one, const Told& other);
