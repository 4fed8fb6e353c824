// SPDX-License-Identifier: BSD-3-Clause
// The place of a course where a wanted arc length is met: Newton's method within a bracket. From near h = 0 the arc
// length is next to flat in places, and Newton's method alone leaves the course at either end.
#pragma once

#include "umat/step_control.hpp"

GRIT_KERNEL_BEGIN

// Where the arc length cannot be met to what is tolerated, the search ends here.
constexpr int longest_search = 40;

template <class Real> class CourseSearch {
    using Plain = PlainOf<Real>;
    using Mask = MaskOf<Real>;

  public:
    // J <= 1, but for roundoff; from h = 0 it takes some 1/beta_r until it is 1.
    CourseSearch(const Material& m, const Plain& arc)
        : wanted(arc), low(0.1 * m.inverse_R * arc),
          high(fma(Plain(3.0 * m.inverse_R), arc, Plain(10.0 / m.beta_r))) {}

    // Not met below this place.
    const Plain& lowest() const { return low; }

    // The next place to try, from dq whose arc length exceeds the wanted one by "excess"; slope: of the arc length.
    Real next(const Mask& open, const Real& dq, const Real& excess, const Real& slope) {
        const Plain at = value(dq), over = value(excess);
        low = select(open & (over < Plain(0.0)), max(low, at), low);
        high = select(open & (over > Plain(0.0)), min(high, at), high);
        const Real newton = dq - excess / slope;
        const Plain to = value(newton);
        const Mask inside = (to > low) & (to < high);
        if (!any(open & !inside)) return newton;
        // The derivative is Newton's.
        const Plain safe = by_power(at, over, value(slope));
        const Mask told = fabs(to) <= Plain(1e300);
        return select(inside, newton, select(told, newton + (safe - to), Real(safe)));
    }

  private:
    // Arc lengths are about powers of q near h = 0.
    Plain by_power(const Plain& at, const Plain& over, const Plain& slope) const {
        const Plain arc = wanted + over;
        const Plain ratio = min(max(wanted / arc, Plain(1e-3)), Plain(1e3));
        const Plain order = min(max(slope * at / arc, Plain(0.1)), Plain(100.0));
        const Plain to = at * rough_root(ratio, order);
        const Plain middle = select(high > 4.0 * low, sqrt(low) * sqrt(high), 0.5 * (low + high));
        return select((to > low) & (to < high), to, middle);
    }

    const Plain wanted;
    Plain low, high;
};

GRIT_KERNEL_END
