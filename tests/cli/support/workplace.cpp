// SPDX-License-Identifier: BSD-3-Clause
#include "support/workplace.hpp"

#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "support/tables/csv.hpp"

namespace fs = std::filesystem;

Workplace::Workplace() {
    std::string pattern = (fs::temp_directory_path() / "grit_cli_XXXXXX").string();
    if (!mkdtemp(pattern.data())) throw std::runtime_error("no temporary folder");
    place = pattern;
}

Workplace::~Workplace() {
    std::error_code ignored;
    fs::remove_all(place, ignored);
}

void Workplace::write(const std::string& name, const std::string& text) const {
    std::ofstream(place / name, std::ios::binary) << text;
}

void Workplace::write_case(const std::string& name, const std::string& stages) const {
    write(name + ".toml",
          "[sand]\nname = \"lausitz\"\n[start]\npressure_kPa = 100\nvoid_ratio = 0.6\n" + stages);
}

Answer Workplace::grit(const std::string& arguments) const {
    const std::string command =
        "cd " + place.string() + " && ( " GRIT_CLI " " + arguments + " ) 2>&1";
    Answer out;
    std::FILE* pipe = popen(command.c_str(), "r");
    char buffer[4096];
    while (std::fgets(buffer, sizeof buffer, pipe)) out.text += buffer;
    const int status = pclose(pipe);
    out.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return out;
}

Answer Workplace::interrupted(const std::string& arguments, const std::string& signal,
                              const std::string& file, const std::string& first) const {
    const std::string stamp = "\"$(stat -c '%i %y' " + file + " 2> /dev/null)\"";
    return grit("--version > /dev/null; " + first + "; old=" + stamp + "; " GRIT_CLI " " +
                arguments +
                " & grit=$!; now=$old; while kill -0 $grit && [ \"${now:-$old}\" = \"$old\" ]; do "
                "sleep 0.02; now=" +
                stamp + "; done; sleep 0.2; kill -" + signal + " $grit; wait $grit; exit $?");
}

Answer Workplace::run(const std::string& name, const std::string& options) const {
    return grit("element --no-plot --out out " + options + " " + name + ".toml");
}

std::map<std::string, Values> Workplace::result(const std::string& name) const {
    const grit::csv::Numbers table = grit::csv::read_numbers(place / "out" / (name + ".csv"));
    std::map<std::string, Values> out;
    for (const std::vector<double>& row : table.rows)
        for (std::size_t i = 0; i < row.size(); ++i) out[table.names[i]].push_back(row[i]);
    return out;
}

std::string Workplace::text(const std::string& name) const {
    std::ifstream file(place / name);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::set<std::string> Workplace::files(const std::string& below) const {
    std::set<std::string> out;
    if (!fs::exists(place / below)) return out;
    for (const auto& entry : fs::directory_iterator(place / below))
        out.insert(entry.path().filename().string());
    return out;
}
