// SPDX-License-Identifier: BSD-3-Clause
// Where a step's course is evaluated, and the weights that make integrals and averages of it.
#pragma once

#include "support/elementary.hpp"

GRIT_KERNEL_BEGIN

// Where J is evaluated within a step: the stages of a method, its end last, and more so that the weights of
// the arc length up to there are not negative. The start of the step is known.
// decay: exp(-q) at the nodes over that at the start, as powers of one exponential.
// averaged: see AverageWeights.
struct DormandPrinceNodes {
    static constexpr bool averaged = false;
    static constexpr int stages = 5, nodes = 7;
    static constexpr double at[nodes] = {1.0 / 5.0, 3.0 / 10.0, 4.0 / 5.0, 8.0 / 9.0,
                                         1.0,       0.1,        0.55};

    template <class Real> static GRIT_INLINE void decay(const Real& dq, Real (&d)[nodes]) {
        const Real half = exp(dq * (-1.0 / 180.0)), x = half * half;  // x: of dq/90
        const Real x_2 = x * x, x_4 = x_2 * x_2, x_8 = x_4 * x_4;
        d[5] = x_8 * x;
        d[0] = d[5] * d[5];
        d[1] = d[0] * d[5];
        const Real x_36 = d[0] * d[0], x_45 = d[1] * d[0];
        d[2] = x_36 * x_36;
        d[3] = d[2] * x_8;
        d[4] = x_45 * x_45;
        d[6] = x_45 * (x_4 * half);
    }
};
struct ThirdOrderNodes {
    static constexpr bool averaged = true;
    static constexpr int stages = 3, nodes = 5;
    static constexpr double at[nodes] = {0.5, 0.75, 1.0, 0.125, 0.25};

    template <class Real> static GRIT_INLINE void decay(const Real& dq, Real (&d)[nodes]) {
        d[3] = exp(dq * -0.125);
        d[4] = d[3] * d[3];
        d[0] = d[4] * d[4];
        d[1] = d[0] * d[4];
        d[2] = d[0] * d[0];
    }
};

// Coefficients of the polynomial that is 1 at one of the places 0, Nodes::at and 0 at the others; of all but
// one that is left out.
template <class Nodes> struct Lagrange {
    long double of[Nodes::nodes + 1] = {1.0L};

    static constexpr long double place(int i) {
        return i == 0 ? 0.0L : static_cast<long double>(Nodes::at[i - 1]);
    }
    constexpr Lagrange(int own, int left_out = -1) {
        int degree = 0;
        for (int other = 0; other <= Nodes::nodes; ++other) {
            if (other == own || other == left_out) continue;
            ++degree;
            for (int k = degree; k >= 0; --k)
                of[k] = ((k > 0 ? of[k - 1] : 0.0L) - place(other) * of[k]) /
                        (place(own) - place(other));
        }
    }
    // Of x^moment times it, from 0.
    constexpr long double integral(long double to, int moment = 0) const {
        long double sum = 0.0L;
        for (int k = Nodes::nodes; k >= 0; --k) sum = sum * to + of[k] / (k + 1 + moment);
        for (int k = 0; k <= moment; ++k) sum *= to;
        return sum;
    }
};

template <class Nodes> struct ArcWeights {
    double start[Nodes::stages];             // of J at the start of the step
    double at[Nodes::stages][Nodes::nodes];  // of J at the nodes
};

// Weights of the polynomial through the start and all nodes, integrated from the start to each stage.
template <class Nodes> constexpr ArcWeights<Nodes> arc_weights() {
    ArcWeights<Nodes> w{};
    for (int i = 0; i <= Nodes::nodes; ++i)
        for (int stage = 0; stage < Nodes::stages; ++stage)
            (i == 0 ? w.start[stage] : w.at[stage][i - 1]) =
                static_cast<double>(Lagrange<Nodes>(i).integral(Nodes::at[stage]));
    return w;
}

template <class Nodes> constexpr ArcWeights<Nodes> arc_weight = arc_weights<Nodes>();

// The rate is linear in a waypoint, which may change much within a step while the stress hardly does. A method of
// third order integrates parabolas, so it is given the one that starts at the waypoint at the start and has the
// mean and the first moment of the polynomial through all nodes: what is left is the error of the stress.
template <class Nodes> struct AverageWeights {
    static constexpr int parabola = Nodes::stages - 1;  // at the stages before the end
    static constexpr int mean = parabola, rough = parabola + 1, rows = parabola + 2;
    double start[rows], at[rows][Nodes::nodes];
};

// Node 0.75 is left out to see how rough it is.
template <class Nodes> constexpr AverageWeights<Nodes> average_weights() {
    AverageWeights<Nodes> w{};
    constexpr int left_out = 2;
    for (int i = 0; i <= Nodes::nodes; ++i) {
        const Lagrange<Nodes> all(i);
        const long double mean = all.integral(1.0L), moment = all.integral(1.0L, 1);
        const long double coarse =
            i == left_out ? 0.0L : Lagrange<Nodes>(i, left_out).integral(1.0L);
        for (int row = 0; row < w.rows; ++row) {
            double& weight = i == 0 ? w.start[row] : w.at[row][i - 1];
            if (row == w.mean) weight = static_cast<double>(mean);
            else if (row == w.rough) weight = static_cast<double>(mean - coarse);
            else {
                const long double x = Nodes::at[row];
                const long double of_mean = x * (18.0L - 24.0L * x);
                const long double of_moment = x * (36.0L * x - 24.0L);
                weight = static_cast<double>(of_mean * mean + of_moment * moment +
                                             (i == 0 ? 1.0L - of_mean - 0.5L * of_moment : 0.0L));
            }
        }
    }
    return w;
}

template <class Nodes> constexpr AverageWeights<Nodes> average_weight = average_weights<Nodes>();

GRIT_KERNEL_END
