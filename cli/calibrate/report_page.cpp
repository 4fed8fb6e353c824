// SPDX-License-Identifier: BSD-3-Clause
#include "cli/calibrate/report_page.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cli/calibrate/chart.hpp"
#include "cli/calibrate/parameter_rows.hpp"
#include "cli/plot/axis.hpp"
#include "cli/process/markup.hpp"
#include "cli/process/version.hpp"
#include "element/atomic_file.hpp"

namespace cli {
namespace {

using calibration::Experiment;

constexpr const char* style =
    "body{font-family:sans-serif;max-width:1040px;margin:24px auto;padding:0 12px;color:#222}"
    "table{border-collapse:collapse;margin:8px 0}td,th{padding:3px 10px;border-bottom:1px solid "
    "#ddd;text-align:right}td:first-child,th:first-child,td.l,th.l{text-align:left}svg{font:11px "
    "sans-serif;margin:2px}.bad{color:#b03000}p{max-width:760px;line-height:1.4}";

std::string parameter_table(const CalibrationCase& file, const CalibrationResult& result) {
    std::string out = "<table><tr><th>parameter</th><th>unit</th><th>start</th><th>best</th>"
                      "<th>2.5 %</th><th>97.5 %</th><th></th></tr>\n";
    for (const ParameterRow& row : parameter_rows(file, result)) {
        const std::string doubt =
            row.doubt.empty() ? "" : fmt::format(" <span class=\"bad\">{}</span>", row.doubt);
        out += fmt::format("<tr><td>{} ({})</td><td>{}</td><td>{}</td><td><b>{}</b></td><td>{}</td>"
                           "<td>{}</td><td class=\"l\">{}{}</td></tr>\n",
                           row.info->name, row.info->symbol, row.unit, row.start, row.best,
                           row.lowest, row.highest, escaped(row.origin), doubt);
    }
    return out + "</table>\n";
}

std::string misfit_table(const CalibrationCase& file, const CalibrationResult& result) {
    const bool beside = !file.beside.empty();
    std::string out =
        "<table><tr><th>root mean square of</th><th>quantity</th><th></th><th>tests</th><th>this "
        "sand</th>" +
        (beside ? fmt::format("<th>{}</th><th>ratio</th>", escaped(file.beside)) : std::string()) +
        "</tr>\n";
    for (std::size_t i = 0; i < result.misfits.by_kind.size(); ++i) {
        const Misfit& one = result.misfits.by_kind[i];
        const auto number = [](const Misfit& each) {
            return each.tests > 0 ? fmt::format("{:.4g}", each.root_mean_square) : "fails";
        };
        out += fmt::format(
            "<tr><td>{}</td><td class=\"l\">{}</td><td>{}</td><td>{}</td><td>{}</td>", one.kind,
            one.quantity.empty() ? "all, over their errors" : one.quantity + " [" + one.unit + "]",
            one.fitted ? "fitted" : "held out", one.tests + one.failed, number(one));
        if (beside)
            out += fmt::format("<td>{}</td><td>{:.3f}</td>", number(result.beside.by_kind[i]),
                               one.root_mean_square / result.beside.by_kind[i].root_mean_square);
        out += "</tr>\n";
    }
    return out + "</table>\n";
}

// Which tests there are, what of them was used, and how far the sand is from each.
std::string test_table(const CalibrationCase& file, const CalibrationResult& result) {
    std::string out =
        "<table><tr><th>test</th><th class=\"l\">kind</th><th></th><th class=\"l\">from</th>"
        "<th>start p [kPa]</th><th>e</th><th>errors off</th><th class=\"l\">most</th></tr>\n";
    for (std::size_t i = 0; i < file.experiments.size(); ++i) {
        const Experiment& test = file.experiments[i];
        const TestMisfit& misfit = result.misfits.by_test[i];
        const double p =
            -(test.at_rest ? test.start.stress[0] : test.start.stress.head<3>().sum() / 3.0);
        out += fmt::format(
            "<tr><td>{}</td><td class=\"l\">{}</td><td>{}</td><td class=\"l\">{}</td>"
            "<td>{:.4g}{}</td><td>{:.4g}{}</td><td>{}</td><td class=\"l\">{}</td></tr>\n",
            escaped(test.name), test.kind, test.fitted ? "fitted" : "held out",
            escaped(file.sources[i]), p, test.at_rest ? " axial" : "", test.start.void_ratio,
            test.at_zero_pressure ? " at p = 0" : "",
            std::isnan(misfit.root_mean_square) ? "fails"
                                                : fmt::format("{:.2f}", misfit.root_mean_square),
            misfit.quantity);
    }
    return out + "</table>\n";
}

// Red for together, blue for against each other.
std::string colour_of(double correlation) {
    const int fade = 255 - static_cast<int>(std::lround(160.0 * std::abs(correlation)));
    return correlation > 0.0 ? fmt::format("rgb(255,{0},{0})", fade)
                             : fmt::format("rgb({0},{0},255)", fade);
}

// Numbers above the diagonal, samples below it.
std::string correlation_picture(const CalibrationCase& file, const CalibrationResult& result) {
    const Eigen::Index count = file.space.size();
    const calibration::Matrix correlation =
        result.posterior ? result.posterior->correlation() : result.laplace.correlation;
    constexpr double cell = 64, margin = 8;
    const double size = cell * static_cast<double>(count) + 2 * margin;
    std::string out =
        fmt::format("<svg width=\"{0}\" height=\"{0}\" viewBox=\"0 0 {0} {0}\">", size);
    for (Eigen::Index i = 0; i < count; ++i)
        for (Eigen::Index k = 0; k < count; ++k) {
            const double x = margin + cell * static_cast<double>(k);
            const double y = margin + cell * static_cast<double>(i);
            const double r = correlation(i, k);
            out += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\" "
                               "stroke=\"#fff\"/>",
                               x, y, cell, cell,
                               i == k  ? "#eee"
                               : k > i ? colour_of(r)
                                       : "#fafafa");
            const std::string name =
                calibration::symbol_of(file.space.free[static_cast<std::size_t>(i)].index);
            if (k >= i)
                out += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                                   x + 0.5 * cell, y + 0.5 * cell + 4,
                                   i == k ? name : fmt::format("{:.2f}", r));
            if (k >= i || !result.posterior) continue;
            const calibration::Matrix& samples = result.posterior->samples;
            const double a_low = samples.col(k).minCoeff(), a_high = samples.col(k).maxCoeff();
            const double b_low = samples.col(i).minCoeff(), b_high = samples.col(i).maxCoeff();
            constexpr int dots = 150;
            for (int d = 0; d < dots; ++d) {
                const auto row = static_cast<Eigen::Index>((d + 0.5) / dots *
                                                           static_cast<double>(samples.rows()));
                out +=
                    fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"0.9\" fill=\"#14508c\"/>",
                                x + cell * (samples(row, k) - a_low) / (a_high - a_low),
                                y + cell * (1.0 - (samples(row, i) - b_low) / (b_high - b_low)));
            }
        }
    return out + "</svg>\n";
}

