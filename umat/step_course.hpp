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

// r is filled in place: with derivatives it is large.
template <class Nodes, class Real>
GRIT_INLINE void step_course_one_by_one(const Material& m, const StraightPath<Real>& path,
                                        const Course<Real>& course, const Position<Real>& from,
                                        const Real& J, const Real& dq, StepCourse<Real, Nodes>& r) {
    constexpr int nodes = Nodes::nodes, stages = Nodes::stages;
    constexpr const ArcWeights<Nodes>& weight = arc_weight<Nodes>;
    Mobilisation<Real> h[nodes];
    Real decay[nodes];
    Nodes::decay(dq, decay);
    for (int i = 0; i < nodes; ++i)
        h[i] = mobilisation(m, course, fma(Real(Nodes::at[i]), dq, from.q),
                            max(from.decay * decay[i], Real(least_decay)));
    const Real R_dq = m.R * dq;
    for (int stage = 0; stage < stages; ++stage) {
        Real mean = weight.start[stage] * J;
        for (int i = 0; i < nodes; ++i) mean = fma(Real(weight.at[stage][i]), h[i].J, mean);
        r.at[stage] = waypoint(m, course.loading, h[stage],
                               (1.0 + from.e) * exp_small(R_dq * mean * path.tr_D) - 1.0);
        r.arc = R_dq * mean;
    }
    r.end_decay = max(from.decay * decay[stages - 1], Real(least_decay));
    r.end = h[stages - 1];
}

using NodeValues = Pack<8>;

// exp(-q) over that at the start; of lanes that are no node, 1.
template <class Nodes> GRIT_INLINE NodeValues decay_at_nodes(double dq) {
    double decay[Nodes::nodes];
    Nodes::decay(dq, decay);
    return NodeValues::each([&](int i) { return i < Nodes::nodes ? decay[i] : 1.0; });
}
template <class Nodes> GRIT_INLINE DualPack<8> decay_at_nodes(const Dual& dq) {
    const NodeValues decay = decay_at_nodes<Nodes>(dq.v);
    const NodeValues at =
        NodeValues::each([](int i) { return i < Nodes::nodes ? Nodes::at[i] : 0.0; });
    return {decay, in_lanes<8>(dq).d * (-at * decay)};
}

// The nodes of one point at once, with the bits of those one by one.
template <class Nodes, class Real>
GRIT_INLINE void step_course_in_lanes(const Material& m, const StraightPath<Real>& path,
                                      const Course<Real>& course, const Position<Real>& from,
                                      const Real& J, const Real& dq, StepCourse<Real, Nodes>& r) {
    constexpr int nodes = Nodes::nodes, stages = Nodes::stages;
    constexpr const ArcWeights<Nodes>& weight = arc_weight<Nodes>;
    using All = InLanes<Real, 8>;
    const auto all = [](const Real& x) { return in_lanes<8>(x); };
    const Course<All> courses = course_in_lanes<8>(course);
    const NodeValues at = NodeValues::each([](int i) { return i < nodes ? Nodes::at[i] : 0.0; });
    const All decay =
        max(all(from.decay) * decay_at_nodes<Nodes>(dq), All(NodeValues(least_decay)));
    const Mobilisation<All> h = mobilisation(m, courses, fma(at, all(dq), all(from.q)), decay);
    All mean = NodeValues::each([](int i) { return i < stages ? weight.start[i] : 0.0; }) * all(J);
    for (int j = 0; j < nodes; ++j)
        mean = fma(NodeValues::each([j](int i) { return i < stages ? weight.at[i][j] : 0.0; }),
                   all(of_lane(h.J, j)), mean);
    const Real R_dq = m.R * dq;
    const All e = (1.0 + all(from.e)) * exp_small(all(R_dq) * mean * all(path.tr_D)) - 1.0;
    const Waypoint<All> w = waypoint(m, courses.loading, h, e);
    for (int i = 0; i < stages; ++i)
        r.at[i] = {of_lane(w.ds, i), of_lane(w.e, i), of_lane(w.along, i), of_lane(w.across, i),
                   of_lane(w.flow, i)};
    constexpr int end = stages - 1;
    r.end = {of_lane(h.rho, end), of_lane(h.c, end),        of_lane(h.across, end),
             of_lane(h.J, end),   of_lane(h.J_growth, end), h.rho_beta[end]};
    r.end_decay = of_lane(decay, end);
    r.arc = R_dq * of_lane(mean, end);
}

template <class Nodes, class Real>
GRIT_INLINE void step_course(const Material& m, const StraightPath<Real>& path,
                             const Course<Real>& course, const Position<Real>& from, const Real& J,
                             const Real& dq, StepCourse<Real, Nodes>& r) {
    if constexpr (takes_lanes<Real>) step_course_in_lanes(m, path, course, from, J, dq, r);
    else step_course_one_by_one(m, path, course, from, J, dq, r);
}

// Without intergranular strain q is the strain over R.
template <class Nodes, class Real>
GRIT_INLINE void basic_step_course(const Material& m, const StraightPath<Real>& path,
                                   const Position<Real>& from, const Real& dq,
                                   StepCourse<Real, Nodes>& r) {
    const Real R_dq = m.R * dq;
    for (int i = 0; i < Nodes::stages; ++i)
        r.at[i] =
            basic_waypoint(m, (1.0 + from.e) * exp_small(Nodes::at[i] * R_dq * path.tr_D) - 1.0);
    r.end = no_mobilisation(dq);
    r.end_decay = from.decay;
    r.arc = R_dq;
}

GRIT_KERNEL_END
