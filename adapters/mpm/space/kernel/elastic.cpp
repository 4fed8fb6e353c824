// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/space/kernel/elastic.hpp"

#include <algorithm>
#include <cmath>

namespace grit::mpm::space {
namespace c = column;
namespace {

// |F|^2 = tr B
double squared_stretches(const ParticleView& q, std::ptrdiff_t p) {
    double sum = 0.0;
    for (int k = 0; k < 9; ++k) sum += q[c::F_xx + k][p] * q[c::F_xx + k][p];
    return sum;
}

}  // namespace

LinearElastic::LinearElastic(double E, double poisson)
    : law(lame_constants(E, poisson)), per_E(1.0 / E), nu(poisson) {}

void LinearElastic::update(const Range& range, const Increments& d) {
    const ParticleView& q = range.particles;
    double* __restrict s[6];
    for (int k = 0; k < 6; ++k) s[k] = q[c::S_xx + k] + range.begin;
    const double lambda = law.lambda, mu = law.mu;
    const auto n = static_cast<int>(range.end - range.begin);
    for (int i = 0; i < n; ++i) {
        const double T[3][3] = {
            {s[0][i], s[3][i], s[4][i]}, {s[3][i], s[1][i], s[5][i]}, {s[4][i], s[5][i], s[2][i]}};
        double QT[3][3];
        const auto Q = [&](int a, int b) { return d.rotation[3 * a + b][i]; };
        for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b)
                QT[a][b] = Q(a, 0) * T[0][b] + Q(a, 1) * T[1][b] + Q(a, 2) * T[2][b];
        const auto turned = [&](int a, int b) {
            return QT[a][0] * Q(b, 0) + QT[a][1] * Q(b, 1) + QT[a][2] * Q(b, 2);
        };
        const double trace = lambda * (d.strain[0][i] + d.strain[1][i] + d.strain[2][i]);
        s[0][i] = turned(0, 0) + trace + 2.0 * mu * d.strain[0][i];
        s[1][i] = turned(1, 1) + trace + 2.0 * mu * d.strain[1][i];
        s[2][i] = turned(2, 2) + trace + 2.0 * mu * d.strain[2][i];
        s[3][i] = turned(0, 1) + mu * d.strain[3][i];
        s[4][i] = turned(0, 2) + mu * d.strain[4][i];
        s[5][i] = turned(1, 2) + mu * d.strain[5][i];
    }
}

void LinearElastic::wave_moduli(const Range& range, double* moduli) const {
    std::fill_n(moduli, range.end - range.begin, law.wave_modulus());
}

double LinearElastic::energy(const ParticleView& q, std::ptrdiff_t p) const {
    double squares = 0.0, products = 0.0, shears = 0.0;
    for (int k = 0; k < 3; ++k) {
        const double s = q[c::S_xx + k][p], next = q[c::S_xx + (k + 1) % 3][p];
        const double shear = q[c::S_xy + k][p];
        squares += s * s;
        products += s * next;
        shears += shear * shear;
    }
    return 0.5 * per_E * (squares - 2.0 * nu * products + 2.0 * (1.0 + nu) * shears) * q.volume(p);
}

NeoHooke::NeoHooke(double E, double nu) : law(lame_constants(E, nu)) {}

void NeoHooke::update(const Range& range, const Increments&) {
    const ParticleView& q = range.particles;
    constexpr int of[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
    for (std::ptrdiff_t p = range.begin; p < range.end; ++p) {
        const double J = q.J(p), pressure = law.lambda * std::log(J) - law.mu;
        for (int k = 0; k < 6; ++k) {
            const int i = of[k][0], j = of[k][1];
            const double B = q.F(i, 0, p) * q.F(j, 0, p) + q.F(i, 1, p) * q.F(j, 1, p) +
                             q.F(i, 2, p) * q.F(j, 2, p);
            q[c::S_xx + k][p] = (law.mu * B + (k < 3 ? pressure : 0.0)) / J;
        }
    }
}

// As in the plane.
void NeoHooke::wave_moduli(const Range& range, double* moduli) const {
    const ParticleView& q = range.particles;
    for (std::ptrdiff_t p = range.begin; p < range.end; ++p) {
        const double J = q.J(p), at_rest = law.mu + law.lambda * std::max(0.0, 1.0 - std::log(J));
        moduli[p - range.begin] = (law.mu * squared_stretches(q, p) + at_rest) / J;
    }
}

double NeoHooke::energy(const ParticleView& q, std::ptrdiff_t p) const {
    const double log_J = std::log(q.J(p));
    return q[c::V0][p] * (0.5 * law.mu * (squared_stretches(q, p) - 3.0 - 2.0 * log_J) +
                          0.5 * law.lambda * log_J * log_J);
}

}  // namespace grit::mpm::space
