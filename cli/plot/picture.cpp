// SPDX-License-Identifier: BSD-3-Clause
#include "cli/plot/picture.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/plot/gnuplot.hpp"
#include "cli/plot/tics.hpp"
#include "cli/plot/viridis.hpp"

namespace cli {
namespace {

namespace fs = std::filesystem;

// Okabe & Ito 2008: distinct for colour-blind readers and in grey.
constexpr const char* colours[] = {"#0072B2", "#D55E00", "#009E73",
                                   "#CC79A7", "#56B4E9", "#E69F00"};
constexpr const char* data_colour = "#222222";

// Of so many; where these are more than the palette has, in their order.
std::string colour_of(const Series& series, int of) {
    if (series.colour < 0) return data_colour;
    if (of > static_cast<int>(std::size(colours)))
        return viridis_at(0.95 * series.colour / (of - 1));
    return colours[static_cast<std::size_t>(series.colour) % std::size(colours)];
}

// Colours of a panel: its own, or those of all panels without a key of their own.
int colours_of(const Picture& picture, const Panel& panel) {
    int last = 0;
    for (const Panel& each : picture.panels)
        if (panel.own_key ? &each == &panel : !each.own_key)
            for (const Series& series : each.series) last = std::max(last, series.colour);
    return last + 1;
}

bool drawable(const Series& series, const Panel& panel, std::size_t i) {
    return std::isfinite(series.x[i]) && std::isfinite(series.y[i]) &&
           (!panel.log_x || series.x[i] > 0.0);
}

std::size_t drawable_rows(const Series& series, const Panel& panel) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < series.x.size(); ++i) count += drawable(series, panel, i);
    return count;
}

struct Extent {
    double low = INFINITY, high = -INFINITY;
    double largest() const { return std::max(std::abs(low), std::abs(high)); }
};

Extent extent_of(const Panel& panel, std::vector<double> Series::*values) {
    Extent out;
    for (const Series& series : panel.series)
        for (std::size_t i = 0; i < series.x.size(); ++i)
            if (drawable(series, panel, i)) {
                out.low = std::min(out.low, (series.*values)[i]);
                out.high = std::max(out.high, (series.*values)[i]);
            }
    return out;
}

// The power of ten that stands in the unit of y, and not in all its numbers.
int power_of(const Picture& picture, const Panel& panel) {
    constexpr double small = 0.01, large = 1e5, nothing = 1e-300;
    const double largest = extent_of(panel, &Series::y).largest();
    const bool plain = !(largest > nothing) || (largest >= small && largest < large);
    if (picture.labels_above || plain || !std::isfinite(largest)) return 0;
    return 3 * static_cast<int>(std::floor(std::log10(largest) / 3.0));
}

// "depth [m]": "depth [10^{-3} m]".
std::string with_power(const std::string& label, int power) {
    if (power == 0) return label;
    const std::string factor = fmt::format("10^{{{}}}", power);
    const std::size_t bracket = label.rfind('[');
    if (bracket == std::string::npos || !label.ends_with(']'))
        return fmt::format("{} [{}]", label, factor);
    const std::string unit = label.substr(bracket + 1, label.size() - bracket - 2);
    const bool none = unit == "-" || unit == "–";
    return fmt::format("{}[{}{}{}]", label.substr(0, bracket), factor, none ? "" : " ",
                       none ? "" : unit);
}

std::string data(const Picture& picture) {
    fmt::memory_buffer out;
    const auto to = std::back_inserter(out);
    for (std::size_t p = 0; p < picture.panels.size(); ++p)
        for (std::size_t s = 0; s < picture.panels[p].series.size(); ++s) {
            const Series& series = picture.panels[p].series[s];
            const double factor = std::pow(10.0, -power_of(picture, picture.panels[p]));
            fmt::format_to(to, "$d{}_{} << EOD\n", p, s);
            for (std::size_t i = 0; i < series.x.size(); ++i)
                if (drawable(series, picture.panels[p], i))
                    fmt::format_to(to, "{:.8g} {:.8g}\n", series.x[i], factor * series.y[i]);
                else fmt::format_to(to, "\n");  // breaks the line
            fmt::format_to(to, "EOD\n");
        }
    return fmt::to_string(out);
}

std::string label(const char* axis, const std::string& text, bool shown) {
    return shown ? fmt::format("set {} {}\n", axis, gnuplot_quoted(text))
                 : fmt::format("unset {}\n", axis);
}

