// SPDX-License-Identifier: BSD-3-Clause
#include "support/folder.hpp"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace fs = std::filesystem;

Folder::Folder() {
    std::string pattern = (fs::temp_directory_path() / "grit_inp_XXXXXX").string();
    if (!mkdtemp(pattern.data())) throw std::runtime_error("no temporary folder");
    place = pattern;
}

Folder::~Folder() {
    std::error_code ignored;
    fs::remove_all(place, ignored);
}

void Folder::fill(const Folder& folder) {
    folder.write("parameters.inp", lausitz_parameters());
    folder.write("initialconditions.inp", isotropic(100.0, 0.7));
    folder.write("test.inp", "result.out\n*TriaxialE1\n20 10 1.0\n-0.002\n*End\n");
}

void Folder::write(const std::string& name, const std::string& text) const {
    std::ofstream(place / name, std::ios::binary) << text;
}

std::set<std::string> Folder::files() const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(place))
        names.insert(entry.path().filename().string());
    return names;
}

incremental_driver::Test parse(const std::string& steps) {
    const Folder folder;
    folder.write("test.inp", "out\n" + steps);
    std::vector<std::string> names;
    for (int i = 1; i <= 14; ++i) names.push_back("statev(" + std::to_string(i) + ")");
    return incremental_driver::read_test(folder.path("test.inp"), names);
}

element::Step parse_one(const std::string& step) { return parse(step).program.at(0); }

Table read_table(const fs::path& path, int headings) {
    std::ifstream file(path);
    Table table;
    std::string line;
    for (int i = 0; i < headings; ++i) std::getline(file, line);
    while (std::getline(file, line)) {
        std::istringstream values(line);
        table.emplace_back();
        for (double value = 0.0; values >> value;) table.back().push_back(value);
    }
    return table;
}

std::string lausitz_parameters() {
    return "Lausitz\n16 nprops\n33.0 "
           "phi_c\n0.0\n1.6e6\n0.19\n0.44\n0.85\n1.0\n0.25\n1.0\n5.0\n2.0\n"
           "1e-4\n0.5\n6.0\n0.0\n10.7\n";
}

std::string isotropic(double pressure, double void_ratio) {
    const std::string s = std::to_string(-pressure) + "\n";
    return "6\n" + s + s + s + "0\n0\n0\n14\n0\n0\n0\n0\n0\n0\n" + std::to_string(void_ratio) +
           "\n";
}