// How a quantity is drawn; stresses without an axis of their own press where they are positive.
struct Shown {
    std::string label;
    double factor = 1.0;
};

Shown shown(const std::string& name, const std::string& unit) {
    if (const Axis* axis = axis_of(name)) return {axis->label, axis->factor};
    const bool stress = unit == "kPa";
    std::string words = name;
    std::replace(words.begin(), words.end(), '_', ' ');
    return {fmt::format("{}{} [{}]", stress ? "−" : "", words, stress ? "kPa" : "%"),
            stress ? -1.0 : 100.0};
}

std::string misfit_sentence(const CalibrationCase& file, const CalibrationResult& result) {
    const calibration::Laplace& laplace = result.laplace;
    if (!laplace.overdetermined)
        return fmt::format("Misfit: {:.3g} independent readings do not tell {} parameters and "
                           "their own errors.",
                           result.independent, file.space.size());
    std::string out =
        fmt::format("Misfit: &chi;&sup2; over the degrees of freedom is {:.3g}. ", laplace.misfit);
    if (!(laplace.misfit > 1.0))
        return out + "Residuals are as large as the stated errors or smaller.";
    out += fmt::format("Residuals are {:.3g} times the stated errors: the law, or the tests, are "
                       "not as exact as stated",
                       std::sqrt(laplace.misfit));
    return out + (laplace.inflation > 1.0 ? ", and intervals are as much wider."
                                          : "; intervals are as the errors are stated.");
}

std::string chart_of(const Experiment& test, const Band& band, int channel) {
    const bool by_strain = test.driver.find("strain") != std::string::npos;
    const calibration::Channel& read = test.channels[static_cast<std::size_t>(channel)];
    const Shown x_axis = shown(test.driver, by_strain ? "-" : "kPa");
    const Shown y_axis = shown(read.name, read.unit);
    Chart chart;
    chart.title = test.name + (test.fitted ? "" : " (held out)");
    chart.x_label = x_axis.label;
    chart.y_label = y_axis.label;
    const double first = by_strain ? test.driven.front() : 0.0;
    chart.logarithmic = test.driver == "stress_11" || test.driver == "p";
    for (std::size_t i = 0; i < test.readings.size(); ++i) {
        const calibration::Reading& each = test.readings[i];
        if (each.channel != channel) continue;
        const double x = x_axis.factor * (test.driven[static_cast<std::size_t>(each.row)] - first);
        if (chart.logarithmic && !(x > 0.0)) continue;
        const double factor = y_axis.factor;
        chart.points.emplace_back(x, factor * each.value);
        if (!band.failure.empty()) continue;
        chart.line.emplace_back(x, factor * band.best[i]);
        chart.lowest.emplace_back(x, factor * band.lowest[i]);
        chart.highest.emplace_back(x, factor * band.highest[i]);
        chart.lowest_outer.emplace_back(x, factor * band.lowest_measured[i]);
        chart.highest_outer.emplace_back(x, factor * band.highest_measured[i]);
    }
    return chart.points.empty() ? "" : chart.svg();
}

