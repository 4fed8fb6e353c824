// SPDX-License-Identifier: BSD-3-Clause
#include "cli/calibrate/calibrate_command.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <thread>

#include <fmt/format.h>

#include "cli/calibrate/advice.hpp"
#include "cli/calibrate/calibration_case.hpp"
#include "cli/calibrate/calibration_result.hpp"
#include "cli/calibrate/doubts.hpp"
#include "cli/calibrate/misfit.hpp"
#include "cli/calibrate/parameter_rows.hpp"
#include "cli/calibrate/report_page.hpp"
#include "cli/process/abnormal_end.hpp"
#include "cli/process/outputs.hpp"
#include "cli/process/progress.hpp"
#include "cli/process/standard_streams.hpp"
#include "cli/process/version.hpp"
#include "cli/sand/sand_file.hpp"
#include "element/atomic_file.hpp"
#include "element/errors.hpp"

namespace cli {
namespace {

namespace fs = std::filesystem;

fs::path sand_of(const CalibrateRequest& request, const CalibrationCase& file) {
    return request.out / (file.name + "_sand.toml");
}

fs::path report_of(const CalibrateRequest& request, const CalibrationCase& file) {
    return request.out / (file.name + "_report.html");
}

constexpr int draws_of_bands = 200;

class Watch {
  public:
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    // Of all threads.
    double processor_seconds() const {
        return static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC;
    }

