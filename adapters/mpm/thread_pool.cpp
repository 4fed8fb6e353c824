// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/thread_pool.hpp"

#include <utility>

namespace grit::mpm {

namespace {

// About a tenth of a millisecond: what lies between two passes of a step. To be woken takes nearly as long.
constexpr int looks_before_sleep = 4000;

void rest() {
#ifdef __x86_64__
    __builtin_ia32_pause();
#else
    std::this_thread::yield();
#endif
}

}  // namespace

ThreadPool::ThreadPool(int count) {
    // With fewer cores than threads, one that only looks would keep another from its work.
    if (count <= static_cast<int>(std::thread::hardware_concurrency())) looks = looks_before_sleep;
    for (int i = 1; i < count; ++i) threads.emplace_back([this] { serve(); });
}

ThreadPool::~ThreadPool() {
    stopping = true;
    ++generation;
    generation.notify_all();
    for (std::thread& thread : threads) thread.join();
}

void ThreadPool::wait(const std::atomic<int>& value, int was) const {
    for (int i = 0; i < looks; ++i) {
        if (value != was) return;
        rest();
    }
    value.wait(was);
}

void ThreadPool::start(int count, const void* task, Call call) {
    work_item = task;
    work_call = call;
    tasks = count;
    next = 0;
    busy = static_cast<int>(threads.size());
    ++generation;
    generation.notify_all();
    work();
    for (int left = busy; left > 0; left = busy) wait(busy, left);
    if (failure) std::rethrow_exception(std::exchange(failure, nullptr));
}

void ThreadPool::work() {
    for (int i = next++; i < tasks; i = next++) {
        try {
            work_call(work_item, i);
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!failure || i < failed_task) {
                failure = std::current_exception();
                failed_task = i;
            }
        }
    }
}

void ThreadPool::serve() {
    for (int seen = 0;; ++seen) {
        wait(generation, seen);
        if (stopping) return;
        work();
        if (--busy == 0) busy.notify_one();
    }
}

}  // namespace grit::mpm
