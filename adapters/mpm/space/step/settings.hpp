// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "adapters/mpm/space/kernel/material.hpp"
#include "adapters/mpm/step/settings.hpp"

namespace grit::mpm::space {

// As in the plane, but for what is not there yet in space; see refuse_what_is_not_there.
using Settings = mpm::Settings;

struct Body {
    std::string name;
    Particles particles;
    std::unique_ptr<Material> material;
    // A rigid body moves as this says, over time [s]; empty: free.
    std::function<Vector3(double)> prescribed_velocity;
    bool rigid() const { return static_cast<bool>(prescribed_velocity); }
};

}  // namespace grit::mpm::space
