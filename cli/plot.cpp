// SPDX-License-Identifier: BSD-3-Clause
#include "cli/plot.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
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
constexpr const char* colours[] = {"#0072B2", "#D55E00", "#009E73",
                                   "#CC79A7", "#56B4E9", "#E69F00"};

std::string quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? std::string("''") : std::string(1, c);
    return out + "'";
}

// One panel: the expressions for a computed and for a reference row. Reference rows are graded;
// spaced() of the script keeps some that leave the line visible between their points.
std::string panel(const std::vector<Curve>& curves, const std::string& computed,
                  const std::string& reference) {
    std::string out;
    bool referenced = false;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        out += fmt::format("{}{} using (-100*column('axial_strain [-]')):({}) with lines lw 2.5 "
                           "lc rgb '{}' title {} noenhanced",
                           out.empty() ? "last = NaN; plot " : ", \\\n     ",
                           quoted(curves[i].csv.string()), computed,
                           colours[i % std::size(colours)], quoted(curves[i].label));
        if (curves[i].reference.empty()) continue;
        out +=
            fmt::format(", \\\n     {} using (spaced(-100*column('eps11'))):({}) with points pt 6 "
                        "ps 0.8 lw 1.2 lc rgb '#222222' notitle",
                        quoted(curves[i].reference.string()), reference);
        referenced = true;
    }
    if (referenced)
        out += ", \\\n     NaN with points pt 6 ps 0.8 lw 1.2 lc rgb '#222222' title 'reference'";
    return out + "\n";
}

std::string body(const std::string& title, const std::vector<Curve>& curves) {
    double longest = 0.0;
    std::size_t label = 9;  // characters of "reference"
    for (const Curve& curve : curves) {
        longest = std::max(longest, std::abs(curve.axial_strain));
        label = std::max(label, curve.label.size());
    }
    // gnuplot estimates the width of a key by wide characters.
    const double width = -0.14 * static_cast<double>(label);
    return fmt::format(
        "reset\nset datafile separator ','\n"
        "set datafile commentschars '#'\n"
        "set datafile columnheaders\n"
        "set encoding utf8\n"
        "spaced(x) = (last == last && abs(x - last) < {}) ? NaN : (last = x, x)\n"
        "set border 3 lw 1 lc rgb '#444444'\n"
        "set tics nomirror out scale 0.6 textcolor rgb '#222222'\n"
        "set grid lt 1 lw 0.6 lc rgb '#e4e4e4'\n"
        "set xlabel 'axial compression −ε_{{11}} [%]' offset 0,0.2\n"
        "set multiplot layout 1,2 title {} noenhanced font ',15' margins 0.075,0.98,0.15,0.89 "
        "spacing 0.105\n"
        "set ylabel 'deviatoric stress q [kPa]' offset 0.5,0\n"
        "set yrange [0:*]\n"
        "set key bottom right Left reverse opaque samplen 1.6 spacing 1.15 width {} font ',11' "
        "textcolor rgb '#222222'\n"
        "{}"
        "set ylabel 'void ratio e [–]' offset 0.5,0\n"
        "set format y '%.2f'\n"
        "set yrange [*:*]\n"
        "set key off\n"
        "{}"
        "unset multiplot\n",
        100.0 * longest / 26.0, quoted(title), width,
        panel(curves, "column('q [kPa]')", "abs(column('s11')-column('s33'))"),
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
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

std::string first_line(const fs::path& path) {
    std::ifstream file(path);
    std::string line;
    while (std::getline(file, line) && line.empty()) {
    }
    return line;
}

fs::path with(fs::path stem, const char* ending) { return stem += ending; }

}  // namespace

std::string plot(const fs::path& stem, const std::string& title, const std::vector<Curve>& curves) {
    const fs::path script = with(stem, ".gnuplot.part"), log = with(stem, ".log.part");
    const fs::path svg = with(stem, ".svg.part"), png = with(stem, ".png.part");
    const std::string drawing = body(title, curves);
    element::write_aside(script, [&](std::FILE* file) {
        fmt::print(file,
                   "set terminal svg size 1000,420 dynamic enhanced font 'sans-serif,13' "
                   "background '#ffffff'\nset output {}\n{}unset output\n",
                   quoted(svg.string()), drawing);
        fmt::print(file,
                   "set terminal pngcairo size 2000,840 enhanced font 'Sans,13' fontscale 1.8 "
                   "linewidth 2 pointscale 1.8\nset output {}\n{}unset output\n",
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
