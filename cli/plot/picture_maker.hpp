// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "cli/plot/picture.hpp"

namespace cli {

// Draws the pictures of a run. They end no computation: the first problem is said on stderr, and nothing is drawn any
// more. That there is no gnuplot is no failure.
class PictureMaker {
  public:
    PictureMaker(std::filesystem::path where, bool no_words)
        : folder(std::move(where)), quiet(no_words) {}

    // name: without ending.
    void draw(const std::string& name, const Picture& picture);
    bool failed() const { return broken; }

  private:
    std::filesystem::path folder;
    bool quiet;
    std::string problem;
    bool broken = false;
};

}  // namespace cli
