// SPDX-License-Identifier: BSD-3-Clause
// Files that appear when they are complete: written beside as NAME.TOKEN.part with a token of their own,
// renamed at the end, and removed if it never comes to that, be it by an exception, a signal or a library
// that ends the program.
#pragma once

#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string_view>

namespace element {

// A file cannot be written: its name and why.
struct CannotWrite : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The name beside, for others to write to.
class AsidePath {
  public:
    explicit AsidePath(std::filesystem::path place);
    AsidePath(const AsidePath&) = delete;
    AsidePath& operator=(const AsidePath&) = delete;
    ~AsidePath();

    const std::filesystem::path& path() const { return aside; }
    const std::filesystem::path& destination() const { return place; }
    void complete();  // throws CannotWrite

  private:
    std::filesystem::path place, aside;
    int slot = -1;  // in the list for remove_aside_files
};

class AsideFile {
  public:
    explicit AsideFile(const std::filesystem::path& place);  // throws CannotWrite
    AsideFile(const AsideFile&) = delete;
    AsideFile& operator=(const AsideFile&) = delete;
    ~AsideFile();

    void write(std::string_view text);
    std::FILE* stream() { return file; }
    const std::filesystem::path& path() const { return name.path(); }
    void flush();     // throws CannotWrite
    void complete();  // throws CannotWrite

  private:
    AsidePath name;
    std::FILE* file = nullptr;
};

// Files beside this one that nobody is going to complete, which its caller knows.
void remove_left_behind(const std::filesystem::path& place) noexcept;

// All of this program that are not complete. May be called by a signal handler.
void remove_aside_files() noexcept;

}  // namespace element
