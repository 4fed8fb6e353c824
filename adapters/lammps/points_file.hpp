// SPDX-License-Identifier: GPL-2.0-only
// What LAMMPS does not know of its atoms, from a text file: a line of names, "id" and columns of particles or
// "density" in the place of "mass", then a line for each atom of a body. # begins a comment.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "adapters/mpm/case/spellings.hpp"

namespace grit::lammps {

// A body's columns, and which of them the file must have, may have, or leaves to the atoms.
class PointsFile {
  public:
    // Of a column that the file may leave out: its value, where the row has all that the file says.
    struct Otherwise {
        std::string name;
        std::function<double(std::vector<double>& row)> value;
    };
    // names: of all columns. first_line: of the file. Throws std::invalid_argument.
    PointsFile(std::vector<std::string> names, const std::string& first_line,
               mpm::words::Geometry geometry, std::vector<Otherwise> otherwise);

    // The number in front of a line; 0: an empty line.
    static int id_of(const char* line);
    // row, which has the position and velocity of the atom already, gets the rest. Throws
    // std::invalid_argument.
    void read(const char* line, std::vector<double>& row) const;

  private:
    std::vector<std::string> names;
    std::vector<int> column;  // of each number in a line behind the first, -1: density
    std::vector<std::size_t> sides,
        diagonal;  // half sides; the components of F that a unit tensor has
    std::size_t mass, volume;
    bool axisymmetric, in_space, has_mass, has_volume;
    std::vector<Otherwise> left_out;
    std::vector<std::size_t> left_out_columns;  // of these
};

}  // namespace grit::lammps
