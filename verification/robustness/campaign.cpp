// SPDX-License-Identifier: BSD-3-Clause
#include "robustness/campaign.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <mutex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include <grit/version.h>

#include "support/version/commit.hpp"
#include "support/version_text.hpp"

namespace robustness {
namespace {

std::atomic<bool> asked_to_stop = false;

// What threads are at: for a signal that ends the program, whose thread may be one that a trial has started.
constexpr int most_threads = 1024;
std::array<std::atomic<long>, most_threads> blocks_begun;  // their numbers plus 1

// Nothing here takes memory or a lock.
void name_blocks(int signal) {
    const auto say = [](std::string_view text) {
        if (write(STDERR_FILENO, text.data(), text.size()) < 0) return;
    };
    say("\ntorture: ended by a signal at block");
    for (const auto& begun : blocks_begun) {
        std::array<char, 24> digits;
        if (const long number = begun) {
            const auto end = std::to_chars(digits.begin(), digits.end(), number - 1).ptr;
            say(" ");
            say({digits.begin(), end});
        }
    }
    say(": --only repeats one\n");
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

// What blocks have cost, and by which programs.
struct Effort {
    double seconds = 0.0;  // of threads
    std::set<std::string> commits;

    void add(double more, const std::string& commit) {
        seconds += more;
        commits.insert(commit.empty() ? "unknown" : commit);
    }
};

class Journal {
  public:
    Journal(const Kind& kind, const Campaign& campaign, std::vector<bool>& done, Findings& all,
            Effort& effort)
        : path(campaign.journal), words(kind.words) {
        if (path.empty()) return;
        const std::string head = "grit torture " + kind.name + ", seed " +
                                 std::to_string(campaign.seed) + ", blocks of " +
                                 std::to_string(kind.block) + ", Grit " +
                                 grit::version_text(grit_version());
        std::ifstream before(path);
        std::string line;
        if (std::getline(before, line)) {
            if (line != head)
                throw std::runtime_error(path + ": is of \"" + line + "\", not of \"" + head +
                                         "\": give another file");
            while (std::getline(before, line)) {
                if (before.eof()) break;  // cut off
                std::istringstream head_of_line(line.substr(0, line.find('\t')));
                std::size_t number = done.size();
                double seconds = 0.0;
                std::string commit;
                if (!(head_of_line >> number >> seconds >> commit))
                    throw std::runtime_error(path + ": no block stands in \"" + line + '"');
                if (number >= done.size() || done[number]) continue;
                all.add(Findings::of_line(words, line));
                effort.add(seconds, commit);
                done[number] = true;
            }
        }
        before.close();
        rewrite_without_cut_line();
        file.open(path, std::ios::app);
        if (file.tellp() == 0) file << head << '\n' << std::flush;
        if (!file) throw std::runtime_error(path + ": cannot be written");
    }

    void add(std::size_t block, double seconds, const Findings& found) {
        if (path.empty()) return;
        const std::string commit = grit::commit();
        file << block << ' ' << seconds << ' ' << (commit.empty() ? "unknown" : commit)
             << found.line(words) << '\n'
             << std::flush;
        if (!file) throw std::runtime_error(path + ": cannot be written");
    }

  private:
    void rewrite_without_cut_line() const {
        std::ifstream in(path, std::ios::binary);
        const std::string text(std::istreambuf_iterator<char>(in), {});
        if (text.empty() || text.back() == '\n') return;
        std::ofstream(path, std::ios::binary) << text.substr(0, text.rfind('\n') + 1);
    }

    std::string path;
    const Vocabulary& words;
    std::ofstream file;
};

}  // namespace

bool run(const Kind& kind, const Campaign& campaign) {
    using Clock = std::chrono::steady_clock;
    const bool alone = campaign.only >= 0;
    const auto blocks =
        alone ? std::size_t{1}
              : static_cast<std::size_t>((campaign.count + kind.block - 1) / kind.block);
    std::vector<bool> done(blocks);
    Findings all(kind.words);
    Effort effort;
    Journal journal(kind, campaign, done, all, effort);
    std::vector<std::size_t> left;
    for (std::size_t i = 0; i < blocks; ++i)
        if (!done[i]) left.push_back(i);
    const std::size_t before = blocks - left.size();

    for (const int each : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL})
        std::signal(each, name_blocks);
    for (const int each : {SIGINT, SIGTERM}) std::signal(each, [](int) { asked_to_stop = true; });
    const auto start = Clock::now();
    const auto seconds = [&] {
        return std::chrono::duration<double>(Clock::now() - start).count();
    };
    std::mutex mutex;
    std::size_t next = 0, ended = 0;
    std::string failure;
    double told = 0.0;
    const auto work = [&](int thread) {
        for (;;) {
            std::size_t block;
            {
                const std::lock_guard lock(mutex);
                const bool late = campaign.hours > 0.0 && seconds() > 3600.0 * campaign.hours;
                if (next == left.size() || asked_to_stop || late || !failure.empty()) return;
                block = left[next++];
            }
            const auto number = alone ? static_cast<std::uint64_t>(campaign.only) : block;
            blocks_begun[static_cast<std::size_t>(thread)] = static_cast<long>(number) + 1;
            Findings found(kind.words);
            // Neighbouring seeds and blocks have streams that share nothing.
            Random random(Random(campaign.seed).bits() ^ Random(~number).bits());
            const double began = seconds();
            std::string thrown;
            try {
                kind.run(random, kind.block, found);
            } catch (const std::exception& error) {
                thrown = error.what();
            }
            const std::lock_guard lock(mutex);
            if (!thrown.empty()) {
                failure = "block " + std::to_string(number) + ": " + thrown;
                return;
            }
            const double took = seconds() - began;
            try {
                journal.add(block, took, found);
            } catch (const std::runtime_error& error) {
                failure = error.what();
                return;
            }
            all.add(found);
            effort.add(took, grit::commit());
            ++ended;
            if (seconds() - told < 10.0) continue;
            told = seconds();
            const double rate = static_cast<double>(ended) / told;
            std::fprintf(stderr, "%s: block %zu of %zu, %.3g cases/s, %.0f s left\n",
                         kind.name.c_str(), before + ended, blocks,
                         rate * static_cast<double>(kind.block),
                         static_cast<double>(left.size() - ended) / rate);
        }
    };
    std::vector<std::thread> others;
    try {
        for (int i = 1; i < std::min(campaign.threads, most_threads); ++i)
            others.emplace_back(work, i);
    } catch (const std::system_error&) {  // no more threads: the others do it
    }
    work(0);
    for (std::thread& each : others) each.join();
    for (auto& each : blocks_begun) each = 0;
    if (!failure.empty()) throw std::runtime_error(failure);

    std::printf("%s: %zu of %zu blocks of %ld cases, seed %lu, Grit %s\n", kind.name.c_str(),
                before + ended, blocks, kind.block, campaign.seed,
                grit::version_text(grit_version()).c_str());
    all.print(kind.words);
    std::string commits;
    for (const std::string& each : effort.commits) commits += (commits.empty() ? "" : ", ") + each;
    std::printf("instruction sets up to %d\n", grit_instruction_set());
    std::printf("| kind | seed | commit | cases | seconds of threads | rules broken |\n"
                "| %s | %lu | %s | %.0f | %.0f | %d |\n",
                kind.name.c_str(), campaign.seed, commits.c_str(),
                static_cast<double>(before + ended) * static_cast<double>(kind.block),
                effort.seconds, all.rules_broken());
    return all.clean();
}

}  // namespace robustness
