// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/case/time_function.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace grit::mpm {

double TimeTable::at(double t) const {
    if (!(t > time.front())) return value.front();
    if (t >= time.back()) return value.back();
    const auto i =
        static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), t) - time.begin());
    const double share = (t - time[i - 1]) / (time[i] - time[i - 1]);
    return value[i - 1] + share * (value[i] - value[i - 1]);
}

int PulseTrain::blow(double t) const {
    if (t < start) return 0;
    return static_cast<int>(
        std::min(std::floor((t - start) / interval) + 1.0, static_cast<double>(count)));
}

int PulseTrain::over(double t) const {
    const auto ended = [&](int n) { return n <= count && t >= start + n * interval; };
    int n = std::max(blow(t) - 1, 0);
    while (ended(n + 1)) ++n;  // once at most, the last one and roundoff
    return n;
}

double PulseTrain::at(double t) const {
    const int number = blow(t);
    if (number == 0) return 0.0;
    const double since = t - start - (number - 1) * interval;
    if (since >= duration) return 0.0;
    if (form == PulseForm::half_sine) return peak * std::sin(std::numbers::pi * since / duration);
    return since < peak_time ? peak * since / peak_time
                             : peak * (duration - since) / (duration - peak_time);
}

double value_at(const TimeFunction& function, double t) {
    return std::visit([t](const auto& f) { return f.at(t); }, function);
}

double next_multiple(double interval, double t) {
    if (!(t / interval < 1e15)) return t;
    const double number = std::floor(t / interval) + 1.0, next = number * interval;
    return next > t ? next : (number + 1.0) * interval;
}

}  // namespace grit::mpm
