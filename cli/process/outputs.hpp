// SPDX-License-Identifier: BSD-3-Clause
// Files that a command is going to write, known before it computes anything.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "element/output_lock.hpp"

namespace cli {

class Outputs {
  public:
    // by: which case wants it. Throws BadInput if another case does too, or if it is a folder.
    void add(const std::filesystem::path& path, const std::string& by);
    // Throws BadInput if one of these would be overwritten.
    void spare(const std::vector<std::filesystem::path>& inputs) const;

    // Make their folders, as below, and keep other runs from writing them as long as it lives.
    // Throws element::CannotWrite if another run does.
    std::unique_ptr<element::OutputLock> lock() const;

  private:
    std::map<std::filesystem::path, std::string> owners;
};

// Make a folder for output. Throws BadInput if it cannot be made or written to.
void make_output_folder(const std::filesystem::path& folder);

}  // namespace cli
