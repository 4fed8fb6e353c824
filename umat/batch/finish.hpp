// SPDX-License-Identifier: BSD-3-Clause
// A point's results on their way back to the host's arrays.
#pragma once

#include "umat/batch/low_stress.hpp"
#include "umat/model/dense_operators.hpp"

GRIT_KERNEL_BEGIN

struct PointResult {
    Tensor<double> T;  // shifted by p_t
    Tensor<double> h;
    double e, w;
    double next_step;
    int flags;
    int substeps, evaluations;
    double error;
    bool stress_free;
    bool has_tangent;  // consistent tangent computed
    Matrix tangent;    // Mandel
};

// h at the end of a path; late: arc length that its mobilisation lacks.
template <class Real>
GRIT_INLINE Tensor<Real> h_at_end(const MaterialOf<Real>& m, const StraightPath<Real>& path,
                                  const Mobilisation<Real>& h, const OfMemory<Real>& late) {
    const Real length = m.R * min(h.rho, Real(1.0));
    const Real along_h = length - late * h.rho_beta * h.c;  // (G3)
    Tensor<Real> end =
        scaled_sum(fma(along_h, h.c, Real(late)), path.D_hat, scaled(path.tau, along_h * h.across));
    const Real length_sq = contract(end, end) * square(m.inverse_R);
    const MaskOf<Real> beyond = length_sq > Real(1.0 + 1e-12);
    if (any(beyond)) assign(beyond, end, scaled(end, 1.0 / sqrt(length_sq)));
    return end;
}

// The end of an integrated path: h, e and, if it separated on the way, w.
inline PointResult result_of(const Material& m, bool igs, const Point& p,
                             const StraightPath<double>& path, const Integrated<double>& end) {
    PointResult r;
    r.T = end.y.T;
    r.h = p.h;
    if (igs) r.h = h_at_end(m, path, end.h, end.h_late);
    r.e = path.e_end;
    r.w = 0.0;
    r.flags = p.flags | (end.outside_cone ? GRIT_SAND_OUTSIDE_CONE : 0);
    r.stress_free = end.separated;
    if (end.separated) {
        r.w = max(path.tr_D * (path.length - end.separation_at), 0.0);
        if (igs) r.h = isotropic(0.0);
    }
    r.next_step = end.next_step;
    r.substeps = static_cast<int>(end.substeps);
    r.evaluations = static_cast<int>(end.evaluations);
    r.error = end.error;
    r.has_tangent = false;
    return r;
}

// What an update returns, the next one must accept.
inline Fault fault_of(const Material& m, const PointResult& r) {
    for (const double component : r.T.c)
        if (!(fabs(component) <= largest_stress_per_h_s * m.h_s - m.p_t))
            return Fault::stress_leaves_range;
    return is_void_ratio(r.e) ? Fault::none : Fault::void_ratio_leaves_range;
}

// A point that stays separated over its whole increment.
inline PointResult separated_result(bool igs, const Point& p) {
    PointResult r;
    const double opened = trace(p.strain_increment);
    r.h = igs ? isotropic(0.0) : p.h;
    r.e = void_ratio_after(p.e, opened);
    r.w = max(p.w + opened, 0.0);
    r.next_step = p.advised_step;
    r.flags = p.flags;
    r.substeps = r.evaluations = 0;
    r.error = 0.0;
    r.stress_free = true;
    r.has_tangent = false;
    return r;
}

inline void write_tangent(const grit_sand_points& q, std::ptrdiff_t at, const Matrix& M) {
    const auto& t = q.tangent;
    double* const to = t.base + at * t.point_stride;
    const auto write = [&](int n) __attribute__((always_inline)) {
        for (int r = 0; r < n; ++r)
            for (int c = 0; c < n; ++c)
                to[r * t.row_stride + c * t.column_stride] = M.c[r][c] * stiffness_to_voigt(r, c);
    };
    q.components == 4 ? write(4) : write(6);
}

// A stress-free point reports the stiffness it would have at the floor, so that hosts can go on.
inline Matrix floor_tangent(const Material& m, bool igs, double e) {
    return dense_L(m, point_factors(m, isotropic(-m.p_floor), e), igs ? m.m_R : 1.0);
}

inline Matrix continuum_tangent(const Material& m, bool igs, const Tensor<double>& T,
                                const Tensor<double>& h, double e,
                                const Tensor<double>& strain_increment) {
    const PointFactors k = point_factors(m, T, e);
    if (igs) return intergranular_M(m, k, h, strain_increment);
    return basic_M(m, k, scaled(strain_increment, 1.0 / norm(strain_increment)));
}

inline void write_end_tangent(const UpdateRequest& q, std::ptrdiff_t at, const Point& p,
                              const PointResult& r) {
    const Material& m = *q.material;
    if (r.stress_free) write_tangent(*q.points, at, floor_tangent(m, q.igs, r.e));
    else if (r.has_tangent) write_tangent(*q.points, at, r.tangent);
    else
        write_tangent(*q.points, at,
                      continuum_tangent(m, q.igs, r.T, r.h, r.e, p.strain_increment));
}

template <class Real>
GRIT_INLINE MaskOf<Real> void_clamped(const Material& m, const Tensor<Real>& T, const Real& e) {
    const Real p = trace(T) * (-1.0 / 3.0);
    const Real e_0 = e * compression(m, p).expansion;
    return (e_0 < Real(m.e_d0)) | (e_0 > Real(m.e_i0));
}

