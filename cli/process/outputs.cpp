// SPDX-License-Identifier: BSD-3-Clause
#include "cli/process/outputs.hpp"

#include <unistd.h>

#include <cerrno>
#include <system_error>

#include <fmt/format.h>

#include "cli/process/exit_code.hpp"

namespace cli {

namespace fs = std::filesystem;

void Outputs::add(const fs::path& path, const std::string& by) {
    const auto [owner, is_new] = owners.emplace(path.lexically_normal(), by);
    if (!is_new)
        throw BadInput(fmt::format("{} would be written by {} and by {}: set name", path.string(),
                                   owner->second, by));
    if (fs::is_directory(path))
        throw BadInput(fmt::format("{}: cannot write this file: it is a folder", path.string()));
}

void Outputs::spare(const std::vector<fs::path>& inputs) const {
    std::error_code ignored;
    for (const auto& [output, owner] : owners)
        for (const fs::path& input : inputs)
            if (fs::equivalent(output, input, ignored))
                throw BadInput(fmt::format("{}: {} would overwrite this file: set name, or --out",
                                           input.string(), owner));
}

std::unique_ptr<element::OutputLock> Outputs::lock() const {
    std::vector<fs::path> all;
    for (const auto& [output, owner] : owners) {
        make_output_folder(output.parent_path());
        all.push_back(output);
    }
    return std::make_unique<element::OutputLock>(all);
}

void make_output_folder(const fs::path& folder) {
    std::error_code refused;
    if (!folder.empty()) fs::create_directories(folder, refused);
    if (refused)
        throw BadInput(
            fmt::format("{}: cannot make this folder: {}", folder.string(), refused.message()));
    if (access(folder.empty() ? "." : folder.c_str(), W_OK | X_OK) != 0)
        throw BadInput(fmt::format("{}: cannot write to this folder: {}", folder.string(),
                                   std::generic_category().message(errno)));
}

}  // namespace cli
