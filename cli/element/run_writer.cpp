// SPDX-License-Identifier: BSD-3-Clause
#include "cli/element/run_writer.hpp"

#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/plot/contents.hpp"
#include "cli/process/standard_streams.hpp"

namespace cli {
namespace {

constexpr double least_strain = 1e-12;  // for a secant, and for a reversal

std::vector<std::string> comments_of(const CaseFile& file) {
    const std::string law = file.umat ? "UMAT " + file.umat->library.string() : "sand " + file.sand;
    std::vector<std::string> out = file.heading();
    const std::string more[] = {
        fmt::format("{}, p0 {:g} kPa, e {:.6g}, tolerance {:g}", law,
                    -file.start.stress.head<3>().sum() / 3.0,
                    file.law->observe(file.point).void_ratio, file.options.tolerance),
        "tension and extension positive, order 11 22 33 12 13 23, engineering shear, logarithmic "
        "strain; p, q, pore_pressure compression positive; stress_ij effective, shear_stress and "
        "axial_deviator total; nan: unknown to this law",
        "triaxial and the like: axial_deviator = -(s11 - (s22+s33)/2), shear_stress = minus half "
        "of "
        "it, shear_strain = e11 - (e22+e33)/2; simple shear: s12, gamma_12; secant_G since the "
        "last "
        "reversal, G_0 = m_R L_1212 (basic model: L_1212); h_ij intergranular strain",
        "how the run ended stands below the last row", picture_comment(file.picture)};
    out.insert(out.end(), std::begin(more), std::end(more));
    return out;
}

}  // namespace

RunWriter::RunWriter(const CaseFile& given, const CaseOutput& where, CaseResult& out)
    : output(where), result(out), columns(given.own_law, given.law->state_names()), cycles(columns),
      file(output.csv, comments_of(given), columns.names()) {
    for (std::size_t i = 0; i < columns.names().size(); ++i) {
        const std::string& name = columns.names()[i].name;
        if (name != "stage" && name != "increment" && !output.columns.contains(name)) continue;
        kept.push_back(i);
        result.table.columns.push_back(columns.names()[i]);
    }
}

void RunWriter::begin_stage(int number, const CaseStage& stage) {
    setting = {number, stage.shear, NAN};
    cyclic = stage.cyclic;
    started = false;
}

// The point of the stage before is where this one begins, unless a record of its own says so.
void RunWriter::start_from(const element::Record& record) {
    started = true;
    reversal = farthest = shear_of(record, setting.shear);
    turns.emplace(reversal.strain, least_strain, 0.0);
    if (cyclic) cycles.begin_stage(setting.stage, setting.shear, record);
}

void RunWriter::increment(const element::Record& now) {
    if (!started) start_from(last);
    const ShearPair shear = shear_of(now, setting.shear);
    const Turns::Move move = turns->add(shear.strain);
    if (move == Turns::Move::turned) reversal = farthest;
    if (move != Turns::Move::back) farthest = shear;
    if (cyclic) cycles.add(now);
    last = now;
}

void RunWriter::record(const element::Record& record) {
    if (record.increment == 0) start_from(record);
    else if (!started) start_from(last);
    const ShearPair shear = shear_of(record, setting.shear);
    const double gamma = shear.strain - reversal.strain;
    setting.secant =
        std::abs(gamma) > least_strain ? (shear.stress - reversal.stress) / gamma : NAN;
    Setting here = setting;
    if (result.rows == 0) here.stage = 0;
    const std::vector<double> row = columns.row(record, here);
    file.row(row);
    ++result.rows;
    for (std::size_t i = 0; i < kept.size(); ++i)
        result.table.columns[i].values.push_back(row[kept[i]]);
    result.iterations += record.iterations;
    result.evaluations += record.evaluations;
    result.halvings += record.cut_backs;
    if (output.residuals && record.increment > 0)
        say("stage {}, step {}, increment {}: residuals {:.1e}\n", here.stage, record.step,
            record.increment, fmt::join(record.residuals, " "));
}

void RunWriter::end_stage() {
    if (cyclic && started) cycles.end_stage();
}

void RunWriter::complete() {
    result.cycles = cycles.take();
    for (const std::string& exit : result.exits) file.comment("ended by " + exit);
    for (const std::string& condition : result.never) file.comment("never held: " + condition);
    if (!result.failure.empty()) file.comment("STOPPED EARLY: " + result.failure);
    file.complete();
}

}  // namespace cli
