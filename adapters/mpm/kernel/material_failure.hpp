// SPDX-License-Identifier: BSD-3-Clause
// A particle whose material cannot follow.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

#include <grit/sand.h>

namespace grit::mpm {

// What the sand was asked, in six components: in the plane 11 = rr, 22 = zz, 33 = tt, 12 = rz.
struct SandUpdate {
    double stress[6];  // before [Pa]
    double state[GRIT_SAND_STATE_SIZE];
    double strain[6];    // engineering shear
    double rotation[9];  // before it
};

class MaterialFailure : public std::runtime_error {
  public:
    // By the material, which knows no more than the place of the particle.
    MaterialFailure(const SandUpdate& update, std::ptrdiff_t place, const std::string& reason)
        : std::runtime_error("sand: " + reason), asked(update), at(place), why(reason) {}
    MaterialFailure of(std::size_t number, const std::string& name, int particle_id,
                       double time) const {
        MaterialFailure out(asked, at, why,
                            "body " + (name.empty() ? std::to_string(number) : name) +
                                ", particle " + std::to_string(particle_id) +
                                ", t = " + std::to_string(time) + " s: " + why);
        out.body_number = number;
        out.body_name = name;
        out.id = particle_id;
        out.start = time;
        return out;
    }

    const SandUpdate& update() const { return asked; }  // the particle is still as before
    std::ptrdiff_t place() const { return at; }
    const std::string& reason() const { return why; }
    std::size_t body() const { return body_number; }
    const std::string& name() const { return body_name; }  // of the body
    int particle() const { return id; }
    double time() const { return start; }  // at the start of the step [s]

  private:
    MaterialFailure(const SandUpdate& update, std::ptrdiff_t place, const std::string& reason,
                    const std::string& what)
        : std::runtime_error(what), asked(update), at(place), why(reason) {}

    SandUpdate asked;
    std::ptrdiff_t at;
    std::string why, body_name;
    std::size_t body_number = 0;
    int id = -1;
    double start = 0.0;
};

// What a call of the sand reports of a range that starts with the particle at begin; asked(i) tells the i-th one's
// update, which is as it was before.
template <class Asked>
[[noreturn]] void throw_failure(const grit_error& error, std::ptrdiff_t begin, const Asked& asked) {
    if (error.point < 0) throw std::runtime_error(std::string("sand: ") + error.message);
    const std::string message = error.message,
                      number = "point " + std::to_string(error.point) + ": ";
    throw MaterialFailure(asked(error.point), begin + error.point,
                          message.starts_with(number) ? message.substr(number.size()) : message);
}

}  // namespace grit::mpm
