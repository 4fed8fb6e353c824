// SPDX-License-Identifier: BSD-3-Clause
#include "robustness/campaign.hpp"

#include <sys/time.h>
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

// What threads are at: a signal that ends the program may find a thread that a trial has started.
constexpr int most_threads = 1024;
std::array<Pulse, most_threads> pulses;
std::array<char, 80> command;  // that repeats a block, without its number

// Nothing here takes memory or a lock.
void say(std::string_view text) {
    if (write(STDERR_FILENO, text.data(), text.size()) < 0) return;
}

void say_repeat(long block) {
    std::array<char, 24> digits;
    const auto end = std::to_chars(digits.begin(), digits.end(), block - 1).ptr;
    say(command.data());
    say({digits.begin(), end});
    say("\n");
}

void name_blocks(int signal) {
    say("\ntorture: ended by a signal in one of these blocks:\n");
    for (const Pulse& each : pulses)
        if (const long block = each.block) say_repeat(block);
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

void stop_or_end(int signal) {
    if (asked_to_stop.exchange(true)) name_blocks(signal);
}

// Seconds of the processor time of a thread, more than sanitizers make of any call.
constexpr long longest_call = 120;

void look_for_hung(int) {
    bool hung = false;
    for (Pulse& each : pulses) {
        const long block = each.block;
        if (block == 0 || each.moved.exchange(false)) continue;
        if (!hung) say("\ntorture: a call does not return in this block:\n");
        hung = true;
        say_repeat(block);
    }
    if (!hung) return;
    std::signal(SIGABRT, SIG_DFL);
    std::raise(SIGABRT);
}

// Hears the clock of the process, which runs for all threads.
class Watch {
  public:
    explicit Watch(int threads) {
        struct sigaction action {};
        action.sa_handler = look_for_hung;
        action.sa_flags = SA_RESTART;
        sigaction(SIGPROF, &action, nullptr);
        every(longest_call * threads);
    }
    ~Watch() { every(0); }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

  private:
    static void every(long seconds) {
        itimerval time{};
        time.it_value.tv_sec = time.it_interval.tv_sec = seconds;
        setitimer(ITIMER_PROF, &time, nullptr);
    }
};

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

    std::snprintf(command.data(), command.size(), "torture %s --seed %lu --only ",
                  kind.name.c_str(), campaign.seed);
    for (const int each : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL})
        std::signal(each, name_blocks);
    for (const int each : {SIGINT, SIGTERM}) std::signal(each, stop_or_end);
    const auto start = Clock::now();
    const auto seconds = [&] {
        return std::chrono::duration<double>(Clock::now() - start).count();
    };
    std::mutex mutex;
    std::size_t next = 0, ended = 0;
    std::string failure;
    double told = 0.0;
    const auto work = [&](int thread) {
        pulse = &pulses[static_cast<std::size_t>(thread)];
        for (;;) {
            std::size_t block;
            {
                const std::lock_guard lock(mutex);
                const bool late = campaign.hours > 0.0 && seconds() > 3600.0 * campaign.hours;
                if (next == left.size() || asked_to_stop || late || !failure.empty()) return;
                block = left[next++];
            }
            const auto number = alone ? static_cast<std::uint64_t>(campaign.only) : block;
            beat();
            pulse->block = static_cast<long>(number) + 1;
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
            pulse->block = 0;
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
    const int threads = std::min(campaign.threads, most_threads);
    const Watch watch(threads);
    std::vector<std::thread> others;
    try {
        for (int i = 1; i < threads; ++i) others.emplace_back(work, i);
    } catch (const std::system_error&) {  // no more threads: the others do it
    }
    work(0);
    for (std::thread& each : others) each.join();
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
