// SPDX-License-Identifier: BSD-3-Clause
// Threads that share tasks, also where there are fewer cores than threads.
#include <gtest/gtest.h>

#include <sched.h>
#include <sys/resource.h>

#include <filesystem>
#include <stdexcept>
#include <thread>
#include <vector>

#include <adapters/mpm/step/thread_pool.hpp>

#include "../few_threads.hpp"
#include "support/box.hpp"

namespace {

using namespace mpm_test;

double processor_seconds() {
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(used.ru_utime) + seconds(used.ru_stime);
}

// On one core until it ends, and all threads that are started meanwhile.
class OnOneCore {
  public:
    OnOneCore() {
        sched_getaffinity(0, sizeof before, &before);
        int core = 0;
        while (!CPU_ISSET(core, &before)) ++core;
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(core, &one);
        sched_setaffinity(0, sizeof one, &one);
    }
    ~OnOneCore() { sched_setaffinity(0, sizeof before, &before); }
    OnOneCore(const OnOneCore&) = delete;
    OnOneCore& operator=(const OnOneCore&) = delete;

  private:
    cpu_set_t before;
};

TEST(ThreadPool, DoesEachTaskOnceWhateverTheThreads) {
    for (const int threads : {1, 2, 3, 16}) {
        ThreadPool pool(threads);
        for (int pass = 0; pass < 2000; ++pass) {
            std::vector<int> done(static_cast<std::size_t>(pass % 37), 0);
            pool.run(pass % 37, [&](int i) { done[static_cast<std::size_t>(i)] += i + 1; });
            for (std::size_t i = 0; i < done.size(); ++i)
                ASSERT_EQ(done[i], static_cast<int>(i) + 1) << threads << ' ' << pass;
        }
    }
}

TEST(ThreadPool, DoesWithTheThreadsThatTheSystemGives) {
    const RoomForFewThreads room;
    ThreadPool pool(1000);
    EXPECT_LT(pool.size(), 1000);
    std::vector<int> done(100, 0);
    pool.run(100, [&](int i) { done[static_cast<std::size_t>(i)] += 1; });
    EXPECT_EQ(done, std::vector<int>(100, 1));
}

TEST(ThreadPool, ThrowsWhatTheLowestTaskThrew) {
    ThreadPool pool(4);
    for (int pass = 0; pass < 200; ++pass) {
        std::string told;
        try {
            pool.run(30, [&](int i) {
                if (i >= pass % 30) throw std::runtime_error(std::to_string(i));
            });
        } catch (const std::runtime_error& error) {
            told = error.what();
        }
        ASSERT_EQ(told, std::to_string(pass % 30));
    }
}

// Threads that wait take no time from one that works.
TEST(ThreadPool, OnOneCoreTakesLittleMoreThanOneThread) {
    const OnOneCore only;
    const auto cost = [](ThreadPool& pool) {
        volatile double sum = 0.0;
        const auto task = [&](int) {
            double x = 1.0;
            for (int k = 0; k < 1000; ++k) x = x * 1.0000001 + 1e-9;
            sum = x;
        };
        const double before = processor_seconds();
        for (int pass = 0; pass < 4000; ++pass) pool.run(4, task);
        return processor_seconds() - before;
    };
    // Made where there are two cores: a pool cannot know who else wants them.
    ThreadPool one(1), two(2);
    const double alone = cost(one);
    EXPECT_LT(cost(two), 2.0 * alone + 0.02);
}

TEST(Simulation, TakesNoMoreThreadsThanThereAreCores) {
    const auto threads_now = [] {
        const std::filesystem::directory_iterator all("/proc/self/task");
        return std::distance(begin(all), end(all));
    };
    const auto before = threads_now();
    const Simulation simulation(Axis::uniform(0.0, 1.0, 4), Axis::uniform(0.0, 1.0, 4),
                                {.threads = 200});
    EXPECT_LT(threads_now() - before, std::max(2u, std::thread::hardware_concurrency()));
    EXPECT_EQ(usable_threads(1), 1);
    EXPECT_EQ(word_of_unused_threads(1), "");
    EXPECT_EQ(usable_threads(100000), static_cast<int>(std::thread::hardware_concurrency()));
    EXPECT_EQ(usable_threads(4, 2), 2);
    EXPECT_EQ(usable_threads(4, 0), 4);  // how many cores there are is not known
    EXPECT_EQ(usable_threads(0, 0), 1);
}

}  // namespace
