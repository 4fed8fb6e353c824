// SPDX-License-Identifier: BSD-3-Clause
// The equations of von Wolffersdorff (1996) and Niemunis & Herle (1997) as printed, on 3 x 3
// matrices: the tests' own transcription, for doubles and for Eigen's AutoDiffScalar.
#pragma once

#include "support/operators.hpp"

namespace tests::paper {

template <class S> using Vector = Eigen::Matrix<S, 6, 1>;

template <class S> struct Parts {
    S a, F, f_d, f_e, f_b, f_s, T_hat_sq;
    Vector<S> T_hat, T_hat_dev;
};

template <class S> S trace_of_cube(const Vector<S>& A) {
    Eigen::Matrix<S, 3, 3> M;
    const S x = A[3] / root_2, y = A[4] / root_2, z = A[5] / root_2;
    M << A[0], x, y, x, A[1], z, y, z, A[2];
    const Eigen::Matrix<S, 3, 3> square = M * M;
    const Eigen::Matrix<S, 3, 3> cube = square * M;
    return S(cube(0, 0) + cube(1, 1) + cube(2, 2));
}

template <class S> Parts<S> parts(const grit_sand_parameters& m, const Vector<S>& T, const S& e) {
    using std::exp, std::pow, std::sqrt;
    Parts<S> k;
    const S tr = T[0] + T[1] + T[2];
    k.T_hat = T / tr;
    k.T_hat_dev = k.T_hat;
    for (int i = 0; i < 3; ++i) k.T_hat_dev[i] = S(k.T_hat[i] - 1.0 / 3.0);
    k.T_hat_sq = k.T_hat.squaredNorm();
    const double sine = std::sin(m.critical_friction_angle);
    k.a = S(std::sqrt(3.0) * (3.0 - sine) / (2.0 * std::sqrt(2.0) * sine));  // (H4)
    const S dev_sq = k.T_hat_dev.squaredNorm();
    k.F = S(1.0);
    if (dev_sq > 1e-28) {
        const S dev = sqrt(dev_sq);
        const S t = std::sqrt(3.0) * dev;
        const S cos3 = -std::sqrt(6.0) * trace_of_cube<S>(k.T_hat_dev) / (dev_sq * dev);
        const S radicand = t * t / 8.0 + (2.0 - t * t) / (2.0 + std::sqrt(2.0) * t * cos3);
        k.F = sqrt(radicand) - t / (2.0 * std::sqrt(2.0));  // (H5)
    }
    const S ratio = -tr / m.granulate_hardness;  // 3p/h_s
    const double n = m.stiffness_exponent;
    const S x = pow(ratio, n);
    const S fall = exp(-x);  // (H6)
    const S e_i = m.loosest_void_ratio * fall;
    const S e_c = m.critical_void_ratio * fall;
    const S e_d = m.densest_void_ratio * fall;
    const S relative = (e - e_d) / (e_c - e_d);
    const S loose = e_c / e;
    k.f_d = pow(relative, m.pyknotropy_exponent);   // (H7)
    k.f_e = pow(loose, m.stiffness_void_exponent);  // (H7)
    const double spread = (m.loosest_void_ratio - m.densest_void_ratio) /
                          (m.critical_void_ratio - m.densest_void_ratio);
    const double widening = m.loosest_void_ratio / m.critical_void_ratio;
    const S bracket =
        3.0 + k.a * k.a - std::sqrt(3.0) * std::pow(spread, m.pyknotropy_exponent) * k.a;
    const S power = pow(ratio, 1.0 - n);
    k.f_b = m.granulate_hardness / n * std::pow(widening, m.stiffness_void_exponent) * (1.0 + e_i) /
            e_i * power / bracket;  // (H8)
    k.f_s = k.f_b * k.f_e;
    return k;
}

// L:X
template <class S> Vector<S> L_of(const Parts<S>& k, const Vector<S>& X) {
    const S scale = k.f_s / k.T_hat_sq;
    const S along = k.T_hat.dot(X);
    const S isotropic = scale * k.F * k.F;
    const S directed = scale * k.a * k.a * along;
    return X * isotropic + k.T_hat * directed;  // (H2)
}

template <class S> Vector<S> N_of(const Parts<S>& k) {
    const S scale = k.f_s * k.f_d * k.a * k.F / k.T_hat_sq;
    return (k.T_hat + k.T_hat_dev) * scale;  // (H3)
}

template <class S>
Vector<S> basic_rate(const grit_sand_parameters& m, const Vector<S>& T, const S& e,
                     const Vector<S>& D) {
    using std::sqrt;
    const Parts<S> k = parts<S>(m, T, e);
    const S square = D.squaredNorm();
    const S speed = sqrt(square);
    return L_of<S>(k, D) + N_of<S>(k) * speed;  // (H1)
}

template <class S>
Vector<S> intergranular_rate(const grit_sand_parameters& m, const Vector<S>& T, const Vec& h,
                             const S& e, const Vector<S>& D) {
    const Parts<S> k = parts<S>(m, T, e);
    const double length = h.norm();
    const Vector<S> h_hat = (length > 0.0 ? Vec(h / length) : Vec(Vec::Zero())).template cast<S>();
    const double w = std::pow(length / m.elastic_strain_radius, m.stiffness_interpolation_exponent);
    const double m_T = m.transverse_stiffness, m_R = m.reversal_stiffness;
    const S along = h_hat.dot(D);
    const Vector<S> L_h = L_of<S>(k, h_hat);
    const S both = S(w * m_T + (1.0 - w) * m_R);
    Vector<S> T_rate = L_of<S>(k, D) * both;  // (G1), (G2)
    if (along > 0.0) {
        const S first = w * (1.0 - m_T) * along;
        const S second = w * along;
        T_rate += L_h * first + N_of<S>(k) * second;
    } else {
        const S reversal = w * (m_R - m_T) * along;
        T_rate += L_h * reversal;
    }
    return T_rate;
}

inline Vec memory_rate(const grit_sand_parameters& m, const Vec& h, const Vec& D) {
    const double length = h.norm();
    if (length == 0.0 || h.dot(D) <= 0.0) return D;
    const double drag = std::pow(length / m.elastic_strain_radius, m.evolution_exponent);
    return D - drag / (length * length) * h.dot(D) * h;  // (G3)
}

}  // namespace tests::paper
