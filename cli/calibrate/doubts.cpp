// SPDX-License-Identifier: BSD-3-Clause
#include "cli/calibrate/doubts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace cli {
namespace {

using calibration::Experiment;

// How the readings of a quantity may have been mistaken.
struct Mistake {
    double factor;  // that would mend them
    const char* words;
};
constexpr Mistake mistakes[] = {
    {-1.0, "the other sign"},     {1e3, "a thousand times as much"},
    {1e-3, "a thousandth of it"}, {100.0, "a hundred times as much"},
    {0.01, "a hundredth of it"},
};

// Of the readings of a channel, times a factor, over what is computed: 0 if they agree, 1 if nothing was read.
double distance(const Experiment& test, const calibration::Prediction& computed, int channel,
                double factor) {
    double apart = 0.0, size = 0.0;
    for (std::size_t i = 0; i < test.readings.size(); ++i) {
        if (test.readings[i].channel != channel) continue;
        const double value = computed.values[static_cast<Eigen::Index>(i)];
        apart += std::pow(value - factor * test.readings[i].value, 2);
        size += value * value;
    }
    return std::sqrt(apart / size);
}

std::string doubt_about(const Experiment& test, const calibration::Prediction& computed,
                        int channel) {
    const double now = distance(test, computed, channel, 1.0);
    for (const Mistake& each : mistakes)
        if (const double then = distance(test, computed, channel, each.factor);
            now > 0.9 && then < 0.7 && then < 0.4 * now)
            return fmt::format(
                "test {}: sand as it is estimated from the tests has {} of {}: look at its unit "
                "and sign",
                test.name, each.words, test.channels[static_cast<std::size_t>(channel)].name);
    return "";
}

// Farther off than the tests around it.
constexpr double much_farther = 4.0, far_off = 5.0;

std::string tests_far_off(const CalibrationCase& file, const CalibrationResult& result) {
    std::vector<double> all;
    for (const TestMisfit& each : result.misfits.by_test)
        if (!std::isnan(each.root_mean_square)) all.push_back(each.root_mean_square);
    if (all.size() < 2) return "";
    std::sort(all.begin(), all.end());
    const double usual = all[(all.size() - 1) / 2];
    std::string out;
    for (std::size_t i = 0; i < file.experiments.size(); ++i) {
        const TestMisfit& each = result.misfits.by_test[i];
        if (file.experiments[i].void_ratio_error > 0.0)
            continue;  // all readings may be off together
        if (!(each.root_mean_square > std::max(far_off, much_farther * usual))) continue;
        out += fmt::format("{}{} ({}: {:.2g} errors)", out.empty() ? "" : ", ",
                           file.experiments[i].name, each.quantity, each.worst);
    }
    return out.empty()
               ? ""
               : fmt::format(
                     "far from the tests, where others have {:.2g} errors: {}: look at units, "
                     "signs and starts",
                     usual, out);
}

// Of tests whose readings count as one each.
std::string readings_together(const CalibrationCase& file, const CalibrationResult& result) {
    double product = 0.0, square = 0.0;
    std::size_t readings = 0, tests = 0;
    for (std::size_t i = 0; i < file.experiments.size(); ++i) {
        const Experiment& test = file.experiments[i];
        if (!test.fitted || test.independent > 0.0) continue;
        product += result.misfits.by_test[i].neighbours;
        square += result.misfits.by_test[i].squares;
        readings += test.readings.size();
        ++tests;
    }
    constexpr double much = 0.6;
    constexpr std::size_t many = 40;
    const double correlation = product / square;
    if (!(correlation > much) || readings < many) return "";
    const double each = static_cast<double>(readings) / static_cast<double>(tests);
    return fmt::format(
        "neighbouring readings err together (correlation {:.2f}), and intervals are too narrow: "
        "independent_readings = {:.0f} or so of a test",
        correlation, std::max(1.0, each * (1.0 - correlation) / (1.0 + correlation)));
}

}  // namespace

std::vector<std::string> doubts_about_units(const CalibrationCase& file, int threads) {
    std::vector<std::vector<std::string>> found(file.experiments.size());
    calibration::in_parallel(threads, file.experiments.size(), [&](std::size_t i) {
        const Experiment& test = file.experiments[i];
        const calibration::Prediction computed = calibration::predict(test, file.space.base);
        if (!computed.failure.empty()) return;
        for (int c = 0; c < static_cast<int>(test.channels.size()); ++c)
            if (std::string doubt = doubt_about(test, computed, c); !doubt.empty())
                found[i].push_back(std::move(doubt));
    });
    std::vector<std::string> out;
    for (const std::vector<std::string>& each : found)
        out.insert(out.end(), each.begin(), each.end());
    return out;
}

std::vector<std::string> doubts(const CalibrationCase& file, const CalibrationResult& result) {
    std::vector<std::string> out = file.doubts;
    const auto starts = static_cast<int>(result.fit.descents.size());
    if (starts > 1 && 2 * result.fit.agreeing <= starts)
        out.push_back(fmt::format(
            "only {} of {} starts end at the best fit, the others at worse places: there may be "
            "a better one yet",
            result.fit.agreeing, starts));
    if (!result.fit.descents[result.fit.best].converged)
        out.push_back(fmt::format("the best fit had not come to its end after {} iterations",
                                  result.fit.descents[result.fit.best].iterations));
    const bool judged = result.laplace.overdetermined;
    if (judged && result.laplace.misfit > far_off * far_off)
        out.push_back(fmt::format(
            "residuals are {:.3g} times the stated errors: a unit, a sign or a start is wrong, or "
            "the errors are far too small",
            std::sqrt(result.laplace.misfit)));
    if (judged && result.laplace.misfit < 0.4)
        out.push_back(fmt::format(
            "residuals are {:.2g} of the stated errors: these are too large, and intervals wider "
            "than need be",
            std::sqrt(result.laplace.misfit)));
    if (const std::string together = readings_together(file, result); !together.empty())
        out.push_back(together);
    if (const std::string far = tests_far_off(file, result); !far.empty()) out.push_back(far);
    const auto at = [&](Eigen::Index k) { return static_cast<std::size_t>(k); };
    std::string at_bounds, open;
    for (Eigen::Index k = 0; k < file.space.size(); ++k) {
        const calibration::FreeParameter& each = file.space.free[at(k)];
        const std::string symbol = calibration::symbol_of(each.index);
        const double x = result.fit.x[k], low = each.coordinate(each.lowest),
                     high = each.coordinate(each.highest), near = 1e-3 * (high - low);
        if (x < low + near || x > high - near)
            at_bounds += fmt::format("{}{}", at_bounds.empty() ? "" : ", ", symbol);
        else if (result.intervals[at(k)].ends_at_bound && result.laplace.determines(k))
            open += fmt::format("{}{}", open.empty() ? "" : ", ", symbol);
    }
    if (!at_bounds.empty())
        out.push_back(fmt::format(
            "the best fit lies at the bounds of {}: tests and law do not go together there, or the "
            "bounds are too narrow",
            at_bounds));
    if (!open.empty())
        out.push_back(fmt::format(
            "the tests leave {} open to the bounds: what the interval ends at is the bound", open));
    const grit_sand_parameters& best = result.best;
    if (best.loosest_void_ratio < 1.001 * best.critical_void_ratio)
        out.emplace_back(
            "e_i0 is pressed against e_c0: tie it to e_c0, or look at what the loose tests say");
    return out;
}

}  // namespace cli
