// SPDX-License-Identifier: BSD-3-Clause
#include "cli/plot/panels.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "cli/plot/axis.hpp"
#include "cli/plot/thinning.hpp"
#include "cli/process/exit_code.hpp"
#include "cli/table/foreign_columns.hpp"
#include "element/nearest.hpp"

namespace cli {
namespace {

using Axes = std::vector<std::pair<Axis, Axis>>;

const std::map<std::string, Axes>& kinds() {
    using namespace axis;
    static const std::map<std::string, Axes> all = {
        {"triaxial", {{eps_a, q}, {eps_a, eps_v}, {p, q}, {log_p, e}}},
        {"triaxial_undrained", {{eps_a, q}, {p, q}, {eps_a, pw}, {eps_a, phi}}},
        {"oedometer", {{log_sigma_a, e}, {eps_a, sigma_a}, {p, q}, {log_p, e}}},
        {"isotropic", {{log_p, e}, {eps_v, p}}},
        {"shear", {{gamma_12, tau_12}, {gamma_12, eps_v}, {sigma_n, tau_12}, {gamma_12, e}}},
        {"shear_constant_volume",
         {{gamma_12, tau_12}, {sigma_n, tau_12}, {gamma_12, p}, {gamma_12, phi}}},
        {"cyclic", {{eps_a, q}, {p, q}, {eps_a, eps_v}, {log_p, e}}},
        {"cyclic_undrained", {{eps_a, q}, {p, q}, {eps_a, pw}, {eps_a, phi}}},
        {"cycles",
         {{cycle, pore_ratio},
          {cycle, amplitude_of_cycle},
          {cycle, secant},
          {cycle, damping},
          {cycle, eps_a},
          {cycle, eps_v}}},
        {"degradation", {{amplitude, ratio}, {amplitude, damping}, {gamma, tau}, {log_p, e}}},
    };
    return all;
}

// Whether a picture takes it from the rows of the cycles.
bool of_cycles(const std::string& kind, const std::string& column) {
    return kind == "cycles" || column == "gamma_amplitude" || column == "G/G_0" ||
           column == "damping";
}

// That count from 1 in each stage, as a count of all.
std::vector<double> counted_on(const std::vector<double>& cycles) {
    std::vector<double> out;
    double before = 0.0;
    for (std::size_t i = 0; i < cycles.size(); ++i) {
        if (i > 0 && cycles[i] <= cycles[i - 1]) before = out.back();
        out.push_back(before + cycles[i]);
    }
    return out;
}

Series series_of(const Curve& curve, const std::string& kind, const Axis& x, const Axis& y) {
    Series out;
    out.label = curve.label;
    out.colour = curve.colour;
    out.points = curve.points;
    const auto column = [&](const Axis& axis) {
        return of_cycles(kind, axis.column) ? curve.cycles.find(axis.column)
                                            : curve.table.find(axis.column);
    };
    const std::vector<double>*xs = column(x), *ys = column(y);
    if (!xs || !ys) return out;
    out.x = x.column == axis::cycle.column ? counted_on(*xs) : *xs;
    out.y = *ys;
    for (double& value : out.x) value *= x.factor;
    for (double& value : out.y) value *= y.factor;
    return out.points ? spaced(out, x.log) : thinned(out, x.log);
}

}  // namespace

const std::vector<std::string>& picture_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> out;
        for (const auto& [name, axes] : kinds()) out.push_back(name);
        return out;
    }();
    return names;
}

void tell_apart(std::vector<Curve>& curves, const std::vector<std::string>& names) {
    std::map<std::string, int> count;
    for (const Curve& curve : curves) ++count[curve.label];
    for (std::size_t i = 0; i < curves.size(); ++i)
        if (count[curves[i].label] > 1) curves[i].label += " (" + names[i] + ")";
}

std::string picture_of(const std::string& test, bool cyclic) {
    if (test == "k0_consolidation") return "oedometer";
    if (test == "oedometer" || test == "isotropic") return test;
    if (test == "simple_shear_constant_stress") return "shear";
    if (test == "simple_shear_constant_volume") return "shear_constant_volume";
    const bool undrained = test.ends_with("undrained") || test.ends_with("volume");
    if (cyclic) return undrained ? "cyclic_undrained" : "cyclic";
    return undrained ? "triaxial_undrained" : "triaxial";
}

std::string picture_of_path(const Table& path) {
    const auto range = [&](const char* name) {
        const auto [low, high] = std::minmax_element(path.at(name).begin(), path.at(name).end());
        return *high - *low;
    };
    constexpr double nothing = 1e-6;
    const double axial = range("strain_11"), shear = range("gamma_12");
    const double strain = std::max(axial, shear), volume = range("volumetric_strain");
    if (shear > axial) return volume < nothing * strain ? "shear_constant_volume" : "shear";
    if (range("strain_22") + range("strain_33") < nothing * axial) return "oedometer";
    if (range("axial_deviator") < nothing * range("p")) return "isotropic";
    return volume < nothing * strain ? "triaxial_undrained" : "triaxial";
}

