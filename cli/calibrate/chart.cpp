// SPDX-License-Identifier: BSD-3-Clause
#include "cli/calibrate/chart.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cli/plot/tics.hpp"
#include "cli/process/markup.hpp"

namespace cli {
namespace {

constexpr double width = 320, height = 220, left = 52, right = 10, top = 22, bottom = 36;

struct Extent {
    double low = INFINITY, high = -INFINITY;
    void take(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    void widen(double share) {
        const double margin = high > low ? share * (high - low) : std::abs(high) * 0.05 + 1e-6;
        low -= margin;
        high += margin;
    }
};

class Frame {
  public:
    explicit Frame(const Chart& chart) : logarithmic(chart.logarithmic) {
        for (const ChartPoints* each :
             {&chart.points, &chart.line, &chart.lowest_outer, &chart.highest_outer})
            for (const auto& [a, b] : *each) {
                x.take(a);
                y.take(b);
            }
        if (!logarithmic) x.widen(0.02);
        y.widen(0.06);
    }

    double right_of(double value) const {
        const auto place = [this](double v) { return logarithmic ? std::log(v) : v; };
        const double width_of_all = place(x.high) - place(x.low);
        const double share =
            width_of_all > 0.0 ? (place(value) - place(x.low)) / width_of_all : 0.5;
        return left + share * (width - left - right);
    }
    double down_of(double value) const {
        return height - bottom - (value - y.low) / (y.high - y.low) * (height - top - bottom);
    }
    std::string path(const ChartPoints& points) const {
        std::string out;
        for (const auto& [a, b] : points)
            out += fmt::format("{:.1f},{:.1f} ", right_of(a), down_of(b));
        return out;
    }
    std::string band(const ChartPoints& low, const ChartPoints& high, const char* fill) const {
        ChartPoints around = high;
        around.insert(around.end(), low.rbegin(), low.rend());
        return fmt::format("<polygon points=\"{}\" fill=\"{}\"/>", path(around), fill);
    }
    std::string axes() const {
        std::string out = fmt::format(
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#888\"/>",
            left, top, width - left - right, height - top - bottom);
        for (const double each :
             logarithmic ? logarithmic_tics(x.low, x.high) : even_tics(x.low, x.high))
            if (each >= x.low && each <= x.high)
                out += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{:g}</text>",
                                   right_of(each), height - bottom + 13, each);
        for (const double each : even_tics(y.low, y.high))
            if (each >= y.low && each <= y.high)
                out += fmt::format("<line x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\" "
                                   "stroke=\"#eee\"/><text x=\"{3}\" y=\"{4:.1f}\" "
                                   "text-anchor=\"end\">{5:g}</text>",
                                   left, width - right, down_of(each), left - 4,
                                   down_of(each) + 3.5, each);
        return out;
    }

  private:
    bool logarithmic;
    Extent x, y;
};

// a_r and a_{11} with their subscripts set low.
std::string marked_up(const std::string& label) {
    const std::string text = escaped(label);
    std::string out;
    const char* level = "";
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t low = std::min(text.find('_', i), text.size());
        out += fmt::format("<tspan{}>{}</tspan>", level, text.substr(i, low - i));
        if (low + 1 >= text.size()) break;
        const bool braced = text[low + 1] == '{';
        const std::size_t begin = low + (braced ? 2 : 1);
        const std::size_t end = braced ? std::min(text.find('}', begin), text.size()) : begin + 1;
        out += fmt::format("<tspan dy=\"3\" font-size=\"8\">{}</tspan>",
                           text.substr(begin, end - begin));
        level = " dy=\"-3\"";
        i = end + (braced ? 1 : 0);
    }
    return out;
}

}  // namespace

std::string Chart::svg() const {
    const Frame frame(*this);
    std::string out =
        fmt::format("<svg width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">", width, height);
    out += frame.axes();
    if (!lowest_outer.empty()) out += frame.band(lowest_outer, highest_outer, "#dce9f7");
    if (!lowest.empty()) out += frame.band(lowest, highest, "#9fc3ea");
    out += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"#14508c\" "
                       "stroke-width=\"1.5\"/>",
                       frame.path(line));
    for (const auto& [a, b] : points)
        out += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2\" fill=\"none\" "
                           "stroke=\"#b03000\"/>",
                           frame.right_of(a), frame.down_of(b));
    out +=
        fmt::format("<text x=\"{}\" y=\"14\" font-weight=\"bold\">{}</text>", left, escaped(title));
    out += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                       0.5 * (left + width - right), height - 6, marked_up(x_label));
    out += fmt::format("<text x=\"12\" y=\"{0}\" text-anchor=\"middle\" transform=\"rotate(-90 12 "
                       "{0})\">{1}</text></svg>\n",
                       0.5 * (top + height - bottom), marked_up(y_label));
    return out;
}

}  // namespace cli
