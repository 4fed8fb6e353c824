// SPDX-License-Identifier: BSD-3-Clause
// Errors of whole paths and evaluations of the rate by tolerance: docs/accuracy.md, docs/adr/0009.
//   path_errors [TOLERANCE ...]   the default one if none is named
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <string>

#include "paths/strain_path.hpp"

namespace {

using namespace paths;

constexpr double wanted = 2e-4;
constexpr int sizes[] = {30, 67, 100, 300, 1000};
const std::string drawn = "random";
constexpr int random_count = 3000;
constexpr unsigned random_seed = 1;

struct Tally {
    double worst = 0.0;
    std::string where;
    int paths = 0, beyond = 0;
    long calls = 0, evaluations = 0;

    void add(const StrainPath& path, const Course& course, double off) {
        ++paths;
        beyond += !(off <= wanted);
        calls += static_cast<long>(course.stress.size());
        evaluations += course.evaluations;
        if (off <= worst) return;
        worst = off;
        where = path.sand_name + (path.intergranular_off ? ", h off" : "") + ", " + path.kind;
    }
    void print(const std::string& name) const {
        std::printf("%-38s %6d  %8.1e %6d  %8.2f  %s\n", name.c_str(), paths, worst, beyond,
                    static_cast<double>(evaluations) / static_cast<double>(calls), where.c_str());
    }
};

void tables(const std::vector<double>& tolerances) {
    std::vector<std::pair<std::string, std::vector<StrainPath>>> groups;
    groups.push_back({"reference, their rows", reference_paths(GRIT_REFERENCE, 0)});
    for (const int calls : sizes)
        groups.push_back({"reference, " + std::to_string(calls) + " calls",
                          reference_paths(GRIT_REFERENCE, calls)});
    for (const int calls : sizes)
        for (const StrainPath& path : laboratory_paths(calls)) {
            const std::string name = path.kind + ", " + std::to_string(calls) + " calls";
            const auto same = [&](const auto& group) { return group.first == name; };
            auto found = std::find_if(groups.begin(), groups.end(), same);
            if (found == groups.end()) found = groups.insert(groups.end(), {name, {}});
            found->second.push_back(path);
        }
    groups.push_back({drawn, random_paths(random_count, random_seed)});
    std::map<const StrainPath*, Course> exact;
    for (const auto& group : groups)
        for (const StrainPath& path : group.second) exact[&path] = run(path, exact_tolerance);
    for (const double tolerance : tolerances) {
        std::printf("\ntolerance %g\n%-38s  paths  worst  > %.0e  evaluations a call, worst of\n",
                    tolerance, "", wanted);
        Tally all;
        for (const auto& [name, list] : groups) {
            Tally tally;
            for (const StrainPath& path : list) {
                if (name == drawn && opens(exact[&path])) continue;
                const Course course = run(path, tolerance);
                const double off = error(path, course, exact[&path]);
                tally.add(path, course, off);
                all.add(path, course, off);
            }
            tally.print(name);
        }
        all.print("all");
    }
}

}  // namespace

int main(int count, char** words) {
    std::vector<double> tolerances;
    for (int i = 1; i < count; ++i) tolerances.push_back(std::atof(words[i]));
    if (tolerances.empty()) tolerances = {GRIT_SAND_DEFAULT_TOLERANCE};
    try {
        tables(tolerances);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "path_errors: %s\n", e.what());
        return 1;
    }
}
