// SPDX-License-Identifier: BSD-3-Clause
// Points one by one with the derivatives of all that they become: (D1). A translation unit of its own.
#pragma once

#include "umat/batch/single_points.hpp"
#include "umat/model/parameter_derivatives.hpp"

GRIT_KERNEL_BEGIN

constexpr int largest_pass_count = GRIT_SAND_LARGEST_DIRECTION_COUNT / sensitivity_lanes;
constexpr int sensitive_rows = 6 + GRIT_SAND_STATE_SIZE;

using Directions = Sensitive::Derivatives;

// Of one point along the directions of a pass, as the host has them: stress and state one below the other.
struct PointDerivatives {
    Directions row[sensitive_rows];
    Directions strain_increment[6];

    Directions& stress(int c) { return row[c]; }
    Directions& state(int c) { return row[6 + c]; }
};

// Stress and state of a point, with derivatives.
template <class Real> struct StateOf {
    Tensor<Real> T, h;  // T as the host has it
    Real e, w;
};

template <class Real> GRIT_INLINE Tensor<Real> nothing() { return isotropic(Real(0.0)); }

template <class Real> inline Tensor<Real> unshifted(const MaterialOf<Real>& m, Tensor<Real> T) {
    for (int c = 0; c < 3; ++c) T[c] = T[c] + m.p_t;  // (H10)
    return T;
}

// Of a point that stays separated over its whole increment.
template <class Real> inline StateOf<Real> separated(bool igs, const PointOf<Real>& p) {
    const Real opened = trace(p.strain_increment);
    return {nothing<Real>(), igs ? nothing<Real>() : p.h, fma(1.0 + p.e, exp(opened), Real(-1.0)),
            max(p.w + opened, Real(0.0))};
}

template <class Real> struct Advanced {
    Integrated<double> end;
    StraightPath<double> path;
    StateOf<Real> state;
};

// Of a point that carries stress on the way.
template <class Real>
inline Advanced<Real> advance(const MaterialOf<Real>& m, const Control& control, bool igs,
                              const PointOf<Real>& p) {
    const auto start = start_of(m, p, p.strain_increment);
    const auto path = straight_path(m, start.strain_increment, start.h, start.e);
    const Integrated<Real> marched =
        igs ? integrate<Real, true>(m, control, path, start.T, p.advised_step, 0.0)
            : integrate<Real, false>(m, control, path, start.T, p.advised_step, 0.0);
    StateOf<Real> to{unshifted(m, marched.y.T), p.h, path.e_end, Real(0.0)};
    if (igs) to.h = h_at_end(m, path, marched.h, marched.h_late);
    if (marched.separated) {
        to.T = nothing<Real>();
        if (igs) to.h = nothing<Real>();
        to.w = max(path.tr_D * (path.length - marched.separation_at), Real(0.0));
    }
    return {value(marched), value(path), to};
}

// Those of the directions of a pass that are carried by a part of them.
struct PartOfPass {
    static constexpr int lanes = Directions::per_part;
    int first = 0, count = 0;

    PartOfPass(int pass, int part, int directions) {
        const int begin = pass * sensitivity_lanes + part * lanes;
        if (begin >= directions) return;
        first = begin;
        count = directions - begin < lanes ? directions - begin : lanes;
    }
};

class DifferentiatedPoints : public PointByPoint {
  public:
    DifferentiatedPoints(const DifferentiationRequest& request, const Control& step_control)
        : PointByPoint(*request.update, step_control), of(*request.derivatives) {
        for (int pass = 0; pass < passes(); ++pass)
            material[pass] = differentiated<Sensitive>(m, [&](int lane) {
                const int k = pass * sensitivity_lanes + lane;
                return of.parameters && k < of.count ? of.parameters[k] : GRIT_SAND_NO_PARAMETER;
            });
    }

