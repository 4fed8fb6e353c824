// SPDX-License-Identifier: BSD-3-Clause
#include "cli/report/frames.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <sstream>
#include <vector>

#include <fmt/format.h>

#include "cli/report/findings.hpp"
#include "cli/report/json_text.hpp"
#include "element/number.hpp"

namespace cli {
namespace {

namespace fs = std::filesystem;

using Values = std::vector<double>;

// attribute="..." of the tag that begins at "from".
std::string attribute(const std::string& text, std::size_t from, const std::string& name) {
    const std::size_t end = text.find('>', from), at = text.find(name + "=\"", from);
    if (at == std::string::npos || at > end) return "";
    const std::size_t begin = at + name.size() + 2;
    return text.substr(begin, text.find('"', begin) - begin);
}

// Binary values of the array NAME after a head of eight bytes.
std::optional<Values> array_of(const std::string& text, const std::string& name, int& components) {
    const std::size_t tag = text.find("<DataArray type=\"Float64\" Name=\"" + name + "\"");
    if (tag == std::string::npos) return std::nullopt;
    const std::size_t begin = text.find('>', tag) + 1, end = text.find('<', begin);
    const std::string bytes = from_base64(text.substr(begin, end - begin));
    if (end == std::string::npos || bytes.size() < 8) return std::nullopt;
    components = static_cast<int>(
        element::number_of(attribute(text, tag, "NumberOfComponents")).value_or(1.0));
    Values out((bytes.size() - 8) / sizeof(double));
    std::memcpy(out.data(), bytes.data() + 8, out.size() * sizeof(double));
    return out;
}

struct Range {
    double low = INFINITY, high = -INFINITY;
    void take(const Values& values) {
        for (const double value : values)
            if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
    }
};

// Cells as they are seen: across and up. In space they are seen along y, z is up, and they have places and sizes along y.
struct Particles {
    Values x, y, width, height;
    Values along, depth;              // of cells in space; else empty
    std::vector<std::size_t> bodies;  // where each one's cells end
    std::map<std::string, Values> variables;

    void keep_only(const std::vector<char>& wanted) {
        const auto filter = [&](Values& values) {
            if (values.empty()) return;
            std::size_t kept = 0;
            for (std::size_t i = 0; i < wanted.size(); ++i)
                if (wanted[i]) values[kept++] = values[i];
            values.resize(kept);
        };
        for (Values* each : {&x, &y, &width, &height, &along, &depth}) filter(*each);
        for (auto& [name, values] : variables) filter(values);
    }
};

double lower(const Particles& cells, std::size_t i) {
    return cells.along[i] - 0.5 * cells.depth[i];
}

// The plane across y that a page shows of bodies in space: through the middle of the one that takes the least room, which
// is what is driven or pressed, or just beside the lowest y of all, if it reaches that: there is a plane of symmetry.
double slice_of(const Particles& cells) {
    Range whole, least;
    double least_room = INFINITY;
    std::size_t from = 0;
    for (const std::size_t end : cells.bodies) {
        Range x, y, z;
        for (std::size_t i = from; i < end; ++i) {
            x.take({cells.x[i] - 0.5 * cells.width[i], cells.x[i] + 0.5 * cells.width[i]});
            y.take({lower(cells, i), lower(cells, i) + cells.depth[i]});
            z.take({cells.y[i] - 0.5 * cells.height[i], cells.y[i] + 0.5 * cells.height[i]});
        }
        from = end;
        whole.take({y.low, y.high});
        const double room = (x.high - x.low) * (y.high - y.low) * (z.high - z.low);
        if (room < least_room) least_room = room, least = y;
    }
    Values sizes = cells.depth;
    std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2),
                     sizes.end());
    const double beside = 0.25 * sizes[sizes.size() / 2];
    return least.low <= whole.low + beside ? whole.low + beside : 0.5 * (least.low + least.high);
}

void cut(Particles& cells, double slice) {
    std::vector<char> wanted(cells.x.size());
    for (std::size_t i = 0; i < wanted.size(); ++i)
        wanted[i] = lower(cells, i) <= slice && slice < lower(cells, i) + cells.depth[i];
    cells.keep_only(wanted);
}

std::vector<std::string> names_in(const std::string& text) {
    std::vector<std::string> out;
    for (std::size_t at = text.find("<CellData"); at != std::string::npos;) {
        at = text.find("<DataArray type=\"Float64\"", at + 1);
        if (at == std::string::npos) break;
        out.push_back(attribute(text, at, "Name"));
    }
    return out;
}

