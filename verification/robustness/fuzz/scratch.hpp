// SPDX-License-Identifier: BSD-3-Clause
// A folder in memory for readers that take files; it vanishes with the program.
#pragma once

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

namespace fuzz {

class Scratch {
  public:
    Scratch() {
        std::string pattern = std::filesystem::exists("/dev/shm") ? "/dev/shm/grit_fuzz_XXXXXX"
                                                                  : "/tmp/grit_fuzz_XXXXXX";
        if (!mkdtemp(pattern.data()))
            throw std::system_error(errno, std::generic_category(), pattern);
        folder = pattern;
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    ~Scratch() {
        std::error_code nobody_asks;
        std::filesystem::remove_all(folder, nobody_asks);
    }
    std::filesystem::path write(const char* name, std::string_view text) const {
        std::filesystem::path out = folder / name;
        std::ofstream file(out, std::ios::binary);
        file << text << std::flush;
        if (!file) throw std::system_error(errno, std::generic_category(), out.string());
        return out;
    }
    const std::filesystem::path& path() const { return folder; }

  private:
    std::filesystem::path folder;
};

// One for the program.
inline const Scratch& scratch() {
    static const Scratch one;
    return one;
}

// Parts of a text that lines of '=' separate, at most n.
inline std::string part_of(const std::string& text, std::size_t number) {
    const std::string cut = "\n====\n";
    std::size_t from = 0;
    for (; number > 0; --number) {
        from = text.find(cut, from);
        if (from == std::string::npos) return "";
        from += cut.size();
    }
    return text.substr(from, text.find(cut, from) - from);
}

}  // namespace fuzz