// A line of one point is not to be seen.
std::string style_of(const Series& series, bool one_point, int colours_in_all) {
    if (series.points || one_point)
        return fmt::format("points pt 6 ps 0.7 lw 1.2 lc rgb '{}'",
                           colour_of(series, colours_in_all));
    const std::string dashes = series.dashes ? fmt::format("dt {} ", series.dashes + 1) : "";
    return fmt::format("lines lw 2.2 {}lc rgb '{}'", dashes, colour_of(series, colours_in_all));
}

// Entries of the key for what later panels draw and this one, the first, has not.
std::vector<std::string> other_labels(const Picture& picture) {
    const auto drawn_in = [](const Panel& panel, const std::string& name) {
        return std::any_of(panel.series.begin(), panel.series.end(), [&](const Series& series) {
            return series.label == name && drawable_rows(series, panel) > 0;
        });
    };
    std::vector<std::string> names, out;
    for (const Panel& panel : picture.panels)
        for (const Series& series : panel.series) {
            const std::size_t rows = drawable_rows(series, panel);
            if (panel.own_key || series.label.empty() || rows == 0 ||
                drawn_in(picture.panels.front(), series.label) ||
                std::find(names.begin(), names.end(), series.label) != names.end())
                continue;
            names.push_back(series.label);
            out.push_back(fmt::format("keyentry with {} title {}",
                                      style_of(series, rows == 1, colours_of(picture, panel)),
                                      gnuplot_quoted(series.label)));
        }
    return out;
}

std::string plots_of(const Picture& picture, std::size_t number) {
    const Panel& panel = picture.panels[number];
    std::vector<std::string> plots;
    for (std::size_t s = 0; s < panel.series.size(); ++s) {
        const Series& series = panel.series[s];
        const std::size_t rows = drawable_rows(series, panel);
        if (rows == 0) continue;
        plots.push_back(fmt::format(
            "$d{}_{} using 1:2 with {} {}", number, s,
            style_of(series, rows == 1, colours_of(picture, panel)),
            series.label.empty() ? "notitle" : "title " + gnuplot_quoted(series.label)));
    }
    if (plots.empty()) return "set multiplot next\n";
    if (number == 0 && !panel.own_key)
        for (std::string& entry : other_labels(picture)) plots.push_back(std::move(entry));
    return fmt::format("plot {}\n", fmt::join(plots, ", \\\n     "));
}

// Rows of the key above all panels: one column, or as many as there is room for.
int key_rows(const Picture& picture, int width) {
    constexpr int alone = 4, sample = 60, character = 10;  // entries of one column; [px]
    int entries = static_cast<int>(other_labels(picture).size());
    std::size_t longest = 1;
    for (const Panel& panel : picture.panels)
        for (const Series& series : panel.series) {
            if (panel.own_key || series.label.empty() || drawable_rows(series, panel) == 0)
                continue;
            longest = std::max(longest, series.label.size());
            entries += &panel == &picture.panels.front();
        }
    const int columns = std::max(1, width / (sample + character * static_cast<int>(longest)));
    return entries <= alone ? entries : (entries + columns - 1) / columns;
}

// Tics of the x axis: gnuplot's own, or ours where it would write too few or too many.
std::string x_tics(const Panel& panel, bool narrow) {
    std::string linear = "unset logscale x\nset autoscale x\nset format x\n";
    if (!std::isnan(panel.x_from)) linear += fmt::format("set xrange [{:.8g}:*]\n", panel.x_from);
    if (!panel.log_x && !narrow) return linear + "set xtics autofreq\n";
    const auto [low, high] = extent_of(panel, &Series::x);
    if (!has_length(low, high)) return linear + "set xtics autofreq\n";
    const double room = panel.log_x ? std::pow(high / low, 0.02) : 1.0;  // for numbers at the ends
    std::string out;
    for (const double tic :
         panel.log_x ? logarithmic_tics(low / room, high * room) : even_tics(low, high))
        out += fmt::format("{}{:g}", out.empty() ? "" : ", ", tic);
    out = fmt::format("set xtics ({})\n", out);
    if (!panel.log_x) return linear + out;
    return fmt::format("set logscale x\nset xrange [{:.8g}:{:.8g}]\nset format x '%g'\n{}",
                       low / room, high * room, out);
}

// Room for the numbers and the label of y; gnuplot puts the label of a .png beside what it thinks is the longest number [px].
int left_of(const Picture& picture) {
    constexpr int least = 96, label_room = 55;
    int longest = 0;
    for (const Panel& panel : picture.panels) {
        const auto [low, high] = extent_of(panel, &Series::y);
        const double factor = std::pow(10.0, -power_of(picture, panel));
        if (high >= low)
            longest = std::max(
                longest, longest_number(panel.y_from_zero ? 0.0 : factor * low, factor * high));
    }
    return picture.labels_above ? least : std::max(least, label_room + longest * 21 / 2);
}

