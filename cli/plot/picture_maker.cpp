// SPDX-License-Identifier: BSD-3-Clause
#include "cli/plot/picture_maker.hpp"

#include <cstdio>

#include <fmt/format.h>

#include "cli/process/standard_streams.hpp"
#include "element/atomic_file.hpp"

namespace cli {

void PictureMaker::draw(const std::string& name, const Picture& picture) {
    if (!problem.empty()) return;
    try {
        problem = cli::draw(folder / name, picture);
    } catch (const element::CannotWrite& error) {
        problem = error.what();
        broken = true;
    }
    if (!problem.empty()) warn("grit: no picture: {}\n", problem);
    else if (!quiet) say("picture: {} and .png\n", (folder / (name + ".svg")).string());
}

}  // namespace cli
