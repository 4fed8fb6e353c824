// SPDX-License-Identifier: BSD-3-Clause
// The course of a step before any stress is known: how far h is mobilised on the way, and its arc length.
#pragma once

#include "umat/integrate/arc_length.hpp"
#include "umat/integrate/course_nodes.hpp"
#include "umat/model/stress_rate.hpp"

GRIT_KERNEL_BEGIN

// Of a step's start.
template <class Real> struct Position {
    Real q, decay;  // of the course; exp(-q)
    Real s, e;      // arc length, void ratio
};

// At all nodes, those of one point as lanes.
template <class Real, class Nodes, bool in_lanes> struct MobilisationAtNodes {
    Mobilisation<InLanes<Real, 8>> all;
};
template <class Real, class Nodes> struct MobilisationAtNodes<Real, Nodes, false> {
    Mobilisation<Real> at[Nodes::nodes];
};

template <class Real, class Nodes> struct StepCourse {
    Real e[Nodes::stages];  // void ratios
    Real arc;               // length of the step
    MobilisationAtNodes<Real, Nodes, takes_lanes<Real>> nodes;
    Mobilisation<Real> end;
    Real end_decay;  // exp(-q) there
};

// r is filled in place: with derivatives it is large.
template <class Nodes, class Real>
GRIT_INLINE void step_course_one_by_one(const MaterialOf<Real>& m, const StraightPath<Real>& path,
                                        const Course<Real>& course, const Position<Real>& from,
                                        const Real& J, const Real& dq, StepCourse<Real, Nodes>& r) {
    constexpr int nodes = Nodes::nodes, stages = Nodes::stages;
    constexpr const ArcWeights<Nodes>& weight = arc_weight<Nodes>;
    Mobilisation<Real>(&h)[nodes] = r.nodes.at;
    Real decay[nodes];
    Nodes::decay(dq, decay);
    constexpr int end = stages - 1;
    for (int i = 0; i < nodes; ++i) {
        const Real q = fma(Real(Nodes::at[i]), dq, from.q);
        decay[i] = max(from.decay * decay[i], Real(least_decay));
        h[i] = i == end ? mobilisation(m, course, q, decay[i])
                        : mobilisation<false>(m, course, q, decay[i]);
    }
    const Real R_dq = m.R * dq;
    for (int stage = 0; stage < stages; ++stage) {
        Real mean = weight.start[stage] * J;
        for (int i = 0; i < nodes; ++i) mean = fma(Real(weight.at[stage][i]), h[i].J, mean);
        r.e[stage] = (1.0 + from.e) * exp_small(R_dq * mean * path.tr_D) - 1.0;
        r.arc = R_dq * mean;
    }
    r.end_decay = decay[end];
    r.end = h[end];
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
GRIT_INLINE void step_course_in_lanes(const MaterialOf<Real>& m, const StraightPath<Real>& path,
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
    const Mobilisation<All>& h = r.nodes.all =
        mobilisation(m, courses, fma(at, all(dq), all(from.q)), decay);
    All mean = NodeValues::each([](int i) { return i < stages ? weight.start[i] : 0.0; }) * all(J);
    for (int j = 0; j < nodes; ++j)
        mean = fma(NodeValues::each([j](int i) { return i < stages ? weight.at[i][j] : 0.0; }),
                   spread(h.J, j), mean);
    const Real R_dq = m.R * dq;
    const All e = (1.0 + all(from.e)) * exp_small(all(R_dq) * mean * all(path.tr_D)) - 1.0;
    for (int i = 0; i < stages; ++i) r.e[i] = of_lane(e, i);
    constexpr int end = stages - 1;
    r.end = {of_lane(h.rho, end), of_lane(h.c, end),        of_lane(h.across, end),
             of_lane(h.J, end),   of_lane(h.J_growth, end), h.rho_beta[end]};
    r.end_decay = of_lane(decay, end);
    r.arc = R_dq * of_lane(mean, end);
}

template <class Nodes, class Real>
GRIT_INLINE void step_course(const MaterialOf<Real>& m, const StraightPath<Real>& path,
                             const Course<Real>& course, const Position<Real>& from, const Real& J,
                             const Real& dq, StepCourse<Real, Nodes>& r) {
    if constexpr (takes_lanes<Real>) step_course_in_lanes(m, path, course, from, J, dq, r);
    else step_course_one_by_one(m, path, course, from, J, dq, r);
}

// Without intergranular strain q is the strain over R.
template <class Nodes, class Real>
GRIT_INLINE void basic_step_course(const MaterialOf<Real>& m, const StraightPath<Real>& path,
                                   const Position<Real>& from, const Real& dq,
                                   StepCourse<Real, Nodes>& r) {
    const Real R_dq = m.R * dq;
    for (int i = 0; i < Nodes::stages; ++i)
        r.e[i] = (1.0 + from.e) * exp_small(Nodes::at[i] * R_dq * path.tr_D) - 1.0;
    r.end = no_mobilisation(dq);
    r.end_decay = from.decay;
    r.arc = R_dq;
}

GRIT_KERNEL_END
