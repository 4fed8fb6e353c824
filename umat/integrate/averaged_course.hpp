// SPDX-License-Identifier: BSD-3-Clause
// Waypoints of a step averaged, so that a method need resolve the stress alone: AverageWeights.
#pragma once

#include "umat/integrate/segment.hpp"
#include "umat/integrate/step_course.hpp"

GRIT_KERNEL_BEGIN

template <class Real, class Nodes> struct AveragedCourse {
    Waypoint<Real> at[Nodes::averages];
    Waypoint<Real> end;       // not averaged
    PlainOf<Real> roughness;  // what the quadrature might miss, of a waypoint
};

// |M:D_hat| of a waypoint, roughly, per stiffness.
template <class Plain> GRIT_INLINE Plain size_of(const Waypoint<Plain>& w, const Plain& tau) {
    return fabs(w.along) + fabs(w.across) * tau + fabs(w.flow);
}

// What is as rough in the arc length does no harm: a stress that comes with its own arc length is on the curve T(s) still.
template <class Plain>
GRIT_INLINE Plain roughness_of(const Waypoint<Plain>& rough, const Waypoint<Plain>& end,
                               const Plain& tau_sq) {
    const Plain tau = sqrt(tau_sq), late = rough.ds / end.ds;
    const auto beside = [&](const Plain& of_rough, const Plain& of_end) {
        return fma(-late, of_end, of_rough);
    };
    const Waypoint<Plain> left{rough.ds, rough.e, beside(rough.along, end.along),
                               beside(rough.across, end.across), beside(rough.flow, end.flow)};
    return size_of(left, tau) / size_of(end, tau);
}

// with(x): a number as what the sums are made of. e is not averaged.
template <class Real, class Nodes, class With>
GRIT_INLINE auto weighted(int row, const Waypoint<Real>& start,
                          const Waypoint<Real> (&nodes)[Nodes::nodes], const With& with) {
    constexpr const AverageWeights<Nodes>& weight = average_weight<Nodes>;
    const auto sum = [&](Real Waypoint<Real>::*member) {
        auto total = weight.start[row] * with(start.*member);
        for (int i = 0; i < Nodes::nodes; ++i)
            total = fma(weight.at[row][i], with(nodes[i].*member), total);
        return total;
    };
    using W = Waypoint<Real>;
    return Waypoint<decltype(with(start.e))>{sum(&W::ds), with(start.e), sum(&W::along),
                                             sum(&W::across), sum(&W::flow)};
}

template <class Nodes, class Real>
GRIT_INLINE void
average_one_by_one(const MaterialOf<Real>& m, const Course<Real>& way, const Waypoint<Real>& start,
                   const StepCourse<Real, Nodes>& course, AveragedCourse<Real, Nodes>& r) {
    Waypoint<Real> nodes[Nodes::nodes];
    for (int i = 0; i < Nodes::nodes; ++i)
        nodes[i] = waypoint(m, way.loading, course.nodes.at[i], start.e);
    for (int row = 0; row < Nodes::averages; ++row)
        r.at[row] = weighted<Real, Nodes>(row, start, nodes, [](const Real& x) { return x; });
    r.end = nodes[Nodes::stages - 1];
    const auto rough = weighted<Real, Nodes>(AverageWeights<Nodes>::rough, start, nodes,
                                             [](const Real& x) { return value(x); });
    r.roughness = roughness_of<PlainOf<Real>>(rough, value(r.end), value(way.tau_sq));
}

// The rows as lanes, with the bits of those one by one.
template <class Nodes, class Real>
GRIT_INLINE void
average_in_lanes(const MaterialOf<Real>& m, const Course<Real>& way, const Waypoint<Real>& start,
                 const StepCourse<Real, Nodes>& course, AveragedCourse<Real, Nodes>& r) {
    using Weights = AverageWeights<Nodes>;
    using All = InLanes<Real, 8>;
    constexpr const Weights& weight = average_weight<Nodes>;
    const Waypoint<All> nodes =
        waypoint(m, MaskOf<All>(way.loading), course.nodes.all, in_lanes<8>(start.e));
    const auto column = [&](const auto& of) {
        return NodeValues::each([&](int row) { return row < Weights::rows ? of(row) : 0.0; });
    };
    const auto sums = [&](const Real& at_start, const All& at) {
        All total = column([&](int row) { return weight.start[row]; }) * in_lanes<8>(at_start);
        for (int i = 0; i < Nodes::nodes; ++i)
            total = fma(column([&](int row) { return weight.at[row][i]; }), spread(at, i), total);
        return total;
    };
    const Waypoint<All> rows{sums(start.ds, nodes.ds), in_lanes<8>(start.e),
                             sums(start.along, nodes.along), sums(start.across, nodes.across),
                             sums(start.flow, nodes.flow)};
    const auto lane = [&](const Waypoint<All>& w, int i) {
        return Waypoint<Real>{of_lane(w.ds, i), start.e, of_lane(w.along, i), of_lane(w.across, i),
                              of_lane(w.flow, i)};
    };
    for (int row = 0; row < Nodes::averages; ++row) r.at[row] = lane(rows, row);
    r.end = lane(nodes, Nodes::stages - 1);
    r.roughness = roughness_of(value(lane(rows, Weights::rough)), value(r.end), value(way.tau_sq));
}

// Of the course of a step from the waypoint at its start, on its way along a segment's.
template <class Real, class Nodes>
GRIT_INLINE void average(const MaterialOf<Real>& m, const Course<Real>& way,
                         const Waypoint<Real>& start, const StepCourse<Real, Nodes>& course,
                         AveragedCourse<Real, Nodes>& r) {
    if constexpr (takes_lanes<Real>) average_in_lanes(m, way, start, course, r);
    else average_one_by_one(m, way, start, course, r);
    for (int row = 0; row < Nodes::averages; ++row) r.at[row].e = course.e[row];
    r.end.e = course.e[Nodes::stages - 1];
}

// Of the basic model only the void ratio changes.
template <class Real, class Nodes>
GRIT_INLINE void basic_average(const MaterialOf<Real>& m, const StepCourse<Real, Nodes>& course,
                               AveragedCourse<Real, Nodes>& r) {
    for (int row = 0; row < Nodes::averages; ++row) r.at[row] = basic_waypoint(m, course.e[row]);
    r.end = basic_waypoint(m, course.e[Nodes::stages - 1]);
    r.roughness = PlainOf<Real>(0.0);
}

GRIT_KERNEL_END
