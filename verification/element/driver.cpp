// SPDX-License-Identifier: BSD-3-Clause
#include "element/driver.hpp"

#include <algorithm>

#include "element/increment.hpp"
#include "element/schedule.hpp"
#include "element/text.hpp"

namespace element {
namespace {

constexpr double smallest_cut = 1.0 / (1 << 20);  // of an increment

Row row_of(const Material& material, const Point& point) {
    Row row;
    row.stress = point.stress;
    row.strain = point.strain;
    row.h = Vector6::Map(point.state.data() + GRIT_SAND_H11);
    row.void_ratio = point.state[GRIT_SAND_VOID_RATIO];
    row.invariants = material.invariants(point);
    return row;
}

// A point on its way along a loading; the strain per share of the last increment guesses the next.
class Path {
  public:
    Path(const Case& test, const Material& m)
        : loading(test.loading), tolerance(test.numerics.tolerance), material(m),
          point(m.start(test.start)), start_stress(point.stress), slope(first_guess()) {}

    const Point& now() const { return point; }

    Increment advance(double from, double to) {
        Goal goal;
        goal.control = loading.control;
        goal.tolerance = tolerance;
        goal.stress = start_stress + to * stress_change();
        goal.strain_increment = (to - from) * slope;
        const Increment increment = solve_increment(material, goal, point);
        if (increment.converged) slope = increment.strain_increment / (to - from);
        return increment;
    }

  private:
    bool is(int component, Control control) const {
        return loading.control[static_cast<std::size_t>(component)] == control;
    }
    Vector6 first_guess() const {
        Vector6 guess = loading.change;
        for (int i = 0; i < 6; ++i)
            if (is(i, Control::stress)) guess[i] = 0.0;
        return guess;
    }
    Vector6 stress_change() const {
        Vector6 change = loading.change;
        for (int i = 0; i < 6; ++i)
            if (is(i, Control::strain)) change[i] = 0.0;
        return change;
    }

    Loading loading;
    double tolerance;
    const Material& material;
    Point point;
    Vector6 start_stress;
    Vector6 slope;
};

// From one scheduled share to the next, in as many parts as it takes.
bool advance_by_parts(Path& path, double from, double to, Row& counts, Run& run) {
    double part = to - from;
    while (from < to) {
        const double next = from + part >= to - 1e-9 * part ? to : from + part;
        const Increment increment = path.advance(from, next);
        counts.iterations += increment.iterations;
        counts.evaluations += increment.evaluations;
        if (increment.converged) {
            from = next;
            part *= 2.0;
            continue;
        }
        part = 0.5 * (next - from);
        ++run.halvings;
        if (!increment.retry_smaller || part < smallest_cut * to) {
            run.failure = increment.reason;
            return false;
        }
    }
    return true;
}

}  // namespace

Run run(const Case& test, const Observer& observer) {
    const Material material(test);
    const std::vector<double> shares = schedule(test.loading);
    const int increments = static_cast<int>(shares.size()) - 1;
    Path path(test, material);
    Run run;
    run.rows.push_back(row_of(material, path.now()));
    for (int i = 1; i <= increments; ++i) {
        const auto at = static_cast<std::size_t>(i);
        Row counts;
        if (!advance_by_parts(path, shares[at - 1], shares[at], counts, run)) {
            const Vector6& strain = path.now().strain;
            run.failure = text("increment %d of %d, at strain_11 = %g: %s", i, increments,
                               strain[0], run.failure.c_str());
            return run;
        }
        Row row = row_of(material, path.now());
        row.iterations = counts.iterations;
        row.evaluations = counts.evaluations;
        run.rows.push_back(row);
        if (observer) observer(i, increments);
    }
    return run;
}

}  // namespace element
