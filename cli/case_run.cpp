// SPDX-License-Identifier: BSD-3-Clause
#include "cli/case_run.hpp"

#include <ctime>
#include <memory>

#include <fmt/format.h>

#include "cli/columns.hpp"
#include "cli/cycles.hpp"
#include "cli/exit_code.hpp"
#include "cli/progress.hpp"
#include "element/errors.hpp"
#include "element/simulate.hpp"

namespace cli {
namespace {

struct Material {
    std::unique_ptr<element::Law> law;
    const element::GritLaw* sand = nullptr;
    element::MaterialPoint start;
};

Material material_of(const CaseFile& file) {
    Material out;
    if (file.umat) {
        auto law = std::make_unique<element::UmatLaw>(*file.umat);
        out.start = law->start(file.start.stress, file.umat_state);
        out.law = std::move(law);
        return out;
    }
    auto law = std::make_unique<element::GritLaw>(file.parameters, file.options);
    out.start = law->start(file.start.stress, file.start.void_ratio);
    if (file.start.intergranular_strain == IntergranularStrain::mobilised)
        law->mobilise(out.start, file.start.direction, file.start.rho);
    out.sand = law.get();
    out.law = std::move(law);
    return out;
}

struct Collected {
    std::vector<StagedRecord> records;
    std::string failure;
    std::vector<std::string> exits;
    long increments = 0;
};

// Stage after stage on one sample. progress may be null.
Collected compute(const CaseFile& file, const Material& material, Progress* progress) {
    Collected out;
    element::Sample sample;
    sample.point = material.start;
    element::Settings settings;
    settings.tolerance = file.stress_tolerance;
    settings.iteration_limit = file.iteration_limit;
    long done = 0, all = 0;
    for (const CaseStage& stage : file.stages) all += element::count_increments(stage.program);
    for (std::size_t i = 0; i < file.stages.size() && out.failure.empty(); ++i) {
        const CaseStage& stage = file.stages[i];
        if (stage.zero_strain) sample.strain.setZero();
        settings.record_start = i == 0 || stage.zero_strain;
        long reached = 0;
        std::string ended;  // by a condition that is watched here
        const auto observer = [&](const element::Progress& now) {
            reached = now.increment;
            if (progress) (*progress)(done + reached, all);
            for (const element::Condition& condition : stage.until)
                if (element::holds(condition, *now.record, material.law->state_names()))
                    ended = fmt::format("step {}: {}", now.step, condition.text);
            return ended.empty();
        };
        element::History history =
            element::simulate(*material.law, sample, stage.program, settings, observer);
        const int number = static_cast<int>(i) + 1;
        for (element::Record& record : history.records)
            out.records.push_back(
                {record.step == 0 && i == 0 ? 0 : number, stage.shear, std::move(record)});
        for (const std::string& exit : history.exits)
            out.exits.push_back(fmt::format("stage {}, {}", number, exit));
        if (!ended.empty()) out.exits.push_back(fmt::format("stage {}, {}", number, ended));
        else if (history.failure)
            out.failure = fmt::format("stage {}, {}", number, history.failure->message);
        done += element::count_increments(stage.program);
        out.increments += reached;
    }
    return out;
}

std::string version() {
    const int v = grit_version();
    return fmt::format("{}.{}.{}", v / 10000, v / 100 % 100, v % 100);
}

void add_comments(const CaseFile& file, CaseResult& result) {
    std::vector<std::string>& out = result.table.comments;
    out.push_back(fmt::format("Grit {}, case {}: {}", version(), file.name, file.title));
    const std::string law = file.umat ? "UMAT " + file.umat->library.string() : "sand " + file.sand;
    out.push_back(fmt::format("{}, p0 {:g} kPa, e {:.6g}, tolerance {:g}", law,
                              result.table.at("p").front(), result.table.at("void_ratio").front(),
                              file.options.tolerance));
    out.emplace_back(
        "tension and extension positive, order 11 22 33 12 13 23, engineering shear, logarithmic "
        "strain; p, q, pore_pressure compression positive; stress_ij effective, shear_stress and "
        "axial_deviator total; nan: unknown to this law");
    out.emplace_back("triaxial and the like: axial_deviator = -(s11 - (s22+s33)/2), shear_stress = "
                     "minus half of "
                     "it, shear_strain = e11 - (e22+e33)/2; simple shear: s12, gamma_12; secant_G "
                     "since the last "
                     "reversal, G_0 = m_R L_1212; h_ij intergranular strain");
    for (const std::string& exit : result.exits) out.push_back("ended by " + exit);
    if (!result.failure.empty()) out.push_back("STOPPED EARLY: " + result.failure);
}

double cpu_milliseconds() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// Processor time: what else the machine does is not the case's.
double fastest_of_five(const CaseFile& file, const Material& material) {
    double best = INFINITY;
    for (int i = 0; i < 5; ++i) {
        const double before = cpu_milliseconds();
        compute(file, material, nullptr);
        best = std::min(best, cpu_milliseconds() - before);
    }
    return best;
}

}  // namespace

CaseResult run_case(const CaseFile& file) try {
    CaseResult out;
    const Material material = material_of(file);
    Progress progress(file.name);
    Collected collected = compute(file, material, &progress);
    progress.finish();
    out.seconds = progress.seconds();
    out.failure = collected.failure;
    out.exits = collected.exits;
    out.increments = collected.increments;
    for (const StagedRecord& staged : collected.records) {
        out.iterations += staged.record.iterations;
        out.evaluations += staged.record.evaluations;
        out.halvings += staged.record.cut_backs;
    }
    if (file.limits.milliseconds) out.milliseconds = fastest_of_five(file, material);
    out.table = tabulate(collected.records, material.sand, material.law->state_names());
    add_comments(file, out);
    std::vector<bool> cyclic;
    for (const CaseStage& stage : file.stages) cyclic.push_back(stage.cyclic);
    out.cycles = cycles_of(out.table, cyclic);
    return out;
} catch (const element::BadCase& error) {
    throw BadInput(fmt::format("{}: {}", file.path.string(), error.what()));
}

}  // namespace cli