// The same where wanted, from the start of the path and its compression: without a logarithm where e stays far from
// both limits. As n < 1, x of (H6) changes by no more than p, relatively; exp(0.018) lies within 1.02 and 1/0.98.
// Where the start has no pressure, nothing is decided.
template <class Real>
GRIT_INLINE MaskOf<Real> void_clamped(const Material& m, const Marched<Real>& start,
                                      const Tensor<Real>& T, const Real& e,
                                      const MaskOf<Real>& wanted) {
    const Real p = trace(start.T), change = trace(T) - p;
    const Real e_0 = e * start.compression.expansion;
    const MaskOf<Real> inside = (start.compression.x * fabs(change) < 0.018 * fabs(p)) &
                                (e_0 >= Real(m.e_d0 * 1.02)) & (e_0 <= Real(m.e_i0 * 0.98));
    const MaskOf<Real> open = wanted & !inside;
    return any(open) ? MaskOf<Real>(open & void_clamped(m, T, e)) : open;
}

inline int void_flag(const Material& m, const Tensor<double>& T, double e) {
    return void_clamped(m, T, e) ? GRIT_SAND_VOID_CLAMPED : 0;
}

inline void write_report(grit_sand_report* report, int flags, int substeps, int evaluations,
                         double error) {
    if (!report) return;
    *report = grit_sand_report{};
    report->flags = flags;
    report->substeps = substeps;
    report->evaluations = evaluations;
    report->error_estimate = error;
    report->step_reduction = 1.0;
}

inline void write_point(const UpdateRequest& q, std::ptrdiff_t i, std::ptrdiff_t at, const Point& p,
                        const PointResult& r) {
    const Material& m = *q.material;
    const grit_sand_points& host = *q.points;
    const int n = host.components == 0 ? 6 : host.components;
    if (q.options->tangent != GRIT_TANGENT_NONE) write_end_tangent(q, at, p, r);

    double stress[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    if (!r.stress_free) {
        Tensor<double> T = r.T;
        for (int c = 0; c < 3; ++c) T[c] = T[c] + m.p_t;  // (H10)
        stress_to_voigt(T, stress);
    }
    double state[GRIT_SAND_STATE_SIZE];
    strain_to_voigt(r.h, state);
    state[GRIT_SAND_VOID_RATIO] = r.e;
    state[GRIT_SAND_SEPARATION] = r.w;
    for (int c = 0; c < n; ++c)
        host.stress.base[at * host.stress.point_stride + c * host.stress.component_stride] =
            stress[c];
    const int first = q.igs ? 0 : GRIT_SAND_VOID_RATIO;  // h is left alone when it is off
    for (int c = first; c < GRIT_SAND_STATE_SIZE; ++c)
        host.state.base[at * host.state.point_stride + c * host.state.component_stride] = state[c];
    if (host.substep.base) host.substep.base[at * host.substep.point_stride] = r.next_step;
    if (!q.reports) return;
    const int flags = r.flags | (r.stress_free ? GRIT_SAND_STRESS_FREE : void_flag(m, r.T, r.e));
    write_report(q.reports + i, flags, r.substeps, r.evaluations, r.error);
}

// A zero increment changes nothing but a rotation; its tangent is the limit of small increments.
inline void write_resting(const UpdateRequest& q, std::ptrdiff_t i, std::ptrdiff_t at,
                          const RawPoint& raw, const Point& p) {
    const Material& m = *q.material;
    const grit_sand_points& host = *q.points;
    const int n = host.components == 0 ? 6 : host.components;
    const bool stress_free = p.separated;
    if (q.options->tangent != GRIT_TANGENT_NONE) {
        const Matrix M = stress_free ? floor_tangent(m, q.igs, p.e)
                                     : resting_M(m, q.igs, point_factors(m, p.T, p.e), p.h);
        write_tangent(host, at, M);
    }
    if (raw.rotates) {
        double turned[6];
        strain_to_voigt(p.h, turned);
        for (int c = 0; q.igs && c < 6; ++c)
            host.state.base[at * host.state.point_stride + c * host.state.component_stride] =
                turned[c];
        if (!q.options->stress_is_rotated) {
            stress_to_voigt(rotated(raw.Q, stress_from_voigt(raw.stress)), turned);
            for (int c = 0; c < n; ++c)
                host.stress.base[at * host.stress.point_stride + c * host.stress.component_stride] =
                    turned[c];
        }
    }
    if (!q.reports) return;
    // h is scaled back where it is written.
    const int flags = (raw.rotates ? p.flags : 0) |
                      (stress_free ? GRIT_SAND_STRESS_FREE : void_flag(m, p.T, p.e));
    write_report(q.reports + i, flags, 0, 0, 0.0);
}

inline void write_failure(const UpdateRequest& q, std::ptrdiff_t i, Fault fault, double increment,
                          double progress, int evaluations) {
    if (!q.reports) return;
    grit_sand_report& report = q.reports[i];
    report = grit_sand_report{};
    report.status = status_of(fault);
    report.evaluations = evaluations;
    report.step_reduction = 1.0;
    if (fault == Fault::stress_leaves_range) report.step_reduction = 0.25;
    if (fault == Fault::increment_too_large || fault == Fault::void_ratio_leaves_range)
        report.step_reduction = min(0.25, max(0.5 * largest_increment / increment, 1e-6));
    if (fault == Fault::evaluation_limit)
        report.step_reduction = min(max(0.8 * progress, 0.1), 0.5);
}

GRIT_KERNEL_END
