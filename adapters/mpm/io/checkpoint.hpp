// SPDX-License-Identifier: BSD-3-Clause
// The state of a simulation between two steps, for one that is built from the same case.
//
//   header    magic, format, library version, instruction set, sizes, checksums
//   words     what the simulation is built of, line by line: grid, bodies, materials, contacts, options
//   state     all that a step leaves for the next one, bit for bit, and the settings that stages may
//             change (damping, step size, PIC rate, gravity)
//
// Numbers are written as they lie in memory, and refused by a machine that orders their bytes differently.
// Not written: functions of time.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>

#include "adapters/mpm/step/simulation.hpp"

namespace grit::mpm {

// What to do with a checkpoint that another instruction set wrote. The driver's kernels give the same
// bits with all of them, the sand does not.
enum class OtherBits { refused, accepted };

// Throws std::runtime_error if the stream fails.
void save(const Simulation& simulation, std::ostream& out);

// The simulation goes on bitwise as the saved one would have. Throws std::runtime_error that names what
// is wrong with the stream or differs in the simulation, which is untouched then. The checkpoint is all that
// is left of the stream.
void restore(Simulation& simulation, std::istream& in, OtherBits bits = OtherBits::refused);

// The same of any simulation that knows its words and its state as bytes; take throws std::runtime_error for bytes that
// cannot be those of the simulation.
void write_state(const std::string& words, const std::string& state, std::ostream& out);
void read_state(std::istream& in, OtherBits bits, const std::string& words,
                const std::function<void(const std::string& state)>& take);

}  // namespace grit::mpm
