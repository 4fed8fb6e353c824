// SPDX-License-Identifier: BSD-3-Clause
// grit_sand_update_undrained: the update of the sand, piece by piece, and the water of what was done.
#define GRIT_TARGET c_api
#include <cmath>
#include <limits>

#include <grit/sand_water.h>

#include "umat/api/update_call.hpp"
#include "umat/model/pore_water.hpp"

namespace grit {
namespace {

constexpr grit_sand_water default_water = [] {
    grit_sand_water water{};
    water.struct_size = sizeof water;
    water.bulk_modulus = std::numeric_limits<double>::quiet_NaN();
    water.largest_tension = std::numeric_limits<double>::infinity();
    return water;
}();

#define GRIT_REQUIRE_OF_WATER(condition, ...)                                                      \
    if (!(condition)) return failure(error, GRIT_BAD_PARAMETER, -1, __VA_ARGS__)

grit_status check_water(const grit_sand_water& w, grit_error* error) {
    GRIT_REQUIRE_OF_WATER(!std::isnan(w.bulk_modulus), "bulk_modulus of the water is not set");
    GRIT_REQUIRE_OF_WATER(w.bulk_modulus >= 0.0 && is_finite(w.bulk_modulus),
                          "bulk_modulus must be >= 0 and finite [stress], got %g", w.bulk_modulus);
    GRIT_REQUIRE_OF_WATER(w.porosity >= 0.0 && w.porosity <= 1.0,
                          "porosity must be 0, for that of the void ratio, or in (0, 1], got %g",
                          w.porosity);
    GRIT_REQUIRE_OF_WATER(w.largest_tension >= 0.0, "largest_tension must be >= 0 [stress], got %g",
                          w.largest_tension);
    return GRIT_OK;
}

grit_status check_water_views(const grit_sand_water& w, std::ptrdiff_t n, grit_error* error) {
    GRIT_CHECK(check_base(w.pore_pressure, "pore_pressure", error));
    GRIT_CHECK(check_written(w.pore_pressure, n, "pore_pressure", "points", error));
    if (!w.total_stress.base) return GRIT_OK;
    GRIT_CHECK(check_written(w.total_stress, n, "total_stress", "points", error));
    return check_component_strides({w.total_stress.component_stride}, "total_stress", error);
}

PoreWater water_of(const grit_sand_water& w) {
    return {w.bulk_modulus, w.porosity, w.largest_tension};
}

// Points of a call, as many as fit the stack.
class Undrained {
  public:
    Undrained(const UpdateRequest& whole, const grit_sand_water& given)
        : call(whole), views(given), water(water_of(given)) {}

    grit_status run(grit_error* error) {
        for (std::ptrdiff_t first = 0; first < call.n; first += capacity) {
            take(first, call.n - first < capacity ? call.n : first + capacity);
            update();
            for (std::ptrdiff_t k = 0; k < count; ++k) finish(k);
        }
        if (bad.point < 0) return GRIT_OK;
        if (bad.fault != Fault::none) return describe(call, bad, error);
        return describe_water(error);
    }

  private:
    static constexpr std::ptrdiff_t capacity = 256;

    std::ptrdiff_t place(std::ptrdiff_t i) const {
        return call.points->index ? call.points->index[i] : i;
    }

    double volumetric(std::ptrdiff_t at) const {
        const grit_view& d = call.points->strain_increment;
        return component(d, at, 0) + component(d, at, 1) + component(d, at, 2);
    }

    double end_pressure(std::ptrdiff_t at) const {
        return water.pressure_after(component(views.pore_pressure, at, 0),
                                    component(call.points->state, at, GRIT_SAND_VOID_RATIO),
                                    volumetric(at));
    }

    // Without the points whose water cannot be updated.
    void take(std::ptrdiff_t begin, std::ptrdiff_t end) {
        count = 0;
        for (std::ptrdiff_t i = begin; i < end; ++i) {
            const std::ptrdiff_t at = place(i);
            number[count] = i;
            index[count] = at;
            p_w[count] = end_pressure(at);
            if (!is_finite(p_w[count]) && sand_takes(at)) fail(i);
            else ++count;
        }
    }

    // Where it does not, the update has the words for what is wrong.
    bool sand_takes(std::ptrdiff_t at) const {
        grit_sand_options options = *call.options;
        options.validate_only = 1;
        grit_sand_points points = *call.points;
        points.index = &at;
        return grit::run({call.material, &options, &points, 1, nullptr, call.igs}).fault ==
               Fault::none;
    }

