// SPDX-License-Identifier: BSD-3-Clause
#include "cli/process/abnormal_end.hpp"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

#include "cli/process/exit_code.hpp"
#include "element/atomic_file.hpp"
#include "element/output_lock.hpp"

namespace cli {
namespace {

// All that the handlers look at. They may not allocate, nor trust the state of the program.
std::array<char, 1024> culprit;
volatile sig_atomic_t running = 0, asked_to_stop = 0;
volatile long last_step = 0;
volatile int last_increment = 0;
volatile double asked_at = 0.0;             // [s]
std::array<char, 65536> stack_of_handlers;  // for a stack that overflows

void say_where(const char* how) {
    std::array<char, 1400> line{};
    const int length =
        std::snprintf(line.data(), line.size(), "\ngrit: %s %s after step %ld, increment %d\n",
                      culprit.data(), how, last_step, last_increment);
    if (write(STDERR_FILENO, line.data(), static_cast<std::size_t>(length)) < 0) return;
}

void remove_unfinished() {
    element::remove_incomplete_files();
    element::leave_output_locks();
}

void at_exit() {
    if (!running) return;
    say_where("ended the program (exit or STOP)");
    remove_unfinished();
    _exit(failed_computation);
}

void at_crash(int signal) {
    const char* how = signal == SIGSEGV   ? "crashed (segmentation fault)"
                      : signal == SIGFPE  ? "crashed (floating-point or integer exception)"
                      : signal == SIGABRT ? "aborted the program"
                                          : "crashed (bus error or illegal instruction)";
    if (running) say_where(how);
    remove_unfinished();
    if (running) _exit(failed_computation);
    ::signal(signal, SIG_DFL);
    raise(signal);
}

double seconds_now() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Asked twice, it drops everything. A terminal that goes, and timeout, send one signal twice in no time.
void at_interrupt(int signal) {
    const double now = seconds_now();
    if (running && !asked_to_stop) {
        asked_to_stop = 1;
        asked_at = now;
        return;
    }
    if (running && now - asked_at < (signal == SIGINT ? 0.1 : 2.0)) return;
    remove_unfinished();
    _exit(128 + signal);
}

// By the keyboard, to see where a program is: with the files of others only.
void at_quit(int signal) {
    remove_unfinished();
    ::signal(signal, SIG_DFL);
    raise(signal);
}

bool is_ignored(int signal) {
    struct sigaction now {};
    return sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

void handle(int signal, void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = SA_ONSTACK;
    sigaction(signal, &action, nullptr);
}

}  // namespace

void handle_abnormal_ends() {
    stack_t stack{};
    stack.ss_sp = stack_of_handlers.data();
    stack.ss_size = stack_of_handlers.size();
    sigaltstack(&stack, nullptr);
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) handle(signal, at_crash);
    for (const int signal : {SIGINT, SIGTERM}) handle(signal, at_interrupt);
    if (!is_ignored(SIGHUP)) handle(SIGHUP, at_interrupt);  // nohup: the terminal may go
    handle(SIGQUIT, at_quit);
    // A file that may not grow and a reader that went away are errors of who writes.
    for (const int signal : {SIGXFSZ, SIGPIPE}) handle(signal, SIG_IGN);
    std::atexit(at_exit);
}

RunGuard::RunGuard(const std::string& what) {
    std::strncpy(culprit.data(), what.c_str(), culprit.size() - 1);
    done(0, 0);
    asked_to_stop = 0;
    running = 1;
}

RunGuard::~RunGuard() { running = 0; }

void RunGuard::done(long step, int increment) {
    last_step = step;
    last_increment = increment;
}

bool RunGuard::interrupted() { return asked_to_stop != 0; }

}  // namespace cli
