// SPDX-License-Identifier: BSD-3-Clause
#include "support/both_hosts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include <adapters/mpm/run/history.hpp>
#include <cli/mpm/case_file.hpp>
#include <cli/mpm/to_lammps.hpp>

namespace {

// Lines of numbers, all of them, that begin with an integer.
std::vector<std::vector<double>> numbers_in(const std::string& text, std::size_t count) {
    std::vector<std::vector<double>> out;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::vector<double> row;
        const char* at = line.c_str();
        for (char* end = nullptr;; at = end) {
            const double x = std::strtod(at, &end);
            if (end == at) break;
            row.push_back(x);
        }
        if (row.size() == count && at[std::strspn(at, " ")] == '\0') out.push_back(row);
    }
    return out;
}

bool same_bits(const std::vector<double>& one, const std::vector<double>& other) {
    if (one.size() != other.size()) return false;
    for (std::size_t i = 0; i < one.size(); ++i)
        if (std::memcmp(&one[i], &other[i], sizeof(double)) != 0 &&
            !(one[i] != one[i] && other[i] != other[i]))
            return false;
    return true;
}

std::string shown(const std::vector<double>& one, const std::vector<double>& other) {
    std::ostringstream out;
    out.precision(17);
    for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i)
        if (!same_bits({one[i]}, {other[i]}))
            out << " column " << i + 1 << ": " << one[i] << " and " << other[i] << ';';
    return out.str();
}

// Columns of all particles, by the numbers that they have as atoms.
template <class Simulated> void add_points(const Simulated& simulation, Told& out) {
    int first = 1;
    for (std::size_t b = 0; b < simulation.bodies(); ++b) {
        const grit::mpm::ParticleColumns& q = simulation.body(b).particles;
        for (std::ptrdiff_t p = 0; p < q.size(); ++p) {
            std::vector<double>& row = out.points[first + q.ids()[p]];
            for (int c = 0; c < q.column_count(); ++c) row.push_back(q(c, p));
        }
        first += static_cast<int>(q.size());
    }
}

// ... and the pore_fields behind them, where any body has water.
template <class Simulated> void add_all(Simulated& simulation, int first_stress, Told& out) {
    add_points(simulation, out);
    std::size_t longest = 0;
    bool has_water = false;
    for (std::size_t b = 0; b < simulation.bodies(); ++b) {
        const auto& body = simulation.body(b);
        longest = std::max(longest, static_cast<std::size_t>(body.particles.column_count()));
        has_water = has_water || body.water;
    }
    int first = 1;
    for (std::size_t b = 0; has_water && b < simulation.bodies(); ++b) {
        auto& body = simulation.body(b);
        const auto q = body.particles.view();
        for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) {
            std::vector<double>& row = out.points[first + body.particles.ids()[p]];
            row.resize(longest, 0.0);
            const double p_w = body.water ? body.water->pressure(q, p) : 0.0;
            row.push_back(p_w);
            for (int k = 0; k < 3; ++k) row.push_back(q[first_stress + k][p] - p_w);
        }
        first += static_cast<int>(body.particles.size());
    }
}

}  // namespace

BothHosts::BothHosts(const std::string& toml, const std::map<std::string, std::string>& beside)
    : name("both"), toml_name("both.toml") {
    for (const auto& [file, text] : beside) folder.write(file, text);
    folder.write(toml_name, toml);
    const grit::mpm::Case plan = cli::read_mpm_case(folder.path() / toml_name).plan;
    in_space = plan.space.has_value();
    cli::write_lammps_files(plan, folder.path());
}

Told BothHosts::in_driver(long steps) const {
    using namespace grit::mpm;
    Runner runner(cli::read_mpm_case(folder.path() / toml_name).plan);
    Told out;
    const auto tell = [&] {
        const HistoryRow row = runner.row();
        std::vector<double>& values = out.rows.emplace_back();
        for (const HistoryColumn& column : history_columns(in_space))
            values.push_back(column.value(row));
    };
    tell();
    for (; steps > 0 && !runner.finished(); --steps) {
        runner.step();
        tell();
    }
    if (runner.space()) add_all(*runner.space(), space::column::S_xx, out);
    else add_all(runner.simulation(), column::S_rr, out);
    return out;
}

