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
class AtomicPath {
  public:
    explicit AtomicPath(std::filesystem::path place);
    AtomicPath(const AtomicPath&) = delete;
    AtomicPath& operator=(const AtomicPath&) = delete;
    ~AtomicPath();

    const std::filesystem::path& path() const { return beside; }
    const std::filesystem::path& destination() const { return place; }
    void complete();  // throws CannotWrite
    void complete_as(std::filesystem::path other);

  private:
    std::filesystem::path place, beside;
    int slot = -1;  // among the names for remove_incomplete_files
};

class AtomicFile {
  public:
    explicit AtomicFile(const std::filesystem::path& place);  // throws CannotWrite
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;
    ~AtomicFile();

    void write(std::string_view text);
    std::FILE* stream() { return file; }
    const std::filesystem::path& path() const { return name.path(); }
    void flush();     // throws CannotWrite
    void complete();  // throws CannotWrite
    // ... and not before the disk has it, so that it survives the power.
    void complete_on_disk();
    // What has been written, up to its last whole line, as another file; this one is none any more. False: it cannot be.
    bool keep_lines(const std::filesystem::path& other) noexcept;

  private:
    AtomicPath name;
    std::FILE* file = nullptr;
};

// Files beside this one that nobody is going to complete, which its caller knows.
void remove_left_behind(const std::filesystem::path& place) noexcept;
// Of the name of a file that is not complete the one that it is to get, else empty.
std::string name_when_complete(const std::string& name);

// All of this program that are not complete. May be called by a signal handler.
void remove_incomplete_files() noexcept;

}  // namespace element
