// SPDX-License-Identifier: BSD-3-Clause
// Memory per particle, nodes included: what the process holds, and the most it held during five steps, with
// 10^6 particles less that with 10^5. Prints lines of JSON.
#include <malloc.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>

#include "mpm_column.hpp"

namespace {

using namespace benchmarks;

// A line of /proc/self/status [bytes].
double status(const std::string& key) {
    std::ifstream file("/proc/self/status");
    for (std::string word; file >> word;)
        if (double kilobytes; word == key + ":" && file >> kilobytes) return 1024.0 * kilobytes;
    throw std::runtime_error("no " + key + " in /proc/self/status");
}

struct Held {
    double particles, resident, peak;  // [bytes]
};

Held measure(bool sand, int cells_r) {
    const grit::mpm::BuiltCase built = column({cells_r, sand});
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << "5";  // the peak starts here
    for (int i = 0; i < 5; ++i) built.simulation->step();
    return {16.0 * cells_r * cells_r, status("VmRSS"), status("VmHWM")};
}

}  // namespace

int main() {
    mallopt(M_MMAP_THRESHOLD, 65536);  // what is freed goes back
    for (const bool sand : {false, true}) {
        const Held few = measure(sand, 79), many = measure(sand, 250);
        const double particles = many.particles - few.particles;
        std::printf("{\"material\": \"%s\", \"resident_bytes_per_particle\": %.0f, "
                    "\"peak_bytes_per_particle\": %.0f}\n",
                    sand ? "sand" : "elastic", (many.resident - few.resident) / particles,
                    (many.peak - few.peak) / particles);
        std::fflush(stdout);
    }
}
