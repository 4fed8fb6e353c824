// SPDX-License-Identifier: BSD-3-Clause
#include "cli/plot.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "element/csv.hpp"

extern char** environ;

namespace cli {
namespace {

namespace fs = std::filesystem;

// Okabe & Ito 2008: distinct for colour-blind readers and in grey.
constexpr const char* colours[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00"};

std::string quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? std::string("''") : std::string(1, c);
    return out + "'";
}

// One panel; q and e are the expressions for a computed and for a reference row.
std::string panel(const std::vector<Curve>& curves, const std::string& computed,
                  const std::string& reference) {
    std::string out;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const char* colour = colours[i % std::size(colours)];
        const std::string separator = out.empty() ? "plot " : ", \\\n     ";
        out += fmt::format("{}{} using (-100*column('axial_strain [-]')):({}) with lines lw 2.5 "
                           "lc rgb '{}' title {} noenhanced",
                           separator, quoted(curves[i].csv.string()), computed, colour,
                           quoted(curves[i].label));
        if (curves[i].reference.empty()) continue;
        // Reference curves are graded too: every 16th row leaves the line visible between points.
        out += fmt::format(", \\\n     {} using (-100*column('eps11')):({}) every 16 with points pt 6 "
                           "ps 0.8 lw 1.2 lc rgb '#222222' title {}",
                           quoted(curves[i].reference.string()), reference,
                           i + 1 == curves.size() ? "'reference'" : "''");
    }
    return out + "\n";
}

std::string body(const std::string& title, const std::vector<Curve>& curves) {
    return fmt::format(
        "set datafile separator ','\n"
        "set datafile commentschars '#'\n"
        "set datafile columnheaders\n"
        "set encoding utf8\n"
        "set border 3 lw 1 lc rgb '#444444'\n"
        "set tics nomirror out scale 0.6 textcolor rgb '#222222'\n"
        "set grid lw 0.7 lc rgb '#dddddd'\n"
        "set key samplen 2 spacing 1.2 textcolor rgb '#222222'\n"
        "set xlabel 'axial compression −ε_{{11}} [%]'\n"
        "set multiplot layout 1,2 title {} noenhanced font ',15' margins 0.08,0.98,0.14,0.89 "
        "spacing 0.10\n"
        "set ylabel 'deviatoric stress q [kPa]'\n"
        "set yrange [0:*]\n"
        "set key bottom right\n"
        "{}"
        "set ylabel 'void ratio e [–]'\n"
        "set yrange [*:*]\n"
        "set key off\n"
        "{}"
        "unset multiplot\n",
        quoted(title), panel(curves, "column('q [kPa]')", "abs(column('s11')-column('s33'))"),
        panel(curves, "column('void_ratio [-]')", "column('e')"));
}

// Exit status of gnuplot, output in log; -1 if there is no gnuplot.
int run_gnuplot(const fs::path& script, const fs::path& log) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 1, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    posix_spawn_file_actions_adddup2(&actions, 1, 2);
    std::string program = "gnuplot", file = script.string();
    char* arguments[] = {program.data(), file.data(), nullptr};
    pid_t child = 0;
    const int refused = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments, environ);
    posix_spawn_file_actions_destroy(&actions);
    if (refused) return -1;
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {}
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

std::string first_line(const fs::path& path) {
    std::ifstream file(path);
    std::string line;
    while (std::getline(file, line) && line.empty()) {}
    return line;
}

fs::path with(fs::path stem, const char* ending) { return stem += ending; }

}  // namespace

std::string plot(const fs::path& stem, const std::string& title,
                 const std::vector<Curve>& curves) {
    const fs::path script = with(stem, ".gnuplot.part"), log = with(stem, ".log.part");
    const fs::path svg = with(stem, ".svg.part"), png = with(stem, ".png.part");
    const std::string drawing = body(title, curves);
    element::write_aside(script, [&](std::FILE* file) {
        fmt::print(file,
                   "set terminal svg size 1000,420 dynamic enhanced font 'DejaVu Sans,13' "
                   "background '#ffffff'\nset output {}\n{}unset output\n",
                   quoted(svg.string()), drawing);
        fmt::print(file,
                   "set terminal pngcairo size 2000,840 enhanced font 'DejaVu Sans,13' fontscale 2 "
                   "linewidth 2 pointscale 2\nset output {}\n{}unset output\n",
                   quoted(png.string()), drawing);
    });
    const int status = run_gnuplot(script, log);
    const std::string said = first_line(log);
    fs::remove(script);
    fs::remove(log);
    if (status < 0) return "gnuplot was not found (Debian: apt-get install gnuplot-nox)";
    if (status > 0) return fmt::format("gnuplot ended with status {}: {}", status, said);
    fs::rename(svg, with(stem, ".svg"));
    fs::rename(png, with(stem, ".png"));
    return "";
}

}  // namespace cli
