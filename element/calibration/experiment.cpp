// SPDX-License-Identifier: BSD-3-Clause
#include "element/calibration/experiment.hpp"

#include <cmath>

#include "element/errors.hpp"

namespace calibration {
namespace {

using element::Start;
using element::StartSlopes;

double mean_pressure(const Start& start) { return -start.stress.head<3>().sum() / 3.0; }

// The start that these parameters make of what is given, and its derivatives.
Start start_of(const Experiment& experiment, const element::GritLaw& law,
               const grit_sand_parameters& parameters) {
    Start start = experiment.start;
    if (experiment.at_rest)
        start.stress[1] = start.stress[2] =
            (1.0 - std::sin(parameters.critical_friction_angle)) * start.stress[0];
    if (experiment.at_zero_pressure)
        start.void_ratio = element::void_ratio_at_pressure(law.sand(), experiment.start.void_ratio,
                                                           mean_pressure(start));
    return start;
}

// K_0 = 1 - sin phi_c, and (H6) at the pressure of that stress.
StartSlopes slopes_of(const Experiment& experiment, const element::GritLaw& law,
                      const grit_sand_parameters& parameters, const Start& start,
                      const element::Directions& by) {
    StartSlopes out;
    const auto count = static_cast<Eigen::Index>(by.size());
    const double p = mean_pressure(start);
    Eigen::RowVectorXd of_pressure = Eigen::RowVectorXd::Zero(count);
    if (experiment.at_rest) {
        out.stress = element::Matrix6X::Zero(6, count);
        for (Eigen::Index k = 0; k < count; ++k) {
            if (by[static_cast<std::size_t>(k)] != GRIT_SAND_CRITICAL_FRICTION_ANGLE) continue;
            const double lateral = -std::cos(parameters.critical_friction_angle) * start.stress[0];
            out.stress(1, k) = out.stress(2, k) = lateral;
            of_pressure[k] = -2.0 / 3.0 * lateral;
        }
    }
    if (experiment.at_zero_pressure) {
        const double e_0 = experiment.start.void_ratio;
        out.void_ratio = element::slopes_at_pressure(law.sand(), e_0, p, by);
        if (experiment.at_rest) {
            const double shifted = p + parameters.pressure_shift;
            const double x = std::pow(3.0 * shifted / parameters.granulate_hardness,
                                      parameters.stiffness_exponent);
            out.void_ratio -=
                start.void_ratio * parameters.stiffness_exponent * x / shifted * of_pressure;
        }
    }
    return out;
}

void read_off(const Experiment& experiment, const std::vector<element::Record>& records,
              Prediction& out) {
    const std::size_t first =
        records.size() - 1 - static_cast<std::size_t>(experiment.records.back());
    const element::Record& start = records[first];
    const auto count = static_cast<Eigen::Index>(experiment.readings.size());
    const Eigen::Index directions = start.slopes.strain.cols();
    out.values.resize(count);
    out.slopes.resize(directions > 0 ? count : 0, directions);
    for (Eigen::Index i = 0; i < count; ++i) {
        const Reading& reading = experiment.readings[static_cast<std::size_t>(i)];
        const Channel& channel = experiment.channels[static_cast<std::size_t>(reading.channel)];
        const element::Record& record =
            records[first + static_cast<std::size_t>(
                                experiment.records[static_cast<std::size_t>(reading.row)])];
        const element::LinearQuantity& quantity = channel.quantity;
        out.values[i] = quantity.of(record) - (channel.change ? quantity.of(start) : 0.0);
        if (directions == 0) continue;
        out.slopes.row(i) = quantity.of(record.slopes);
        if (channel.change) out.slopes.row(i) -= quantity.of(start.slopes);
    }
}

}  // namespace

Prediction predict(const Experiment& experiment, const grit_sand_parameters& parameters,
                   const element::Directions& by) {
    Prediction out;
    try {
        const element::GritLaw law(parameters, experiment.options);
        const Start start = start_of(experiment, law, parameters);
        element::Sample sample;
        sample.point = element::start_point(law, start);
        if (!by.empty())
            sample.slopes = element::start_slopes(
                law, start, by, slopes_of(experiment, law, parameters, start, by));
        const element::History history =
            element::simulate(law, sample, experiment.program, experiment.settings);
        if (history.failure) out.failure = history.failure->message;
        else read_off(experiment, history.records, out);
    } catch (const element::BadCase& error) {
        out.failure = error.what();
    }
    if (out.failure.empty() && !(out.values.allFinite() && out.slopes.allFinite()))
        out.failure = "a value that is not finite";
    return out;
}

}  // namespace calibration
