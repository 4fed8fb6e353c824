// SPDX-License-Identifier: BSD-3-Clause
// Where a step's course is evaluated, and the weights that make integrals and averages of it.
#pragma once

#include "support/elementary.hpp"

GRIT_KERNEL_BEGIN

// Where J is evaluated within a step: the stages of a method, its end last, and more so that the weights of
// the arc length up to there are not negative. The start of the step is known.
// decay: exp(-q) at the nodes over that at the start, as powers of one exponential.
// averages: stages that are given averaged waypoints, and moments that these share with the course;
// left_out: the node that AverageWeights do without to see how rough a course is.
struct DormandPrinceNodes {
    static constexpr int stages = 5, nodes = 7;
    static constexpr int averages = 5, moments = 3, left_out = 6;
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
    static constexpr int stages = 3, nodes = 5;
    static constexpr int averages = 2, moments = 2, left_out = 1;
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

// Of the polynomial that starts at w and has the given moments over [0, 1], at x: the weights of these.
template <int moments> struct Matched {
    long double of_start = 0.0L, of_moment[moments] = {};

    constexpr explicit Matched(long double x) {
        // Rows: moments of w + sum c_k x^k, k from 1; right-hand sides: unit moments, and -w's.
        constexpr int columns = 2 * moments + 1;
        long double a[moments][columns] = {};
        for (int j = 0; j < moments; ++j) {
            for (int k = 0; k < moments; ++k) a[j][k] = 1.0L / (j + k + 2);
            a[j][moments + j] = 1.0L;
            a[j][columns - 1] = -1.0L / (j + 1);
        }
        for (int pivot = 0; pivot < moments; ++pivot)
            for (int row = 0; row < moments; ++row) {
                const long double share = a[row][pivot] / a[pivot][pivot];
                if (row != pivot)
                    for (int k = 0; k < columns; ++k) a[row][k] -= share * a[pivot][k];
            }
        of_start = 1.0L;
        long double power = 1.0L;
        for (int k = 0; k < moments; ++k) {
            power *= x;
            for (int j = 0; j < moments; ++j) of_moment[j] += power * a[k][moments + j] / a[k][k];
            of_start += power * a[k][columns - 1] / a[k][k];
        }
    }
};

// The rate is linear in a waypoint, which may change much within a step while the stress hardly does. A method
// integrates polynomials of some degree exactly, so it is given the one that starts at the waypoint at the start and
// has the mean and the first moments of the polynomial through all nodes: what is left is the error of the stress.
template <class Nodes> struct AverageWeights {
    static constexpr int rough = Nodes::averages,
                         rows = rough + 1;  // rough: what one node less makes of the mean
    double start[rows], at[rows][Nodes::nodes];
};

template <class Nodes> constexpr AverageWeights<Nodes> average_weights() {
    constexpr int gap = Nodes::left_out + 1;
    AverageWeights<Nodes> w{};
    for (int i = 0; i <= Nodes::nodes; ++i) {
        const Lagrange<Nodes> all(i);
        const auto set = [&](int row, long double weight) {
            (i == 0 ? w.start[row] : w.at[row][i - 1]) = static_cast<double>(weight);
        };
        for (int row = 0; row < Nodes::averages; ++row) {
            const Matched<Nodes::moments> p(Nodes::at[row]);
            long double sum = i == 0 ? p.of_start : 0.0L;
            for (int j = 0; j < Nodes::moments; ++j) sum += p.of_moment[j] * all.integral(1.0L, j);
            set(row, sum);
        }
        const long double coarse = i == gap ? 0.0L : Lagrange<Nodes>(i, gap).integral(1.0L);
        set(w.rough, all.integral(1.0L) - coarse);
    }
    return w;
}

template <class Nodes> constexpr AverageWeights<Nodes> average_weight = average_weights<Nodes>();

// Polynomials that a method integrates exactly pass through as they are, and are not rough.
template <class Nodes> constexpr bool keeps_polynomials() {
    constexpr const AverageWeights<Nodes>& weight = average_weight<Nodes>;
    for (int row = 0; row < weight.rows; ++row)
        for (int degree = 0; degree <= Nodes::moments; ++degree) {
            const auto power = [&](double x) {
                double p = 1.0;
                for (int k = 0; k < degree; ++k) p *= x;
                return p;
            };
            double sum = row == weight.rough ? 0.0 : -power(Nodes::at[row]);
            sum += degree == 0 ? weight.start[row] : 0.0;
            for (int i = 0; i < Nodes::nodes; ++i) sum += weight.at[row][i] * power(Nodes::at[i]);
            if (!(sum < 1e-14 && sum > -1e-14)) return false;
        }
    return true;
}
static_assert(keeps_polynomials<ThirdOrderNodes>() && keeps_polynomials<DormandPrinceNodes>());

GRIT_KERNEL_END