// Panels in rows and columns, and what surrounds them [px].
struct Layout {
    explicit Layout(const Picture& picture)
        : columns(std::min(picture.columns, static_cast<int>(picture.panels.size()))),
          rows((static_cast<int>(picture.panels.size()) + columns - 1) / columns),
          width(columns * picture.width), entries(key_rows(picture, width)), top(40 + 20 * entries),
          height(rows * picture.height + top),
          keys(std::any_of(picture.panels.begin(), picture.panels.end(),
                           [](const Panel& panel) { return panel.own_key; })),
          left(left_of(picture)), gap_x(picture.labels_above ? 62 : left + 8),
          gap_y(picture.labels_above ? 52
                : keys               ? 132
                                     : 76) {}

    std::string margins() const {
        return fmt::format("margins {:.4f},{:.4f},{:.4f},{:.4f} spacing {:.4f},{:.4f}",
                           part(left, width), 1.0 - part(26, width), part(70, height),
                           1.0 - part(top + 24, height), part(gap_x, width), part(gap_y, height));
    }
    static double part(int pixels, int whole) { return static_cast<double>(pixels) / whole; }

    int columns, rows, width, entries, top, height;
    bool keys;  // of panels, above them
    int left, gap_x, gap_y;
};

std::string panel_script(const Picture& picture, const Layout& layout, std::size_t number) {
    const Panel& panel = picture.panels[number];
    const bool named = !picture.labels_above;
    std::string out = label("xlabel", panel.x_label, named);
    out += label("ylabel", with_power(panel.y_label, power_of(picture, panel)), named);
    out += panel.title.empty() ? "unset title\n"
                               : fmt::format("set title {} noenhanced font ',11' offset 0,-0.8\n",
                                             gnuplot_quoted(panel.title));
    out += x_tics(panel, picture.labels_above);
    out += panel.y_from_zero ? "set yrange [0:*]\n" : "set yrange [*:*]\n";
    if (panel.own_key)
        out += "set key at graph 0.5,1.02 center bottom horizontal maxcols 3 Left reverse "
               "samplen 1.2 noenhanced font ',10'\n";
    else
        out += number == 0
                   ? fmt::format("set key at screen 0.5,{:.4f} center top vertical maxrows {} Left "
                                 "reverse samplen 1.6 noenhanced\n",
                                 1.0 - Layout::part(30, layout.height), std::max(1, layout.entries))
                   : "unset key\n";
    return out + plots_of(picture, number);
}

std::string sheet(const Picture& picture, const Layout& layout) {
    std::string out =
        fmt::format("reset\nset encoding utf8\n"
                    "set border 3 lw 1 lc rgb '#444444'\n"
                    "set tics nomirror out scale 0.6 textcolor rgb '#222222' font ',11'\n"
                    "set grid lt 1 lw 0.6 lc rgb '#e4e4e4'\n"
                    "set multiplot layout {},{} title {} {} font ',15' {}\n",
                    layout.rows, layout.columns, gnuplot_quoted(picture.title),
                    picture.title_in_markup ? "enhanced" : "noenhanced", layout.margins());
    for (std::size_t i = 0; i < picture.panels.size(); ++i) out += panel_script(picture, layout, i);
    return out + "unset multiplot\n";
}

}  // namespace

bool says_anything(const Panel& panel) {
    constexpr double least_shown = 1e-8, noise_of_largest = 1e-9;
    double low = INFINITY, high = -INFINITY, widest = 0.0;
    std::size_t points = 0;
    for (const Series& series : panel.series)
        for (std::size_t i = 0; i < series.x.size(); ++i)
            if (drawable(series, panel, i)) {
                low = std::min(low, series.y[i]);
                high = std::max(high, series.y[i]);
                widest = std::max(widest, std::abs(series.x[i]));
                ++points;
            }
    const double largest = std::max(std::abs(low), std::abs(high));
    if (points < 2) return points == 1 && widest > least_shown && largest > least_shown;
    if (!(widest > least_shown) || !(largest > least_shown)) return false;
    return panel.y_from_zero || high - low > noise_of_largest * largest;
}

std::string draw(const fs::path& stem, const Picture& picture) {
    const Layout layout(picture);
    return draw_with_gnuplot(stem, layout.width, layout.height, data(picture),
                             sheet(picture, layout),
                             {.svg = true, .png = true, .pdf = picture.pdf});
}

}  // namespace cli
