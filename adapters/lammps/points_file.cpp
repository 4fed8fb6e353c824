// SPDX-License-Identifier: GPL-2.0-only
#include "adapters/lammps/points_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "adapters/mpm/kernel/particles.hpp"
#include "adapters/mpm/space/kernel/particles.hpp"
#include "adapters/mpm/step/text.hpp"

namespace grit::lammps {

using mpm::words::Geometry;

namespace {

constexpr char blanks[] = " \t\r\n";

std::string word_at(const std::string& text, std::size_t first) {
    return text.substr(first, text.find_first_of(blanks, first) - first);
}

}  // namespace

PointsFile::PointsFile(std::vector<std::string> given, const std::string& first_line,
                       Geometry geometry, std::vector<Otherwise> otherwise)
    : names(std::move(given)), axisymmetric(geometry == Geometry::axisymmetric),
      in_space(geometry == Geometry::space) {
    if (geometry == Geometry::space) {
        namespace c = mpm::space::column;
        sides = {c::l_x, c::l_y, c::l_z};
        diagonal = {c::F_xx, c::F_yy, c::F_zz};
        mass = c::mass;
        volume = c::V0;
    } else {
        namespace c = mpm::column;
        sides = {c::l_r, c::l_z};
        diagonal = {c::F_rr, c::F_zz, c::F_tt};
        mass = c::mass;
        volume = c::V0;
    }
    std::istringstream words(first_line.substr(0, first_line.find('#')));
    std::string word;
    if (!(words >> word) || word != "id")
        throw std::invalid_argument("the first line must name the columns, the first one id");
    std::vector<bool> seen(names.size() + 1, false);
    while (words >> word) {
        const auto found = std::find(names.begin(), names.end(), word);
        const bool density = word == "density";
        if (found == names.end() && !density)
            throw std::invalid_argument("its body has no column \"" + word + '"');
        const auto at = static_cast<std::size_t>(found - names.begin());
        if (seen[at]) throw std::invalid_argument("column \"" + word + "\" is there twice");
        seen[at] = true;
        column.push_back(density ? -1 : static_cast<int>(at));
    }
    has_mass = seen[mass];
    has_volume = seen[volume];
    for (const std::size_t side : sides)
        if (!seen[side])
            throw std::invalid_argument("column " + names[side] + ", a half side, must be there");
    if (has_mass == seen[names.size()])
        throw std::invalid_argument("column mass or column density must be there");
    const auto e = std::find(names.begin(), names.end(), "e");
    if (e != names.end() && !seen[static_cast<std::size_t>(e - names.begin())])
        throw std::invalid_argument("column e, the void ratio of a sand, must be there");
    for (Otherwise& column_left_out : otherwise) {
        const auto found = std::find(names.begin(), names.end(), column_left_out.name);
        const auto at = static_cast<std::size_t>(found - names.begin());
        if (found == names.end() || seen[at]) continue;
        left_out_columns.push_back(at);
        left_out.push_back(std::move(column_left_out));
    }
}

int PointsFile::id_of(const char* line) {
    char* end = nullptr;
    const long id = std::strtol(line, &end, 10);
    const std::string rest(line);
    const std::size_t first = rest.find_first_not_of(blanks);
    if (first == std::string::npos) return 0;
    if (id < 1 || id > std::numeric_limits<int>::max())
        throw std::invalid_argument("an id must be in [1, 2147483647], got " +
                                    word_at(rest, first));
    return static_cast<int>(id);
}

void PointsFile::read(const char* line, std::vector<double>& row) const {
    row.resize(names.size(), 0.0);
    for (const std::size_t unit : diagonal) row[unit] = 1.0;
    char* at = nullptr;
    const long id = std::strtol(line, &at, 10);
    const auto fail = [id](const std::string& why) {
        throw std::invalid_argument("point " + std::to_string(id) + ": " + why);
    };
    const auto fail_at = [&](int which, const std::string& rest) {
        const std::size_t first = rest.find_first_not_of(blanks);
        fail("column " + (which < 0 ? "density" : names[static_cast<std::size_t>(which)]) +
             (first == std::string::npos
                  ? " is missing"
                  : " must be a finite number, got \"" + word_at(rest, first) + '"'));
    };
    double density = 0.0;
    for (const int which : column) {
        const char* begin = at;
        const double value = std::strtod(begin, &at);
        if (at == begin || !std::isfinite(value)) fail_at(which, begin);
        (which < 0 ? density : row[static_cast<std::size_t>(which)]) = value;
    }
    while (*at == ' ' || *at == '\t' || *at == '\r') ++at;
    if (*at != '\0' && *at != '\n' && *at != '#') fail("more numbers than columns");
    const auto check = [&](const std::string& what, double value, const char* unit) {
        if (!(value > 0.0 && std::isfinite(value)))
            fail(what + " must be > 0 and finite, got " + mpm::text(value) + unit);
    };
    double brick = 1.0;
    for (const std::size_t side : sides) {
        check("half side " + names[side], row[side], " m");
        brick *= 2.0 * row[side];
    }
    if (!has_volume) row[volume] = axisymmetric ? brick * row[mpm::column::r] : brick;
    if (!has_mass) row[mass] = density * row[volume];
    const std::string per = in_space ? "" : axisymmetric ? "/rad" : "/m";
    check("the volume", row[volume], (" m³" + per).c_str());
    check("the mass", row[mass], (" kg" + per).c_str());
    const double stretch = in_space ? mpm::space::ParticleView{row.data(), 1}.J(0)
                                    : mpm::ParticleView{row.data(), 1}.J(0);
    if (!(stretch > 0.0)) fail("det F must be positive, got " + mpm::text(stretch));
    for (std::size_t i = 0; i < left_out.size(); ++i)
        row[left_out_columns[i]] = left_out[i].value(row);
}

}  // namespace grit::lammps
