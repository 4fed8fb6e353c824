// SPDX-License-Identifier: BSD-3-Clause
// Points one by one, whatever they are: with Real double their values, with Real Dual the derivatives of the stress by
// the strain increment too. A translation unit has one of the two, as either takes long to compile.
#pragma once

#include "umat/batch/finish.hpp"
#include "umat/integrate/integrate.hpp"

GRIT_KERNEL_BEGIN

inline Control control_of(const UpdateRequest& request) {
    Control control{request.options->tolerance, request.options->evaluation_limit};
    control.next_step_wanted = request.points->substep.base != nullptr;
    return control;
}

// What points one by one have in common.
struct PointByPoint {
    const UpdateRequest& q;
    const Material& m;
    const Control& control;
    UpdateOutcome outcome;  // the first failure

    PointByPoint(const UpdateRequest& request, const Control& step_control)
        : q(request), m(*request.material), control(step_control) {}

    void fail(const Point& p, std::ptrdiff_t i, const Integrated<double>& end,
              Fault fault = Fault::evaluation_limit) {
        double strain[6];
        strain_to_voigt(p.strain_increment, strain);
        fail(i, fault, strain, end.failed ? end.progress : 0.0, static_cast<int>(end.evaluations));
    }

    void fail(std::ptrdiff_t i, Fault fault, const double strain[6], double progress,
              int evaluations) {
        write_failure(q, i, fault, norm(strain_from_voigt(strain)), progress, evaluations);
        if (outcome.point < 0 || i < outcome.point) outcome = {fault, i, progress, evaluations};
    }
};

template <class Real> class SinglePoints : public PointByPoint {
  public:
    using PointByPoint::PointByPoint;

    // Point i of the call: written, or left as it is and reported.
    void take(std::ptrdiff_t i) {
        const std::ptrdiff_t at = q.points->index ? q.points->index[i] : i;
        const RawPoint raw = read_point(*q.points, at);
        const Fault fault = check_point(m, *q.options, q.igs, q.points->components, raw);
        if (fault != Fault::none) return fail(i, fault, raw.strain, 0.0, 0);
        if (q.options->validate_only) {
            write_report(q.reports ? q.reports + i : nullptr, 0, 0, 0, 0.0);
            return;
        }
        Point p = prepare_point(*q.options, raw);
        enter_domain(m, q.igs, p);
        if (p.resting) return write_resting(q, i, at, raw, p);
        if (p.stress_free) return write_point(q, i, at, p, separated_result(q.igs, p));
        march(p, i, at);
    }

  private:
    static constexpr bool derives = !std::is_same_v<Real, double>;

    void march(const Point& p, std::ptrdiff_t i, std::ptrdiff_t at) {
        [[maybe_unused]] StrainDirections along;
        Tensor<Real> strain_increment;
        if constexpr (derives) {
            along = strain_directions(p.strain_increment, q.igs ? p.h : isotropic(0.0));
            strain_increment = variable(p.strain_increment, along);
        } else strain_increment = p.strain_increment;
        const auto start = start_of<Real>(m, p, strain_increment);
        const auto path = straight_path(m, start.strain_increment, start.h, start.e);
        const Integrated<Real> marched =
            q.igs ? integrate<Real, true>(m, control, path, start.T, p.advised_step, 0.0)
                  : integrate<Real, false>(m, control, path, start.T, p.advised_step, 0.0);
        const Integrated<double> end = value(marched);
        if (end.failed) return fail(p, i, end);
        PointResult r = result_of(m, q.igs, p, value(path), end);
        if (const Fault f = fault_of(m, r); f != Fault::none) return fail(p, i, end, f);
        if constexpr (derives) {
            r.has_tangent = true;
            for (int row = 0; row < 6; ++row) {
                const Six slope = by_strain(marched.y.T[row], along);
                for (int c = 0; c < 6; ++c) r.tangent.c[row][c] = slope[c];
                if (!are_finite(r.tangent.c[row], 6)) return fail(p, i, end);
            }
        }
        write_point(q, i, at, p, r);
    }
};

GRIT_KERNEL_END
