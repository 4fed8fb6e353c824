// SPDX-License-Identifier: BSD-3-Clause
#include "element/calibration/problem.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>

namespace calibration {

void in_parallel(int threads, std::size_t count, const std::function<void(std::size_t)>& work) {
    std::atomic<std::size_t> next{0};
    std::mutex mutex;  // of what follows
    std::size_t failed = count;
    std::exception_ptr failure;
    const auto serve = [&] {
        for (std::size_t i = next++; i < count; i = next++) {
            try {
                work(i);
            } catch (...) {
                const std::lock_guard lock(mutex);
                if (i < failed) {
                    failed = i;
                    failure = std::current_exception();
                }
                next = count;  // those before it have been taken
            }
        }
    };
    std::vector<std::thread> helpers;
    helpers.reserve(std::min(static_cast<std::size_t>(std::max(threads, 1)), count));
    try {
        for (int i = 1; i < threads && static_cast<std::size_t>(i) < count; ++i)
            helpers.emplace_back(serve);
    } catch (
        const std::system_error&) {  // no more threads are to be had: those that are there do it
    }
    serve();
    for (std::thread& helper : helpers) helper.join();
    if (failure) std::rethrow_exception(failure);
}

Problem::Problem(ParameterSpace space, std::vector<Experiment> experiments,
                 std::vector<Direct> direct, int threads)
    : parameters(std::move(space)), tests(std::move(experiments)), measured(std::move(direct)),
      workers(threads) {
    for (std::size_t i = 0; i < tests.size(); ++i) {
        if (!tests[i].fitted) continue;
        const Experiment& test = tests[i];
        const auto count = static_cast<Eigen::Index>(test.readings.size());
        fitted.push_back(i);
        begins.push_back(row_count);
        row_count += count;
        const double share = test.independent > 0.0
                                 ? std::min(1.0, test.independent / static_cast<double>(count))
                                 : 1.0;
        Vector scale(count), value(count);
        for (Eigen::Index k = 0; k < count; ++k) {
            const Reading& reading = test.readings[static_cast<std::size_t>(k)];
            scale[k] = std::sqrt(share) / reading.error;
            value[k] = reading.value;
        }
        scales.push_back(std::move(scale));
        readings.push_back(std::move(value));
    }
    common.resize(fitted.size());
    row_count += static_cast<Eigen::Index>(measured.size());
}

double Problem::independent() const {
    auto out = static_cast<double>(measured.size());
    for (const std::size_t i : fitted) {
        const auto count = static_cast<double>(tests[i].readings.size());
        out += tests[i].independent > 0.0 ? std::min(tests[i].independent, count) : count;
    }
    return out;
}

// With u = J_e sigma_e, errors have the covariance 1 + u u'; its root's inverse is 1 - c u u', which common holds as
// sqrt(c) u.
bool Problem::weigh_starts(const Vector& x) {
    bool any = false;
    const grit_sand_parameters sand = parameters.at(x);
    for (std::size_t i = 0; i < fitted.size(); ++i) {
        const Experiment& test = tests[fitted[i]];
        if (!(test.void_ratio_error > 0.0)) continue;
        const Prediction out = predict(test, sand, {element::by_void_ratio});
        if (!out.failure.empty()) continue;
        const Vector u = test.void_ratio_error * scales[i].cwiseProduct(Vector(out.slopes.col(0)));
        const double square = u.squaredNorm();
        if (!(square > 0.0)) continue;
        common[i] = std::sqrt((1.0 - 1.0 / std::sqrt(1.0 + square)) / square) * u;
        any = true;
    }
    return any;
}

Vector Problem::weighed(std::size_t i, const Vector& values) const {
    if (common[i].size() == 0) return values;
    return values - common[i] * common[i].dot(values);
}

Vector Problem::left(std::size_t i, const Vector& predicted) const {
    return weighed(i, (predicted - readings[i]).cwiseProduct(scales[i]));
}

void Problem::add_direct(const Vector& x, Residuals& out) const {
    const grit_sand_parameters sand = parameters.at(x);
    const Matrix chain = parameters.chain(x);
    const element::Directions by = parameters.directions();
    Eigen::Index row = row_count - static_cast<Eigen::Index>(measured.size());
    for (const Direct& each : measured) {
        out.values[row] = (get(sand, each.index) - each.value) / each.error;
        for (std::size_t k = 0; k < by.size() && out.slopes.rows() > 0; ++k)
            if (by[k] == each.index)
                out.slopes.row(row) = chain.row(static_cast<Eigen::Index>(k)) / each.error;
        ++row;
    }
}

std::optional<Residuals> Problem::residuals(const Vector& x, bool with_slopes,
                                            std::string* why) const {
    const grit_sand_parameters sand = parameters.at(x);
    const element::Directions by = with_slopes ? parameters.directions() : element::Directions{};
    const Matrix chain = parameters.chain(x);
    Residuals out;
    out.values = Vector::Zero(row_count);
    out.slopes = Matrix::Zero(with_slopes ? row_count : 0, parameters.size());
    std::vector<std::string> failures(fitted.size());
    in_parallel(workers, fitted.size(), [&](std::size_t i) {
        Prediction now = predict(tests[fitted[i]], sand, by);
        failures[i] = std::move(now.failure);
        if (!failures[i].empty()) return;
        const Eigen::Index begin = begins[i], count = now.values.size();
        out.values.segment(begin, count) = left(i, now.values);
        if (!with_slopes) return;
        const Matrix slopes = scales[i].asDiagonal() * (now.slopes * chain);
        for (Eigen::Index k = 0; k < slopes.cols(); ++k)
            out.slopes.block(begin, k, count, 1) = weighed(i, slopes.col(k));
    });
    for (std::size_t i = 0; i < failures.size(); ++i)
        if (!failures[i].empty()) {
            if (why) *why = tests[fitted[i]].name + ": " + failures[i];
            return std::nullopt;
        }
    add_direct(x, out);
    return out;
}

std::optional<double> Problem::sum(const Vector& x, double limit, const Loss& rho) const {
    const grit_sand_parameters sand = parameters.at(x);
    double total = 0.0;
    for (const Direct& each : measured) {
        const double r = (get(sand, each.index) - each.value) / each.error;
        total += rho(r * r);
    }
    for (std::size_t i = 0; i < fitted.size(); ++i) {
        if (total > limit) return std::nullopt;
        const Prediction now = predict(tests[fitted[i]], sand);
        if (!now.failure.empty()) return std::nullopt;
        const Vector r = left(i, now.values);
        for (const double each : r) total += rho(each * each);
    }
    if (total > limit) return std::nullopt;
    return total;
}

}  // namespace calibration
