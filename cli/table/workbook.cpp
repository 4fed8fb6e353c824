// SPDX-License-Identifier: BSD-3-Clause
#include "cli/table/workbook.hpp"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>

#include <fmt/format.h>
#include <pugixml.hpp>
#include <zip.h>

#include "cli/process/exit_code.hpp"
#include "element/nearest.hpp"
#include "element/number.hpp"
#include "support/tables/csv.hpp"

namespace cli {
namespace {

using grit::csv::most_cells;

constexpr zip_uint64_t largest_part =
    64U << 20;  // bytes: what unpacks to more is no sheet of a laboratory
constexpr std::size_t most_letters = 256U << 20;                // of all cells
constexpr std::size_t last_column = 16384, last_row = 1048576;  // of the format

class Archive {
  public:
    explicit Archive(const std::filesystem::path& place) : path(place) {
        int code = 0;
        zip.reset(zip_open(path.c_str(), ZIP_RDONLY, &code));
        if (zip) return;
        zip_error_t error;
        zip_error_init_with_code(&error, code);
        const std::string why = zip_error_strerror(&error);
        zip_error_fini(&error);
        std::ifstream file(path, std::ios::binary);
        char begin[4] = {};
        file.read(begin, sizeof begin);
        if (std::memcmp(begin, old_workbook_begin, 4) == 0) fail(old_workbook);
        if (file && std::memcmp(begin, "PK", 2) != 0)
            fail("is no workbook: the name of a CSV ends with .csv");
        fail("cannot read this workbook: " + why);
    }

    // Nothing if there is none.
    std::unique_ptr<pugi::xml_document> part(const std::string& name) const {
        zip_stat_t about;
        if (zip_stat(zip.get(), name.c_str(), 0, &about) != 0) return nullptr;
        if (about.size > largest_part) fail(name + " is too large");
        const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(
            zip_fopen(zip.get(), name.c_str(), 0), zip_fclose);
        std::string text(about.size, '\0');
        if (!file || zip_fread(file.get(), text.data(), text.size()) !=
                         static_cast<zip_int64_t>(text.size()))
            fail("cannot unpack " + name);
        auto out = std::make_unique<pugi::xml_document>();
        const pugi::xml_parse_result parsed =
            out->load_buffer(text.data(), text.size(), pugi::parse_default | pugi::parse_ws_pcdata);
        if (!parsed) fail(fmt::format("{} is no XML: {}", name, parsed.description()));
        return out;
    }

    [[noreturn]] void fail(const std::string& why) const {
        throw BadInput(fmt::format("{}: {}", path.string(), why));
    }

