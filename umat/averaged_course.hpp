// SPDX-License-Identifier: BSD-3-Clause
// Waypoints of a step averaged, so that a method need resolve the stress alone: AverageWeights.
#pragma once

#include "umat/segment.hpp"
#include "umat/step_course.hpp"

GRIT_KERNEL_BEGIN

template <class Real, class Nodes> struct AveragedCourse {
    using Plain = PlainOf<Real>;
    Waypoint<Real> at[AverageWeights<Nodes>::parabola];
    Waypoint<Plain> mean;
    Plain roughness;  // what the quadrature might miss, of the mean
};

// |M:D_hat| of a waypoint, roughly, per stiffness.
template <class Plain> GRIT_INLINE Plain size_of(const Waypoint<Plain>& w, const Plain& tau_sq) {
    return fabs(w.along) + fabs(w.across) * sqrt(tau_sq) + fabs(w.flow);
}

// with(weight of the start, weights of the nodes) is a waypoint of the sums; e is not averaged.
template <class Real, class Nodes, class Sum>
GRIT_INLINE auto weighted(int row, const Waypoint<Real>& start,
                          const Waypoint<Real> (&nodes)[Nodes::nodes], const Sum& plain) {
    constexpr const AverageWeights<Nodes>& weight = average_weight<Nodes>;
    const auto sum = [&](Real Waypoint<Real>::*member) {
        auto total = weight.start[row] * plain(start.*member);
        for (int i = 0; i < Nodes::nodes; ++i)
            total = fma(weight.at[row][i], plain(nodes[i].*member), total);
        return total;
    };
    using W = Waypoint<Real>;
    return Waypoint<decltype(plain(start.e))>{sum(&W::ds), plain(start.e), sum(&W::along),
                                              sum(&W::across), sum(&W::flow)};
}

template <class Nodes, class Real>
GRIT_INLINE void average_one_by_one(const Segment<Real>& start,
                                    const Waypoint<Real> (&nodes)[Nodes::nodes],
                                    AveragedCourse<Real, Nodes>& r) {
    using Weights = AverageWeights<Nodes>;
    const auto itself = [](const Real& x) { return x; };
    const auto plain = [](const Real& x) { return value(x); };
    for (int row = 0; row < Weights::parabola; ++row)
        r.at[row] = weighted<Real, Nodes>(row, start.at, nodes, itself);
    r.mean = weighted<Real, Nodes>(Weights::mean, start.at, nodes, plain);
    const auto rough = weighted<Real, Nodes>(Weights::rough, start.at, nodes, plain);
    const auto tau_sq = value(start.course.tau_sq);
    r.roughness = size_of(rough, tau_sq) / size_of(r.mean, tau_sq);
}

// The rows as lanes, with the bits of those one by one.
template <class Nodes, class Real, class All>
GRIT_INLINE void average_in_lanes(const Segment<Real>& start, const Waypoint<All>& nodes,
                                  AveragedCourse<Real, Nodes>& r) {
    using Weights = AverageWeights<Nodes>;
    constexpr const Weights& weight = average_weight<Nodes>;
    const auto column = [&](const auto& of) {
        return NodeValues::each([&](int row) { return row < Weights::rows ? of(row) : 0.0; });
    };
    const auto sums = [&](const Real& at_start, const All& at) {
        All total = column([&](int row) { return weight.start[row]; }) * in_lanes<8>(at_start);
        for (int i = 0; i < Nodes::nodes; ++i)
            total = fma(column([&](int row) { return weight.at[row][i]; }), spread(at, i), total);
        return total;
    };
    const Waypoint<Real>& w = start.at;
    const All ds = sums(w.ds, nodes.ds), along = sums(w.along, nodes.along),
              across = sums(w.across, nodes.across), flow = sums(w.flow, nodes.flow);
    for (int row = 0; row < Weights::parabola; ++row)
        r.at[row] = {of_lane(ds, row), w.e, of_lane(along, row), of_lane(across, row),
                     of_lane(flow, row)};
    const auto plain = [&](int row) {
        return Waypoint<double>{value(ds)[row], value(w.e), value(along)[row], value(across)[row],
                                value(flow)[row]};
    };
    r.mean = plain(Weights::mean);
    const double tau_sq = value(start.course.tau_sq);
    r.roughness = size_of(plain(Weights::rough), tau_sq) / size_of(r.mean, tau_sq);
}

// Of the course of a segment.
template <class Real, class Nodes>
GRIT_INLINE void average(const Segment<Real>& start, const StepCourse<Real, Nodes>& course,
                         AveragedCourse<Real, Nodes>& r) {
    if constexpr (takes_lanes<Real>) average_in_lanes(start, course.nodes.all, r);
    else average_one_by_one(start, course.nodes.at, r);
    for (int row = 0; row < AverageWeights<Nodes>::parabola; ++row) r.at[row].e = course.at[row].e;
}

// Of the basic model only the void ratio changes.
template <class Real, class Nodes>
GRIT_INLINE void basic_average(const Segment<Real>& start, const StepCourse<Real, Nodes>& course,
                               AveragedCourse<Real, Nodes>& r) {
    for (int row = 0; row < AverageWeights<Nodes>::parabola; ++row) r.at[row] = course.at[row];
    r.mean = value(start.at);
    r.roughness = PlainOf<Real>(0.0);
}

GRIT_KERNEL_END
