// SPDX-License-Identifier: BSD-3-Clause
#include "cli/plot/gnuplot.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <memory>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "element/atomic_file.hpp"

extern char** environ;

namespace cli {
namespace {

namespace fs = std::filesystem;

// Between pictures.
constexpr std::string_view cut = "==== grit: the next picture ====";

class Pipe {
  public:
    Pipe() {
        if (pipe2(ends.data(), O_CLOEXEC) != 0)
            throw element::CannotWrite("no pipe for gnuplot: " +
                                       std::generic_category().message(errno));
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    ~Pipe() {
        for (const int end : ends)
            if (end >= 0) close(end);
    }
    int in() const { return ends[0]; }
    int out() const { return ends[1]; }
    void close_out() {
        close(ends[1]);
        ends[1] = -1;
    }
    // False at its end.
    bool read_some(std::string& text) const {
        std::array<char, 65536> some;
        const ssize_t got = read(ends[0], some.data(), some.size());
        if (got > 0) text.append(some.data(), static_cast<std::size_t>(got));
        return got > 0 || (got < 0 && errno == EINTR);
    }

  private:
    std::array<int, 2> ends{-1, -1};
};

struct Drawn {
    int status = -1;  // of gnuplot; -1: there is none
    std::string pictures, words;
};

// gnuplot does not look at what a disk has taken: it writes into pipes, and files are for who does.
Drawn run_gnuplot(const fs::path& script) {
    Pipe pictures, words;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, pictures.out(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, words.out(), STDERR_FILENO);
    std::string program = "gnuplot", file = script.string();
    char* arguments[] = {program.data(), file.data(), nullptr};
    pid_t child = 0;
    const int refused = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments, environ);
    posix_spawn_file_actions_destroy(&actions);
    Drawn out;
    if (refused) return out;
    pictures.close_out();
    words.close_out();
    std::array<pollfd, 2> open{{{pictures.in(), POLLIN, 0}, {words.in(), POLLIN, 0}}};
    while (open[0].fd >= 0 || open[1].fd >= 0) {
        if (poll(open.data(), open.size(), -1) < 0 && errno != EINTR) break;
        if (open[0].revents && !pictures.read_some(out.pictures)) open[0].fd = -1;
        if (open[1].revents && !words.read_some(out.words)) open[1].fd = -1;
    }
    while (waitpid(child, &out.status, 0) < 0 && errno == EINTR) {
    }
    out.status = WIFEXITED(out.status) ? WEXITSTATUS(out.status) : 128;
    return out;
}

std::string first_line(const std::string& text) {
    const std::size_t from = text.find_first_not_of('\n');
    return from == text.npos ? "" : text.substr(from, text.find('\n', from) - from);
}

std::vector<std::string_view> cut_apart(std::string_view text) {
    std::vector<std::string_view> out;
    for (std::size_t at; (at = text.find(cut)) != text.npos;
         text.remove_prefix(at + cut.size() + 1))
        out.push_back(text.substr(0, at));
    out.push_back(text);
    return out;
}

constexpr double centimetres = 2.54 / 96.0;  // of a pixel of a picture on paper

fs::path with(fs::path stem, const char* ending) { return stem += ending; }

}  // namespace

std::string draw_with_gnuplot(const fs::path& stem, int width, int height, const std::string& data,
                              const std::string& drawing, const PictureFiles& files) {
    std::vector<std::string> endings, terminals;
    const auto want = [&](const char* ending, std::string terminal) {
        endings.emplace_back(ending);
        terminals.push_back(std::move(terminal));
    };
    if (files.svg)
        want(".svg", fmt::format("svg size {},{} dynamic enhanced font 'sans-serif,13' "
                                 "background '#ffffff'",
                                 width, height));
    if (files.png)
        want(".png", fmt::format("pngcairo size {},{} enhanced font 'Sans,13'", width, height));
    if (files.pdf)
        want(".pdf", fmt::format("pdfcairo size {:.4g}cm,{:.4g}cm enhanced font 'Sans,10'",
                                 width * centimetres, height * centimetres));
    element::AtomicFile script(with(stem, ".gnuplot"));
    script.write("set print '-'\n" + data);
    for (std::size_t i = 0; i < terminals.size(); ++i)
        script.write(fmt::format("{}set terminal {}\n{}",
                                 i == 0 ? std::string() : fmt::format("print '{}'\n", cut),
                                 terminals[i], drawing));
    script.flush();
    const Drawn drawn = run_gnuplot(script.path());
    if (drawn.status < 0) return "gnuplot was not found (Debian: apt-get install gnuplot-nox)";
    const std::vector<std::string_view> pictures = cut_apart(drawn.pictures);
    if (drawn.status > 0 || pictures.size() != terminals.size())
        throw element::CannotWrite(fmt::format("{}: gnuplot ended with status {}: {}",
                                               with(stem, endings.front().c_str()).string(),
                                               drawn.status, first_line(drawn.words)));
    std::vector<std::unique_ptr<element::AtomicFile>> complete;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        complete.push_back(std::make_unique<element::AtomicFile>(with(stem, endings[i].c_str())));
        complete.back()->write(pictures[i]);
        complete.back()->flush();
    }
    for (const auto& file : complete) file->complete();
    return "";
}

std::string gnuplot_quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? std::string("''") : std::string(1, c);
    return out + "'";
}

}  // namespace cli
