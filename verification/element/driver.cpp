// SPDX-License-Identifier: BSD-3-Clause
#include "element/driver.hpp"

#include <algorithm>
#include <cmath>

#include "element/errors.hpp"
#include "element/grit_law.hpp"
#include "element/laboratory.hpp"
#include "element/simulate.hpp"
#include "element/text.hpp"

namespace element {
namespace {

GritLawOptions options_of(const Case& test) {
    GritLawOptions out;
    out.tolerance = test.numerics.tolerance;
    out.evaluation_limit = test.numerics.evaluation_limit;
    out.intergranular_strain = test.start.intergranular_strain != IntergranularStrain::off;
    return out;
}

double start_void_ratio(const GritLaw& law, const Start& start) {
    if (start.void_ratio.has_value() == start.void_ratio_at_zero.has_value())
        throw BadCase("give either void_ratio or void_ratio_at_zero_pressure");
    double e = start.void_ratio.value_or(0.0), limits[3] = {};
    const grit_sand& sand = law.sand();
    if ((start.void_ratio_at_zero &&
         grit_sand_void_ratio_at_pressure(&sand, *start.void_ratio_at_zero, start.pressure, &e)) ||
        grit_sand_void_ratios(&sand, start.pressure, limits))
        throw BadCase(text("no void ratio belongs to a pressure of %g kPa", start.pressure));
    if (!(e >= limits[2] && e <= limits[0]))
        throw BadCase(text("void ratio at %g kPa must be in [e_d, e_i] = [%.4f, %.4f], got %g",
                           start.pressure, limits[2], limits[0], e));
    return e;
}

Sample start_of(const GritLaw& law, const Start& start) {
    if (!(start.pressure > 0.0) || !std::isfinite(start.pressure))
        throw BadCase(text("pressure must be > 0 kPa, got %g kPa", start.pressure));
    Vector6 stress = Vector6::Zero(), compression = Vector6::Zero();
    stress.head<3>().setConstant(-start.pressure);
    compression.head<3>().setConstant(-1.0);
    Sample sample;
    sample.point = law.start(stress, start_void_ratio(law, start));
    if (start.intergranular_strain == IntergranularStrain::mobilised)
        law.mobilise(sample.point, compression, 1.0);
    return sample;
}

Program program_of(const Loading& loading) {
    Step step = component_control(loading.control, loading.change);
    step.increments = loading.increments;
    step.first_share = loading.first_share;
    return {step};
}

Row row_of(const GritLaw& law, const Record& record) {
    Row row;
    row.stress = record.stress;
    row.strain = record.strain;
    row.h = Vector6::Map(record.state.data() + GRIT_SAND_H11);
    row.void_ratio = record.void_ratio;
    row.invariants = law.invariants({record.stress, record.state});
    row.iterations = record.iterations;
    row.evaluations = record.evaluations;
    return row;
}

}  // namespace

Run run(const Case& test, const Observer& observer) {
    const GritLaw law(test.parameters, options_of(test));
    Sample sample = start_of(law, test.start);
    Settings settings;
    settings.tolerance = std::min(settings.tolerance, test.numerics.tolerance);
    const auto report = [&](const Progress& progress) {
        if (observer)
            observer(static_cast<int>(progress.increment), static_cast<int>(progress.increments));
        return true;
    };
    const History history = simulate(law, sample, program_of(test.loading), settings, report);
    Run out;
    for (const Record& record : history.records) {
        out.rows.push_back(row_of(law, record));
        out.halvings += record.cut_backs;
    }
    if (history.failure) out.failure = history.failure->message;
    return out;
}

}  // namespace element
