// SPDX-License-Identifier: BSD-3-Clause
#include "cli/plot/gnuplot.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>

#include <cerrno>
#include <fstream>
#include <memory>
#include <vector>

#include <fmt/format.h>

#include "element/atomic_file.hpp"

extern char** environ;

namespace cli {
namespace {

namespace fs = std::filesystem;

// Exit status of gnuplot, output in log; -1 if there is no gnuplot.
int spawn(const fs::path& script, const fs::path& log) {
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

// What went wrong, empty if nothing.
std::string run_gnuplot(const fs::path& script, const fs::path& log) {
    const int status = spawn(script, log);
    if (status < 0) return "gnuplot was not found (Debian: apt-get install gnuplot-nox)";
    if (status > 0) return fmt::format("gnuplot ended with status {}: {}", status, first_line(log));
    return "";
}

constexpr double centimetres = 2.54 / 96.0;  // of a pixel of a picture on paper

fs::path with(fs::path stem, const char* ending) { return stem += ending; }

}  // namespace

std::string draw_with_gnuplot(const fs::path& stem, int width, int height, const std::string& data,
                              const std::string& drawing, const PictureFiles& files) {
    element::AtomicFile script(with(stem, ".gnuplot"));
    const element::AtomicPath log(with(stem, ".log"));
    script.write(data);
    std::vector<std::unique_ptr<element::AtomicPath>> pictures;
    const auto draw = [&](const char* ending, const std::string& terminal) {
        pictures.push_back(std::make_unique<element::AtomicPath>(with(stem, ending)));
        script.write(fmt::format("set terminal {}\nset output {}\n{}unset output\n", terminal,
                                 gnuplot_quoted(pictures.back()->path().string()), drawing));
    };
    if (files.svg)
        draw(".svg", fmt::format("svg size {},{} dynamic enhanced font 'sans-serif,13' "
                                 "background '#ffffff'",
                                 width, height));
    if (files.png)
        draw(".png", fmt::format("pngcairo size {},{} enhanced font 'Sans,13'", width, height));
    if (files.pdf)
        draw(".pdf", fmt::format("pdfcairo size {:.4g}cm,{:.4g}cm enhanced font 'Sans,10'",
                                 width * centimetres, height * centimetres));
    script.flush();
    std::string problem = run_gnuplot(script.path(), log.path());
    if (!problem.empty()) return problem;
    for (const auto& picture : pictures) picture->complete();
    return "";
}

std::string gnuplot_quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? std::string("''") : std::string(1, c);
    return out + "'";
}

}  // namespace cli
