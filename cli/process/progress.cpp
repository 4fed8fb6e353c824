// SPDX-License-Identifier: BSD-3-Clause
#include "cli/process/progress.hpp"

#include <unistd.h>

#include <cstdio>

#include <fmt/format.h>

#include "cli/process/standard_streams.hpp"

namespace cli {

Progress::Progress(std::string case_name, std::string counted)
    : name(std::move(case_name)), what(std::move(counted)), terminal(isatty(STDERR_FILENO) == 1),
      start(Clock::now()), last(start) {}

double Progress::seconds() const {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string Progress::line(long increment, long increments) const {
    const double elapsed = seconds();
    const double rate = elapsed > 0.0 ? static_cast<double>(increment) / elapsed : 0.0;
    const double left = rate > 0.0 ? static_cast<double>(increments - increment) / rate : 0.0;
    return fmt::format("{}: {} {} of {} ({:.0f} %), {:.0f} {}s/s, {:.0f} s left", name, what,
                       increment, increments,
                       100.0 * static_cast<double>(increment) / static_cast<double>(increments),
                       rate, what, left);
}

void Progress::operator()(long increment, long increments) {
    const auto now = Clock::now();
    if (terminal) {
        if (now - last < std::chrono::milliseconds(100)) return;
        warn("\r\033[K{}", line(increment, increments));
        drawn = true;
    } else {
        const int reached = static_cast<int>(10.0 * static_cast<double>(increment) /
                                             static_cast<double>(increments));
        if (reached == tenths || now - last < std::chrono::seconds(1)) return;
        tenths = reached;
        warn("{}\n", line(increment, increments));
    }
    last = now;
}

void Progress::finish() {
    if (!drawn) return;
    warn("\r\033[K");
}

}  // namespace cli
