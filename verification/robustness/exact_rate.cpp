// SPDX-License-Identifier: BSD-3-Clause
#include "robustness/exact_rate.hpp"

#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include <boost/numeric/odeint.hpp>

namespace robustness {
namespace {

using Real = long double;
using Tensor = std::array<Real, 6>;  // Mandel: shear times sqrt 2
using Y = std::vector<Real>;         // stress over its norm at the start, h over R, e

const Real root_2 = std::sqrt(2.0L), root_3 = std::sqrt(3.0L);

Real dot(const Tensor& a, const Tensor& b) {
    Real sum = 0.0L;
    for (std::size_t i = 0; i < 6; ++i) sum += a[i] * b[i];
    return sum;
}
Real trace(const Tensor& a) { return a[0] + a[1] + a[2]; }
Tensor plus(const Tensor& a, Real s, const Tensor& b) {
    Tensor out;
    for (std::size_t i = 0; i < 6; ++i) out[i] = a[i] + s * b[i];
    return out;
}
constexpr Tensor zero = {};
constexpr Tensor unit = {1.0L, 1.0L, 1.0L, 0.0L, 0.0L, 0.0L};

Real determinant(const Tensor& a) {
    const Real xy = a[3] / root_2, xz = a[4] / root_2, yz = a[5] / root_2;
    return a[0] * (a[1] * a[2] - yz * yz) - xy * (xy * a[2] - yz * xz) + xz * (xy * yz - a[1] * xz);
}

// (H1)-(H9) and (G1)-(G3).
class Law {
  public:
    Law(const grit_sand_parameters& parameters, bool without_memory)
        : s(parameters), basic(without_memory) {
        const Real sine = std::sin(static_cast<Real>(s.critical_friction_angle));
        a = root_3 * (3.0L - sine) / (2.0L * root_2 * sine);
    }

    struct Rate {
        Tensor T, h;
        Real e;
        bool inside = true;  // of the domain, by a margin
    };

    Rate rate(const Tensor& T_stored, const Tensor& h, Real e, const Tensor& D) const {
        const Tensor T = plus(T_stored, -static_cast<Real>(s.pressure_shift), unit);
        Rate out;
        const Real tr = trace(T), p = -tr / 3.0L, h_s = s.granulate_hardness;
        Tensor That = zero;
        for (std::size_t i = 0; i < 6; ++i) That[i] = T[i] / tr;
        const Tensor dev = plus(That, -1.0L / 3.0L, unit);
        const Real size = std::sqrt(dot(dev, dev)), tan_psi = root_3 * size;
        const Real x = 3.0L * p / h_s,
                   shrink = std::exp(-std::pow(x, static_cast<Real>(s.stiffness_exponent)));
        const Real e_i = s.loosest_void_ratio * shrink, e_c = s.critical_void_ratio * shrink,
                   e_d = s.densest_void_ratio * shrink;
        out.inside = p > 1e-6L * h_s && tan_psi < 1.35L && e > e_d + 1e-3L * (e_c - e_d) && e < e_i;
        if (!out.inside) {
            out.T = out.h = zero;
            out.e = 0.0L;
            return out;
        }
        Real cosine = 1.0L;
        if (size > 0.0L) {
            // tr A^3 = 3 det A of a deviator
            cosine = -std::sqrt(6.0L) * 3.0L * determinant(dev) / (size * size * size);
            cosine = std::fmin(1.0L, std::fmax(-1.0L, cosine));
        }
        const Real t2 = tan_psi * tan_psi;
        const Real F = std::sqrt(t2 / 8.0L + (2.0L - t2) / (2.0L + root_2 * tan_psi * cosine)) -
                       tan_psi / (2.0L * root_2);
        const Real alpha = s.pyknotropy_exponent, beta = s.stiffness_void_exponent,
                   n = s.stiffness_exponent;
        const Real e_i0 = s.loosest_void_ratio, e_c0 = s.critical_void_ratio,
                   e_d0 = s.densest_void_ratio;
        const Real f_d = std::pow((e - e_d) / (e_c - e_d), alpha), f_e = std::pow(e_c / e, beta);
        const Real f_b =
            h_s / n * std::pow(e_i0 / e_c0, beta) * (1.0L + e_i) / e_i * std::pow(x, 1.0L - n) /
            (3.0L + a * a - root_3 * a * std::pow((e_i0 - e_d0) / (e_c0 - e_d0), alpha));
        const Real scale = f_b * f_e / dot(That, That);
        const auto L = [&](const Tensor& E) {
            Tensor LE = zero;
            const Real along = a * a * dot(That, E);
            for (std::size_t i = 0; i < 6; ++i) LE[i] = scale * (F * F * E[i] + along * That[i]);
            return LE;
        };
        Tensor N = zero;
        for (std::size_t i = 0; i < 6; ++i) N[i] = scale * f_d * a * F * (That[i] + dev[i]);
        out.e = (1.0L + e) * trace(D);
        if (basic) {
            out.T = plus(L(D), 1.0L, N);  // |D| = 1
            out.h = zero;
            return out;
        }
        const Real m_R = s.reversal_stiffness, m_T = s.transverse_stiffness;
        const Real length = std::sqrt(dot(h, h)), rho = length / s.elastic_strain_radius;
        const Real share = std::pow(rho, static_cast<Real>(s.stiffness_interpolation_exponent));
        Tensor towards = zero;
        for (std::size_t i = 0; i < 6; ++i) towards[i] = length > 0.0L ? h[i] / length : 0.0L;
        const Real loading = dot(towards, D);
        const Tensor LD = L(D), Lh = L(towards);
        const Real base = share * m_T + (1.0L - share) * m_R;
        for (std::size_t i = 0; i < 6; ++i)
            out.T[i] =
                base * LD[i] + (loading > 0.0L ? share * ((1.0L - m_T) * Lh[i] + N[i]) * loading
                                               : share * (m_R - m_T) * Lh[i] * loading);
        const Real held = loading > 0.0L
                              ? loading * std::pow(rho, static_cast<Real>(s.evolution_exponent))
                              : 0.0L;
        out.h = plus(D, -held, towards);
        return out;
    }

