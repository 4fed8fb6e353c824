// SPDX-License-Identifier: BSD-3-Clause
// torture sand|derivatives|undrained|contact|distances|normals|penalty|surface|mpm [--count N] [--seed S] [--only BLOCK] [--part SHARE] [--hours H] [--threads N] [--journal FILE]:
// random trials, what they found, and for each rule that was broken a program that breaks it again. Ends with 1 if there is one.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <stdexcept>

#include <CLI/CLI.hpp>

#include "robustness/campaign.hpp"
#include "robustness/contact_trials.hpp"
#include "robustness/derivative_trials.hpp"
#include "robustness/distance_trials.hpp"
#ifdef GRIT_TORTURES_MPM
#include "robustness/mpm_trials.hpp"
#endif
#include "robustness/normal_trials.hpp"
#include "robustness/penalty_trials.hpp"
#include "robustness/sand_trials.hpp"
#include "robustness/surface_trials.hpp"
#include "robustness/undrained_trials.hpp"

int main(int argc, char** argv) {
    using namespace robustness;
    CLI::App app("Random trials of Grit, see docs/robustness.md");
    Campaign campaign;
    std::string name;
    const std::map<std::string, Kind (*)()> kinds{{"sand", &sand_trials},
                                                  {"contact", &contact_trials},
#ifdef GRIT_TORTURES_MPM
                                                  {"mpm", &mpm_trials},
#endif
                                                  {"distances", &distance_trials},
                                                  {"normals", &normal_trials},
                                                  {"penalty", &penalty_trials},
                                                  {"surface", &surface_trials},
                                                  {"derivatives", &derivative_trials},
                                                  {"undrained", &undrained_trials}};
    app.add_option("KIND", name, "Of what")->required()->check(CLI::IsMember(kinds));
    app.add_option("--count", campaign.count, "Cases, in whole blocks")
        ->check(CLI::Range(1L, 1000000000000L));
    app.add_option("--seed", campaign.seed, "Other numbers")->check(CLI::NonNegativeNumber);
    app.add_option("--only", campaign.only, "This block alone, as a longer campaign counts them")
        ->check(CLI::NonNegativeNumber)
        ->excludes(app.add_option("--journal", campaign.journal,
                                  "File with a line per block, to go on from"));
    app.add_option("--hours", campaign.hours, "Begin no block after them")
        ->check(CLI::PositiveNumber);
    double part = 1.0;
    app.add_option("--part", part, "Blocks of this share of their cases, the first")
        ->check(CLI::Range(1e-9, 1.0));
    app.add_option("--threads", campaign.threads, "Change no result")->check(CLI::Range(1, 1024));
    CLI11_PARSE(app, argc, argv);
    try {
        Kind kind = kinds.at(name)();
        kind.block = std::max(1L, std::lround(part * static_cast<double>(kind.block)));
        return run(kind, campaign) ? 0 : 1;
    } catch (const std::runtime_error& error) {
        std::fprintf(stderr, "torture: %s\n", error.what());
        return 2;
    }
}