namespace {

std::vector<std::string> columns_of(const std::string& kind, bool cycles) {
    std::vector<std::string> out;
    for (const auto& [x, y] : kinds().at(kind))
        for (const Axis& axis : {x, y})
            if (of_cycles(kind, axis.column) == cycles) out.emplace_back(axis.column);
    return out;
}

}  // namespace

std::vector<std::string> columns_of_picture(const std::string& kind) {
    return columns_of(kind, false);
}

std::vector<std::string> columns_of_cycles(const std::string& kind) {
    return columns_of(kind, true);
}

std::vector<std::string> columns_of_pictures() {
    std::vector<std::string> out;
    for (const std::string& kind : picture_names())
        for (const auto& [x, y] : kinds().at(kind))
            for (const std::string name : {x.column, y.column})
                if (std::find(out.begin(), out.end(), name) == out.end()) out.push_back(name);
    return out;
}

std::string picture_of_columns_named(const std::vector<std::string>& columns) {
    const auto there = [&](const Axis& axis) {
        return std::find(columns.begin(), columns.end(), axis.column) != columns.end();
    };
    std::string out;
    std::ptrdiff_t most = 0;
    for (const char* kind : {"triaxial", "triaxial_undrained", "oedometer", "isotropic", "shear",
                             "shear_constant_volume"}) {
        const Axes& panels = kinds().at(kind);
        const auto drawn = std::count_if(panels.begin(), panels.end(), [&](const auto& panel) {
            return there(panel.first) && there(panel.second);
        });
        if (drawn <= most) continue;
        most = drawn;
        out = kind;
    }
    return out;
}

bool may_be_together(const std::string& a, const std::string& b) {
    const auto same = [](const Axis& one, const Axis& other) {
        return one.column == other.column && one.log == other.log;
    };
    const auto of_a = kinds().find(a), of_b = kinds().find(b);
    if (of_a == kinds().end() || of_b == kinds().end()) return a == b;
    const auto &first = of_a->second.front(), &other = of_b->second.front();
    return same(first.first, other.first) && same(first.second, other.second);
}

bool shows_cycles(const std::string& kind) { return kind == "cycles" || kind == "degradation"; }

std::size_t panels_of(const std::string& kind) { return kinds().at(kind).size(); }

Panel panel_of_curves(const std::string& kind, std::size_t number,
                      const std::vector<Curve>& curves) {
    const auto& [x, y] = kinds().at(kind).at(number);
    Panel out;
    out.x_label = x.label;
    out.y_label = y.label;
    out.log_x = x.log;
    out.y_from_zero = y.from_zero;
    for (const Curve& curve : curves) out.series.push_back(series_of(curve, kind, x, y));
    return out;
}

namespace {

// As it is drawn in pictures of tests, or as it is called.
Axis axis_of_column(const Column& column, std::string& label) {
    if (const Axis* known = axis_of(column.name)) {
        label = known->label;
        return *known;
    }
    label = column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit);
    for (std::size_t at = 0; (at = label.find('_', at)) != std::string::npos; at += 2)
        label.insert(at, "\\");
    return {column.name.c_str(), 1.0, label.c_str()};
}

const Column& column_called(const Curve& curve, const std::string& name) {
    std::vector<std::string> known;
    const std::string ours = standard_column_name(name);
    for (const Column& each : curve.table.columns) {
        if ((each.name == name || each.name == ours) && each.problem.empty()) return each;
        known.push_back(each.name);
    }
    throw BadInput(fmt::format("{} has no column \"{}\"{}", curve.label, name,
                               element::suggestion(name, known)));
}

void check_alike(const Curve& curve, const std::string& beside, const std::string& label) {
    if (!beside.empty() && label != beside)
        throw BadInput(
            fmt::format("{} has {}, and what is drawn beside it {}", curve.label, label, beside));
}

}  // namespace

Picture picture_of_columns(const std::string& x, const std::vector<std::string>& ys,
                           const std::string& title, const std::vector<Curve>& curves) {
    Picture out;
    out.title = title;
    for (const std::string& y : ys) {
        Panel panel;
        for (const Curve& curve : curves) {
            const std::string beside_x = panel.x_label, beside_y = panel.y_label;
            const Axis across = axis_of_column(column_called(curve, x), panel.x_label);
            const Axis up = axis_of_column(column_called(curve, y), panel.y_label);
            check_alike(curve, beside_x, panel.x_label);
            check_alike(curve, beside_y, panel.y_label);
            panel.series.push_back(series_of(curve, "", across, up));
        }
        out.panels.push_back(std::move(panel));
    }
    return out;
}

Picture picture_of_curves(const std::string& kind, const std::string& title,
                          const std::vector<Curve>& curves) {
    Picture out;
    out.title = title;
    for (std::size_t i = 0; i < panels_of(kind); ++i)
        out.panels.push_back(panel_of_curves(kind, i, curves));
    if (std::any_of(out.panels.begin(), out.panels.end(), says_anything))
        std::erase_if(out.panels, [](const Panel& panel) { return !says_anything(panel); });
    return out;
}

}  // namespace cli
