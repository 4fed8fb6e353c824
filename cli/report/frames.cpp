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

struct Particles {
    Values x, y, width, height;
    std::map<std::string, Values> variables;
};

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
    const std::size_t before = cells.x.size(), number = static_cast<std::size_t>(count);
    for (std::size_t i = 0; i < number; ++i) {
        double x = 0.0, y = 0.0;
        Range along_x, along_y;
        for (std::size_t k = 0; k < of_cell; ++k) {
            const double* corner = corners->data() + 3 * (i * of_cell + k);
            x += corner[0] / static_cast<double>(of_cell);
            y += corner[1] / static_cast<double>(of_cell);
            along_x.take({corner[0]});
            along_y.take({corner[1]});
        }
        cells.x.push_back(x);
        cells.y.push_back(y);
        cells.width.push_back(along_x.high - along_x.low);
        cells.height.push_back(along_y.high - along_y.low);
    }
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

std::string frames_of(const fs::path& list) {
    const auto files = files_in(list);
    std::vector<Particles> frames;
    Values times;
    const std::size_t count = std::min(files.size(), most_frames);
    for (std::size_t i = 0; i < count; ++i) {
        const auto& [time, parts] = files[count > 1 ? i * (files.size() - 1) / (count - 1) : 0];
        Particles cells;
        const bool whole = std::all_of(parts.begin(), parts.end(),
                                       [&](const fs::path& part) { return add_file(part, cells); });
        if (!whole || cells.x.empty()) continue;
        frames.push_back(std::move(cells));
        times.push_back(time);
    }
    if (frames.empty()) return "";
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
    std::string out =
        fmt::format("{{\"of\":{},\"times\":{},\"x\":{},\"y\":{},\"edge\":{},\"variables\":{{",
                    files.size(), json_numbers(times), bounds(x), bounds(y), bounds(edge));
    bool first = true;
    for (const auto& [name, range] : ranges) {
        out += fmt::format("{}{}:{}", first ? "" : ",", json_text(name), bounds(range));
        first = false;
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
    return out + "]}";
}

}  // namespace cli
