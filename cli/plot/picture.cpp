// SPDX-License-Identifier: BSD-3-Clause
#include "cli/plot/picture.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/plot/gnuplot.hpp"
#include "cli/plot/tics.hpp"

namespace cli {
namespace {

namespace fs = std::filesystem;

// Okabe & Ito 2008: distinct for colour-blind readers and in grey.
constexpr const char* colours[] = {"#0072B2", "#D55E00", "#009E73",
                                   "#CC79A7", "#56B4E9", "#E69F00"};
constexpr const char* data_colour = "#222222";

const char* colour_of(const Series& series) {
    if (series.colour < 0) return data_colour;
    return colours[static_cast<std::size_t>(series.colour) % std::size(colours)];
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

std::string data(const Picture& picture) {
    fmt::memory_buffer out;
    const auto to = std::back_inserter(out);
    for (std::size_t p = 0; p < picture.panels.size(); ++p)
        for (std::size_t s = 0; s < picture.panels[p].series.size(); ++s) {
            const Series& series = picture.panels[p].series[s];
            fmt::format_to(to, "$d{}_{} << EOD\n", p, s);
            for (std::size_t i = 0; i < series.x.size(); ++i)
                if (drawable(series, picture.panels[p], i))
                    fmt::format_to(to, "{:.8g} {:.8g}\n", series.x[i], series.y[i]);
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
std::string style_of(const Series& series, bool one_point) {
    if (series.points || one_point)
        return fmt::format("points pt 6 ps 0.7 lw 1.2 lc rgb '{}'", colour_of(series));
    const std::string dashes = series.dashes ? fmt::format("dt {} ", series.dashes + 1) : "";
    return fmt::format("lines lw 2.2 {}lc rgb '{}'", dashes, colour_of(series));
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
            out.push_back(fmt::format("keyentry with {} title {}", style_of(series, rows == 1),
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
            "$d{}_{} using 1:2 with {} {}", number, s, style_of(series, rows == 1),
            series.label.empty() ? "notitle" : "title " + gnuplot_quoted(series.label)));
    }
    if (plots.empty()) return "set multiplot next\n";
    if (number == 0 && !panel.own_key)
        for (std::string& entry : other_labels(picture)) plots.push_back(std::move(entry));
    return fmt::format("plot {}\n", fmt::join(plots, ", \\\n     "));
}

int labels_of(const Picture& picture) {
    const Panel& panel = picture.panels.front();
    const auto own =
        std::count_if(panel.series.begin(), panel.series.end(), [&](const Series& series) {
            return !series.label.empty() && drawable_rows(series, panel) > 0;
        });
    return static_cast<int>(own) + static_cast<int>(other_labels(picture).size());
}

// Tics of the x axis: gnuplot's own, or ours where it would write too few or too many.
std::string x_tics(const Panel& panel, bool narrow) {
    const std::string linear = "unset logscale x\nset autoscale x\nset format x\n";
    if (!panel.log_x && !narrow) return linear + "set xtics autofreq\n";
    double low = INFINITY, high = -INFINITY;
    for (const Series& series : panel.series)
        for (std::size_t i = 0; i < series.x.size(); ++i)
            if (drawable(series, panel, i)) {
                low = std::min(low, series.x[i]);
                high = std::max(high, series.x[i]);
            }
    if (!(high > low)) return linear + "set xtics autofreq\n";
    std::string out;
    for (const double tic : panel.log_x ? logarithmic_tics(low, high) : even_tics(low, high))
        out += fmt::format("{}{:g}", out.empty() ? "" : ", ", tic);
    return fmt::format(
        "{}set xtics ({})\n",
        panel.log_x ? "set logscale x\nset autoscale xfix\nset format x '%g'\n" : linear, out);
}

// Panels in rows and columns, and what surrounds them [px].
struct Layout {
    explicit Layout(const Picture& picture)
        : columns(std::min(picture.columns, static_cast<int>(picture.panels.size()))),
          rows((static_cast<int>(picture.panels.size()) + columns - 1) / columns),
          top(40 + 20 * labels_of(picture)), width(columns * picture.width),
          height(rows * picture.height + top),
          keys(std::any_of(picture.panels.begin(), picture.panels.end(),
                           [](const Panel& panel) { return panel.own_key; })),
          left(keys || picture.wide_tics ? 122 : 96), gap_x(picture.labels_above        ? 62
                                                            : keys || picture.wide_tics ? 130
                                                                                        : 104),
          gap_y(picture.labels_above ? 52
                : keys               ? 132
                                     : 76) {}

    std::string margins() const {
        return fmt::format("margins {:.4f},{:.4f},{:.4f},{:.4f} spacing {:.4f},{:.4f}",
                           part(left, width), 1.0 - part(26, width), part(70, height),
                           1.0 - part(top + 24, height), part(gap_x, width), part(gap_y, height));
    }
    static double part(int pixels, int whole) { return static_cast<double>(pixels) / whole; }

    int columns, rows, top, width, height;
    bool keys;  // of panels, above them
    int left, gap_x, gap_y;
};

std::string panel_script(const Picture& picture, const Layout& layout, std::size_t number) {
    const Panel& panel = picture.panels[number];
    const bool named = !picture.labels_above;
    std::string out = label("xlabel", panel.x_label, named);
    out += label("ylabel", panel.y_label, named);
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
                   ? fmt::format("set key at screen 0.5,{:.4f} center top Left reverse samplen "
                                 "1.6 noenhanced\n",
                                 1.0 - Layout::part(30, layout.height))
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
