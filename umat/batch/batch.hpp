// SPDX-License-Identifier: BSD-3-Clause
// Many points: ordinary ones as packs, those that need more than a short increment collected until a pack is
// full; the others alone (single_points.hpp). A lane never looks at its neighbours: the result of a point does not depend on n.
#pragma once

#include "umat/batch/ordinary_points.hpp"
#include "umat/batch/single_points.hpp"

GRIT_KERNEL_BEGIN

using Lanes = Pack<native_lanes>;

// Of an increment that may well be short enough for one step, in R. Where the others are integrated, the same
// step is tried: what is right here is a matter of time alone.
constexpr double promising_length = 0.3;

// Ordinary points to be integrated.
struct Queue {
    std::ptrdiff_t points[native_lanes];
    double spent[native_lanes];  // evaluations of a short increment that was not accepted, or 0
    int count = 0;
};

class Batch {
  public:
    explicit Batch(const UpdateRequest& request) : q(request), m(*request.material) {}

    UpdateOutcome run() {
        if (q.options->validate_only)
            for (std::ptrdiff_t i = 0; i < q.n; ++i) take(i);
        else q.igs ? take_all<true>() : take_all<false>();
        return single.outcome;
    }

  private:
    template <bool igs> void take_all() {
        if (q.n == 1) return take_alone<igs>();
        for (std::ptrdiff_t i = 0; i < q.n; i += native_lanes) take_pack<igs>(i);
        flush<igs>(turning);
        flush<igs>(others);
    }

    // Short increments of ordinary points end here.
    template <bool igs> void take_pack(std::ptrdiff_t first) {
        const auto lane_points = LanePoints<Lanes>::from(q, first);
        const OrdinaryPoints<Lanes> x = read_ordinary(q, lane_points);
        const StraightPath<Lanes> path = straight_path(m, x.strain_increment, x.h, x.e);
        PackMask<native_lanes> turns(false), shorter = x.ordinary;
        if constexpr (igs) {
            turns = turns_on_the_way(m, path);
            shorter = shorter & !turns & (path.length <= Lanes(promising_length * m.R));
        }
        PackMask<native_lanes> done(false);
        Lanes spent(0.0);
        if (any(shorter)) {
            const Segment<Lanes> start = first_segment<Lanes, igs>(m, path, x.T);
            const auto end = short_increment<Lanes, igs>(m, control, path, start,
                                                         allowed_error(m, control, path, start),
                                                         select(shorter, Lanes(0.0), Lanes(1.0)));
            spent = select(shorter & !end.accepted, end.evaluations, Lanes(0.0));
            done = write_ends(q, lane_points, x, path, end_of(path, start, end));
        }
        for (int lane = 0; lane < lane_points.count; ++lane) {
            if (done[lane]) continue;
            if (x.ordinary[lane])
                enqueue<igs>(turns[lane] ? turning : others, lane_points.i[lane], spent[lane]);
            else take(lane_points.i[lane]);
        }
    }

    template <bool igs> void take_alone() {
        const auto lane_points = LanePoints<double>::from(q, 0);
        const OrdinaryPoints<double> x = read_ordinary(q, lane_points);
        if (!x.ordinary) return take(0);
        const StraightPath<double> path = straight_path(m, x.strain_increment, x.h, x.e);
        const Segment<double> start = first_segment<double, igs>(m, path, x.T);
        const double allowed = allowed_error(m, control, path, start);
        const auto quick = short_increment<double, igs>(m, control, path, start, allowed, 0.0);
        if (write_ends(q, lane_points, x, path, end_of(path, start, quick))) return;
        const auto end =
            integrate<double, igs>(m, control, path, start, quick, allowed, x.advised_step);
        if (!write_ends(q, lane_points, x, path, end_of(end))) take(0);
    }

    // Points of the same kind have as many segments and about as many steps.
    template <bool igs> void enqueue(Queue& queue, std::ptrdiff_t i, double spent) {
        queue.points[queue.count] = i;
        queue.spent[queue.count++] = spent;
        if (queue.count == native_lanes) flush<igs>(queue);
    }

    template <bool igs> void flush(Queue& queue) {
        if (queue.count == 0) return;
        const auto lane_points = LanePoints<Lanes>::of(q, queue.points, queue.count);
        const OrdinaryPoints<Lanes> x = read_ordinary(q, lane_points);
        Lanes spent;
        for (int lane = 0; lane < native_lanes; ++lane)
            spent.set(lane, queue.spent[lane < queue.count ? lane : 0]);
        const StraightPath<Lanes> path = straight_path(m, x.strain_increment, x.h, x.e);
        const auto end = integrate<Lanes, igs>(m, control, path, x.T, x.advised_step, spent);
        const PackMask<native_lanes> done = write_ends(q, lane_points, x, path, end_of(end));
        for (int lane = 0; lane < queue.count; ++lane)
            if (!done[lane]) take(lane_points.i[lane]);
        queue.count = 0;
    }

    // A point that may be anything, or comes to an end that is not ordinary.
    void take(std::ptrdiff_t i) { single.take(i); }

    const UpdateRequest& q;
    const Material& m;
    const Control control = control_of(q);
    SinglePoints<double> single{q, control};
    Queue turning, others;
};

GRIT_KERNEL_END

namespace grit::GRIT_TARGET {

UpdateOutcome update(const UpdateRequest& request) {
    if (request.options->tangent == GRIT_TANGENT_CONSISTENT) return update_with_tangents(request);
    return Batch(request).run();
}

}  // namespace grit::GRIT_TARGET
