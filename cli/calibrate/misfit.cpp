// SPDX-License-Identifier: BSD-3-Clause
#include "cli/calibrate/misfit.hpp"

#include <algorithm>
#include <cmath>

#include "element/calibration/problem.hpp"

namespace cli {
namespace {

struct Sum {
    Misfit row;
    double squares = 0.0, relative_squares = 0.0;
    long count = 0;
    const calibration::Experiment* last = nullptr;  // that has been counted
};

Sum& find(std::vector<Sum>& sums, const calibration::Experiment& test, const std::string& quantity,
          const std::string& unit) {
    const auto at = std::find_if(sums.begin(), sums.end(), [&](const Sum& each) {
        return each.row.kind == test.kind && each.row.quantity == quantity &&
               each.row.fitted == test.fitted;
    });
    if (at != sums.end()) return *at;
    sums.emplace_back();
    sums.back().row.kind = test.kind;
    sums.back().row.quantity = quantity;
    sums.back().row.unit = unit;
    sums.back().row.fitted = test.fitted;
    return sums.back();
}

void count(Sum& sum, const calibration::Experiment& test, bool failed) {
    if (sum.last == &test) return;
    sum.last = &test;
    ++(failed ? sum.row.failed : sum.row.tests);
}

void add(std::vector<Sum>& sums, const calibration::Experiment& test,
         const calibration::Prediction& computed) {
    const bool failed = !computed.failure.empty();
    std::vector<double> largest(test.channels.size(), 0.0);
    for (const calibration::Reading& each : test.readings)
        largest[static_cast<std::size_t>(each.channel)] =
            std::max(largest[static_cast<std::size_t>(each.channel)], std::abs(each.value));
    for (std::size_t i = 0; i < test.readings.size(); ++i) {
        const calibration::Reading& reading = test.readings[i];
        const calibration::Channel& channel =
            test.channels[static_cast<std::size_t>(reading.channel)];
        find(sums, test, channel.name, channel.unit);
        Sum& all = find(sums, test, "", "");  // finding may move what was found before
        Sum& one = find(sums, test, channel.name, channel.unit);
        count(one, test, failed);
        count(all, test, failed);
        if (failed) continue;
        const double difference = computed.values[static_cast<Eigen::Index>(i)] - reading.value;
        one.squares += difference * difference;
        const double most = largest[static_cast<std::size_t>(reading.channel)];
        const double share = most > 0.0 ? difference / most : difference == 0.0 ? 0.0 : INFINITY;
        one.relative_squares += share * share;
        ++one.count;
        const double over_error = difference / reading.error;
        all.squares += over_error * over_error;
        ++all.count;
    }
}

TestMisfit of_test(const calibration::Experiment& test, const calibration::Prediction& computed) {
    TestMisfit out;
    if (!computed.failure.empty()) {
        out.root_mean_square = out.worst = NAN;
        return out;
    }
    std::vector<double> squares(test.channels.size(), 0.0), counts(test.channels.size(), 0.0);
    double before = 0.0;
    int channel = -1;
    for (std::size_t i = 0; i < test.readings.size(); ++i) {
        const calibration::Reading& each = test.readings[i];
        const double off =
            (computed.values[static_cast<Eigen::Index>(i)] - each.value) / each.error;
        squares[static_cast<std::size_t>(each.channel)] += off * off;
        counts[static_cast<std::size_t>(each.channel)] += 1.0;
        out.squares += off * off;
        if (each.channel == channel) out.neighbours += off * before;
        channel = each.channel;
        before = off;
    }
    out.root_mean_square = std::sqrt(out.squares / static_cast<double>(test.readings.size()));
    for (std::size_t c = 0; c < squares.size(); ++c) {
        const double off = std::sqrt(squares[c] / std::max(counts[c], 1.0));
        if (off < out.worst) continue;
        out.worst = off;
        out.quantity = test.channels[c].name;
    }
    return out;
}

}  // namespace

Misfits misfits(const std::vector<calibration::Experiment>& tests, const grit_sand_parameters& sand,
                int threads) {
    std::vector<calibration::Prediction> computed(tests.size());
    calibration::in_parallel(threads, tests.size(), [&](std::size_t i) {
        computed[i] = calibration::predict(tests[i], sand);
    });
    Misfits out;
    std::vector<Sum> sums;
    for (std::size_t i = 0; i < tests.size(); ++i) {
        add(sums, tests[i], computed[i]);
        out.by_test.push_back(of_test(tests[i], computed[i]));
    }
    for (Sum& each : sums) {
        const auto count = static_cast<double>(each.count);
        each.row.root_mean_square = std::sqrt(each.squares / count);
        each.row.relative = std::sqrt(each.relative_squares / count);
        out.by_kind.push_back(each.row);
    }
    return out;
}

}  // namespace cli