    void take(std::ptrdiff_t i) {
        const std::ptrdiff_t at = q.points->index ? q.points->index[i] : i;
        const RawPoint raw = read_point(*q.points, at);
        Fault fault = check_point(m, *q.options, q.igs, q.points->components, raw);
        PointDerivatives d[largest_pass_count];
        if (fault == Fault::none && !read(at, d)) fault = Fault::derivative_not_finite;
        if (fault != Fault::none) return fail(i, fault, raw.strain, 0.0, 0);
        if (q.options->validate_only) {
            write_report(q.reports ? q.reports + i : nullptr, 0, 0, 0, 0.0);
            return;
        }
        const Point start = prepare_point(*q.options, raw);
        Point p = start;
        enter_domain(m, q.igs, p);
        for (int pass = 0; pass < passes(); ++pass) {
            PointOf<Sensitive> s = prepared(start, raw, d[pass]);
            enter_domain(material[pass], q.igs, s);
            if (p.resting) keep(rested(s, pass), d[pass]);
            else if (p.stress_free) keep(separated(q.igs, s), d[pass]);
            else if (!march(p, s, pass, i, d[pass])) return;
        }
        if (!all_finite(d)) {
            const bool marched = !p.resting && !p.stress_free;
            return fail(i, Fault::derivative_leaves_range, raw.strain, 0.0,
                        marched ? result.evaluations : 0);
        }
        if (p.resting) write_resting(q, i, at, raw, p);
        else write_point(q, i, at, p, p.stress_free ? separated_result(q.igs, p) : result);
        write(at, d);
    }

  private:
    int components() const { return q.points->components == 4 ? 4 : 6; }
    int passes() const { return (of.count + sensitivity_lanes - 1) / sensitivity_lanes; }

    // A row of a view, the directions of a pass; of those that are not there, 0.
    template <class View>
    GRIT_INLINE Directions read_row(const View& view, std::ptrdiff_t at, int row, int pass) const {
        return Directions::each([&](int part) {
            const PartOfPass own(pass, part, of.count);
            const double* const from = view.base + at * view.point_stride + row * view.row_stride +
                                       own.first * view.column_stride;
            if (view.column_stride == 1) return load_first<PartOfPass::lanes>(from, own.count);
            return Pack<PartOfPass::lanes>::each(
                [&](int k) { return k < own.count ? from[k * view.column_stride] : 0.0; });
        });
    }

    GRIT_INLINE void write_row(const grit_mutable_matrix_view& view, std::ptrdiff_t at, int row,
                               int pass, const Directions& x) const {
        for (int part = 0; part * PartOfPass::lanes < sensitivity_lanes; ++part) {
            const PartOfPass own(pass, part, of.count);
            double* const to = view.base + at * view.point_stride + row * view.row_stride +
                               own.first * view.column_stride;
            if (view.column_stride == 1) store_first(to, own.count, x.part[part]);
            else
                for (int k = 0; k < own.count; ++k) to[k * view.column_stride] = x.part[part][k];
        }
    }

    bool read(std::ptrdiff_t at, PointDerivatives* d) const {
        for (int pass = 0; pass < passes(); ++pass) {
            PointDerivatives& x = d[pass];
            for (Directions& row : x.row) row = Directions::zero();
            for (Directions& row : x.strain_increment) row = Directions::zero();
            for (int c = 0; c < components(); ++c) {
                x.stress(c) = read_row(of.stress, at, c, pass);
                if (of.strain_increment.base)
                    x.strain_increment[c] = read_row(of.strain_increment, at, c, pass);
            }
            for (int c = 0; c < GRIT_SAND_STATE_SIZE; ++c)
                x.state(c) = read_row(of.state, at, c, pass);
        }
        return all_finite(d);
    }

    // Of the directions that there are.
    bool all_finite(const PointDerivatives* d) const {
        bool all = true;
        for (int pass = 0; pass < passes(); ++pass) {
            Directions sum = Directions::zero();  // 0 x is 0 for a finite x, NaN otherwise
            for (const Directions& row : d[pass].row) sum = scaled_sum(row, 0.0, sum);
            for (const Directions& row : d[pass].strain_increment) sum = scaled_sum(row, 0.0, sum);
            double of_lane[sensitivity_lanes];
            for (int lane = 0; lane < sensitivity_lanes; ++lane) of_lane[lane] = sum[lane];
            const int left = of.count - pass * sensitivity_lanes;
            all = all && are_finite(of_lane, left < sensitivity_lanes ? left : sensitivity_lanes);
        }
        return all;
    }

    void write(std::ptrdiff_t at, PointDerivatives* d) const {
        const int first = q.igs ? 0 : GRIT_SAND_VOID_RATIO;  // as of the state
        for (int pass = 0; pass < passes(); ++pass) {
            for (int c = 0; c < components(); ++c)
                write_row(of.stress, at, c, pass, d[pass].stress(c));
            for (int c = first; c < GRIT_SAND_STATE_SIZE; ++c)
                write_row(of.state, at, c, pass, d[pass].state(c));
        }
    }

