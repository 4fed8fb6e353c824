// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/thread_pool.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

namespace grit::mpm {

namespace {

// A microsecond or two: for the last task of another core.
constexpr int looks = 64;
// What lies between two passes of a step, and to be woken takes nearly as long. The core is free for others.
constexpr int yields = 200;

void rest() {
#ifdef __x86_64__
    __builtin_ia32_pause();
#else
    std::this_thread::yield();
#endif
}

}  // namespace

int usable_threads(int wanted) {
    return usable_threads(wanted, static_cast<int>(std::thread::hardware_concurrency()));
}

int usable_threads(int wanted, int cores) {
    return std::max(cores > 0 ? std::min(wanted, cores) : wanted, 1);
}

std::string word_of_unused_threads(int wanted) {
    const int usable = usable_threads(wanted);
    if (usable >= wanted) return {};
    return std::to_string(wanted) + " threads wanted, " + std::to_string(usable) +
           " used: there are no more cores";
}

ThreadPool::ThreadPool(int count) {
    threads.reserve(static_cast<std::size_t>(std::max(count - 1, 0)));
    try {
        for (int i = 1; i < count; ++i) threads.emplace_back([this] { serve(); });
    } catch (const std::system_error&) {  // no more are to be had: those that are there do it
    }
}

ThreadPool::~ThreadPool() {
    stopping = true;
    ++generation;
    generation.notify_all();
    for (std::thread& thread : threads) thread.join();
}

void ThreadPool::wait(const std::atomic<int>& value, int was) {
    for (int i = 0; i < looks + yields; ++i) {
        if (value != was) return;
        if (i < looks) rest();
        else std::this_thread::yield();
    }
    value.wait(was);
}

void ThreadPool::start(int count, const void* task, Call call) {
    // All tasks of the run before are done: nobody who reads these now can take one.
    work_item = task;
    work_call = call;
    tasks = count;
    done = 0;
    open = ((open >> 32) + 1) << 32 | static_cast<std::uint32_t>(count);
    ++generation;
    if (!threads.empty()) generation.notify_all();
    work();
    for (int so_far = done; so_far < count; so_far = done) wait(done, so_far);
    if (failure) std::rethrow_exception(std::exchange(failure, nullptr));
}

void ThreadPool::work() {
    for (std::uint64_t now = open;;) {
        const auto left = static_cast<std::uint32_t>(now);
        if (left == 0) return;
        const int count = tasks;
        const void* item = work_item;
        const Call call = work_call;
        if (!open.compare_exchange_weak(now, now - 1)) continue;
        const int i = count - static_cast<int>(left);
        try {
            call(item, i);
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!failure || i < failed_task) {
                failure = std::current_exception();
                failed_task = i;
            }
        }
        if (++done == count) done.notify_all();
        now = open;
    }
}

void ThreadPool::serve() {
    for (int seen = 0; !stopping;) {
        wait(generation, seen);
        seen = generation;
        work();
    }
}

}  // namespace grit::mpm
