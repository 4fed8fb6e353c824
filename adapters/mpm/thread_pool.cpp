// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/thread_pool.hpp"

#include <utility>

namespace grit::mpm {

ThreadPool::ThreadPool(int count) {
    for (int i = 1; i < count; ++i) threads.emplace_back([this] { serve(); });
}

ThreadPool::~ThreadPool() {
    {
        const std::lock_guard lock(mutex);
        stopping = true;
    }
    wake.notify_all();
    for (std::thread& thread : threads) thread.join();
}

void ThreadPool::start(int count, const void* task, Call call) {
    {
        const std::lock_guard lock(mutex);
        work_item = task;
        work_call = call;
        tasks = count;
        next = 0;
        busy = static_cast<int>(threads.size());
        ++generation;
    }
    if (!threads.empty()) wake.notify_all();
    work();
    std::unique_lock lock(mutex);
    done.wait(lock, [this] { return busy == 0; });
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
    int seen = 0;
    for (;;) {
        {
            std::unique_lock lock(mutex);
            wake.wait(lock, [&] { return stopping || generation != seen; });
            if (stopping) return;
            seen = generation;
        }
        work();
        const std::lock_guard lock(mutex);
        if (--busy == 0) done.notify_one();
    }
}

}  // namespace grit::mpm
