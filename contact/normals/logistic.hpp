// SPDX-License-Identifier: BSD-3-Clause
// The plane that parts two clouds: minimum of the penalised logistic loss
//
//   sum_p weight_p log(1 + exp(-m_p)) + ridge / 2 |w|^2,   m_p = y_p (w . x_p + b)
//
// (the weights of each body have the sum 1/2), which is convex, has one minimum for every ridge > 0 as soon as both bodies are there (separable,
// coincident and collinear clouds included), and does not penalise the offset b.
#pragma once

#include "contact/normals/cloud.hpp"

GRIT_KERNEL_BEGIN

GRIT_INLINE double sum_of(Lanes x) {
    double half[native_lanes];
    __builtin_memcpy(half, &x.v, sizeof half);
    for (int width = native_lanes / 2; width > 0; width /= 2)
        for (int lane = 0; lane < width; ++lane) half[lane] += half[lane + width];
    return half[0];
}

// w and b
template <int D> struct Plane { double u[D + 1]; };

template <int D> struct Loss {
    double value;
    double gradient[D + 1];
    double hessian[D + 1][D + 1];  // lower triangle
};

// log(1 + exp(-m)), minus its derivative, and its second derivative.
struct Logistic {
    Lanes value, pull, bend;
};

GRIT_INLINE Logistic logistic(Lanes m) {
    const Lanes e = exp(-fabs(m));
    const Lanes one_e = Lanes(1.0) + e;
    const Lanes q = Lanes(1.0) / one_e;
    // What 1 + e has lost is added, or small losses would be noise to the line search.
    const Lanes log_one_e = fma(e - (one_e - Lanes(1.0)), q, log(one_e));
    return {log_one_e + max(-m, Lanes(0.0)), select(m > Lanes(0.0), e * q, q), e * q * q};
}

// at_start: the plane is zero, and so is every m.
template <int D, bool at_start>
Loss<D> loss(const Cloud& cloud, double ridge, const Plane<D>& plane) {
    Lanes value(0.0), gradient[D + 1], hessian[D + 1][D + 1];
    for (int r = 0; r <= D; ++r) {
        gradient[r] = Lanes(0.0);
        for (int c = 0; c <= r; ++c) hessian[r][c] = Lanes(0.0);
    }
    Logistic f{Lanes(0x1.62e42fefa39efp-1), Lanes(0.5), Lanes(0.25)};
    for (int k = 0; k < cloud.packs; ++k) {
        Lanes row[D + 1], m(0.0);
        for (int r = 0; r <= D; ++r) {
            row[r] = load(cloud.row[r] + k * native_lanes);
            m = fma(Lanes(plane.u[r]), row[r], m);
        }
        if constexpr (!at_start) f = logistic(m);
        const Lanes weight = load(cloud.weight + k * native_lanes);
        value = fma(weight, f.value, value);
        const Lanes pull = weight * f.pull, bend = weight * f.bend;
        for (int r = 0; r <= D; ++r) {
            gradient[r] = fma(-pull, row[r], gradient[r]);
            const Lanes bent = bend * row[r];
            for (int c = 0; c <= r; ++c) hessian[r][c] = fma(bent, row[c], hessian[r][c]);
        }
    }
    Loss<D> sums;
    sums.value = sum_of(value);
    for (int r = 0; r <= D; ++r) {
        sums.gradient[r] = sum_of(gradient[r]);
        for (int c = 0; c <= r; ++c) sums.hessian[r][c] = sum_of(hessian[r][c]);
    }
    for (int r = 0; r < D; ++r) {
        sums.value += 0.5 * ridge * square(plane.u[r]);
        sums.gradient[r] += ridge * plane.u[r];
        sums.hessian[r][r] += ridge;
    }
    return sums;
}

// -hessian^-1 gradient: the offset is eliminated first, what is left is at least the ridge.
template <int D> Plane<D> newton_step(const Loss<D>& f) {
    const double bend = max(f.hessian[D][D], 1e-290);
    double mean[D], A[D][D];
    Plane<D> step;
    for (int r = 0; r < D; ++r) {
        mean[r] = f.hessian[D][r] / bend;
        for (int c = 0; c <= r; ++c) A[r][c] = f.hessian[r][c] - mean[r] * f.hessian[D][c];
        step.u[r] = mean[r] * f.gradient[D] - f.gradient[r];
    }
    for (int r = 0; r < D; ++r) {  // L D L^T
        for (int c = 0; c < r; ++c) {
            for (int k = 0; k < c; ++k) A[r][c] -= A[r][k] * A[c][k] * A[k][k];
            A[r][c] /= A[c][c];
        }
        for (int k = 0; k < r; ++k) A[r][r] -= square(A[r][k]) * A[k][k];
    }
    for (int r = 0; r < D; ++r)
        for (int k = 0; k < r; ++k) step.u[r] -= A[r][k] * step.u[k];
    for (int r = 0; r < D; ++r) step.u[r] /= A[r][r];
    for (int r = D - 1; r >= 0; --r)
        for (int k = r + 1; k < D; ++k) step.u[r] -= A[k][r] * step.u[k];
    step.u[D] = -f.gradient[D] / bend;
    for (int r = 0; r < D; ++r) step.u[D] -= mean[r] * step.u[r];
    return step;
}

template <int D> struct Regression {
    Plane<D> plane;
    int evaluations;
    bool converged;
};

// Newton steps, halved until the loss decreases enough (Armijo); the last one is taken as it comes: it
// moves no m_p by more than 1e-6, so that what remains is of the order of its square.
template <int D> Regression<D> separate(const Cloud& cloud, double ridge, int evaluation_limit) {
    constexpr double last_change = 1e-6;
    constexpr double sufficient = 1e-4;
    constexpr double roundoff = 1e-14;
    Regression<D> result{};
    Loss<D> f = loss<D, true>(cloud, ridge, result.plane);
    result.evaluations = 1;
    for (;;) {
        const Plane<D> step = newton_step<D>(f);
        double change = fabs(step.u[D]), slope = step.u[D] * f.gradient[D];
        for (int r = 0; r < D; ++r) {
            change += cloud.radius * fabs(step.u[r]);
            slope += step.u[r] * f.gradient[r];
        }
        result.converged = change <= last_change;
        if (!result.converged && result.evaluations >= evaluation_limit) return result;
        for (double share = 1.0;; share *= 0.5) {
            Plane<D> trial;
            for (int r = 0; r <= D; ++r) trial.u[r] = result.plane.u[r] + share * step.u[r];
            if (result.converged) {
                result.plane = trial;
                return result;
            }
            const Loss<D> g = loss<D, false>(cloud, ridge, trial);
            ++result.evaluations;
            if (g.value <= f.value + sufficient * share * slope + roundoff * f.value) {
                result.plane = trial;
                f = g;
                break;
            }
            if (result.evaluations >= evaluation_limit) return result;
        }
    }
}

GRIT_KERNEL_END
