// SPDX-License-Identifier: BSD-3-Clause
#include "cli/element/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "cli/element/curve_difference.hpp"
#include "cli/element/stage_rows.hpp"

namespace cli {
namespace {

double value_of(const ReferenceValue& wanted, const Table& table) {
    const auto [first, last] = rows_of_stage(table, wanted.stage);
    const std::vector<double>& values = table.at(wanted.quantity);
    if (!wanted.over.empty()) {
        const std::vector<double>& over = table.at(wanted.over);
        return (values[last] - values[first]) / (over[last] - over[first]);
    }
    if (wanted.at == At::end) return values[last];
    const double sign = wanted.at == At::largest ? 1.0 : -1.0;
    double best = NAN;  // values that are unknown do not count
    for (std::size_t i = first; i <= last; ++i)
        if (!(sign * values[i] <= sign * best) && !std::isnan(values[i])) best = values[i];
    return best;
}

std::string label_of(const ReferenceValue& value, const Table& table) {
    std::string unit;
    for (const Column& column : table.columns)
        if (column.name == value.quantity) unit = column.unit;
    std::string out = value.at == At::largest    ? "largest "
                      : value.at == At::smallest ? "smallest "
                                                 : "";
    out += value.quantity;
    if (!value.over.empty()) out += "/" + value.over;
    if (value.stage > 0) out += fmt::format(" (stage {})", value.stage);
    return unit.empty() || unit == "-" ? out : out + " " + unit;
}

// Cells of the table.
struct Line {
    std::string name, what;
    std::string computed = "-", reference = "-", ratio = "-", difference = "-", limit = "-";
    const char* remark = "";

    std::vector<std::string> cells(const std::string& verdict) const {
        std::vector<std::string> out = {name,  what,       computed, reference,
                                        ratio, difference, limit,    verdict};
        for (std::string& cell : out)
            std::replace(cell.begin(), cell.end(), ',', ';');  // a file has them between commas
        return out;
    }
    std::string text() const {
        return fmt::format("{:<42} {:<36} {:>10} {:>10} {:>7} {:>10} {:>7}{}\n", name, what,
                           computed, reference, ratio, difference, limit, remark);
    }
};

void add(Line line, bool within, Comparison& table) {
    if (!within) line.remark = "  EXCEEDED";
    table.within = table.within && within;
    table.text += line.text();
    table.rows.push_back(line.cells(!within ? "EXCEEDED" : line.limit == "-" ? "told" : "within"));
}

std::string limit_text(const std::optional<double>& tolerance) {
    return tolerance ? fmt::format("{:g}", *tolerance) : "-";
}

void compare_value(const CaseFile& file, const ReferenceValue& wanted, const Table& result,
                   Comparison& table) {
    Line line{file.name, label_of(wanted, result)};
    const double computed = value_of(wanted, result);
    const double difference = (computed - wanted.value) / std::abs(wanted.value);
    line.computed = fmt::format("{:.6g}", computed);
    line.reference = fmt::format("{:.6g}", wanted.value);
    line.ratio = fmt::format("{:.4f}", computed / wanted.value);
    line.difference = fmt::format("{:+.1e}", difference);
    line.limit = limit_text(wanted.tolerance);
    add(line, std::abs(difference) <= wanted.tolerance.value_or(INFINITY), table);
}

void compare_curve(const CaseFile& file, const CaseResult& result, Comparison& table) {
    const Reference& reference = file.reference;
    if (!reference.curve_tolerance) return;
    const CurveDifference d = difference(result.table, reference.curve);
    if (!d.problem.empty()) return add({file.name, "curve: " + d.problem}, false, table);
    const double tolerance = *reference.curve_tolerance;
    Line line{file.name, "whole curve, stress and void ratio"};
    line.difference = fmt::format("{:.1e}", std::max(d.stress, d.void_ratio));
    line.limit = limit_text(tolerance);
    add(line, d.stress <= tolerance && d.void_ratio <= tolerance, table);
}

void compare_limits(const CaseFile& file, const CaseResult& result, Comparison& table) {
    if (const std::optional<int> most = file.limits.increments) {
        Line line{file.name, "increments", std::to_string(result.increments)};
        line.limit = std::to_string(*most);
        add(line, result.increments <= *most, table);
    }
    if (const std::optional<double> most = file.limits.milliseconds) {
        Line line{file.name, "milliseconds of processor time",
                  fmt::format("{:.1f}", result.milliseconds)};
        line.limit = limit_text(most);
        add(line, result.milliseconds <= *most, table);
    }
}

struct Ratios {
    double sum = 0.0;
    int count = 0;
    const Reference* reference = nullptr;
};

}  // namespace

Comparison compare(const std::vector<CaseFile>& cases, const std::vector<CaseResult>& results) {
    Comparison out;
    std::map<std::string, Ratios> means;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const CaseFile& file = cases[i];
        const Table& table = results[i].table;
        if (!results[i].failure.empty()) continue;  // the end was not reached
        for (const ReferenceValue& wanted : file.reference.values)
            compare_value(file, wanted, table, out);
        compare_curve(file, results[i], out);
        compare_limits(file, results[i], out);
        if (file.reference.mean_ratio) {
            const ReferenceValue& first = file.reference.values.front();
            Ratios& mean = means[file.path.stem().string()];
            mean.sum += value_of(first, table) / first.value;
            ++mean.count;
            mean.reference = &file.reference;
        }
    }
    for (const auto& [name, mean] : means) {
        const double ratio = mean.sum / mean.count, wanted = *mean.reference->mean_ratio;
        const double tolerance = mean.reference->mean_ratio_tolerance;
        Line line{name, fmt::format("mean ratio of {}", mean.count)};
        line.reference = fmt::format("{:g}", wanted);
        line.ratio = fmt::format("{:.4f}", ratio);
        line.difference = fmt::format("{:+.4f}", ratio - wanted);
        line.limit = fmt::format("{:g}", tolerance);
        add(line, std::abs(ratio - wanted) <= tolerance, out);
    }
    if (out.text.empty()) return out;
    const Line header{"case", "what", "computed", "reference", "ratio", "difference", "limit"};
    out.text = header.text() + out.text;
    out.rows.insert(out.rows.begin(), header.cells("verdict"));
    return out;
}

}  // namespace cli
