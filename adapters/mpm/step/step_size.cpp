// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/step_size.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "adapters/mpm/step/text.hpp"

namespace grit::mpm {

// v + c of a body, its largest ones wherever they are: however strips and processes cut it, the same.
void StepSize::measure(const Gather& gather) {
    constexpr std::size_t each = 4;  // c, v2, way along z, what pore water adds to c2
    const std::size_t bodies = model.parts.size();
    maxima.assign(each * bodies, 0.0);
    for (std::size_t i = 0; i < bodies; ++i)
        for (const Gather::OfStrip& strip : gather.strips(i)) {
            double* of_body = &maxima[each * i];
            of_body[0] = std::max(of_body[0], strip.speed);
            of_body[1] = std::max(of_body[1], strip.sums.most_v2);
            of_body[2] = std::max(of_body[2], strip.sums.most_dz);
        }
    for (std::size_t i = 0; i < bodies; ++i) maxima[each * i + 3] = water.speed2(i);
    model.exchange.max(maxima.data(), static_cast<int>(maxima.size()));
    largest_speed = 0.0;
    double way = 0.0;
    for (std::size_t i = 0; i < bodies; ++i) {
        const double* of_body = &maxima[each * i];
        const double more = of_body[3];
        const double c = more > 0.0 ? std::sqrt(of_body[0] * of_body[0] + more) : of_body[0];
        largest_speed = std::max(largest_speed, c + std::sqrt(of_body[1]));
        way = std::max(way, of_body[2]);
    }
    model.drift += way;
}

// What moves a rigid body in a step is its velocity at the end of the step.
void StepSize::decide() {
    model.dt = stable(std::max(largest_speed, fastest_rigid(model.t).speed));
    while (std::isfinite(model.dt) && shorten()) {
    }
    if (!std::isfinite(model.dt))
        throw std::runtime_error("no finite time step: is anything able to move?");
    if (!(model.dt > 0.0)) throw std::runtime_error(word_of_no_step());
}

// By 1 % at the least, and no more than by half: an end that is much farther off says little.
bool StepSize::shorten() {
    const double limit = stable(std::max(largest_speed, fastest_rigid(model.t + model.dt).speed));
    if (model.dt <= limit) return false;
    model.dt = std::max(0.5 * model.dt, std::min(0.99 * model.dt, limit));
    return true;
}

StepSize::Fastest StepSize::fastest_rigid(double at) const {
    Fastest fastest;
    for (const Part& part : model.parts) {
        if (!part.body.rigid()) continue;
        const Vector2 v = part.body.prescribed_velocity(at);
        const double size = std::hypot(v[0], v[1]);
        if (!std::isfinite(size))
            throw std::runtime_error("body " + part.body.name +
                                     ": its prescribed velocity at t = " + text(at) + " s is (" +
                                     text(v[0]) + ", " + text(v[1]) + ") m/s");
        if (size > fastest.speed) fastest = {size, &part.body.name};
    }
    return fastest;
}

// Some speed is so large that its square is not a number, and the step none.
std::string StepSize::word_of_no_step() const {
    const Fastest rigid = fastest_rigid(model.t);
    const bool is_rigid = rigid.speed > largest_speed;
    return "no time step is short enough: " +
           (is_rigid ? "body " + *rigid.name : "waves and particles") + " would move at " +
           text(std::max(rigid.speed, largest_speed)) + " m/s at t = " + text(model.t) +
           " s, over cells of " + text(model.shortest) + " m";
}

double StepSize::stable(double speed) const {
    double inverse2 = speed * speed / (model.shortest * model.shortest);
    for (std::size_t i = 0; i < penalties.count(); ++i)
        inverse2 += 1.0 / (penalties[i].stable_step() * penalties[i].stable_step());
    return std::min(model.settings.cfl / std::sqrt(inverse2), model.settings.largest_step);
}

}  // namespace grit::mpm
