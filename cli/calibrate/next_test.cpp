// SPDX-License-Identifier: BSD-3-Clause
#include "cli/calibrate/next_test.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <fmt/format.h>

#include "cli/calibrate/followed_steps.hpp"
#include "cli/calibrate/laboratory_column.hpp"
#include "cli/table/columns.hpp"

namespace cli {
namespace {

using calibration::Experiment;
using calibration::Matrix;
using calibration::Vector;

constexpr double independent = 10.0;  // readings that a curve is worth

struct Plan {
    const char* test;
    const char* way;
    double pressure;  // at the start [kPa]
    double last;      // of what drives it
    std::vector<const char*> read;
};

const std::vector<Plan>& plans() {
    static const std::vector<Plan> all = {
        {"oedometer", "axial_stress_kPa", 10.0, -1000.0, {"void_ratio"}},
        {"isotropic", "pressure_kPa", 20.0, 800.0, {"void_ratio"}},
        {"triaxial_drained", "axial_strain", 50.0, -0.2, {"axial_deviator", "volumetric_strain"}},
        {"triaxial_drained", "axial_strain", 400.0, -0.2, {"axial_deviator", "volumetric_strain"}},
        {"triaxial_undrained", "axial_strain", 200.0, -0.1, {"axial_deviator", "pore_pressure"}},
    };
    return all;
}

// Of a channel: of stresses the median share of the largest in a test that has it, of void ratios and strains the median
// itself; or what a good laboratory reaches.
double error_of(const CalibrationCase& file, const calibration::Channel& channel, double largest) {
    const bool stress = channel.unit == "kPa";
    std::vector<double> errors;
    for (const Experiment& test : file.experiments) {
        std::vector<double> most(test.channels.size(), 1e-12);
        for (const calibration::Reading& each : test.readings)
            most[static_cast<std::size_t>(each.channel)] =
                std::max(most[static_cast<std::size_t>(each.channel)], std::abs(each.value));
        for (const calibration::Reading& each : test.readings) {
            const auto place = static_cast<std::size_t>(each.channel);
            if (test.channels[place].name == channel.name)
                errors.push_back(stress ? each.error / most[place] : each.error);
        }
    }
    if (errors.empty()) return stress ? 0.04 * largest : 0.002;
    const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
    std::nth_element(errors.begin(), middle, errors.end());
    return stress ? *middle * largest : *middle;
}

Experiment experiment_of(const Plan& plan, const CalibrationCase& file,
                         const grit_sand_parameters& sand, double density) {
    Experiment out;
    out.kind = plan.test;
    out.options = file.experiments.front().options;
    out.settings = file.experiments.front().settings;
    out.start.intergranular_strain = file.experiments.front().start.intergranular_strain;
    out.at_rest = out.kind == "oedometer";
    if (out.at_rest) out.start.direction = -element::Vector6::Unit(0);
    out.start.stress = out.at_rest ? element::Vector6(-plan.pressure * element::Vector6::Unit(0))
                                   : element::Vector6(-plan.pressure * element::unit_tensor());
    out.start.void_ratio =
        sand.critical_void_ratio - density * (sand.critical_void_ratio - sand.densest_void_ratio);
    const Way* way = nullptr;
    bool shear = false;
    for (const LaboratoryTest& test : laboratory_tests())
        for (const Way& each : test.ways)
            if (test.name == plan.test && each.key == plan.way) {
                way = &each;
                shear = test.shear;
            }
    constexpr int rows = 20;
    for (int i = 0; i <= rows; ++i) {
        const double share = static_cast<double>(i) / rows;
        const double first = plan.pressure * (plan.last < 0.0 ? -1.0 : 1.0);
        out.driven.push_back(way->strain() ? plan.last * share * share
                                           : first * std::pow(plan.last / first, share));
    }
    Followed followed = follow(*way, out.driven, 1.0);
    out.program = {std::move(followed.step)};
    out.records = std::move(followed.increments);
    for (const char* name : plan.read) {
        calibration::Channel channel;
        channel.name = name;
        channel.quantity = *linear_quantity(name, shear);
        for (const Column& column : linear_columns())
            if (column.name == channel.name) channel.unit = column.unit;
        channel.change = counts_from_start(channel.name, channel.unit);
        for (int row = 1; row <= rows; ++row)
            out.readings.push_back({row, static_cast<int>(out.channels.size()), 0.0, 1.0});
        out.channels.push_back(std::move(channel));
    }
    return out;
}

std::string name_of(const Plan& plan, double density, double e) {
    const std::string sand =
        fmt::format("{} sand, e = {:.2f},", density > 0.5 ? "dense" : "loose", e);
    const std::string test = plan.test;
    if (test == "oedometer")
        return fmt::format("oedometer test of {} to {:g} kPa", sand, -plan.last);
    if (test == "isotropic")
        return fmt::format("isotropic compression of {} to {:g} kPa", sand, plan.last);
    return fmt::format("{} triaxial test of {} at {:g} kPa",
                       test == "triaxial_drained" ? "drained" : "undrained", sand, plan.pressure);
}

}  // namespace

std::vector<NextTest> next_tests(const CalibrationCase& file, const CalibrationResult& result,
                                 int threads) {
    struct Candidate {
        const Plan* plan;
        double density;
    };
    std::vector<Candidate> candidates;
    for (const Plan& plan : plans())
        for (const double density : {0.1, 0.85}) candidates.push_back({&plan, density});
    const Matrix information = result.laplace.covariance.inverse();
    std::vector<NextTest> found(candidates.size());
    calibration::in_parallel(threads, candidates.size(), [&](std::size_t i) {
        const Candidate& each = candidates[i];
        const Experiment test = experiment_of(*each.plan, file, result.best, each.density);
        const calibration::Prediction computed =
            calibration::predict(test, result.best, file.space.directions());
        if (!computed.failure.empty()) return;
        Matrix slopes = computed.slopes * file.space.chain(result.fit.x);
        const double share = std::min(1.0, independent / static_cast<double>(test.readings.size()));
        std::vector<double> largest(test.channels.size(), 0.0);
        for (Eigen::Index k = 0; k < slopes.rows(); ++k) {
            double& most = largest[static_cast<std::size_t>(
                test.readings[static_cast<std::size_t>(k)].channel)];
            most = std::max(most, std::abs(computed.values[k]));
        }
        for (Eigen::Index k = 0; k < slopes.rows(); ++k) {
            const auto place =
                static_cast<std::size_t>(test.readings[static_cast<std::size_t>(k)].channel);
            slopes.row(k) *= std::sqrt(share) / result.laplace.inflation /
                             error_of(file, test.channels[place], largest[place]);
        }
        const Matrix after = (information + slopes.transpose() * slopes).inverse();
        NextTest& out = found[i];
        out.name = name_of(*each.plan, each.density, test.start.void_ratio);
        const Vector gain = result.laplace.deviation.cwiseQuotient(after.diagonal().cwiseSqrt());
        Eigen::Index most = 0;
        gain.maxCoeff(&most);
        out.information =
            0.5 * std::log(result.laplace.covariance.determinant() / after.determinant());
        const calibration::FreeParameter& parameter =
            file.space.free[static_cast<std::size_t>(most)];
        const double value = std::abs(parameter.value(result.fit.x[most]));
        const double size = parameter.logarithmic() ? 1.0 : value > 0.0 ? value : parameter.highest;
        out.parameter = calibration::symbol_of(parameter.index);
        out.before = result.laplace.deviation[most] / size;
        out.after = std::sqrt(after(most, most)) / size;
    });
    std::vector<NextTest> out;
    for (NextTest& each : found)
        if (!each.name.empty() && std::isfinite(each.information)) out.push_back(std::move(each));
    std::sort(out.begin(), out.end(),
              [](const NextTest& a, const NextTest& b) { return a.information > b.information; });
    return out;
}

}  // namespace cli
