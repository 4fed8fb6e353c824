// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/progress.hpp"

#include <unistd.h>

#include <cmath>
#include <cstdio>

#include <fmt/format.h>

#include "cli/process/standard_streams.hpp"

namespace cli {
namespace {

// Steps between looks at the clock.
constexpr long look_every = 8;

double seconds_between(std::chrono::steady_clock::time_point a,
                       std::chrono::steady_clock::time_point b) {
    return std::chrono::duration<double>(b - a).count();
}

}  // namespace

MpmProgress::MpmProgress(bool be_quiet)
    : quiet(be_quiet), terminal(isatty(STDERR_FILENO) == 1), start(Clock::now()), last(start),
      last_line(start), stage_start(start) {}

double MpmProgress::seconds() const { return seconds_between(start, Clock::now()); }

std::string MpmProgress::line(grit::mpm::Runner& runner) {
    const grit::mpm::Case& plan = runner.description();
    const auto i = static_cast<std::size_t>(runner.state().stage);
    const grit::mpm::Subject& simulation = runner.subject();
    const double steps = static_cast<double>(simulation.steps() - first_step);
    const double rate = steps * static_cast<double>(runner.particles()) / seconds();
    const double share = runner.share_done();
    // Of this stage, at the pace it had so far.
    const double left =
        seconds_between(stage_start, Clock::now()) * (1.0 - share) / (share - stage_share);
    return fmt::format(
        "{}: stage {} ({} of {}){}, depth {:.4f} m, t {:.4f} s, step {}, dt "
        "{:.2e} s, {:.2e} particle-steps/s{}",
        plan.name, plan.stages[i].name, i + 1, plan.stages.size(),
        runner.blow() > 0 ? fmt::format(", blow {}", runner.blow()) : std::string(), runner.depth(),
        simulation.time(), simulation.steps(), runner.state().last_dt, rate,
        std::isfinite(left) && left >= 0.0 ? fmt::format(", {:.0f} s left in this stage", left)
                                           : std::string());
}

bool MpmProgress::operator()(grit::mpm::Runner& runner) {
    if (first_step < 0) first_step = runner.subject().steps() - 1;
    if (runner.finished() || runner.subject().steps() % look_every != 0) return false;
    const auto now = Clock::now();
    if (runner.state().stage != stage) {
        stage = runner.state().stage;
        stage_start = now;
        stage_share = runner.share_done();
    }
    if (now - last < std::chrono::seconds(1)) return false;
    last = now;
    if (quiet || (!terminal && now - last_line < std::chrono::seconds(30))) return true;
    last_line = now;
    warn("{}{}{}", terminal ? "\r\033[K" : "", line(runner), terminal ? "" : "\n");
    drawn = terminal;
    return true;
}

void MpmProgress::finish() {
    if (!drawn) return;
    warn("\r\033[K");
    drawn = false;
}

}  // namespace cli
