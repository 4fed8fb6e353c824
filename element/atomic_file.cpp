// SPDX-License-Identifier: BSD-3-Clause
#include "element/atomic_file.hpp"

#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <random>
#include <system_error>

namespace element {
namespace {

namespace fs = std::filesystem;

// Fixed memory, for a signal handler may not allocate. Names that do not fit are removed by their
// destructors alone.
struct Slot {
    std::atomic<bool> taken{false}, listed{false};
    std::array<char, 4096> name{};
};
std::array<Slot, 32> slots;

int list(const fs::path& path) {
    const std::string& name = path.native();
    for (std::size_t i = 0; i < slots.size() && name.size() < slots[i].name.size(); ++i) {
        if (slots[i].taken.exchange(true)) continue;
        std::strcpy(slots[i].name.data(), name.c_str());
        slots[i].listed = true;
        return static_cast<int>(i);
    }
    return -1;
}

void unlist(int slot) {
    if (slot < 0) return;
    slots[static_cast<std::size_t>(slot)].listed = false;
    slots[static_cast<std::size_t>(slot)].taken = false;
}

constexpr std::size_t token_length = 16;

// "NAME.0123456789abcdef.part": no two programs write to the same.
std::string name_beside(const std::string& name) {
    std::random_device random;
    char token[token_length + 1];
    std::snprintf(token, sizeof token, "%08x%08x", random(), random());
    return name + '.' + token + ".part";
}

bool is_name_beside(std::string_view name, std::string_view of) {
    constexpr std::string_view end = ".part";
    if (name.size() != of.size() + 1 + token_length + end.size() || !name.starts_with(of) ||
        name[of.size()] != '.' || !name.ends_with(end))
        return false;
    const std::string_view token = name.substr(of.size() + 1, token_length);
    return token.find_first_not_of("0123456789abcdef") == token.npos;
}

[[noreturn]] void fail(const fs::path& place, int error) {
    throw CannotWrite(place.string() +
                      ": cannot write this file: " + std::generic_category().message(error));
}

}  // namespace

void remove_incomplete_files() noexcept {
    for (const Slot& slot : slots)
        if (slot.listed) unlink(slot.name.data());
}

void remove_left_behind(const fs::path& place) noexcept try {
    for (const fs::directory_entry& entry :
         fs::directory_iterator(fs::absolute(place).parent_path()))
        if (is_name_beside(entry.path().filename().native(), place.filename().native()))
            fs::remove(entry.path());
} catch (const std::exception&) {
    return;  // they are in nobody's way
}

AtomicPath::AtomicPath(fs::path destination) : place(std::move(destination)), beside(place) {
    beside.replace_filename(name_beside(place.filename().string()));
    beside = fs::absolute(beside);  // whatever a library does to the current folder
    slot = list(beside);
}

AtomicPath::~AtomicPath() {
    std::error_code nobody_is_left_to_ask;
    if (!beside.empty()) fs::remove(beside, nobody_is_left_to_ask);
    unlist(slot);
}

void AtomicPath::complete() {
    std::error_code refused;
    fs::rename(beside, place, refused);
    if (refused) fail(place, refused.value());
    beside.clear();
    unlist(slot);
    slot = -1;
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

void AtomicFile::complete() {
    flush();
    const bool closed = std::fclose(file) == 0;
    file = nullptr;
    if (!closed) fail(name.destination(), errno);
    name.complete();
}

}  // namespace element