  private:
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    std::clock_t processor = std::clock();
};

calibration::Fit best_fit(const CalibrationCase& file, calibration::Problem& problem,
                          CalibrationResult& result, bool quiet) {
    calibration::FitOptions options;
    options.loss = calibration::Loss(file.loss, file.loss_scale);
    options.starts = file.starts;
    options.spread = file.spread;
    Progress progress(file.name, "start");
    options.progress = [&](int ended) {
        if (!quiet) progress(ended, file.starts);
        return !RunGuard::interrupted();
    };
    const Watch watch;
    calibration::Fit out = fit(problem, problem.space().coordinates(file.space.base), options);
    // What an error of the void ratio does depends on the parameters: once more from there.
    if (!out.stopped && problem.weigh_starts(out.x)) {
        const std::vector<calibration::Descent> descents = std::move(out.descents);
        const std::size_t best = out.best;
        const int agreeing = out.agreeing;
        options.starts = 1;
        options.progress = [](int) { return !RunGuard::interrupted(); };
        out = fit(problem, out.x, options);
        out.descents = descents;
        out.best = best;
        out.agreeing = agreeing;
    }
    progress.finish();
    result.fit_seconds = watch.seconds();
    result.fit_processor_seconds = watch.processor_seconds();
    return out;
}

void say_tests(const CalibrationCase& file) {
    std::size_t fitted = 0, readings = 0;
    for (const calibration::Experiment& each : file.experiments) {
        if (!each.fitted) continue;
        ++fitted;
        readings += each.readings.size();
    }
    say("{}: {} test{} with {} readings fitted, {} held out\n", file.title, fitted,
        fitted == 1 ? "" : "s", readings, file.experiments.size() - fitted);
}

void say_parameters(const CalibrationCase& file, const CalibrationResult& result) {
    say("\n{:<7} {:<4} {:>10} {:>10} {:>10} {:>10}  {}\n", "", "unit", "start", "best", "2.5 %",
        "97.5 %", "start from");
    for (const ParameterRow& row : parameter_rows(file, result))
        say("{:<7} {:<4} {:>10} {:>10} {:>10} {:>10}  {}{}\n", row.info->symbol, row.unit,
            row.start, row.best, row.lowest, row.highest, row.origin,
            row.doubt.empty() ? "" : "; " + row.doubt);
}

void say_fit(const CalibrationCase& file, const CalibrationResult& result) {
    const calibration::Fit& fit = result.fit;
    int iterations = 0;
    for (const calibration::Descent& each : fit.descents) iterations += each.iterations;
    say("\nbest fit: {} of {} starts end there, {} iterations, {:.1f} s ({:.1f} s of processors)\n",
        fit.agreeing, fit.descents.size(), iterations, result.fit_seconds,
        result.fit_processor_seconds);
    if (!result.laplace.overdetermined) {
        say("misfit: {:.3g} independent readings do not tell {} parameters and their own errors\n",
            result.independent, file.space.size());
        return;
    }
    say("misfit: chi^2/({:.0f} - {}) = {:.4g}{}\n", result.independent, file.space.size(),
        result.laplace.misfit,
        result.laplace.inflation > 1.0
            ? fmt::format(": residuals are {:.3g} times their stated errors, and intervals are as "
                          "much wider",
                          result.laplace.inflation)
            : std::string());
}

void say_posterior(const CalibrationCase& file, const CalibrationResult& result) {
    if (!result.posterior) {
        say("intervals: normal distribution at the best fit\n");
        return;
    }
    const calibration::Posterior& posterior = *result.posterior;
    say("posterior: {} samples of {} walkers in {} ensembles (seed {}), {:.1f} s ({:.1f} s of "
        "processors); acceptance "
        "{:.2f}, {} computed to the end or dropped on the way, R-hat {:.3f} at worst, {:.0f} "
        "independent samples at least\n",
        posterior.samples.rows(), posterior.walkers * posterior.ensembles, posterior.ensembles,
        file.seed, result.posterior_seconds, result.posterior_processor_seconds,
        posterior.acceptance, posterior.computed, posterior.r_hat.maxCoeff(),
        posterior.effective.minCoeff());
    if (!(posterior.r_hat.array() < 1.05).all())
        say("note: R-hat above 1.05: the ensembles disagree yet, take more samples\n");
    const double walkers = posterior.walkers * posterior.ensembles;
    const double times = posterior.effective.minCoeff() / walkers;  // of autocorrelation
    if (!(times > 8.0))
        say("note: walkers have gone {:.1f} times as far as they remember: the number of "
            "independent samples is a "
            "guess yet, take more\n",
            times);
}

void say_misfits(const CalibrationCase& file, const CalibrationResult& result) {
    const bool beside = !file.beside.empty();
    say("\n{:<19} {:<18} {:<7} {:>5} {:>12} {:>10}{}\n", "root mean square of", "quantity", "",
        "tests", "this sand", "of largest",
        beside ? fmt::format(" {:>12} {:>10}  {}", file.beside, "of largest", "ratio")
               : std::string());
    for (std::size_t i = 0; i < result.misfits.by_kind.size(); ++i) {
        const Misfit& one = result.misfits.by_kind[i];
        const bool all = one.quantity.empty();
        const auto numbers = [&](const Misfit& each) {
            if (each.tests == 0) return fmt::format(" {:>12} {:>10}", "fails", "");
            return fmt::format(" {:>12.4g} {:>10}", each.root_mean_square,
                               all ? "" : fmt::format("{:.2f} %", 100.0 * each.relative)) +
                   (each.failed > 0 ? fmt::format(" ({} fail)", each.failed) : "");
        };
        std::string other;
        if (beside) {
            const Misfit& two = result.beside.by_kind[i];
            other =
                numbers(two) + fmt::format("  {:.3f}", one.root_mean_square / two.root_mean_square);
        }
        say("{:<19} {:<18} {:<7} {:>5}{}{}\n", one.kind,
            all ? "all over errors" : one.quantity + (one.unit == "-" ? "" : " [" + one.unit + "]"),
            one.fitted ? "fitted" : "held", one.tests + one.failed, numbers(one), other);
    }
}

std::vector<std::string> provenance(const CalibrationCase& file, const CalibrationResult& result) {
    std::vector<std::string> out = {
        fmt::format("{}: found by grit calibrate (Grit {})", file.title, version()),
        fmt::format("case {}", file.path.filename().string())};
    for (const fs::path& each : file.inputs)
        if (each != file.path) out.push_back(fmt::format("from {}", each.filename().string()));
    std::string names;
    for (const calibration::Experiment& each : file.experiments)
        if (each.fitted) names += (names.empty() ? "" : ", ") + each.name;
    out.push_back("tests fitted: " + names);
    out.push_back(fmt::format("chi^2/freedom {:.4g}; 95 % intervals:", result.laplace.misfit));
    for (const ParameterRow& row : parameter_rows(file, result))
        if (!row.lowest.empty())
            out.push_back(fmt::format("  {} {} ... {} {}{}", row.info->symbol, row.lowest,
                                      row.highest, row.unit,
                                      row.doubt.empty() ? "" : ", " + row.doubt));
    return out;
}

}  // namespace

ExitCode run_calibration(const CalibrateRequest& request) {
    CalibrationCase file = read_calibration_case(request.file);
    if (request.samples) file.samples = *request.samples;
    const std::string who = fmt::format("case {} ({})", file.name, file.path.string());
    Outputs outputs;
    outputs.add(sand_of(request, file), who);
    outputs.add(report_of(request, file), who);
    outputs.spare(file.inputs);
    const auto lock = outputs.lock();
    const int threads = request.threads > 0
                            ? request.threads
                            : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    const RunGuard guard(file.name + ": Grit");
    for (std::string& each : doubts_about_units(file, threads))
        file.doubts.push_back(std::move(each));
    if (!request.quiet) say_tests(file);
    flush_words();

    calibration::Problem problem(file.space, file.experiments, file.direct, threads);
    CalibrationResult result;
    result.fit = best_fit(file, problem, result, request.quiet);
    if (result.fit.stopped) {
        warn("grit: {}: stopped on request, nothing is written\n", file.name);
        return failed_computation;
    }
    result.best = file.space.at(result.fit.x);
    result.independent = problem.independent();
    ExitCode ended = ok;
    result.laplace = calibration::laplace(problem, result.fit.residuals, file.inflate);
    if (!request.quiet) say_fit(file, result);
    flush_words();
    if (file.samples > 0) {
        calibration::SampleOptions options;
        options.loss = calibration::Loss(file.loss, file.loss_scale);
        options.samples = file.samples;
        options.seed = file.seed;
        options.inflation = result.laplace.inflation;
        Progress progress(file.name, "sample");
        options.progress = [&](long done, long all) {
            if (!request.quiet) progress(done, all);
            return !RunGuard::interrupted();
        };
        const Watch watch;
        try {
            result.posterior = calibration::sample(problem, result.fit.x, result.laplace, options);
        } catch (const element::BadCase& error) {
            file.doubts.push_back(fmt::format(
                "no samples, intervals are those of a normal distribution: {}", error.what()));
        }
        progress.finish();
        result.posterior_seconds = watch.seconds();
        result.posterior_processor_seconds = watch.processor_seconds();
        if (result.posterior && result.posterior->stopped) {
            warn("grit: {}: sampling was stopped on request: intervals are those of a normal "
                 "distribution at the best fit\n",
                 file.name);
            result.posterior.reset();
            ended = failed_computation;
        }
    }
    result.intervals = intervals(file.space, result);
    result.misfits = misfits(file.experiments, result.best, threads);
    if (!file.beside.empty())
        result.beside = misfits(file.experiments, file.beside_parameters, threads);
    result.advice = advice(file.space, result.laplace);
    result.doubts = doubts(file, result);

    const std::vector<NextTest> next = next_tests(file, result, threads);
    // Both are there before either takes the place of an older one: a sand beside its own report.
    element::AtomicFile page(report_of(request, file)), sand(sand_of(request, file));
    write_report_page(page, file, result, bands(file, result, draws_of_bands, threads), next);
    write_sand_file(sand, result.best, provenance(file, result));
    sand.complete();
    page.complete();
    if (request.quiet) return ended;
    say_posterior(file, result);
    say_parameters(file, result);
    say_misfits(file, result);
    say("\n");
    for (const std::string& sentence : result.doubts) say("look: {}\n", sentence);
    for (const std::string& sentence : result.advice) say("{}\n", sentence);
    if (!next.empty()) say("most would be learnt from a further {}\n", next.front().name);
    say("-> {}, {}\n", sand_of(request, file).string(), report_of(request, file).string());
    return ended;
}

}  // namespace cli
