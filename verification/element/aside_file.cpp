// SPDX-License-Identifier: BSD-3-Clause
#include "element/aside_file.hpp"

#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
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

[[noreturn]] void fail(const fs::path& place, int error) {
    throw CannotWrite(place.string() +
                      ": cannot write this file: " + std::generic_category().message(error));
}

}  // namespace

void remove_aside_files() noexcept {
    for (const Slot& slot : slots)
        if (slot.listed) unlink(slot.name.data());
}

AsidePath::AsidePath(fs::path destination) : place(std::move(destination)), aside(place) {
    aside += ".part";
    aside = fs::absolute(aside);  // whatever a library does to the current folder
    slot = list(aside);
}

AsidePath::~AsidePath() {
    std::error_code nobody_is_left_to_ask;
    if (!aside.empty()) fs::remove(aside, nobody_is_left_to_ask);
    unlist(slot);
}

void AsidePath::complete() {
    std::error_code refused;
    fs::rename(aside, place, refused);
    if (refused) fail(place, refused.value());
    aside.clear();
    unlist(slot);
    slot = -1;
}

AsideFile::AsideFile(const fs::path& place) : name(place) {
    file = std::fopen(name.path().c_str(), "w");
    if (!file) fail(place, errno);
}

AsideFile::~AsideFile() {
    if (file) std::fclose(file);
}

void AsideFile::write(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), file) != text.size())
        fail(name.destination(), errno);
}

void AsideFile::flush() {
    if (std::fflush(file) != 0 || std::ferror(file) != 0) fail(name.destination(), errno);
}

void AsideFile::complete() {
    flush();
    const bool closed = std::fclose(file) == 0;
    file = nullptr;
    if (!closed) fail(name.destination(), errno);
    name.complete();
}

}  // namespace element