  private:
    const grit_sand_parameters& s;
    bool basic;
    Real a = 0.0L;
};

Tensor mandel(const double* voigt, Real shear) {
    Tensor out;
    for (std::size_t i = 0; i < 6; ++i)
        out[i] = static_cast<Real>(voigt[i]) * (i < 3 ? 1.0L : shear);
    return out;
}

constexpr int most_rates = 200000;

}  // namespace

std::optional<ExactEnd> exact_update(const grit_sand_parameters& sand, const double stress[6],
                                     const double state[GRIT_SAND_STATE_SIZE],
                                     const double strain[6], bool basic) {
    const Law law(sand, basic);
    const Tensor T_0 = mandel(stress, root_2), h_0 = mandel(state, 1.0L / root_2),
                 dE = mandel(strain, 1.0L / root_2);
    const Real scale = std::sqrt(dot(T_0, T_0)), length = std::sqrt(dot(dE, dE)),
               R = basic ? 1.0L : static_cast<Real>(sand.elastic_strain_radius);
    if (!(scale > 0.0L) || !(length > 0.0L)) return std::nullopt;
    const Tensor D = plus(zero, 1.0L / length, dE);
    Y y(13);
    for (std::size_t i = 0; i < 6; ++i) {
        y[i] = T_0[i] / scale;
        y[6 + i] = h_0[i] / R;
    }
    y[12] = state[GRIT_SAND_VOID_RATIO];
    bool inside = true;
    const auto length_of_h = [&y] {
        return std::sqrt(std::inner_product(y.begin() + 6, y.begin() + 12, y.begin() + 6, 0.0L));
    };
    Real least_h = basic ? 1.0L : length_of_h();
    int rates = 0;
    const auto tensor = [](const Y& v, std::size_t first, Real size) {
        Tensor out;
        for (std::size_t i = 0; i < 6; ++i) out[i] = v[first + i] * size;
        return out;
    };
    struct OutOfDomain {};
    const auto slope = [&](const Y& v, Y& dv, Real) {
        const Law::Rate rate = law.rate(tensor(v, 0, scale), tensor(v, 6, R), v[12], D);
        if (!rate.inside || ++rates > most_rates) throw OutOfDomain();
        for (std::size_t i = 0; i < 6; ++i) {
            dv[i] = rate.T[i] / scale;
            dv[6 + i] = rate.h[i] / R;
        }
        dv[12] = rate.e;
    };
    // Counted from 0, where powers of |h| may rise without a slope.
    const auto march = [&](Real strained) {
        using namespace boost::numeric::odeint;
        // Short steps, for paths that pass the hydrostatic axis, where F has the tip of a cone.
        const Real longest = strained / 100.0L;
        integrate_adaptive(
            make_controlled(1e-15L, 1e-15L, longest, runge_kutta_fehlberg78<Y, Real, Y, Real>()),
            slope, y, 0.0L, strained, 0.1L * longest);
    };
    const Real turn = -dot(h_0, D);  // until there the strain leads away from h
    try {
        const bool turns = !basic && turn > 0.0L && turn < length;
        if (turns) {
            march(turn);
            least_h = std::fmin(least_h, length_of_h());
        }
        march(turns ? length - turn : length);
    } catch (const OutOfDomain&) {
        inside = false;
    }
    if (!inside) return std::nullopt;
    ExactEnd out{};
    out.least_h = static_cast<double>(least_h);
    for (std::size_t i = 0; i < 6; ++i) {
        out.stress[i] = static_cast<double>(y[i] * scale / (i < 3 ? 1.0L : root_2));
        out.h[i] = static_cast<double>(y[6 + i] * R * (i < 3 ? 1.0L : root_2));
    }
    return out;
}

}  // namespace robustness
