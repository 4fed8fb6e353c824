// SPDX-License-Identifier: BSD-3-Clause
// A system that gives no more threads: there is no room for their stacks.
#pragma once

#include <sys/resource.h>
#include <unistd.h>

#include <fstream>

// Until it ends; threads that are there go on.
class RoomForFewThreads {
  public:
    RoomForFewThreads() {
        getrlimit(RLIMIT_AS, &before);
        std::size_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        // Room for numbers, and for a few of the stacks, 8 MiB each.
        const rlim_t now = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
        const rlimit limit{now + (rlim_t{64} << 20), before.rlim_max};
        setrlimit(RLIMIT_AS, &limit);
    }
    ~RoomForFewThreads() { setrlimit(RLIMIT_AS, &before); }
    RoomForFewThreads(const RoomForFewThreads&) = delete;
    RoomForFewThreads& operator=(const RoomForFewThreads&) = delete;

  private:
    rlimit before{};
};