    // What prepare_point makes of a point: scaled to Mandel, turned with Q.
    PointOf<Sensitive> prepared(const Point& start, const RawPoint& raw,
                                PointDerivatives& d) const {
        const bool turn_T = raw.rotates && !q.options->stress_is_rotated;
        PointOf<Sensitive> s;
        for (int c = 0; c < 6; ++c) {
            const double to_stress = c < 3 ? 1.0 : root_2, to_strain = c < 3 ? 1.0 : root_half;
            s.T[c] = {start.T[c], d.stress(c) * to_stress};
            s.h[c] = {start.h[c], d.state(c) * to_strain};
            s.strain_increment[c] = {start.strain_increment[c], d.strain_increment[c] * to_strain};
        }
        if (turn_T) turn(raw.Q, s.T);
        if (raw.rotates) turn(raw.Q, s.h);
        s.e = {start.e, d.state(GRIT_SAND_VOID_RATIO)};
        s.w = {start.w, d.state(GRIT_SAND_SEPARATION)};
        s.advised_step = start.advised_step;
        s.flags = 0;
        s.resting = start.resting;
        s.separated = s.stress_free = false;
        return s;
    }

    // The derivatives; the values are turned.
    static void turn(const double Q[9], Tensor<Sensitive>& A) {
        for (int lane = 0; lane < sensitivity_lanes; ++lane) {
            Tensor<double> of_lane;
            for (int c = 0; c < 6; ++c) of_lane[c] = A[c].d[lane];
            of_lane = rotated(Q, of_lane);
            for (int c = 0; c < 6; ++c) A[c].d.set(lane, of_lane[c]);
        }
    }

    StateOf<Sensitive> rested(const PointOf<Sensitive>& s, int pass) const {
        StateOf<Sensitive> end{unshifted(material[pass], s.T), s.h, s.e, s.w};
        const Tensor<Sensitive>& dE = s.strain_increment;
        end.e = s.e + (1.0 + s.e) * trace(dE);  // (H9)
        if (s.separated) {
            if (value(s.w) > 0.0) end.w = s.w + trace(dE);
            return end;
        }
        const Matrix M = resting_M(m, q.igs, point_factors(m, value(s.T), value(s.e)), value(s.h));
        for (int r = 0; r < 6; ++r)
            for (int c = 0; c < 6; ++c) end.T[r] = end.T[r] + M.c[r][c] * dE[c];
        for (int c = 0; q.igs && c < 6; ++c) end.h[c] = end.h[c] + dE[c];
        return end;
    }

    // Integrates; false where it failed.
    bool march(const Point& p, const PointOf<Sensitive>& s, int pass, std::ptrdiff_t i,
               PointDerivatives& d) {
        const auto to = advance<Sensitive>(material[pass], control, q.igs, s);
        if (to.end.failed) return fail(p, i, to.end), false;
        result = result_of(m, q.igs, p, to.path, to.end);
        if (const Fault f = fault_of(m, result); f != Fault::none)
            return fail(p, i, to.end, f), false;
        keep(to.state, d);
        return true;
    }

    static void keep(const StateOf<Sensitive>& x, PointDerivatives& d) {
        for (int c = 0; c < 6; ++c) {
            d.stress(c) = x.T[c].d * (c < 3 ? 1.0 : root_half);
            d.state(c) = x.h[c].d * (c < 3 ? 1.0 : root_2);
        }
        d.state(GRIT_SAND_VOID_RATIO) = x.e.d;
        d.state(GRIT_SAND_SEPARATION) = x.w.d;
    }

    const grit_sand_derivatives& of;
    SensitiveMaterial<Sensitive> material[largest_pass_count];
    PointResult result;
};

GRIT_KERNEL_END

namespace grit::GRIT_TARGET {

UpdateOutcome update_differentiated(const DifferentiationRequest& request) {
    const Control control = control_of(*request.update);
    DifferentiatedPoints points(request, control);
    for (std::ptrdiff_t i = 0; i < request.update->n; ++i) points.take(i);
    return points.outcome;
}

}  // namespace grit::GRIT_TARGET