std::string charts(const CalibrationCase& file, const std::vector<Band>& bands) {
    std::string out;
    for (std::size_t i = 0; i < file.experiments.size(); ++i) {
        const Experiment& test = file.experiments[i];
        if (!bands[i].failure.empty())
            out += fmt::format("<p class=\"bad\">{}: {}</p>\n", escaped(test.name),
                               escaped(bands[i].failure));
        for (int c = 0; c < static_cast<int>(test.channels.size()); ++c)
            out += chart_of(test, bands[i], c);
    }
    return out;
}

std::string next_table(const std::vector<NextTest>& next) {
    std::string out =
        "<table><tr><th>a test that nobody has made yet</th><th>information "
        "[nats]</th><th>gains most</th><th>its standard deviation now</th><th>then</th>"
        "</tr>\n";
    for (const NextTest& each : next)
        out += fmt::format("<tr><td>{}</td><td>{:.2f}</td><td>{}</td><td>{:.2g} %</td><td>{:.2g} "
                           "%</td></tr>\n",
                           escaped(each.name), each.information, each.parameter, 100 * each.before,
                           100 * each.after);
    return out + "</table>\n";
}

std::string sampling(const CalibrationResult& result) {
    if (!result.posterior)
        return "<p>Intervals are those of a normal distribution at the best fit (Laplace). "
               "<code>[posterior]</code> samples the distribution itself.</p>\n";
    const calibration::Posterior& p = *result.posterior;
    return fmt::format("<p>Intervals are quantiles of {} samples of the posterior distribution: {} "
                       "ensembles of {} walkers, acceptance {:.2f}, R-hat {:.3f} at worst, {:.0f} "
                       "independent samples of the parameter with the fewest.</p>\n",
                       p.samples.rows(), p.ensembles, p.walkers, p.acceptance, p.r_hat.maxCoeff(),
                       p.effective.minCoeff());
}

}  // namespace

void write_report_page(element::AtomicFile& page, const CalibrationCase& file,
                       const CalibrationResult& result, const std::vector<Band>& bands,
                       const std::vector<NextTest>& next) {
    page.write(
        fmt::format("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>"
                    "{0}</title><style>{1}</style></head><body><h1>{0}</h1>\n",
                    escaped(file.title), style));
    page.write(fmt::format(
        "<p>Parameters of a hypoplastic sand, found by <code>grit calibrate {}</code> (Grit "
        "{}).</p>\n",
        escaped(file.path.filename().string()), version()));
    if (!result.doubts.empty()) {
        page.write("<h2>Look at this first</h2>\n<ul>\n");
        for (const std::string& each : result.doubts)
            page.write(fmt::format("<li class=\"bad\">{}</li>\n", escaped(each)));
        page.write("</ul>\n");
    }
    page.write("<h2>Parameters</h2>\n" + parameter_table(file, result) + sampling(result));
    page.write("<p>" + misfit_sentence(file, result) + "</p>\n");
    page.write(fmt::format(
        "<p>{} of {} starts end at this best fit. The sand stands in <code>{}</code>: "
        "<code>grit element --sand FILE</code> and <code>grit mpm --sand FILE</code> "
        "compute with it, <code>grit sand show FILE</code> shows it for other programs.</p>\n",
        result.fit.agreeing, result.fit.descents.size(), escaped(file.name + "_sand.toml")));
    page.write("<h2>How far from the tests</h2>\n<p>Root mean squares of the difference.</p>\n" +
               misfit_table(file, result) + test_table(file, result));
    page.write("<h2>Which parameters go together</h2>\n<p>Correlation: red, one may be larger if "
               "the other is; blue, if the other is smaller." +
               std::string(result.posterior ? " Below the diagonal, samples." : "") + "</p>\n" +
               correlation_picture(file, result));
    page.write("<h2>What to measure next</h2>\n");
    for (const std::string& sentence : result.advice)
        page.write("<p>" + escaped(sentence) + ".</p>\n");
    if (!next.empty())
        page.write("<p>What a further test would add, most first: information in nats is the "
                   "logarithm of how "
                   "many times smaller the volume of parameters becomes that the tests allow (0.7 "
                   "halves it); "
                   "beside it the parameter that gains most, and its standard deviation.</p>\n" +
                   next_table(next));
    page.write("<h2>Measured and computed</h2>\n<p>Circles are measured, the line is computed with "
               "the best parameters; strains are logarithmic. 95 % of what the parameters may be "
               "lies in the darker band, of "
               "measurements with their errors in the lighter one.</p>\n" +
               charts(file, bands));
    page.write("</body></html>\n");
    page.flush();
}

}  // namespace cli
