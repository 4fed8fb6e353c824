// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/space/step/rigid_motion.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Dense>

#include "adapters/mpm/space/kernel/place.hpp"

namespace grit::mpm::space {
namespace {

using baseline::cross;

using Matrix3 = std::array<Vector3, 3>;

Vector3 times(const Matrix3& a, const Vector3& x) {
    return {dot(a[0], x), dot(a[1], x), dot(a[2], x)};
}

Matrix3 times(const Matrix3& a, const Matrix3& b) {
    Matrix3 out;
    for (std::size_t i = 0; i < 3; ++i) out[i] = a[i][0] * b[0] + a[i][1] * b[1] + a[i][2] * b[2];
    return out;
}

constexpr Matrix3 unit{Vector3{1.0, 0.0, 0.0}, Vector3{0.0, 1.0, 0.0}, Vector3{0.0, 0.0, 1.0}};

// Rotation by the angle |w| about w (Rodrigues).
Matrix3 rotation(const Vector3& w) {
    const double angle = norm(w);
    if (!(angle > 0.0)) return unit;
    const double half = std::sin(0.5 * angle) / angle;
    const double a = std::sin(angle) / angle, b = 2.0 * half * half;
    Matrix3 out;
    for (int k = 0; k < 3; ++k) {
        const Vector3 e = unit[static_cast<std::size_t>(k)], first = cross(w, e);
        const Vector3 column = e + a * first + b * cross(w, first);
        for (std::size_t i = 0; i < 3; ++i) out[i][k] = column[static_cast<int>(i)];
    }
    return out;
}

}  // namespace

RigidMotion::RigidMotion(const RigidCourse& of, const ParticleView& q, std::ptrdiff_t count,
                         bool fixed_point, Exchange* others)
    : plan(of), orientation(unit), turn(unit) {
    Exchange nobody;
    Exchange& exchange = others ? *others : nobody;
    std::array<Total, 4> sums;  // mass, and its moments
    for (std::ptrdiff_t p = 0; p < count; ++p) {
        const double m = q[column::mass][p];
        sums[0].add(m, fixed_point);
        for (std::size_t k = 0; k < 3; ++k)
            sums[k + 1].add(m * q.position(p)[static_cast<int>(k)], fixed_point);
    }
    exchange.sum(sums, fixed_point);
    total = sums[0].value();
    const Vector3 of_mass =
        (1.0 / total) * Vector3{sums[1].value(), sums[2].value(), sums[3].value()};
    middle = plan.centre.value_or(of_mass);
    off_mass = norm(middle - of_mass);
    std::array<Total, 9> inertias;
    for (std::ptrdiff_t p = 0; p < count; ++p) {
        const Vector3 r = q.position(p) - middle;
        const double m = q[column::mass][p];
        // Of a brick, which may have been turned, about its own centre, and about this one.
        Vector3 side[3];
        for (int j = 0; j < 3; ++j) {
            const double l = q[column::l_x + j][p];
            side[j] = {l * q.F(0, j, p), l * q.F(1, j, p), l * q.F(2, j, p)};
        }
        const auto own = [&](int i, int j) {
            return m / 3.0 *
                   (side[0][i] * side[0][j] + side[1][i] * side[1][j] + side[2][i] * side[2][j]);
        };
        const double trace = own(0, 0) + own(1, 1) + own(2, 2);
        reach = std::max(reach, norm(r) + std::sqrt(3.0 * trace / m));
        const double all = trace + m * dot(r, r);
        Total* inertia_here = inertias.data();
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                (inertia_here++)
                    ->add((i == j ? all : 0.0) - own(i, j) - m * r[i] * r[j], fixed_point);
    }
    exchange.sum(inertias, fixed_point);
    exchange.max(&reach, 1);
    for (std::size_t i = 0; i < 9; ++i)
        inertia_at_start[i / 3][static_cast<int>(i % 3)] = inertias[i].value();
    is_free = has_begun(0.0) ? plan.free : std::array<bool, 6>{};
    before = now = as_told(0.0, has_begun(0.0) ? plan.start : Twist{}, is_free);
    spin_momentum = times(inertia(), now.about);
}

void RigidMotion::check_centre() const {
    if (any_free() && off_mass > 1e-9 * reach)
        throw std::invalid_argument(
            "what is free moves about the centre of mass, another one was given");
}

bool RigidMotion::any_free() const {
    return std::any_of(plan.free.begin(), plan.free.end(), [](bool x) { return x; });
}

Twist RigidMotion::as_told(double t, const Twist& given, const std::array<bool, 6>& free) const {
    const Vector3 none{0.0, 0.0, 0.0};
    const Vector3 velocity = plan.velocity ? plan.velocity(t) : none;
    const Vector3 spin = plan.spin ? plan.spin(t) : none;
    Twist out = given;
    for (int k = 0; k < 3; ++k) {
        if (!free[static_cast<std::size_t>(k)]) out.along[k] = velocity[k];
        if (!free[static_cast<std::size_t>(k) + 3]) out.about[k] = spin[k];
    }
    return out;
}

Vector3 RigidMotion::at(const Twist& u, const Vector3& x) const {
    return u.along + cross(u.about, x - middle);
}

RigidMotion::Matrix3 RigidMotion::inertia() const {
    Matrix3 back;  // the transpose of the orientation
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            back[i][static_cast<int>(j)] = orientation[j][static_cast<int>(i)];
    return times(orientation, times(inertia_at_start, back));
}

// Of the momentum about free axes, and of the spin about the others.
void RigidMotion::find_spin() {
    const Matrix3 I = inertia();
    Eigen::Matrix3d of = Eigen::Matrix3d::Identity();
    Eigen::Vector3d right;
    for (int i = 0; i < 3; ++i) {
        const bool turns = is_free[static_cast<std::size_t>(i) + 3];
        right[i] = turns ? spin_momentum[i] : now.about[i];
        for (int j = 0; j < 3 && turns; ++j) of(i, j) = I[static_cast<std::size_t>(i)][j];
    }
    const Eigen::Vector3d spin = of.partialPivLu().solve(right);
    for (int i = 0; i < 3; ++i)
        if (is_free[static_cast<std::size_t>(i) + 3]) now.about[i] = spin[i];
    const Vector3 momentum = times(I, now.about);
    for (int i = 0; i < 3; ++i)
        if (!is_free[static_cast<std::size_t>(i) + 3]) spin_momentum[i] = momentum[i];
}

bool RigidMotion::has_begun(double t) const { return !plan.has_begun || plan.has_begun(t); }

void RigidMotion::begin(double t, double dt, const Vector3& gravity, const Twist& load) {
    brought = 0.0;
    if (is_free != plan.free && has_begun(t)) {
        is_free = plan.free;
        now = as_told(t, plan.start, is_free);
        spin_momentum = times(inertia(), now.about);
        brought = kinetic_energy();
    }
    before = now = as_told(t, now, is_free);
    spin_momentum_before = spin_momentum;
    acted = dt * total * norm(gravity) + norm(load.along);
    for (int k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(k);
        if (is_free[i]) now.along[k] += dt * gravity[k] + load.along[k] / total;
        if (is_free[i + 3]) spin_momentum[k] += load.about[k];
    }
    if (any_free()) find_spin();
}

void RigidMotion::push(const Twist& impulse) {
    acted += norm(impulse.along);
    for (int k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(k);
        if (is_free[i]) now.along[k] += impulse.along[k] / total;
        if (is_free[i + 3]) spin_momentum[k] += impulse.about[k];
    }
    find_spin();
}

Matrix6 RigidMotion::mass_matrix() const {
    Matrix6 out{};
    const Matrix3 I = inertia();
    for (std::size_t i = 0; i < 3; ++i) {
        out[i][i] = is_free[i] ? total : 1.0;
        for (std::size_t j = 0; j < 3; ++j)
            out[i + 3][j + 3] = is_free[i + 3] && is_free[j + 3] ? I[i][static_cast<int>(j)]
                                : i == j                         ? 1.0
                                                                 : 0.0;
    }
    return out;
}

// The rotation of a step is by the spin in its middle, where the inertia is that of half of it.
void RigidMotion::finish(double dt) {
    middle_before = middle;
    middle = middle + dt * now.along;
    turn = unit;
    if (norm(now.about) == 0.0) return;
    const bool turns_freely = is_free[3] || is_free[4] || is_free[5];
    if (turns_freely) {
        const Matrix3 at_start = orientation;
        orientation = times(rotation(0.5 * dt * now.about), at_start);
        find_spin();
        orientation = at_start;
    }
    turn = rotation(dt * now.about);
    orientation = times(turn, orientation);
    if (turns_freely) find_spin();
}

Vector3 RigidMotion::moved(const Vector3& x) const {
    if (norm(now.about) == 0.0) return x + (middle - middle_before);
    return middle + turned(x - middle_before);
}

Vector3 RigidMotion::turned(const Vector3& r) const { return times(turn, r); }

double RigidMotion::kinetic_energy() const {
    double out = 0.0;
    for (int k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(k);
        if (is_free[i]) out += 0.5 * total * now.along[k] * now.along[k];
        if (is_free[i + 3]) out += 0.5 * spin_momentum[k] * now.about[k];
    }
    return out;
}

double RigidMotion::unbalanced_share() const {
    if (!(acted > 0.0)) return 0.0;
    Vector3 along{0.0, 0.0, 0.0}, about{0.0, 0.0, 0.0};
    for (int k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(k);
        if (is_free[i]) along[k] = total * (now.along[k] - before.along[k]);
        if (is_free[i + 3]) about[k] = spin_momentum[k] - spin_momentum_before[k];
    }
    return std::max(norm(along), norm(about) / reach) / acted;
}

double RigidMotion::speed(double t) const {
    const bool begins = is_free != plan.free && has_begun(t);
    const Twist u = begins ? as_told(t, plan.start, plan.free) : as_told(t, now, is_free);
    return norm(u.along) + norm(u.about) * reach;
}

}  // namespace grit::mpm::space
