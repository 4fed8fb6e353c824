// SPDX-License-Identifier: BSD-3-Clause
// Tests of a laboratory that the law itself has made.
#pragma once

#include <cmath>

#include "element/calibration/experiment.hpp"
#include "element/laboratory.hpp"

inline grit_sand_parameters lausitz() {
    grit_sand_parameters out;
    grit_sand_parameters_init(&out, sizeof out);
    grit_sand_record_parameters(grit_sand_record_find("lausitz"), 1.0, &out);
    return out;
}

inline element::Step imported(const element::Step& unit, const std::vector<double>& values) {
    element::Step out = unit;
    element::Imported path;
    path.rows = std::get<element::Linear>(unit.kind).rows;
    path.columns[0] = {0, 1.0};
    for (const double each : values) path.table.push_back({each});
    out.kind = path;
    return out;
}

// Readings in every second record.
inline void read_all(calibration::Experiment& test, int increments) {
    for (int i = 0; i <= increments; i += 2) test.records.push_back(i);
    for (int c = 0; c < static_cast<int>(test.channels.size()); ++c)
        for (int row = 1; row < static_cast<int>(test.records.size()); ++row)
            test.readings.push_back({row, c, 0.0, 1.0});
}

inline calibration::Experiment oedometer(double void_ratio, bool at_zero_pressure = false) {
    calibration::Experiment out;
    out.name = "oedometer";
    out.kind = "oedometer";
    out.driver = "stress_11";
    out.start.stress[0] = -10.0;
    out.start.direction = -element::Vector6::Unit(0);
    out.start.void_ratio = void_ratio;
    out.at_rest = true;
    out.at_zero_pressure = at_zero_pressure;
    std::vector<double> stress;
    for (int i = 0; i <= 20; ++i) stress.push_back(-10.0 * std::pow(50.0, i / 20.0));
    out.program = {imported(element::oedometer_stress(-1.0), stress)};
    calibration::Channel e{"void_ratio", "-", {}, false};
    e.quantity.void_ratio = 1.0;
    out.channels = {e};
    read_all(out, 20);
    for (const int record : out.records)
        out.driven.push_back(stress[static_cast<std::size_t>(record)]);
    return out;
}

inline calibration::Experiment triaxial(double pressure, double void_ratio) {
    calibration::Experiment out;
    out.name = "triaxial";
    out.kind = "triaxial_drained";
    out.driver = "axial_strain";
    out.start.stress = -pressure * element::unit_tensor();
    out.start.void_ratio = void_ratio;
    std::vector<double> strain;
    for (int i = 0; i <= 40; ++i) strain.push_back(-0.2 * std::pow(i / 40.0, 2.0));
    out.program = {imported(element::triaxial_drained(-1.0), strain)};
    calibration::Channel q{"axial_deviator", "kPa", {}, false};
    q.quantity.total_stress.head<3>() << -1.0, 0.5, 0.5;
    calibration::Channel v{"volumetric_strain", "-", {}, true};
    v.quantity.strain.head<3>().setOnes();
    out.channels = {q, v};
    read_all(out, 40);
    for (const int record : out.records)
        out.driven.push_back(strain[static_cast<std::size_t>(record)]);
    return out;
}

// Its readings become what the sand gives, with this error of the largest of each channel.
inline void measure(calibration::Experiment& test, const grit_sand_parameters& sand, double error) {
    const calibration::Prediction exact = calibration::predict(test, sand);
    std::vector<double> largest(test.channels.size(), 0.0);
    for (std::size_t i = 0; i < test.readings.size(); ++i) {
        calibration::Reading& each = test.readings[i];
        each.value = exact.values[static_cast<Eigen::Index>(i)];
        double& most = largest[static_cast<std::size_t>(each.channel)];
        most = std::fmax(most, std::fabs(each.value));
    }
    for (calibration::Reading& each : test.readings)
        each.error = error * largest[static_cast<std::size_t>(each.channel)];
}
