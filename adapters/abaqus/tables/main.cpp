// SPDX-License-Identifier: BSD-3-Clause
// grit_umat_tables FILE: the file with its tables of PROPS and STATEV written anew, to stdout. A table
// stands between two lines,
//   <!-- table: PROPS classic -->  and  <!-- end of table -->   in Markdown,
//   ** table: PROPS classic        and  ** end of table         in an input deck.
#include <cstdio>
#include <fstream>
#include <iostream>
#include <string>

#include "adapters/abaqus/tables/rows.hpp"

namespace grit::abaqus {
namespace {

std::string places(const Row& row) {
    const std::string first = std::to_string(row.first);
    return row.first == row.last ? first : first + "–" + std::to_string(row.last);
}

// Input decks are plain ASCII.
std::string plain(std::string text) {
    const std::pair<const char*, const char*> spellings[] = {
        {"–", "-"},  {"−", "-"}, {"…", "to"},    {"≤", "<="},
        {"≥", ">="}, {"′", "'"}, {"‖h‖", "|h|"}, {"°", " degrees"}};
    for (const auto& [from, to] : spellings)
        for (std::size_t at; (at = text.find(from)) != std::string::npos;)
            text.replace(at, std::string(from).size(), to);
    return text;
}

void print_markdown(const std::vector<Row>& rows, bool props) {
    std::puts(props ? "| | | unit | | range |\n|---|---|---|---|---|"
                    : "| | | | in | out |\n|---|---|---|---|---|");
    for (const Row& r : rows) {
        const std::string& third = props ? r.unit : r.meaning;
        const std::string& fourth = props ? r.meaning : r.in;
        const std::string& fifth = props ? r.range : r.out;
        std::printf("| %s | %s | %s | %s | %s |\n", places(r).c_str(), r.symbol.c_str(),
                    third.c_str(), fourth.c_str(), fifth.c_str());
    }
}

void print_deck(const std::vector<Row>& rows, bool props) {
    for (const Row& r : rows) {
        const std::string place = plain(places(r)) + ".";
        const std::string details = props ? " [" + r.unit + "]: " + r.range : "";
        std::printf("** %-4s %-11s %s\n", place.c_str(), r.plain_symbol.c_str(),
                    plain(r.meaning + details).c_str());
    }
}

bool print_table(const std::string& head) {
    const bool props = head.find("PROPS") != std::string::npos;
    const bool radian = head.find("radian") != std::string::npos;
    if (props == (head.find("STATEV") != std::string::npos) ||
        radian == (head.find("classic") != std::string::npos))
        return false;
    const LayoutName layout = radian ? LayoutName::radian : LayoutName::classic;
    const std::vector<Row> rows = props ? props_rows(layout) : statev_rows(layout);
    if (head.starts_with("**")) print_deck(rows, props);
    else print_markdown(rows, props);
    return true;
}

}  // namespace
}  // namespace grit::abaqus

int main(int count, char** arguments) {
    if (count != 2) {
        std::fputs("usage: grit_umat_tables FILE\n", stderr);
        return 2;
    }
    std::ifstream file(arguments[1]);
    bool inside = false;
    int tables = 0;
    for (std::string line; std::getline(file, line);) {
        if (line.find(" end of table") != std::string::npos) inside = false;
        if (!inside) std::puts(line.c_str());
        if (line.find(" table: ") == std::string::npos) continue;
        inside = grit::abaqus::print_table(line);
        if (!inside) {
            std::fprintf(stderr, "%s: no such table: %s\n", arguments[1], line.c_str());
            return 2;
        }
        ++tables;
    }
    if (tables > 0 && !inside) return 0;
    std::fprintf(stderr, "%s: no table, or one without an end\n", arguments[1]);
    return 2;
}
