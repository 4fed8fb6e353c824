// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/field_files.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace cli {
namespace {

// Letters, digits, - and _ stay; a name that is taken or empty gets the number of the body.
std::string file_word(const std::string& name, std::size_t body,
                      const std::vector<std::string>& taken) {
    std::string out;
    for (const char c : name) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                           (c >= '0' && c <= '9') || c == '-' || c == '_';
        out += plain ? c : '_';
    }
    const bool is_taken = std::find(taken.begin(), taken.end(), out) != taken.end();
    return out.empty() || is_taken ? fmt::format("{}body{}", out, body) : out;
}

}  // namespace

MpmFieldFiles::MpmFieldFiles(std::filesystem::path place, std::vector<MpmField> of,
                             const ShownFields& source)
    : stem(std::move(place)), variables(std::move(of)), fields(source) {
    for (std::size_t b = 0; b < fields.bodies(); ++b)
        body_names.push_back(file_word(fields.name(b), b, body_names));
}

std::string MpmFieldFiles::file_name(std::size_t frame, std::size_t body) const {
    return fmt::format("{}_{:06}_{}.vtu", stem.filename().string(), frame, body_names[body]);
}

void MpmFieldFiles::write() {
    const double now = fields.time();
    const std::filesystem::path folder = stem.parent_path();
    // No list of an older run names files of this one.
    if (!list) begin_list();
    for (std::size_t b = 0; b < fields.bodies(); ++b) {
        VtuSheet sheet{now, fields.corners(b), {}, fields.corners_each()};
        for (const MpmField& field : variables)
            if (fields.has(b, field))
                sheet.arrays.push_back({field.label(), field.components, fields.values(b, field)});
        write_vtu(folder / file_name(written.size(), b), sheet);
    }
    written.push_back(now);
    list->add(entries_of(written.size() - 1));
}

void MpmFieldFiles::begin_list() {
    std::vector<std::vector<PvdEntry>> frames;
    for (std::size_t i = 0; i < written.size(); ++i) frames.push_back(entries_of(i));
    std::filesystem::path place = stem;
    list.emplace(place += ".pvd", frames);
}

std::vector<PvdEntry> MpmFieldFiles::entries_of(std::size_t frame) const {
    std::vector<PvdEntry> out;
    for (std::size_t b = 0; b < fields.bodies(); ++b)
        out.push_back({written[frame], static_cast<int>(b), file_name(frame, b)});
    return out;
}

}  // namespace cli
