// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/kernel/elastic.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace grit::mpm {
namespace c = column;

std::vector<std::string> elastic_words(const char* law, const LameConstants& constants) {
    char numbers[80];
    std::snprintf(numbers, sizeof numbers, "Lame's constants %.17g and %.17g Pa", constants.lambda,
                  constants.mu);
    return {law, numbers};
}

LameConstants lame_constants(double E, double nu) {
    if (!(E > 0.0 && nu > -1.0 && nu < 0.5))
        throw std::invalid_argument(
            "elastic: Young's modulus > 0 and Poisson's ratio in (-1, 0.5)");
    return {E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)), 0.5 * E / (1.0 + nu)};
}

void reflect(const Material& material, const ParticleView& q, std::ptrdiff_t p) {
    for (const int odd : {c::r, c::v_r, c::F_rz, c::F_zr, c::S_rz, c::b_r}) q[odd][p] = -q[odd][p];
    material.reflect(q, p);
}

LinearElastic::LinearElastic(double E, double poisson)
    : law(lame_constants(E, poisson)), per_E(1.0 / E), nu(poisson) {}

std::vector<std::string> LinearElastic::words() const {
    return elastic_words("linear elastic", law);
}

void LinearElastic::update(const Range& range, const Increments& d) {
    const ParticleView& q = range.particles;
    double* __restrict s_rr = q[c::S_rr] + range.begin;
    double* __restrict s_zz = q[c::S_zz] + range.begin;
    double* __restrict s_tt = q[c::S_tt] + range.begin;
    double* __restrict s_rz = q[c::S_rz] + range.begin;
    const double lambda = law.lambda, mu = law.mu;
    const auto n = static_cast<int>(range.end - range.begin);
    for (int i = 0; i < n; ++i) {
        const double cosine = d.rotation[0][i], sine = d.rotation[1][i];
        const double cc = cosine * cosine, ss = sine * sine, cs = cosine * sine;
        const double rr = s_rr[i], zz = s_zz[i], rz = s_rz[i];
        const double trace = lambda * (d.strain[0][i] + d.strain[1][i] + d.strain[2][i]);
        s_rr[i] = cc * rr + ss * zz + 2.0 * cs * rz + trace + 2.0 * mu * d.strain[0][i];
        s_zz[i] = ss * rr + cc * zz - 2.0 * cs * rz + trace + 2.0 * mu * d.strain[1][i];
        s_tt[i] += trace + 2.0 * mu * d.strain[2][i];
        s_rz[i] = (cc - ss) * rz + cs * (zz - rr) + mu * d.strain[3][i];
    }
}

void LinearElastic::wave_moduli(const Range& range, double* moduli) const {
    std::fill_n(moduli, range.end - range.begin, law.wave_modulus());
}

double LinearElastic::energy(const ParticleView& q, std::ptrdiff_t p) const {
    const double rr = q[c::S_rr][p], zz = q[c::S_zz][p], tt = q[c::S_tt][p], rz = q[c::S_rz][p];
    const double squares = rr * rr + zz * zz + tt * tt;
    const double products = rr * zz + zz * tt + tt * rr;
    return 0.5 * per_E * (squares - 2.0 * nu * products + 2.0 * (1.0 + nu) * rz * rz) *
           q[c::V0][p] * q.J(p);
}

NeoHooke::NeoHooke(double E, double nu) : law(lame_constants(E, nu)) {}

std::vector<std::string> NeoHooke::words() const { return elastic_words("neo-Hooke", law); }

void NeoHooke::update(const Range& range, const Increments&) {
    const ParticleView& q = range.particles;
    for (std::ptrdiff_t p = range.begin; p < range.end; ++p) {
        const double rr = q[c::F_rr][p], rz = q[c::F_rz][p], zr = q[c::F_zr][p];
        const double zz = q[c::F_zz][p], tt = q[c::F_tt][p];
        const double J = q.J(p), pressure = law.lambda * std::log(J) - law.mu;
        q[c::S_rr][p] = (law.mu * (rr * rr + rz * rz) + pressure) / J;
        q[c::S_zz][p] = (law.mu * (zr * zr + zz * zz) + pressure) / J;
        q[c::S_tt][p] = (law.mu * tt * tt + pressure) / J;
        q[c::S_rz][p] = law.mu * (rr * zr + rz * zz) / J;
    }
}

// Along each principal axis mu (1 + 1/F^2) + lambda (1 - ln J)/F^2 per F^2 of the current length.
void NeoHooke::wave_moduli(const Range& range, double* moduli) const {
    const ParticleView& q = range.particles;
    for (std::ptrdiff_t p = range.begin; p < range.end; ++p) {
        const double J = q.J(p), rr = q[c::F_rr][p], rz = q[c::F_rz][p];
        const double zr = q[c::F_zr][p], zz = q[c::F_zz][p];
        const double stretch2 = rr * rr + rz * rz + zr * zr + zz * zz;  // no less than the largest
        const double at_rest = law.mu + law.lambda * std::max(0.0, 1.0 - std::log(J));
        moduli[p - range.begin] = (law.mu * stretch2 + at_rest) / J;
    }
}

double NeoHooke::energy(const ParticleView& q, std::ptrdiff_t p) const {
    const double rr = q[c::F_rr][p], rz = q[c::F_rz][p], zr = q[c::F_zr][p], zz = q[c::F_zz][p];
    const double tt = q[c::F_tt][p], log_J = std::log(q.J(p));
    const double trace = rr * rr + rz * rz + zr * zr + zz * zz + tt * tt;
    return q[c::V0][p] *
           (0.5 * law.mu * (trace - 3.0 - 2.0 * log_J) + 0.5 * law.lambda * log_J * log_J);
}

}  // namespace grit::mpm
