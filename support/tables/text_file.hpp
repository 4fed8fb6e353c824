// SPDX-License-Identifier: BSD-3-Clause
// Whole files of text, of which none is too long to be one: a device without end ends as an error.
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace grit {

// What is wrong with a file: its name and why.
struct TextFileError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

constexpr std::size_t megabyte = std::size_t{1} << 20;
constexpr std::size_t longest_case = 64 * megabyte;     // a file that people write
constexpr std::size_t longest_table = 1024 * megabyte;  // a file that machines write
constexpr std::size_t longest_line = megabyte;          // of a table

// At most so many bytes. Throws TextFileError.
inline std::string read_text_file(const std::filesystem::path& path, std::size_t longest) {
    std::ifstream file(path, std::ios::binary);
    if (!file || std::filesystem::is_directory(path))
        throw TextFileError(path.string() + ": cannot read this file");
    std::string out;
    while (file) {
        const std::size_t before = out.size();
        if (before > longest)
            throw TextFileError(path.string() + ": is longer than " +
                                std::to_string(longest / megabyte) + " MiB, the most that is read");
        // Twice as much each time, up to one byte too many.
        out.resize(std::min(std::max<std::size_t>(2 * before, 4096), longest + 1));
        file.read(out.data() + before, static_cast<std::streamsize>(out.size() - before));
        out.resize(before + static_cast<std::size_t>(file.gcount()));
    }
    return out;
}

// Line after line, without their ends.
class TextLines {
  public:
    explicit TextLines(const std::string& whole) : text(whole) {}
    // The next one; false: there is none. Longer ones are cut behind longest_line + 1 letters.
    bool next(std::string& line) {
        if (at >= text.size()) return false;
        const std::size_t end = std::min(text.find('\n', at), text.size());
        line.assign(text, at, std::min(end - at, longest_line + 1));
        at = end + 1;
        return true;
    }

  private:
    const std::string& text;
    std::size_t at = 0;
};

}  // namespace grit
