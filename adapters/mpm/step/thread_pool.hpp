// SPDX-License-Identifier: BSD-3-Clause
// A few threads that share numbered tasks. Who does which is left open: tasks must not depend on it.
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace grit::mpm {

// As many as there are cores for, and no more than wanted: others would only take turns.
int usable_threads(int wanted);
int usable_threads(int wanted, int cores);  // cores 0: how many there are is not known
// What a user is told where those are fewer; empty where they are not.
std::string word_of_unused_threads(int wanted);

class ThreadPool {
  public:
    // The calling thread is one of them. Fewer, if the system gives no more.
    explicit ThreadPool(int threads);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    int size() const { return static_cast<int>(threads.size()) + 1; }
    // task(0) ... task(count - 1); throws the exception of the lowest task that threw. Waits for tasks, not
    // for threads: one that gets no core is not missed.
    template <class Task> void run(int count, const Task& task) {
        start(count, &task, [](const void* work, int i) { (*static_cast<const Task*>(work))(i); });
    }

  private:
    using Call = void (*)(const void*, int);
    void start(int count, const void* task, Call call);
    void work();
    void serve();
    // Returns once value is no longer what it was.
    static void wait(const std::atomic<int>& value, int was);

    std::vector<std::thread> threads;
    // Tasks that nobody has taken yet, and above these 32 bits the number of the run: who looked at an earlier
    // one takes none.
    std::atomic<std::uint64_t> open{0};
    std::atomic<int> done{0}, generation{0};
    std::atomic<bool> stopping{false};
    // Of this run; they hold for whoever has taken a task of it.
    std::atomic<int> tasks{0};
    std::atomic<const void*> work_item{nullptr};
    std::atomic<Call> work_call{nullptr};
    std::mutex mutex;  // of what follows
    int failed_task = 0;
    std::exception_ptr failure;
};

}  // namespace grit::mpm