  private:
    struct Discard {
        void operator()(zip_t* z) const { zip_discard(z); }
    };
    std::filesystem::path path;
    std::unique_ptr<zip_t, Discard> zip;
};

// Names with or without a prefix: "x:row" is a row.
bool is(const pugi::xml_node& node, const char* name) {
    const char* colon = std::strchr(node.name(), ':');
    return std::strcmp(colon ? colon + 1 : node.name(), name) == 0;
}

pugi::xml_node child(const pugi::xml_node& node, const char* name) {
    return node.find_child([name](const pugi::xml_node& each) { return is(each, name); });
}

// All that is written in a string, in runs of different letters too, but not how it is pronounced.
void collect_text(const pugi::xml_node& node, std::string& out) {
    for (const pugi::xml_node& each : node) {
        if (is(each, "t")) out += each.child_value();
        else if (is(each, "r")) collect_text(each, out);
    }
}

std::vector<std::string> shared_strings(const Archive& archive) {
    std::vector<std::string> out;
    const auto part = archive.part("xl/sharedStrings.xml");
    if (!part) return out;
    for (const pugi::xml_node& item : part->document_element()) {
        if (!is(item, "si")) continue;
        collect_text(item, out.emplace_back());
    }
    return out;
}

// The part of a sheet: its relation in the workbook, whose target that is.
std::string part_of_sheet(const Archive& archive, std::string& name,
                          std::vector<std::string>& known) {
    const auto book = archive.part("xl/workbook.xml");
    const auto relations = archive.part("xl/_rels/workbook.xml.rels");
    if (!book || !relations) archive.fail("is no workbook: it has no xl/workbook.xml");
    std::string id;
    for (const pugi::xml_node& sheet : child(book->document_element(), "sheets")) {
        known.emplace_back(sheet.attribute("name").value());
        if (name.empty()) name = known.back();
        if (known.back() != name) continue;
        for (const pugi::xml_attribute& each : sheet.attributes())
            if (std::string(each.name()).ends_with(":id")) id = each.value();
    }
    if (id.empty())
        archive.fail(fmt::format("has no sheet \"{}\"{}", name, element::suggestion(name, known)));
    for (const pugi::xml_node& relation : relations->document_element())
        if (id == relation.attribute("Id").value()) {
            const std::string target = relation.attribute("Target").value();
            return target.starts_with('/') ? target.substr(1) : "xl/" + target;
        }
    archive.fail(fmt::format("sheet \"{}\" has no part in this workbook", name));
}

// Column of "AB12", from 0; where a cell does not say, it follows the one before.
std::size_t column_of(const char* reference, std::size_t next) {
    std::size_t out = 0;
    for (; *reference >= 'A' && *reference <= 'Z'; ++reference)
        out = 26 * out + static_cast<std::size_t>(*reference - 'A') + 1;
    return out > 0 ? out - 1 : next;
}

// A format of numbers that has days, months, years or hours in it, outside of quotation marks and brackets.
bool shows_date(const std::string& format) {
    char until = 0;
    for (const char each : format) {
        if (until != 0) {
            if (each == until) until = 0;
        } else if (each == '"' || each == '[') {
            until = each == '"' ? '"' : ']';
        } else if (std::strchr("dmyhs", std::tolower(static_cast<unsigned char>(each)))) {
            return true;
        }
    }
    return false;
}

enum class Style { number, date, percent };

Style style_of(const std::string& format) {
    if (shows_date(format)) return Style::date;
    return format.find('%') != std::string::npos ? Style::percent : Style::number;
}

// How the styles of cells show a number.
std::vector<Style> styles_of(const Archive& archive) {
    std::vector<Style> out;
    const auto part = archive.part("xl/styles.xml");
    if (!part) return out;
    std::map<int, Style> own;
    for (const pugi::xml_node& each : child(part->document_element(), "numFmts"))
        own[each.attribute("numFmtId").as_int()] = style_of(each.attribute("formatCode").value());
    for (const pugi::xml_node& each : child(part->document_element(), "cellXfs")) {
        if (!is(each, "xf")) continue;
        const int format = each.attribute("numFmtId").as_int();
        const auto at = own.find(format);
        // Built-in ones of dates and times, and of percentages.
        const bool date = (format >= 14 && format <= 22) || (format >= 45 && format <= 47);
        const bool percent = format == 9 || format == 10;
        out.push_back(at != own.end() ? at->second
                      : date          ? Style::date
                      : percent       ? Style::percent
                                      : Style::number);
    }
    return out;
}

// Cells that are merged all have what stands in them.
void spread_merged(const pugi::xml_node& sheet, std::vector<std::vector<std::string>>& rows) {
    std::size_t budget = 100000;  // cells: what are more are no headings
    constexpr std::size_t longest_heading = 1000;
    for (const pugi::xml_node& each : child(sheet, "mergeCells")) {
        const std::string range = each.attribute("ref").value();
        const std::size_t colon = range.find(':');
        if (colon == std::string::npos) continue;
        const std::string first = range.substr(0, colon), last = range.substr(colon + 1);
        const std::size_t from = column_of(first.c_str(), 0), to = column_of(last.c_str(), 0);
        const auto row_of = [](const std::string& cell) {
            const std::size_t digits = std::min(cell.find_first_of("0123456789"), cell.size());
            return static_cast<std::size_t>(std::strtoull(cell.c_str() + digits, nullptr, 10));
        };
        const std::size_t first_row = row_of(first), end_row = std::min(row_of(last), rows.size());
        if (first_row < 1 || first_row > rows.size() || to < from || to >= last_column ||
            from >= rows[first_row - 1].size() || end_row < first_row)
            continue;
        const std::size_t cells_of_range = (end_row - first_row + 1) * (to - from + 1);
        if (cells_of_range > std::min<std::size_t>(budget, 10000)) continue;
        budget -= cells_of_range;
        const std::string text = rows[first_row - 1][from];
        if (text.size() > longest_heading) continue;
        for (std::size_t row = first_row; row <= end_row; ++row) {
            std::vector<std::string>& cells = rows[row - 1];
            if (cells.size() <= to) cells.resize(to + 1);
            for (std::size_t column = from; column <= to; ++column) cells[column] = text;
        }
    }
}

std::string value_of(const pugi::xml_node& cell, const std::vector<std::string>& strings,
                     const std::vector<Style>& styles, const Archive& archive) {
    const std::string type = cell.attribute("t").value();
    if (type == "inlineStr") {
        std::string out;
        collect_text(child(cell, "is"), out);
        return out;
    }
    const std::string value = child(cell, "v").child_value();
    if (type == "b") return value == "0" ? "FALSE" : "TRUE";
    if (value.empty() && child(cell, "f")) return "(a formula without its value)";
    const auto look = static_cast<std::size_t>(cell.attribute("s").as_uint());
    const bool is_number = (type.empty() || type == "n") && !value.empty() && look < styles.size();
    if (is_number && styles[look] == Style::date) return value + " (a date)";
    // As it is shown.
    if (const auto share = element::number_of(value);
        is_number && share && styles[look] == Style::percent)
        return fmt::format("{:.15g} %", 100.0 * *share);
    if (type != "s") return value;
    const auto number = static_cast<std::size_t>(std::strtoull(value.c_str(), nullptr, 10));
    if (number >= strings.size())
        archive.fail(
            fmt::format("cell {} names a string that is not there", cell.attribute("r").value()));
    return strings[number];
}

}  // namespace

WorkbookSheet read_workbook(const std::filesystem::path& path, const std::string& sheet) {
    const Archive archive(path);
    WorkbookSheet out;
    out.name = sheet;
    const std::string part_name = part_of_sheet(archive, out.name, out.sheets);
    const auto part = archive.part(part_name);
    if (!part) archive.fail(fmt::format("has no {}", part_name));
    const std::vector<std::string> strings = shared_strings(archive);
    const std::vector<Style> styles = styles_of(archive);
    std::size_t filled = 0, letters = 0;
    for (const pugi::xml_node& row : child(part->document_element(), "sheetData")) {
        if (!is(row, "row")) continue;
        const std::size_t number =
            row.attribute("r").as_uint(static_cast<unsigned>(out.rows.size()) + 1);
        if (number < 1 || number > last_row)
            archive.fail(fmt::format("sheet {} has a row {}", out.name, number));
        if (out.rows.size() < number) out.rows.resize(number);
        std::vector<std::string>& cells = out.rows[number - 1];
        std::size_t next = 0;
        for (const pugi::xml_node& cell : row) {
            if (!is(cell, "c")) continue;
            const std::size_t column = column_of(cell.attribute("r").value(), next);
            next = column + 1;
            if (column >= last_column)
                archive.fail(
                    fmt::format("sheet {} has a cell {}", out.name, cell.attribute("r").value()));
            std::string value = value_of(cell, strings, styles, archive);
            if (value.empty()) continue;
            if (cells.size() <= column) {
                filled += column + 1 - cells.size();
                if (filled > most_cells)
                    archive.fail(
                        fmt::format("sheet {} has more than {} cells", out.name, most_cells));
                cells.resize(column + 1);
            }
            letters += value.size();
            if (letters > most_letters)
                archive.fail(fmt::format("sheet {} has more than {} MiB of text", out.name,
                                         most_letters >> 20));
            cells[column] = std::move(value);
        }
    }
    spread_merged(part->document_element(), out.rows);
    return out;
}

}  // namespace cli
