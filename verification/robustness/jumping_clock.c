/* SPDX-License-Identifier: BSD-3-Clause
 * To be preloaded: clocks as on a machine whose time is set, by years and back, and which sleeps for an hour now and then.
 *   JUMPING_SEED    other jumps
 *   JUMPING_COUNT   a file that gets how many times clocks were read */
#define _GNU_SOURCE
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

static _Atomic uint64_t state = 1, calls;
static _Atomic int64_t slept;

static uint64_t draw(void) {
    state += 0x9e3779b97f4a7c15ULL;
    const uint64_t x = state;
    const uint64_t y = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    return y ^ (y >> 31);
}

static __attribute__((constructor)) void read_settings(void) {
    const char* seed = getenv("JUMPING_SEED");
    if (seed) state = strtoull(seed, NULL, 10);
}

static __attribute__((destructor)) void write_count(void) {
    const char* name = getenv("JUMPING_COUNT");
    FILE* file = name ? fopen(name, "w") : NULL;
    if (!file) return;
    fprintf(file, "%llu\n", (unsigned long long)calls);
    fclose(file);
}

int clock_gettime(clockid_t clock, struct timespec* at) {
    const int status = (int)syscall(SYS_clock_gettime, clock, at);
    ++calls;
    if (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE) {
        at->tv_sec += (time_t)(draw() % 600000000) - 300000000;
    } else if (clock == CLOCK_MONOTONIC) {
        if (draw() % 64 == 0) slept += (int64_t)(draw() % 3600);
        at->tv_sec += (time_t)slept;
    }
    return status;
}

int gettimeofday(struct timeval* restrict at, void* restrict zone) {
    struct timespec now;
    (void)zone;
    clock_gettime(CLOCK_REALTIME, &now);
    at->tv_sec = now.tv_sec;
    at->tv_usec = now.tv_nsec / 1000;
    return 0;
}

time_t time(time_t* at) {
    struct timespec now;
    clock_gettime(CLOCK_REALTIME, &now);
    if (at) *at = now.tv_sec;
    return now.tv_sec;
}
