// SPDX-License-Identifier: BSD-3-Clause
// Do calibrations find what they should? Tests of sands whose parameters are known, computed by the law itself:
//   synthetic recover                  without noise, from starts 30 % off, the seven sands of the catalogue
//   synthetic cover [REPETITIONS] [FILE]  with noise of 2 %: how often the 95 % intervals hold the truth. Repetitions are
//                                      numbered and kept in FILE, which an interrupted run goes on from.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>

#include <tests/calibration/samples.hpp>

#include "element/calibration/fit.hpp"
#include "element/calibration/laplace.hpp"
#include "element/errors.hpp"
#include "element/laboratory.hpp"
#include "support/trials/split_mix.hpp"

namespace {

using namespace calibration;

constexpr double bound_factor = 3.0;  // on both sides of the truth
constexpr double noise = 0.02;        // of a stress, and of the largest strain

std::vector<double> spread(double last, int count, double power) {
    std::vector<double> out;
    for (int i = 0; i <= count; ++i) out.push_back(last * std::pow(i / double(count), power));
    return out;
}

Experiment sample(const char* name, const char* kind, double void_ratio) {
    Experiment out;
    out.name = name;
    out.kind = kind;
    out.options.intergranular_strain = false;
    out.start.intergranular_strain = element::IntergranularStrain::off;
    out.start.void_ratio = void_ratio;
    return out;
}

void add_readings(Experiment& out, int increments, int every) {
    out.records = {0};
    for (int i = every; i <= increments; i += every) out.records.push_back(i);
    for (std::size_t c = 0; c < out.channels.size(); ++c)
        for (int row = 1; row < static_cast<int>(out.records.size()); ++row)
            out.readings.push_back({row, static_cast<int>(c), 0.0, 1.0});
}

Experiment oedometer(const char* name, double void_ratio) {
    Experiment out = sample(name, "oedometer", void_ratio);
    out.at_rest = true;
    out.start.stress[0] = -10.0;
    std::vector<double> stress;
    for (int i = 0; i <= 30; ++i) stress.push_back(-10.0 * std::pow(100.0, i / 30.0));
    out.program = {imported(element::oedometer_stress(-1.0), stress)};
    Channel strain{"axial_strain", "-", {}, true};
    strain.quantity.strain[0] = 1.0;
    out.channels = {strain};
    add_readings(out, 30, 2);
    return out;
}

Experiment triaxial(const char* name, double pressure, double void_ratio, bool undrained) {
    Experiment out =
        sample(name, undrained ? "triaxial_undrained" : "triaxial_drained", void_ratio);
    out.start.stress = -pressure * element::unit_tensor();
    out.program = {
        imported(undrained ? element::triaxial_undrained(-1.0) : element::triaxial_drained(-1.0),
                 spread(-0.20, 48, 1.7))};
    Channel q{"axial_deviator", "kPa", {}, false};
    q.quantity.total_stress = element::Vector6(element::Vector6::Zero());
    q.quantity.total_stress.head<3>() << -1.0, 0.5, 0.5;
    Channel other{"volumetric_strain", "-", {}, true};
    if (undrained) {
        other = {"pore_pressure", "kPa", {}, true};
        other.quantity.pore_pressure = 1.0;
    } else {
        other.quantity.strain.head<3>().setOnes();
    }
    out.channels = {q, other};
    add_readings(out, 48, 3);
    return out;
}

// Loose to dense samples within what the sand can be at their pressures.
std::vector<Experiment> tests_of(const grit_sand_parameters& sand) {
    const double d = sand.densest_void_ratio, c = sand.critical_void_ratio;
    const auto at = [&](double density) { return d + (1.0 - density) * (c - d); };
    Experiment loosest = oedometer("loosest oedometer", c + 0.5 * (sand.loosest_void_ratio - c));
    loosest.at_zero_pressure = true;
    return {loosest,
            oedometer("loose oedometer", at(0.05)),
            oedometer("dense oedometer", at(0.85)),
            triaxial("loose 100", 100.0, at(0.15), false),
            triaxial("medium 200", 200.0, at(0.5), false),
            triaxial("dense 100", 100.0, at(0.8), false),
            triaxial("dense 400", 400.0, at(0.8), false),
            triaxial("undrained 200", 200.0, at(0.4), true)};
}

// Values that the truth gives, and errors of 2 % of each stress and of the largest strain.
bool measure(std::vector<Experiment>& tests, const grit_sand_parameters& truth) {
    for (Experiment& test : tests) {
        const Prediction exact = predict(test, truth);
        if (!exact.failure.empty()) {
            std::fprintf(stderr, "%s: %s\n", test.name.c_str(), exact.failure.c_str());
            return false;
        }
        std::vector<double> largest(test.channels.size(), 0.0);
        for (std::size_t i = 0; i < test.readings.size(); ++i) {
            Reading& reading = test.readings[i];
            reading.value = exact.values[static_cast<Eigen::Index>(i)];
            double& most = largest[static_cast<std::size_t>(reading.channel)];
            most = std::fmax(most, std::fabs(reading.value));
        }
        for (Reading& reading : test.readings)
            reading.error = noise * largest[static_cast<std::size_t>(reading.channel)];
    }
    return true;
}

ParameterSpace space_around(const grit_sand_parameters& truth) {
    ParameterSpace out;
    out.base = truth;
    for (int i = 0; i < 8; ++i) {
        const grit_sand_parameter_info& info = *grit_sand_parameter_describe(i);
        FreeParameter each;
        each.index = i;
        each.lowest = std::fmax(info.lowest, get(truth, i) / bound_factor);
        each.highest = std::fmin(info.highest, get(truth, i) * bound_factor);
        out.free.push_back(each);
    }
    return out;
}

grit_sand_parameters catalogue(int record) {
    grit_sand_parameters out;
    grit_sand_parameters_init(&out, sizeof out);
    grit_sand_record_parameters(record, 1.0, &out);
    return out;
}

// A start with every parameter 30 % off, up or down, where all tests can begin.
Vector start_off(const Problem& problem, const grit_sand_parameters& truth, int trial,
                 double distance) {
    for (int pattern = trial * 37;; ++pattern) {
        grit_sand_parameters start = truth;
        for (int i = 0; i < 8; ++i) {
            const bool up = ((pattern * 2654435761U) >> (8 + i)) & 1U;
            set(start, i, get(truth, i) * (1.0 + (up ? distance : -distance)));
        }
        const Vector x = problem.space().coordinates(start);
        if (problem.space().contains(x) && problem.residuals(x, true)) return x;
        if (pattern > trial * 37 + 20000) return {};
    }
}

int recover() {
    std::printf("%-28s %5s %5s %12s  %s\n", "sand", "start", "iter.", "worst", "of");
    double worst = 0.0;
    for (int record = 0; record < grit_sand_record_count(); ++record) {
        const grit_sand_parameters truth = catalogue(record);
        std::vector<Experiment> tests = tests_of(truth);
        if (!measure(tests, truth)) return 1;
        Problem problem(space_around(truth), tests, {}, 2);
        for (int trial = 0; trial < 3; ++trial) {
            const Vector start = start_off(problem, truth, trial, 0.3);
            if (start.size() == 0) {
                std::printf("%-28s no start 30 %% off can be computed\n",
                            grit_sand_record_at(record)->name);
                return 1;
            }
            FitOptions options;
            options.starts = 8;
            const Fit found = fit(problem, start, options);
            double error = 0.0;
            int of = 0;
            for (int i = 0; i < 8; ++i) {
                const double relative =
                    std::fabs(get(problem.space().at(found.x), i) / get(truth, i) - 1.0);
                if (relative > error) of = i;
                error = std::fmax(error, relative);
            }
            worst = std::fmax(worst, error);
            std::printf("%-28s %5d %5d %12.2e  %s\n", grit_sand_record_at(record)->name, trial + 1,
                        found.descents[found.best].iterations, error, symbol_of(of).c_str());
            std::fflush(stdout);
        }
    }
    std::printf("worst %.2e: %s\n", worst, worst <= 1e-6 ? "within 1e-6" : "BEYOND 1e-6");
    return worst <= 1e-6 ? 0 : 1;
}

int cover(int repetitions, const char* path) {
    const grit_sand_parameters truth = catalogue(grit_sand_record_find("lausitz"));
    std::vector<Experiment> tests = tests_of(truth);
    if (!measure(tests, truth)) return 1;
    const std::vector<Experiment> exact = tests;
    const ParameterSpace space = space_around(truth);
    const Vector x = space.coordinates(truth);
    // A line per repetition: its number, then 1 where the interval of a parameter holds the truth.
    std::vector<std::string> lines;
    if (path) {
        std::ifstream file(path);
        for (std::string line; std::getline(file, line);) lines.push_back(line);
    }
    std::FILE* file = path ? std::fopen(path, "a") : nullptr;
    for (int k = static_cast<int>(lines.size()); k < repetitions; ++k) {
        grit::SplitMix random(static_cast<std::uint64_t>(1000 + k));
        tests = exact;
        for (Experiment& test : tests)
            for (Reading& reading : test.readings) reading.value += reading.error * random.normal();
        Problem problem(space, tests, {}, 2);
        FitOptions options;
        options.starts = 1;
        std::string line = std::to_string(k);
        try {
            const Fit found = fit(problem, x, options);
            const Laplace around = laplace(problem, found.residuals, false);
            for (Eigen::Index i = 0; i < x.size(); ++i)
                line += std::fabs(found.x[i] - x[i]) <= 1.959963984540054 * around.deviation[i]
                            ? " 1"
                            : " 0";
        } catch (const element::BadCase&) {
            line += " failed";
        }
        lines.push_back(line);
        if (file) {
            std::fprintf(file, "%s\n", line.c_str());
            std::fflush(file);
        }
    }
    if (file) std::fclose(file);
    std::vector<int> held(static_cast<std::size_t>(x.size()), 0);
    int failed = 0, all = 0;
    for (const std::string& line : lines) {
        if (line.find("failed") != std::string::npos) {
            ++failed;
            continue;
        }
        for (std::size_t i = 0; i < held.size(); ++i)
            if (line[line.size() - 2 * held.size() + 2 * i + 1] == '1') ++held[i], ++all;
    }
    const int count = static_cast<int>(lines.size()) - failed;
    std::printf("%d repetitions, %d failed; 95 %% intervals that hold the truth\n", count, failed);
    for (std::size_t i = 0; i < held.size(); ++i)
        std::printf("  %-6s %.1f %%\n", symbol_of(static_cast<int>(i)).c_str(),
                    100.0 * held[i] / count);
    const double share = 100.0 * all / (count * static_cast<double>(held.size()));
    std::printf("  all    %.1f %%: %s\n", share,
                share >= 93.0 && share <= 97.0 ? "within 93 ... 97" : "BEYOND 93 ... 97");
    return share >= 93.0 && share <= 97.0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc > 1 && std::strcmp(argv[1], "recover") == 0) return recover();
    if (argc > 1 && std::strcmp(argv[1], "cover") == 0)
        return cover(argc > 2 ? std::atoi(argv[2]) : 500, argc > 3 ? argv[3] : nullptr);
    std::fputs("usage: synthetic recover | cover [REPETITIONS] [FILE]\n", stderr);
    return 2;
}
