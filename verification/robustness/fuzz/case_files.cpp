// SPDX-License-Identifier: BSD-3-Clause
// Files in TOML that people write: cases of grit element and grit mpm, sands, calibrations. The first letter says which. What
// stands behind a line "====" is the file "other", which they may name: a base, a sand, a table, a surface.
#include <cstdint>
#include <stdexcept>
#include <string>

#include <adapters/mpm/case/build_case.hpp>

#include "cli/calibrate/calibration_case.hpp"
#include "cli/element/case_file.hpp"
#include "cli/mpm/case_file.hpp"
#include "cli/process/exit_code.hpp"
#include "cli/sand/sand_file.hpp"
#include "robustness/fuzz/refusal.hpp"
#include "robustness/fuzz/scratch.hpp"

namespace {

// Other files of the machine are nobody's business here, and libraries are not to be loaded.
bool reaches_out(const std::string& text) {
    return text.find('/') != std::string::npos || text.find("library") != std::string::npos ||
           text.find('\\') != std::string::npos;
}

void read(char kind, const std::filesystem::path& path) {
    switch (kind) {
        case 'm': {
            const cli::MpmCaseFile file = cli::read_mpm_case(path);
            grit::mpm::build_case(file.plan);
            break;
        }
        case 's': cli::read_sand_file(path); break;
        case 'c': cli::read_calibration_case(path); break;
        default: cli::read_case_file(path, {});
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 2) return -1;
    const std::string text(reinterpret_cast<const char*>(data) + 2, size - 2);
    if (reaches_out(text)) return -1;
    // Whoever reads "base" comes back to the file itself, at the most.
    fuzz::scratch().write("other", fuzz::part_of(text, 1));
    const std::filesystem::path path = fuzz::scratch().write("case.toml", fuzz::part_of(text, 0));
    try {
        read(static_cast<char>(data[0]), path);
    } catch (const cli::BadInput& refused) {
        fuzz::refusal = refused.what();
    } catch (const std::invalid_argument& refused) {
        fuzz::refusal = refused.what();
    }
    return 0;
}
