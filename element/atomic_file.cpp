// SPDX-License-Identifier: BSD-3-Clause
#include "element/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <random>
#include <string>
#include <system_error>
#include <utility>

#include "element/signal_safe_names.hpp"

namespace element {
namespace {

namespace fs = std::filesystem;

// Names that do not fit are removed by their destructors alone.
constinit SignalSafeNames<32> incomplete_files;

constexpr std::size_t token_length = 16;

// "NAME.0123456789abcdef.part": no two programs write to the same.
std::string name_beside(const std::string& name) {
    std::random_device random;
    char token[token_length + 1];
    std::snprintf(token, sizeof token, "%08x%08x", random(), random());
    return name + '.' + token + ".part";
}

[[noreturn]] void fail(const fs::path& place, int error) {
    throw CannotWrite(place.string() +
                      ": cannot write this file: " + std::generic_category().message(error));
}

}  // namespace

void remove_incomplete_files() noexcept {
    incomplete_files.for_each([](const char* name, int) { unlink(name); });
}

std::string name_when_complete(const std::string& name) {
    constexpr std::string_view end = ".part";
    if (!name.ends_with(end) || name.size() <= 1 + token_length + end.size()) return {};
    const std::size_t length = name.size() - end.size() - token_length - 1;
    const std::string token = name.substr(length + 1, token_length);
    const bool is_one =
        name[length] == '.' && token.find_first_not_of("0123456789abcdef") == token.npos;
    return is_one ? name.substr(0, length) : "";
}

void remove_left_behind(const fs::path& place) noexcept try {
    for (const fs::directory_entry& entry :
         fs::directory_iterator(fs::absolute(place).parent_path()))
        if (name_when_complete(entry.path().filename()) == place.filename())
            fs::remove(entry.path());
} catch (const std::exception&) {
    return;  // they are in nobody's way
}

AtomicPath::AtomicPath(fs::path destination) : place(std::move(destination)), beside(place) {
    beside.replace_filename(name_beside(place.filename().string()));
    beside = fs::absolute(beside);  // whatever a library does to the current folder
    slot = incomplete_files.add(beside);
}

AtomicPath::~AtomicPath() {
    std::error_code nobody_is_left_to_ask;
    if (!beside.empty()) fs::remove(beside, nobody_is_left_to_ask);
    incomplete_files.remove(slot);
}

void AtomicPath::complete() {
    std::error_code refused;
    fs::rename(beside, place, refused);
    if (refused) fail(place, refused.value());
    beside.clear();
    incomplete_files.remove(slot);
    slot = -1;
}

void AtomicPath::complete_as(fs::path other) {
    place = std::move(other);
    complete();
}

AtomicFile::AtomicFile(const fs::path& place) : name(place) {
    file = std::fopen(name.path().c_str(), "wx");
    if (!file) fail(place, errno);
}

AtomicFile::~AtomicFile() {
    if (file) std::fclose(file);
}

void AtomicFile::write(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), file) != text.size())
        fail(name.destination(), errno);
}

void AtomicFile::flush() {
    if (std::fflush(file) != 0 || std::ferror(file) != 0) fail(name.destination(), errno);
}

void AtomicFile::complete_on_disk() {
    flush();
    const fs::path place = name.destination();
    // Some file systems know no such call.
    if (fsync(fileno(file)) != 0 && errno != EINVAL && errno != EROFS) fail(place, errno);
    complete();
    const fs::path folder = fs::absolute(place).parent_path();
    const int handle = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (handle < 0) return;
    fsync(handle);  // the file itself is complete, whatever this says
    close(handle);
}

bool AtomicFile::keep_lines(const fs::path& other) noexcept try {
    if (file) std::fclose(std::exchange(file, nullptr));
    std::ifstream in(name.path(), std::ios::binary);
    std::uintmax_t whole = 0, at = 0;
    for (char c; in.get(c);)
        if (++at, c == '\n') whole = at;
    in.close();
    if (whole == 0) return false;
    fs::resize_file(name.path(), whole);
    name.complete_as(other);
    return true;
} catch (const std::exception&) {
    return false;
}

void AtomicFile::complete() {
    flush();
    const bool closed = std::fclose(file) == 0;
    file = nullptr;
    if (!closed) fail(name.destination(), errno);
    name.complete();
}

}  // namespace element
