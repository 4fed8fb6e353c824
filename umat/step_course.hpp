// SPDX-License-Identifier: BSD-3-Clause
// The course of a step before any stress is known: what every stage of it needs, and its arc length.
#pragma once

#include "umat/arc_length.hpp"
#include "umat/stress_rate.hpp"

GRIT_KERNEL_BEGIN

// Where J is evaluated within a step: the stages of a method, its end last, and more so that the weights of
// the arc length are positive. The start of the step is known.
// decay: exp(-q) at the nodes over that at the start, as powers of one exponential.
struct DormandPrinceNodes {
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

template <class Nodes> struct ArcWeights {
    double start[Nodes::stages];             // of J at the start of the step
    double at[Nodes::stages][Nodes::nodes];  // of J at the nodes
};

// Weights of the polynomial through the start and all nodes, integrated from the start to each stage.
template <class Nodes> constexpr ArcWeights<Nodes> arc_weights() {
    constexpr int nodes = Nodes::nodes;
    ArcWeights<Nodes> w{};
    for (int i = -1; i < nodes; ++i) {
        long double polynomial[nodes + 1] = {1.0L};  // of Lagrange: 1 at node i, 0 at the others
        const long double own = i < 0 ? 0.0L : static_cast<long double>(Nodes::at[i]);
        for (int j = -1, degree = 0; j < nodes; ++j) {
            if (j == i) continue;
            const long double other = j < 0 ? 0.0L : static_cast<long double>(Nodes::at[j]);
            ++degree;
            for (int k = degree; k >= 0; --k)
                polynomial[k] =
                    ((k > 0 ? polynomial[k - 1] : 0.0L) - other * polynomial[k]) / (own - other);
        }
        for (int stage = 0; stage < Nodes::stages; ++stage) {
            const long double to = Nodes::at[stage];
            long double integral = 0.0L;
            for (int k = nodes; k >= 0; --k) integral = (integral + polynomial[k] / (k + 1)) * to;
            (i < 0 ? w.start[stage] : w.at[stage][i]) = static_cast<double>(integral);
        }
    }
    return w;
}

template <class Nodes> constexpr ArcWeights<Nodes> arc_weight = arc_weights<Nodes>();

constexpr double least_decay = 1e-300;

// Of a step's start.
template <class Real> struct Position {
    Real q, decay;  // of the course; exp(-q)
    Real s, e;      // arc length, void ratio
};

template <class Real, class Nodes> struct StepCourse {
    Waypoint<Real> at[Nodes::stages];
    Mobilisation<Real> end;
    Real end_decay;  // exp(-q) there
    Real arc;        // length of the step

    GRIT_INLINE const Waypoint<Real>& at_end() const { return at[Nodes::stages - 1]; }
};

template <class Nodes, class Real>
GRIT_INLINE StepCourse<Real, Nodes>
step_course(const Material& m, const StraightPath<Real>& path, const Course<Real>& course,
            const Position<Real>& from, const Real& J, const Real& dq) {
    constexpr int nodes = Nodes::nodes, stages = Nodes::stages;
    constexpr const ArcWeights<Nodes>& weight = arc_weight<Nodes>;
    Mobilisation<Real> h[nodes];
    Real decay[nodes];
    Nodes::decay(dq, decay);
    for (int i = 0; i < nodes; ++i)
        h[i] = mobilisation(m, course, fma(Real(Nodes::at[i]), dq, from.q),
                            max(from.decay * decay[i], Real(least_decay)));
    const Real R_dq = m.R * dq;
    StepCourse<Real, Nodes> r;
    for (int stage = 0; stage < stages; ++stage) {
        Real mean = weight.start[stage] * J;
        for (int i = 0; i < nodes; ++i) mean = fma(Real(weight.at[stage][i]), h[i].J, mean);
        r.at[stage] = waypoint(m, course.loading, h[stage],
                               (1.0 + from.e) * exp_small(R_dq * mean * path.tr_D) - 1.0);
        r.arc = R_dq * mean;
    }
    r.end_decay = max(from.decay * decay[stages - 1], Real(least_decay));
    r.end = h[stages - 1];
    return r;
}

// The nodes of one path at once, with the bits of the loop above.
template <class Nodes>
GRIT_INLINE StepCourse<double, Nodes>
step_course(const Material& m, const StraightPath<double>& path, const Course<double>& course,
            const Position<double>& from, const double& J, const double& dq) {
    constexpr int nodes = Nodes::nodes, stages = Nodes::stages;
    constexpr const ArcWeights<Nodes>& weight = arc_weight<Nodes>;
    using Points = Pack<8>;
    const auto column = [](const auto& of_lane) {
        Points x;
        for (int lane = 0; lane < 8; ++lane) x.set(lane, of_lane(lane));
        return x;
    };
    const LoadingCurve<double>& c = course.curve;
    const Course<Points> all{course.loading,
                             {Points(c.E_sq), Points(c.across), Points(c.y), Points(c.kappa)},
                             Points(course.u_0),
                             Points(course.tau_sq)};
    const Points at = column([](int i) { return i < nodes ? Nodes::at[i] : 1.0; });
    double decay[nodes];
    Nodes::decay(dq, decay);
    const Points all_decay = column([&](int i) { return decay[i < nodes ? i : stages - 1]; });
    const Mobilisation<Points> h =
        mobilisation(m, all, fma(at, Points(dq), Points(from.q)),
                     max(Points(from.decay) * all_decay, Points(least_decay)));
    Points mean = column([](int i) { return i < stages ? weight.start[i] : 0.0; }) * Points(J);
    for (int j = 0; j < nodes; ++j)
        mean = fma(column([j](int i) { return i < stages ? weight.at[i][j] : 0.0; }),
                   Points(h.J[j]), mean);
    const double R_dq = m.R * dq;
    const Points e =
        (1.0 + Points(from.e)) * exp_small(Points(R_dq) * mean * Points(path.tr_D)) - 1.0;
    const Waypoint<Points> w = waypoint(m, all.loading, h, e);
    StepCourse<double, Nodes> r;
    for (int i = 0; i < stages; ++i)
        r.at[i] = {w.ds[i], w.e[i], w.along[i], w.across[i], w.flow[i]};
    constexpr int end = stages - 1;
    r.end = {h.rho[end], h.c[end], h.across[end], h.J[end], h.J_growth[end], h.rho_beta[end]};
    r.end_decay = max(from.decay * decay[end], least_decay);
    r.arc = R_dq * mean[end];
    return r;
}

// Without intergranular strain q is the strain over R.
template <class Nodes, class Real>
GRIT_INLINE StepCourse<Real, Nodes> basic_step_course(const Material& m,
                                                      const StraightPath<Real>& path,
                                                      const Position<Real>& from, const Real& dq) {
    const Real R_dq = m.R * dq;
    StepCourse<Real, Nodes> r;
    for (int i = 0; i < Nodes::stages; ++i)
        r.at[i] =
            basic_waypoint(m, (1.0 + from.e) * exp_small(Nodes::at[i] * R_dq * path.tr_D) - 1.0);
    r.end = no_mobilisation(dq);
    r.end_decay = from.decay;
    r.arc = R_dq;
    return r;
}

GRIT_KERNEL_END
