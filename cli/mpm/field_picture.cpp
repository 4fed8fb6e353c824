// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "cli/mpm/colour_range.hpp"
#include "cli/mpm/pictures.hpp"
#include "cli/plot/gnuplot.hpp"
#include "cli/plot/viridis.hpp"

namespace cli {
namespace {

namespace fs = std::filesystem;

std::string palette() {
    std::string out;
    for (std::size_t i = 0; i < viridis.size(); ++i)
        out += fmt::format("{}{} '{}'", i == 0 ? "" : ", ", i, viridis[i]);
    return fmt::format("set palette defined ({}) maxcolors 0\n", out);
}

constexpr double infinity = std::numeric_limits<double>::infinity();

// Quadrilaterals of a body, and their values; none: the body is grey.
struct Shape {
    std::vector<double> corners, values;
};

double centre(const Shape& shape, std::size_t i, std::size_t k) {
    const double* c = &shape.corners[8 * i + k];
    return 0.25 * (c[0] + c[2] + c[4] + c[6]);
}

std::vector<double> lengths(const std::vector<double>& values, int components) {
    if (components == 1) return values;
    std::vector<double> out;
    for (std::size_t i = 0; i < values.size(); i += 2)
        out.push_back(std::hypot(values[i], values[i + 1]));
    return out;
}

std::vector<Shape> shapes_of(const MpmField& field, const MpmFields& fields) {
    std::vector<Shape> out;
    for (std::size_t b = 0; b < fields.bodies(); ++b) {
        out.push_back({fields.corners(b), {}});
        if (fields.has(b, field))
            out.back().values = lengths(fields.values(b, field), field.components);
    }
    return out;
}

Window window_of(const FieldPicture& picture, const std::vector<Shape>& shapes) {
    if (picture.window.r1 > picture.window.r0) return picture.window;
    Window w{infinity, -infinity, infinity, -infinity};
    for (const Shape& shape : shapes)
        for (std::size_t i = 0; i < shape.corners.size(); i += 2) {
            w.r0 = std::min(w.r0, shape.corners[i]);
            w.r1 = std::max(w.r1, shape.corners[i]);
            w.z0 = std::min(w.z0, shape.corners[i + 1]);
            w.z1 = std::max(w.z1, shape.corners[i + 1]);
        }
    if (picture.mirrored) w.r0 = -w.r1;
    return w;
}

bool inside(const Window& w, double r, double z) {
    return r >= w.r0 && r <= w.r1 && z >= w.z0 && z <= w.z1;
}

// Of the values in sight.
ColourRange colours_of(const FieldPicture& picture, const Window& window,
                       const std::vector<Shape>& shapes) {
    if (picture.low < picture.high) return {picture.low, picture.high};
    std::vector<double> seen;
    for (const Shape& shape : shapes)
        for (std::size_t i = 0; i < shape.values.size(); ++i) {
            const double r = centre(shape, i, 0), z = centre(shape, i, 1);
            if (inside(window, r, z) || (picture.mirrored && inside(window, -r, z)))
                seen.push_back(shape.values[i]);
        }
    return colour_range(std::move(seen));
}

// A surface of its own for every quadrilateral; grey ones as closed lines.
std::string data(const FieldPicture& picture, const Window& window,
                 const std::vector<Shape>& shapes, bool coloured) {
    fmt::memory_buffer out;
    const auto to = std::back_inserter(out);
    for (const Shape& shape : shapes) {
        if (shape.values.empty() == coloured) continue;
        for (std::size_t i = 0; i < shape.corners.size() / 8; ++i)
            for (const double side : {1.0, -1.0}) {
                if (side < 0.0 && !picture.mirrored) continue;
                if (!inside(window, side * centre(shape, i, 0), centre(shape, i, 1))) continue;
                const double* c = &shape.corners[8 * i];
                const auto point = [&](std::size_t k) {
                    fmt::format_to(to, "{:.7g} {:.7g} {:.7g}\n", side * c[2 * k], c[2 * k + 1],
                                   coloured ? shape.values[i] : 0.0);
                };
                if (coloured) {
                    point(0), point(1);
                    fmt::format_to(to, "\n");
                    point(3), point(2);
                } else {
                    for (const std::size_t k : {0u, 1u, 2u, 3u, 0u}) point(k);
                }
                fmt::format_to(to, "\n\n");
            }
    }
    return fmt::to_string(out);
}

// A plot of equal scale along both axes with its surroundings [px].
struct Frame {
    Frame(const Window& w, int largest_height) {
        const double r = w.r1 - w.r0, z = w.z1 - w.z0;
        const double scale = std::min(largest_height / z, 900.0 / r);
        plot_width = std::max(static_cast<int>(std::lround(scale * r)), 60);
        plot_height = std::max(static_cast<int>(std::lround(scale * z)), 60);
        width = std::max(left + plot_width + right, 420);
        height = top + plot_height + bottom;
    }
    std::string margins() const {
        const double x = 1.0 / width, y = 1.0 / height;
        const double end = left + plot_width;
        return fmt::format(
            "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n"
            "set bmargin at screen {:.5f}\nset tmargin at screen {:.5f}\n"
            "set colorbox user origin screen {:.5f},{:.5f} size screen {:.5f},{:.5f}\n",
            left * x, end * x, bottom * y, (bottom + plot_height) * y, (end + 18) * x, bottom * y,
            16 * x, plot_height * y);
    }
    static constexpr int left = 84, right = 150, bottom = 64, top = 56;
    int plot_width = 0, plot_height = 0, width = 0, height = 0;
};

// "p [kPa]", and from where to where values go that lie beyond the colours.
std::string label(const MpmField& field, const ColourRange& colours) {
    const std::string name =
        field.components == 2 ? fmt::format("|{}| [{}]", field.name, field.unit) : field.label();
    return colours.beyond.empty() ? name : fmt::format("{} (all: {})", name, colours.beyond);
}

std::string sheet(const FieldPicture& picture, const Window& w, const Frame& frame,
                  const ColourRange& colours, bool has_colour, bool has_grey) {
    std::string out = fmt::format(
        "reset\nset encoding utf8\nset border 15 lw 1 lc rgb '#444444'\n"
        "set tics nomirror out scale 0.6 textcolor rgb '#222222' font ',11'\n"
        "set title {} noenhanced font ',15'\nset xtics offset 0,0.5\nset xlabel '{} [m]' offset "
        "0,0.9\nset ylabel 'z [m]' offset 1.2,0\n"
        "set xrange [{:.9g}:{:.9g}]\nset yrange [{:.9g}:{:.9g}]\nset cbrange [{:.9g}:{:.9g}]\n"
        "set cblabel {} noenhanced offset 1,0\nset format cb '%.4g'\nunset key\n{}{}",
        gnuplot_quoted(picture.title), picture.across, w.r0, w.r1, w.z0, w.z1, colours.low,
        colours.high, gnuplot_quoted(label(picture.field, colours)), palette(), frame.margins());
    // Some four tics along the shorter side.
    if (frame.plot_width < 300)
        out += fmt::format("set xtics {:g} offset 0,0.5\n", [](double x) {
            const double unit = std::pow(10.0, std::floor(std::log10(x)));
            return x / unit >= 5.0 ? 5.0 * unit : x / unit >= 2.0 ? 2.0 * unit : unit;
        }((w.r1 - w.r0) * 80.0 / frame.plot_width));
    out += "set pm3d map corners2color c1\n";
    std::string plots;
    if (has_colour) plots += "$coloured using 1:2:3 with pm3d";
    if (has_grey)
        plots += fmt::format("{}$grey using 1:2:3 with lines lw 0.7 lc rgb '#8a8a8a' nocontour",
                             plots.empty() ? "" : ", ");
    return out + "splot " + plots + "\n";
}

}  // namespace

std::string draw_field(const fs::path& stem, const FieldPicture& picture, const MpmFields& fields) {
    const std::vector<Shape> shapes = shapes_of(picture.field, fields);
    const Window window = window_of(picture, shapes);
    const std::string coloured = data(picture, window, shapes, true);
    const std::string grey = data(picture, window, shapes, false);
    if (coloured.empty() && grey.empty()) return "no particle is in the window";
    const Frame frame(window, picture.height);
    return draw_with_gnuplot(
        stem, frame.width, frame.height,
        fmt::format("$coloured << EOD\n{}EOD\n$grey << EOD\n{}EOD\n", coloured, grey),
        sheet(picture, window, frame, colours_of(picture, window, shapes), !coloured.empty(),
              !grey.empty()),
        picture.files);
}

}  // namespace cli
