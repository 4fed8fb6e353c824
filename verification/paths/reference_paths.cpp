// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

#include "paths/strain_path.hpp"
#include "support/tables/csv.hpp"

namespace paths {
namespace {

// Six components of one kind; files of principal values have no shear.
Six six(const grit::csv::Numbers& table, const std::vector<double>& row,
        const std::array<const char*, 6>& names) {
    Six r{};
    for (std::size_t c = 0; c < 6; ++c)
        if (const auto place = c < 3 ? table.at(names[c]) : table.find(names[c]))
            r[c] = row[*place];
    return r;
}
constexpr std::array strain = {"eps11", "eps22", "eps33", "gam12", "gam13", "gam23"};
constexpr std::array stress = {"s11", "s22", "s33", "s12", "s13", "s23"};
constexpr std::array memory = {"d11", "d22", "d33", "dg12", "dg13", "dg23"};

StrainPath path_of(const std::filesystem::path& file, int calls) {
    const std::string name = file.stem().string();
    StrainPath path{name, "lausitz", {}, name.find("noIGS") != std::string::npos, 0.0, {}, {}, {}};
    grit_sand_parameters p;
    grit_sand_parameters_init(&p, sizeof p);
    grit_sand_record_parameters(grit_sand_record_find("lausitz"), 1.0, &p);
    grit_sand_prepare(&p, &path.sand, nullptr);
    path.opening_pressure = opening_pressure(path.sand);
    const grit::csv::Numbers table = grit::csv::read_numbers(file);
    const auto& rows = table.rows;
    path.stress = six(table, rows[0], stress);
    const Six h = six(table, rows[0], memory);
    std::copy(h.begin(), h.end(), path.state.begin());
    path.state[GRIT_SAND_VOID_RATIO] = rows[0][table.at("e")];
    // The strain at a share i/pieces of the rows, linear between two of them.
    const std::size_t last = rows.size() - 1;
    const std::size_t pieces = calls == 0 ? last : static_cast<std::size_t>(calls);
    const auto strain_at = [&](std::size_t i) {
        const std::size_t row = i * last / pieces;
        const double share = static_cast<double>(i * last % pieces) / static_cast<double>(pieces);
        Six r = six(table, rows[row], strain);
        if (share == 0.0) return r;
        const Six next = six(table, rows[row + 1], strain);
        for (std::size_t c = 0; c < 6; ++c) r[c] += share * (next[c] - r[c]);
        return r;
    };
    Six from = strain_at(0);
    for (std::size_t i = 1; i <= pieces; ++i) {
        const Six to = strain_at(i);
        Six d = to;
        for (std::size_t c = 0; c < 6; ++c) d[c] -= from[c];
        path.increments.push_back(d);
        from = to;
    }
    return path;
}

}  // namespace

std::vector<StrainPath> reference_paths(const std::string& folder, int calls) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".csv") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<StrainPath> r;
    for (const auto& file : files) r.push_back(path_of(file, calls));
    return r;
}

}  // namespace paths
