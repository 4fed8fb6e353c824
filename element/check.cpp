// SPDX-License-Identifier: BSD-3-Clause
#include "element/check.hpp"

#include <algorithm>
#include <cmath>

#include "element/errors.hpp"
#include "element/path.hpp"
#include "element/schedule.hpp"
#include "element/text.hpp"

namespace element {
namespace {

void require(bool condition, const std::string& message) {
    if (!condition) throw BadCase(message);
}

void check_rows(const Restrictions& rows, bool undrained) {
    require(rows.stress.allFinite() && rows.strain.allFinite(), "restrictions must be finite");
    for (int r = 0; r < 6; ++r)
        require(!rows.stress.row(r).isZero(0.0) || !rows.strain.row(r).isZero(0.0),
                text("restriction %d has neither stress nor strain", r + 1));
    Eigen::Matrix<double, 6, 12> both;
    both << rows.stress, rows.strain;
    for (int r = 0; r < 6; ++r) both.row(r) /= both.row(r).norm();
    const auto rank = Eigen::FullPivLU<Eigen::Matrix<double, 6, 12>>(both).rank();
    require(rank == 6,
            text("the six restrictions say only %d different things", static_cast<int>(rank)));
    if (undrained)
        require(!(rows.stress * unit_tensor()).isZero(1e-12),
                "an undrained step needs a restriction of total stress that feels its mean value, "
                "or the pore pressure stays unknown");
}

// What each kind asks for.
struct CheckKind {
    const Step& step;

    void operator()(const Linear& k) const {
        check_rows(k.rows, step.undrained);
        require(k.change.allFinite(), "changes must be finite");
    }
    void operator()(const Circulating& k) const {
        check_rows(k.rows, step.undrained);
        require(k.amplitude.allFinite() && k.phase.allFinite() && k.drift.allFinite(),
                "amplitude, phase and drift must be finite");
        require(k.cycles > 0.0 && std::isfinite(k.cycles),
                text("cycles must be > 0, got %g", k.cycles));
        require(
            !k.rate_at_midpoint || step.increments > k.cycles,
            text("a rate at midpoint needs more increments than cycles, got %d", step.increments));
    }
    void operator()(const DeformationGradient& k) const {
        require(!step.undrained && !step.drains,
                "a deformation gradient can neither be undrained nor drain");
        require(k.F.allFinite() && k.F.determinant() > 0.0,
                text("det F must be > 0, got %g", k.F.determinant()));
    }
    void operator()(const Imported& k) const {
        check_rows(k.rows, step.undrained);
        require(k.table.size() >= 2, "an imported history needs two rows at least");
        for (const auto& row : k.table) {
            require(row.size() == k.table.front().size(),
                    "rows of an imported history must have as many columns as the first");
            for (const double value : row)
                require(std::isfinite(value), "an imported history must be finite");
        }
        for (const auto& column : k.columns) check_column(k, column);
        check_column(k, k.time);
    }
    void operator()(const Perturbations& k) const {
        require(step.exit.any_of.empty(),
                "probes are undone one by one: no condition can end them");
        check_rows(k.rows, step.undrained);
        require(k.first.allFinite() && k.second.allFinite(), "directions must be finite");
    }
    void operator()(const RandomWalk& k) const {
        check_rows(k.rows, step.undrained);
        require(k.amplitude.allFinite(), "amplitudes must be finite");
    }
    void operator()(const Repetition&) const {}

    static void check_column(const Imported& k, const Imported::Column& column) {
        const int n = static_cast<int>(k.table.front().size());
        require(column.index < n, text("an imported history has %d columns, there is no column %d",
                                       n, column.index + 1));
        require(std::isfinite(column.factor), "factors of an imported history must be finite");
    }
};

void check_increments(const Step& step) {
    if (std::holds_alternative<Imported>(step.kind)) return;
    require(step.increments >= 1 && step.increments <= increment_limit,
            text("increments must be in [1, %d], got %d", increment_limit, step.increments));
    require(step.first_share >= 0.0,
            text("the first share must be >= 0, got %g", step.first_share));
    check_schedule(step.increments, step.first_share);
}

void check_steps(const Program& program, const std::string& where) {
    int number = 0;
    for (const Step& step : program) {
        const std::string here = where + text("step %d", ++number);
        if (const auto* repetition = std::get_if<Repetition>(&step.kind)) {
            require(repetition->times >= 1 && !repetition->steps.empty(),
                    here + ": a repetition needs steps and at least one time");
            check_steps(repetition->steps, here + ", ");
            continue;
        }
        try {
            check_step(step);
        } catch (const BadCase& error) {
            throw BadCase(here + (step.name.empty() ? "" : " (" + step.name + ")") + ": " +
                          error.what());
        }
    }
}

// Beyond any integer, if need be.
double increments_of_all(const Program& program) {
    double n = 0.0;
    for (const Step& step : program) {
        const auto* repetition = std::get_if<Repetition>(&step.kind);
        n += repetition ? repetition->times * increments_of_all(repetition->steps)
                        : increments_of(step);
    }
    return n;
}

}  // namespace

void check_step(const Step& step) {
    check_increments(step);
    require(step.every >= 1, text("every must be >= 1, got %d", step.every));
    require(step.duration >= 0.0 && std::isfinite(step.duration),
            text("duration must be >= 0, got %g", step.duration));
    require(std::isfinite(step.temperature_change), "temperature change must be finite");
    require(step.iteration_limit >= 0,
            text("iteration limit must be >= 0, got %d", step.iteration_limit));
    require(!step.undrained || !step.drains, "an undrained step cannot drain");
    std::visit(CheckKind{step}, step.kind);
}

void check_program(const Program& program) {
    check_steps(program, "");
    const double n = increments_of_all(program);
    require(n <= static_cast<double>(run_limit),
            text("a run has at most %ld increments, got %.3g", run_limit, n));
}

std::optional<bool> pore_pressure_after(const Step& step, bool before) {
    if (const auto* repetition = std::get_if<Repetition>(&step.kind)) {
        std::optional<bool> now = before;
        // Its second time begins as the first one ends.
        for (int time = 0; time < std::min(repetition->times, 2); ++time)
            for (const Step& each : repetition->steps)
                if (now) now = pore_pressure_after(each, *now);
        return now;
    }
    const auto* linear = std::get_if<Linear>(&step.kind);
    const bool rests = linear && linear->rows.stress.isZero(0.0) && linear->change.isZero(0.0);
    if (before && !step.undrained && !step.drains && !rests) return std::nullopt;
    return step.undrained || (before && !step.drains);
}

void check_settings(const Settings& s) {
    require(s.tolerance >= 1e-14 && s.tolerance <= 1e-2,
            text("tolerance must be in [1e-14, 1e-2], got %g", s.tolerance));
    require(s.iteration_limit >= 1,
            text("iteration limit must be >= 1, got %d", s.iteration_limit));
    require(s.smallest_part > 0.0 && s.smallest_part <= 1.0,
            text("smallest part must be in (0, 1], got %g", s.smallest_part));
}

}  // namespace element