// As root, as in containers, OpenMPI wants to be told.
std::string BothHosts::start(int processes, const std::string& program) {
    if (processes == 1) return "timeout 250 " + program;
    return "timeout 250 env OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 " MPIEXEC
           " --oversubscribe --mca mpi_yield_when_idle 1 -np " +
           std::to_string(processes) + ' ' + program;
}

Answer BothHosts::lammps(int processes, const std::string& script) const {
    folder.write("script.in", script);
    Answer answer = folder.run(start(processes, GRIT_LMP " -in script.in -log said.log"));
    // The first rank that ends with an error may end the others before they have written what they said;
    // LAMMPS closes its log before that.
    if (answer.status != 0) answer.text += folder.read("said.log");
    return answer;
}

Told BothHosts::in_lammps(const std::array<int, 3>& processors,
                          const std::string& script_given) const {
    const std::string wanted = script_given.empty() ? script() : script_given;
    std::string bricks = "processors";
    for (const int count : processors) bricks += ' ' + std::to_string(count);
    const Answer answer =
        lammps(processors[0] * processors[1] * processors[2],
               "variable thermo_steps index 1\n" + bricks + "\n" + wanted +
                   "write_dump all custom end.dump id f_mpm[*] modify format float %.17g\n");
    EXPECT_EQ(answer.status, 0) << answer.text;
    return read_told(answer.text);
}

Told BothHosts::read_told(const std::string& printed) const {
    Told out;
    const std::size_t count = grit::mpm::history_columns(in_space).size();
    for (const std::vector<double>& row : numbers_in(printed, count + 1)) {
        // The step is in front; a run begins with the last row of the one before.
        std::vector<double> values(row.begin() + 1, row.end());
        if (out.rows.empty() || out.rows.back()[1] != values[1]) out.rows.push_back(values);
    }
    const std::string dump = folder.read("end.dump");
    const std::string head = dump.substr(0, dump.find("\n", dump.find("ITEM: ATOMS")));
    std::size_t columns = 0;
    for (std::size_t at = head.find("f_mpm"); at != std::string::npos;
         at = head.find("f_mpm", at + 1))
        ++columns;
    for (const std::vector<double>& row : numbers_in(dump, columns + 1))
        out.points[static_cast<int>(row[0])] = {row.begin() + 1, row.end()};
    return out;
}

std::string replaced(std::string text, const std::string& words, const std::string& other) {
    const std::size_t at = text.find(words);
    EXPECT_NE(at, std::string::npos) << words << " in\n" << text;
    return at == std::string::npos ? text : text.replace(at, words.size(), other);
}

std::string first_difference(const Told& one, const Told& other) {
    for (std::size_t i = 0; i < std::min(one.rows.size(), other.rows.size()); ++i)
        if (!same_bits(one.rows[i], other.rows[i]))
            return "history, row " + std::to_string(i) + ':' + shown(one.rows[i], other.rows[i]);
    if (one.rows.size() != other.rows.size())
        return std::to_string(one.rows.size()) + " and " + std::to_string(other.rows.size()) +
               " rows";
    if (one.points.size() != other.points.size())
        return std::to_string(one.points.size()) + " and " + std::to_string(other.points.size()) +
               " particles";
    for (const auto& [id, row] : one.points) {
        const auto found = other.points.find(id);
        if (found == other.points.end()) return "there is no particle " + std::to_string(id);
        // Bodies with fewer columns have zeros behind them in LAMMPS.
        std::vector<double> a = row, b = found->second;
        a.resize(std::max(a.size(), b.size()), 0.0);
        b.resize(a.size(), 0.0);
        if (!same_bits(a, b)) return "particle " + std::to_string(id) + ':' + shown(a, b);
    }
    return {};
}

void expect_error(const Answer& answer, const std::string& why) {
    EXPECT_NE(answer.status, 0);
    EXPECT_TRUE(answer.says("ERROR")) << answer.text;
    EXPECT_TRUE(answer.says(why)) << answer.text;
    EXPECT_FALSE(answer.says("terminate called") || answer.says("Segmentation")) << answer.text;
}
