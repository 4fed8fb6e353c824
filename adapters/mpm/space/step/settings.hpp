// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "adapters/mpm/space/kernel/material.hpp"
#include "adapters/mpm/space/step/rigid_motion.hpp"
#include "adapters/mpm/step/settings.hpp"

namespace grit::mpm::space {

using Settings = mpm::Settings;

// What of the settings is not there in space: its key in [numerics], and a word for it. Null: all of it is there.
struct NotThere {
    const char* key = nullptr;
    const char* what = nullptr;
};
inline NotThere not_there(const Settings& settings) {
    if (settings.shape == Shape::cpdi_published)
        return {"shape_function", "the shape function cpdi_published"};
    if (settings.scheme != Scheme::usl) return {"scheme", "another scheme than usl"};
    if (settings.reduced_domains) return {"reduced_domains", "the reduction of domains"};
    return {};
}
// Throws std::invalid_argument with the word.
inline void check_there(const Settings& settings) {
    if (const NotThere found = not_there(settings); found.key)
        throw std::invalid_argument(std::string(found.what) + " is not there in space");
}

struct Body {
    std::string name;
    Particles particles;
    std::unique_ptr<Material> material;
    std::optional<RigidMotion> motion = {};  // of a rigid body; none: it deforms
    std::optional<PoreWater> water = {};     // its columns follow those of the material
    bool rigid() const { return motion.has_value(); }
    // From now on; what its particles are is known. exchange: of processes that have some of them.
    void make_rigid(const RigidCourse& course, bool fixed_point, Exchange* exchange) {
        motion.emplace(course, particles.view(), particles.size(), fixed_point, exchange);
    }
    // ... of one process, at the start.
    void make_rigid(const RigidCourse& course, bool fixed_point = false) {
        make_rigid(course, fixed_point, nullptr);
        motion->check_centre();
    }
};

}  // namespace grit::mpm::space