    void fail(std::ptrdiff_t i) {
        if (bad.point < 0) bad.point = i;
        if (!call.reports) return;
        call.reports[i] = grit_sand_report{};
        call.reports[i].status = GRIT_BAD_STATE;
        call.reports[i].step_reduction = 1.0;
    }

    void update() {
        grit_sand_points points = *call.points;
        points.index = index;
        UpdateOutcome found =
            grit::run({call.material, call.options, &points, count, reports, call.igs});
        if (found.fault == Fault::none) return;
        found.point = number[found.point];
        if (bad.point < 0 || found.point < bad.point) bad = found;
    }

    void finish(std::ptrdiff_t k) {
        grit_sand_report& report = reports[k];
        if (report.status == GRIT_OK && !call.options->validate_only) {
            if (water.cavitates(p_w[k])) report.flags |= GRIT_SAND_CAVITATED;
            write(index[k], p_w[k]);
        }
        if (call.reports) call.reports[number[k]] = report;
    }

    void write(std::ptrdiff_t at, double pressure) {
        const grit_sand_points& q = *call.points;
        const int components = q.components == 4 ? 4 : 6;
        component(views.pore_pressure, at, 0) = pressure;
        for (int c = 0; views.total_stress.base && c < components; ++c) {
            const double effective = component(q.stress, at, c);
            component(views.total_stress, at, c) =
                c < 3 ? effective - water.borne(pressure) : effective;
        }
        if (call.options->tangent == GRIT_TANGENT_NONE) return;
        const double K = water.stiffness(pressure, component(q.state, at, GRIT_SAND_VOID_RATIO));
        double* const to = q.tangent.base + at * q.tangent.point_stride;
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 3; ++c)
                to[r * q.tangent.row_stride + c * q.tangent.column_stride] += K;
    }

    grit_status describe_water(grit_error* error) const {
        const std::ptrdiff_t at = place(bad.point);
        const double start = component(views.pore_pressure, at, 0);
        if (!is_finite(start))
            return failure(error, GRIT_BAD_STATE, at,
                           "point %td: pore_pressure must be finite, got %g", at, start);
        return failure(error, GRIT_BAD_STATE, at,
                       "point %td: the increment takes pore_pressure from %g to %g: units of "
                       "bulk_modulus (%g)?",
                       at, start, end_pressure(at), water.K_w);
    }

    const UpdateRequest& call;
    const grit_sand_water& views;
    const PoreWater water;
    UpdateOutcome bad;  // the first of the call; no fault: of its water

    // This piece.
    std::ptrdiff_t count = 0;
    std::ptrdiff_t number[capacity], index[capacity];
    double p_w[capacity];  // at the end
    grit_sand_report reports[capacity];
};

}  // namespace
}  // namespace grit

using namespace grit;

extern "C" {

grit_status grit_sand_water_init(grit_sand_water* water, size_t struct_size) {
    return init_versioned(default_water, water, struct_size) ? GRIT_OK : GRIT_BAD_CALL;
}

grit_status grit_sand_water_stiffness(const grit_sand_water* water, double pore_pressure,
                                      double void_ratio, double* stiffness) {
    grit_sand_water own;
    if (!water || !stiffness || !is_finite(pore_pressure) || !is_finite(void_ratio) ||
        !(void_ratio > 0.0))
        return GRIT_BAD_CALL;
    const grit_sand_water* const w = view_versioned(water, default_water, own);
    grit_error* const error = nullptr;
    if (!w) return GRIT_BAD_CALL;
    GRIT_CHECK(check_water(*w, error));
    *stiffness = water_of(*w).stiffness(pore_pressure, void_ratio);
    return GRIT_OK;
}

grit_status grit_sand_update_undrained(const grit_sand* sand, const grit_sand_options* options,
                                       const grit_sand_water* water, ptrdiff_t n,
                                       const grit_sand_points* points, grit_sand_report* reports,
                                       grit_error* error) {
    constexpr char name[] = "grit_sand_update_undrained";
    SandCall call;
    grit_sand_water own_water;
    GRIT_CHECK(read_call(name, sand, options, n, points, call, error));
    GRIT_CHECK(check_given(water, {name, "water"}, error));
    const grit_sand_water* const w = view_versioned(water, default_water, own_water);
    GRIT_CHECK(
        check_understood(w, water, "grit_sand_water", "call grit_sand_water_init first", error));
    GRIT_CHECK(check_update(call, n, error));
    GRIT_CHECK(check_water(*w, error));
    if (n == 0) return GRIT_OK;
    GRIT_CHECK(check_water_views(*w, n, error));
    return Undrained(request_of(*sand, call, n, reports), *w).run(error);
}
}
