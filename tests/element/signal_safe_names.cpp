// SPDX-License-Identifier: BSD-3-Clause
#include <element/signal_safe_names.hpp>

#include <gtest/gtest.h>
#include <pthread.h>
#include <signal.h>

#include <array>
#include <atomic>
#include <map>
#include <random>
#include <string>
#include <thread>
#include <vector>

namespace {

// One size for all: g++ 12 merges remove() of two sizes and then warns of the bounds of the smaller.
constexpr int places = 2;
using Table = element::SignalSafeNames<places>;

std::map<std::string, int> names_in(const Table& table) {
    std::map<std::string, int> out;
    table.for_each([&](const char* name, int descriptor) { out.emplace(name, descriptor); });
    return out;
}

using Names = std::map<std::string, int>;

TEST(SignalSafeNames, AreThoseThatWereAddedAndNotRemoved) {
    Table table;
    EXPECT_EQ(names_in(table), Names());
    const int a = table.add("/a", 7), b = table.add("/b");
    EXPECT_EQ(names_in(table), (Names{{"/a", 7}, {"/b", -1}}));
    table.remove(a);
    EXPECT_EQ(names_in(table), (Names{{"/b", -1}}));
    table.remove(b);
    EXPECT_EQ(names_in(table), Names());
}

TEST(SignalSafeNames, HavePlacesThatAreTakenAgain) {
    Table table;
    const int first = table.add("/a long name that a shorter one follows", 1),
              second = table.add("/b", 2);
    EXPECT_EQ(table.add("/c", 3), table.none);
    table.remove(first);
    EXPECT_EQ(table.add("/c", 3), first);
    EXPECT_NE(first, second);
    table.remove(table.none);  // of one that did not fit
    EXPECT_EQ(names_in(table), (Names{{"/b", 2}, {"/c", 3}}));
}

TEST(SignalSafeNames, LeaveOutWhatIsTooLong) {
    Table table;
    const std::string longest(table.longest, 'x');
    EXPECT_EQ(table.add(longest + 'x'), table.none);
    EXPECT_EQ(names_in(table), Names());
    EXPECT_NE(table.add(longest), table.none);
    EXPECT_EQ(names_in(table), (Names{{longest, -1}}));
}

TEST(SignalSafeNames, ShareNoPlaceHoweverManyThreadsAddThem) {
    Table table;
    std::array<std::atomic<int>, places> owners{};
    std::atomic<int> two = 0, got = 0;
    std::vector<std::thread> threads;
    for (unsigned seed = 0; seed < 6; ++seed)
        threads.emplace_back([&, seed] {
            std::mt19937 random(seed);
            for (int i = 0; i < 200000; ++i) {
                const std::string name(1 + random() % 4000, static_cast<char>('a' + seed));
                const int place = table.add(name, static_cast<int>(seed));
                if (place == table.none) continue;
                std::atomic<int>& owner = owners[static_cast<std::size_t>(place)];
                two += ++owner != 1;
                ++got;
                std::this_thread::yield();  // whoever else took the place has it now
                --owner;
                table.remove(place);
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(two, 0);
    EXPECT_GT(got, 1000);
    EXPECT_EQ(names_in(table), Names());
}

// Names are of one letter, whose number is the descriptor: another is half of one.
element::SignalSafeNames<4> seen_by_handler;
volatile sig_atomic_t readings = 0, halves = 0;

void read_names(int) {
    seen_by_handler.for_each([](const char* name, int descriptor) {
        readings = readings + 1;
        for (; *name; ++name)
            if (*name != 'a' + descriptor) halves = halves + 1;
    });
}

TEST(SignalSafeNames, AreWholeForAHandlerThatInterruptsWhoChangesThem) {
    struct sigaction action {
    }, before{};
    action.sa_handler = read_names;
    sigaction(SIGUSR1, &action, &before);
    const pthread_t changer = pthread_self();
    std::atomic<bool> done = false;
    std::thread other([&] {
        for (int i = 0; i < 20000; ++i) {
            pthread_kill(changer, SIGUSR1);
            std::this_thread::yield();
        }
        done = true;
    });
    std::mt19937 random(1);
    std::array<int, 4> taken{-1, -1, -1, -1};
    while (!done) {
        int& place = taken[random() % taken.size()];
        seen_by_handler.remove(place);
        const int letter = static_cast<int>(random() % 26);
        place = seen_by_handler.add(std::string(random() % 4000, static_cast<char>('a' + letter)),
                                    letter);
    }
    other.join();
    sigaction(SIGUSR1, &before, nullptr);
    for (const int place : taken) seen_by_handler.remove(place);
    EXPECT_EQ(halves, 0);
    EXPECT_GT(readings, 100);
}

}  // namespace