// Adds the cells of a file; false where it is not whole.
bool add_file(const fs::path& path, Particles& cells) {
    const std::string text = content_of(path);
    const std::size_t piece = text.find("<Piece");
    if (piece == std::string::npos || text.find("</VTKFile>") == std::string::npos) return false;
    const double points =
        element::number_of(attribute(text, piece, "NumberOfPoints")).value_or(0.0);
    const double count = element::number_of(attribute(text, piece, "NumberOfCells")).value_or(0.0);
    int components = 0;
    const std::optional<Values> corners = array_of(text, "corners", components);
    if (!corners || !(count > 0.0) || components != 3 ||
        corners->size() != static_cast<std::size_t>(3.0 * points))
        return false;
    const auto of_cell = static_cast<std::size_t>(points / count);
    const bool in_space = of_cell == 8;
    const std::size_t before = cells.x.size(), number = static_cast<std::size_t>(count);
    for (std::size_t i = 0; i < number; ++i) {
        double centre[3] = {};
        Range along[3];
        for (std::size_t k = 0; k < of_cell; ++k)
            for (std::size_t c = 0; c < 3; ++c) {
                const double place = (*corners)[3 * (i * of_cell + k) + c];
                centre[c] += place / static_cast<double>(of_cell);
                along[c].take({place});
            }
        const std::size_t up = in_space ? 2 : 1;
        cells.x.push_back(centre[0]);
        cells.y.push_back(centre[up]);
        cells.width.push_back(along[0].high - along[0].low);
        cells.height.push_back(along[up].high - along[up].low);
        if (!in_space) continue;
        cells.along.push_back(centre[1]);
        cells.depth.push_back(along[1].high - along[1].low);
    }
    cells.bodies.push_back(cells.x.size());
    for (const std::string& name : names_in(text)) {
        const std::optional<Values> values = array_of(text, name, components);
        if (!values || components != 1 || values->size() != number) continue;
        Values& all = cells.variables[name];
        all.resize(before, NAN);  // earlier files had none
        all.insert(all.end(), values->begin(), values->end());
    }
    for (auto& [name, values] : cells.variables) values.resize(cells.x.size(), NAN);
    return true;
}

constexpr double largest = 65534.0;  // 65535: no value

// Sixteen bits for each value, little-endian.
std::string packed(const Values& values, const Range& range) {
    std::string bytes;
    const double width = range.high > range.low ? range.high - range.low : 1.0;
    for (const double value : values) {
        const unsigned word =
            std::isfinite(value)
                ? static_cast<unsigned>(std::lround(largest * (value - range.low) / width))
                : 65535u;
        bytes += static_cast<char>(word & 255u);
        bytes += static_cast<char>(word >> 8 & 255u);
    }
    return '"' + base64(bytes) + '"';
}

// Files of each time, in the order of the list.
std::vector<std::pair<double, std::vector<fs::path>>> files_in(const fs::path& list) {
    std::vector<std::pair<double, std::vector<fs::path>>> out;
    const std::string text = content_of(list);
    for (std::size_t at = 0; (at = text.find("<DataSet ", at)) != std::string::npos; ++at) {
        const std::optional<double> time = element::number_of(attribute(text, at, "timestep"));
        const fs::path file = fs::path(attribute(text, at, "file")).filename();
        if (!time || file.empty()) continue;
        if (out.empty() || out.back().first != *time) out.push_back({*time, {}});
        out.back().second.push_back(list.parent_path() / file);
    }
    return out;
}

}  // namespace

Frames frames_of(const fs::path& list, const std::string& across) {
    const auto files = files_in(list);
    std::vector<Particles> frames;
    Values times;
    std::optional<double> slice;
    const std::size_t count = std::min(files.size(), most_frames);
    for (std::size_t i = 0; i < count; ++i) {
        const auto& [time, parts] = files[count > 1 ? i * (files.size() - 1) / (count - 1) : 0];
        Particles cells;
        const bool whole = std::all_of(parts.begin(), parts.end(),
                                       [&](const fs::path& part) { return add_file(part, cells); });
        if (!whole || cells.x.empty()) continue;
        if (!cells.along.empty()) {
            if (!slice) slice = slice_of(cells);
            cut(cells, *slice);
            if (cells.x.empty()) continue;
        }
        frames.push_back(std::move(cells));
        times.push_back(time);
    }
    Frames shown;
    if (frames.empty()) return shown;
    Range x, y, edge;
    std::map<std::string, Range> ranges;
    for (const Particles& cells : frames) {
        x.take(cells.x);
        y.take(cells.y);
        edge.take(cells.width);
        edge.take(cells.height);
        for (const auto& [name, values] : cells.variables) ranges[name].take(values);
    }
    std::erase_if(ranges, [](const auto& each) { return !(each.second.high >= each.second.low); });
    const auto bounds = [](const Range& range) {
        return fmt::format("[{:.8g},{:.8g}]", range.low, range.high);
    };
    std::string out = fmt::format(
        "{{\"of\":{},\"across\":{},\"slice\":{},\"times\":{},\"x\":{},\"y\":{},\"edge\":{},"
        "\"variables\":{{",
        files.size(), json_text(slice ? "x" : across),
        slice ? fmt::format("{:.4g}", *slice) : std::string("null"), json_numbers(times), bounds(x),
        bounds(y), bounds(edge));
    for (const auto& [name, range] : ranges) {
        out += fmt::format("{}{}:{}", shown.variables.empty() ? "" : ",", json_text(name),
                           bounds(range));
        shown.variables.push_back(name);
    }
    out += "},\"frames\":[";
    for (const Particles& cells : frames) {
        out +=
            fmt::format("{}{{\"x\":{},\"y\":{},\"w\":{},\"h\":{}",
                        &cells == &frames.front() ? "" : ",", packed(cells.x, x),
                        packed(cells.y, y), packed(cells.width, edge), packed(cells.height, edge));
        for (const auto& [name, values] : cells.variables)
            if (ranges.contains(name))
                out += fmt::format(",{}:{}", json_text("v " + name), packed(values, ranges[name]));
        out += "}";
    }
    shown.json = out + "]}";
    return shown;
}

}  // namespace cli
