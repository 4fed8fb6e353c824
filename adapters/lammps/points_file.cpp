// SPDX-License-Identifier: GPL-2.0-only
#include "adapters/lammps/points_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "adapters/mpm/kernel/particles.hpp"

namespace grit::lammps {

namespace c = mpm::column;

PointsFile::PointsFile(std::vector<std::string> given, const std::string& first_line,
                       bool is_axisymmetric, std::vector<Otherwise> otherwise)
    : names(std::move(given)), axisymmetric(is_axisymmetric) {
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
    has_mass = seen[c::mass];
    has_volume = seen[c::V0];
    if (!seen[c::l_r] || !seen[c::l_z])
        throw std::invalid_argument("columns l_r and l_z, the half sides, must be there");
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

int PointsFile::id_of(const char* line) { return static_cast<int>(std::strtol(line, nullptr, 10)); }

void PointsFile::read(const char* line, std::vector<double>& row) const {
    row.resize(names.size(), 0.0);
    row[c::F_rr] = row[c::F_zz] = row[c::F_tt] = 1.0;
    char* at = nullptr;
    const long id = std::strtol(line, &at, 10);
    const auto fail = [id](const std::string& why) {
        throw std::invalid_argument("point " + std::to_string(id) + ": " + why);
    };
    double density = 0.0;
    for (const int which : column) {
        const char* begin = at;
        const double value = std::strtod(begin, &at);
        if (at == begin || !std::isfinite(value)) fail("a number is missing or wrong");
        (which < 0 ? density : row[static_cast<std::size_t>(which)]) = value;
    }
    while (*at == ' ' || *at == '\t' || *at == '\r') ++at;
    if (*at != '\0' && *at != '\n' && *at != '#') fail("more numbers than columns");
    if (!has_volume)
        row[c::V0] = 4.0 * row[c::l_r] * row[c::l_z] * (axisymmetric ? row[c::r] : 1.0);
    if (!has_mass) row[c::mass] = density * row[c::V0];
    if (!(row[c::l_r] > 0.0 && row[c::l_z] > 0.0 && row[c::mass] > 0.0 && row[c::V0] > 0.0))
        fail("half sides, mass and volume must be positive");
    for (std::size_t i = 0; i < left_out.size(); ++i)
        row[left_out_columns[i]] = left_out[i].value(row);
}

}  // namespace grit::lammps
