// SPDX-License-Identifier: BSD-3-Clause
// Ends that nobody asked for: a signal, or a foreign UMAT that crashes or ends the program.
#pragma once

#include <string>

namespace cli {

// From now on, files that are not complete are removed however the program ends. SIGINT, SIGTERM and, unless it
// is ignored, SIGHUP stop a run after the increment it is at (see RunGuard), or, asked twice or outside a run, the program.
// A file that grows beyond the limit of the shell is one that cannot be written.
void handle_abnormal_ends();

// While a law is at work. If the program ends under it, one line says so and the exit status is 1.
class RunGuard {
  public:
    // what: "CASE: the UMAT FILE", or "CASE: Grit" for its own law.
    explicit RunGuard(const std::string& what);
    RunGuard(const RunGuard&) = delete;
    RunGuard& operator=(const RunGuard&) = delete;
    ~RunGuard();

    // The last increment that went well.
    static void done(long step, int increment);
    // Somebody has asked to stop.
    static bool interrupted();
};

}  // namespace cli
