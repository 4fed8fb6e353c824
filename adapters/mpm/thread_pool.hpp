// SPDX-License-Identifier: BSD-3-Clause
// A few threads that share numbered tasks. Who does which is left open: tasks must not depend on it.
#pragma once

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace grit::mpm {

class ThreadPool {
  public:
    // The calling thread is one of them.
    explicit ThreadPool(int threads);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    // task(0) ... task(count - 1); throws the exception of the lowest task that threw.
    template <class Task> void run(int count, const Task& task) {
        start(count, &task, [](const void* work, int i) { (*static_cast<const Task*>(work))(i); });
    }

  private:
    using Call = void (*)(const void*, int);
    void start(int count, const void* task, Call call);
    void work();
    void serve();
    // Returns once value is no longer what it was.
    void wait(const std::atomic<int>& value, int was) const;

    std::vector<std::thread> threads;
    int looks = 0;  // before a thread that waits goes to sleep
    std::atomic<int> next{0}, busy{0}, generation{0};
    std::atomic<bool> stopping{false};
    int tasks = 0;
    const void* work_item = nullptr;
    Call work_call = nullptr;
    std::mutex mutex;  // of what follows
    int failed_task = 0;
    std::exception_ptr failure;
};

}  // namespace grit::mpm
