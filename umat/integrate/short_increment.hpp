// SPDX-License-Identifier: BSD-3-Clause
// One step over a whole segment, of second or third order: most increments of explicit codes are far below R and
// end here. What these do not accept is integrated: integrate.hpp.
#pragma once

#include "umat/integrate/course_search.hpp"
#include "umat/integrate/runge_kutta.hpp"
#include "umat/integrate/segment.hpp"
#include "umat/model/cone.hpp"

GRIT_KERNEL_BEGIN

template <class Real> struct ShortIncrement {
    MaskOf<Real> accepted;  // over the segment
    MaskOf<Real> outside_cone;
    Tensor<Real> T;
    Mobilisation<Real> h;
    OfMemory<Real> h_late;  // see Integrated
    PlainOf<Real> error, evaluations;
};

template <class Real, bool igs> class ShortSegment {
    using Plain = PlainOf<Real>;
    using Mask = MaskOf<Real>;

  public:
    ShortSegment(const MaterialOf<Real>& material, const Control& limits,
                 const StraightPath<Real>& along, const Segment<Real>& segment,
                 const Plain& allowed_here, ShortIncrement<Real>& result)
        : m(material), control(limits), path(along), start(segment), allowed(allowed_here),
          arc(segment.end - segment.s), r(result) {}

    // "spent": evaluations of an attempt that is known to have failed, or 0.
    void run(const Plain& spent) {
        const Mask fresh = spent <= Plain(0.0);
        r.accepted = r.outside_cone = Mask(false);
        r.T = start.y.T;
        r.h_late = OfMemory<Real>(0.0);
        r.error = Plain(0.0);
        r.evaluations = select(fresh, Plain(1.0), spent);
        if (!any(fresh)) return;
        const Plain length = value(arc);
        // Stiffness changes by up to m_R chi (1 - rho): more than h itself where rho is near 1.
        change = Plain(0.0);
        if constexpr (igs)
            change = min(plain(m).m_R * plain(m).chi * start.memory, Plain(1.0)) *
                     (plain(m).inverse_R * length);
        const Plain growth = start.relative_rate / value(start.at.ds) * length;
        const Plain second = 0.1 * growth * square(growth + change);
        const Plain third = 0.5 * square(growth) * min(growth + change, Plain(1.0));
        // From near h = 0 nothing is smooth.
        Mask smooth = fresh, smoother = fresh & (change <= longest_averaged);
        if constexpr (igs) {
            const auto away = [&](double share) {
                const Plain near = (plain(m).chi < 2.0 ? 1.0 : share) * change;
                return !(start.course.loading & (value(start.h.rho) < near));
            };
            smooth = smooth & away(0.01);
            smoother = smoother & away(0.1);
        }
        const Mask heun = smooth & (heun_safety * second <= allowed);
        const Mask third_order = smoother & (third_order_safety * third <= allowed);
        if (!any(heun | third_order)) return;
        dq = arc * m.inverse_R;
        if constexpr (igs) dq = predicted_course(m, start.h.J, start.h.J_growth, arc);
        if (any(heun)) try_heun(heun);
        const Mask again =
            third_order & !r.accepted &
            (r.evaluations + 2.0 <= Plain(static_cast<double>(control.evaluation_limit)));
        if (any(again)) try_third_order(again);
        r.outside_cone = back_into_cone(r.T, r.accepted);
    }

  private:
    void try_heun(const Mask& where) {
        Waypoint<Real> end;
        Mobilisation<Real> h = start.h;
        Real dq_here = dq;
        Mask met = where;
        if constexpr (igs) {
            met = find_course_of_segment(where, dq_here);
            h = mobilisation(m, start.course, dq_here);
            end = waypoint(m, start.course.loading, h, start.e_end);
        } else {
            end = basic_waypoint(m, start.e_end);
        }
        const StepContext<Real> c{m, path, dq_here, arc, start.stress_scale};
        judge(met, heun_step<Real, igs>(c, start, end, change), h, OfMemory<Real>(0.0));
        r.evaluations = r.evaluations + select(where, Plain(1.0), Plain(0.0));
    }

    // From the prediction, which is good enough where J hardly changes; says where it was met.
    Mask find_course_of_segment(const Mask& where, Real& dq_here) const {
        constexpr double tolerated_bend = 0.02, tolerated_length = 0.05;
        const Plain bend = fabs(value(start.h.J_growth)) * value(dq);
        const Plain rho = value(start.h.rho);
        Mask open = where & start.course.loading &
                    ((bend > Plain(tolerated_bend)) | (value(dq) > Plain(tolerated_length)) |
                     (rho < 4.0 * value(dq)));
        CourseSearch<Real> search(plain(m), value(arc));
        for (int i = 0; i < longest_search && any(open); ++i) {
            const Real excess =
                arc_length(m, start.course, dq * 0.0, dq_here, rho, control.panels(plain(m))) - arc;
            const Real slope = m.R * mobilisation(m, start.course, dq_here).J;
            dq_here = select(open, search.next(open, dq_here, excess, slope), dq_here);
            open = open & !(fabs(value(excess)) <= control.tolerated_excess() * value(arc));
        }
        return where & !open;
    }

    void try_third_order(const Mask& where) {
        using Nodes = ThirdOrderNodes;
        StepCourse<Real, Nodes> course;
        AveragedCourse<Real, Nodes> averaged;
        const Position<Real> from{dq * 0.0, Real(1.0), start.s, start.e};
        if constexpr (igs) {
            step_course(m, path, start.course, from, start.h.J, dq, course);
            Mask open = where & start.course.loading;
            for (int i = 0; i < 4; ++i) {
                const Real excess = course.arc - arc;
                open = open & (fabs(value(excess)) > control.tolerated_excess() * value(arc));
                if (!any(open)) break;
                dq = select(open, dq - excess / (m.R * course.end.J), dq);
                step_course(m, path, start.course, from, start.h.J, dq, course);
            }
            average(m, start.course, start.at, course, averaged);
        } else {
            basic_step_course(m, path, from, dq, course);
            basic_average(m, course, averaged);
        }
        const StepContext<Real> c{m, path, dq, arc, start.stress_scale};
        const OfMemory<Real> late = of_memory(arc) - of_memory(course.arc);
        judge(where & (fabs(value(late)) <= control.tolerated_excess() * value(arc)),
              third_order_step<Real, igs>(c, start, averaged, change), course.end, late);
        r.evaluations = r.evaluations + select(where, Plain(2.0), Plain(0.0));
    }

    void judge(const Mask& where, const Trial<Real>& trial, const Mobilisation<Real>& h,
               const OfMemory<Real>& late) {
        const Plain p_0 = trace(value(start.y.T)) * (-1.0 / 3.0);
        const Plain p_1 = trace(value(trial.y.T)) * (-1.0 / 3.0);
        const Mask above =
            (p_1 >= Plain(opening_pressure(plain(m)))) | ((p_1 >= p_0) & (p_1 > Plain(0.0)));
        const Mask here = where & (trial.error <= allowed) & above;
        if (!any(here)) return;  // a branch, foreseen: the stress need not wait for its error
        r.accepted = r.accepted | here;
        assign(here, r.T, trial.y.T);
        assign(here, r.h, h);
        r.h_late = select(here, late, r.h_late);
        r.error = select(here, trial.error, r.error);
    }

    const MaterialOf<Real>& m;
    const Control& control;
    const StraightPath<Real>& path;
    const Segment<Real>& start;
    const Plain& allowed;
    const Real arc;
    Real dq;
    Plain change;  // of the stiffness over the segment, relative
    ShortIncrement<Real>& r;
};

template <class Real, bool igs>
inline ShortIncrement<Real>
short_increment(const MaterialOf<Real>& m, const Control& control, const StraightPath<Real>& path,
                const Segment<Real>& start, const PlainOf<Real>& allowed,
                const PlainOf<Real>& spent) {
    ShortIncrement<Real> r;
    ShortSegment<Real, igs>(m, control, path, start, allowed, r).run(spent);
    return r;
}

GRIT_KERNEL_END
