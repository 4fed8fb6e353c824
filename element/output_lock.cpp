// SPDX-License-Identifier: BSD-3-Clause
#include "element/output_lock.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <string_view>
#include <system_error>

#include "element/atomic_file.hpp"
#include "element/signal_safe_names.hpp"

namespace element {
namespace {

namespace fs = std::filesystem;

// Locks of an open file, not of a process, where there are any: closing another copy releases nothing.
#ifdef F_OFD_SETLK
constexpr int set_lock = F_OFD_SETLK, get_lock = F_OFD_GETLK;
#else
constexpr int set_lock = F_SETLK, get_lock = F_GETLK;
#endif

enum class Answer { taken, held_by_another, another_leaves, no_locks_here };

Answer lock_bytes(int file, off_t first, off_t count) {
    struct flock range {};
    range.l_type = F_WRLCK;
    range.l_whence = SEEK_SET;
    range.l_start = first;
    range.l_len = count;
    if (fcntl(file, set_lock, &range) == 0) return Answer::taken;
    if (errno != EACCES && errno != EAGAIN) return Answer::no_locks_here;
    // All of the file is held by one that leaves, for a moment: see remove_if_last.
    if (fcntl(file, get_lock, &range) == 0 &&
        (range.l_type == F_UNLCK || (range.l_start == 0 && range.l_len == 0)))
        return Answer::another_leaves;
    return Answer::held_by_another;
}

Answer lock_all(int file) { return lock_bytes(file, 0, 0); }

// What does not fit stays behind, empty.
constinit SignalSafeNames<8> held_locks;

// FNV-1a. A byte of the lock file stands for a name; it need not be there to be locked.
off_t byte_of(std::string_view name) {
    std::uint64_t hash = 14695981039346656037u;
    for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
    return static_cast<off_t>(hash >> 2);
}

// Who had it open last may have removed it meanwhile.
bool is_still(int file, const char* path) {
    struct stat opened {
    }, named{};
    return fstat(file, &opened) == 0 && stat(path, &named) == 0 && opened.st_ino == named.st_ino &&
           opened.st_dev == named.st_dev;
}

// Who holds all of the file is alone with it, and nobody takes it before the name is gone.
void remove_if_last(int file, const char* path) noexcept {
    if (lock_all(file) == Answer::taken && is_still(file, path)) unlink(path);
}

fs::path folder_of(const fs::path& output) { return fs::absolute(output).parent_path(); }

}  // namespace

OutputLock::Folder* OutputLock::open_folder(const fs::path& folder) {
    for (Folder& known : folders)
        if (known.lock.parent_path() == folder) return &known;
    const fs::path path = folder / ".grit-lock";
    const int file = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file < 0) return nullptr;
    folders.push_back({path, file, held_locks.add(path, file)});
    return &folders.back();
}

OutputLock::OutputLock(const std::vector<fs::path>& outputs) {
    int attempts = 1000;  // where names and files never agree, there is no lock
    for (std::size_t i = 0; i < outputs.size();) {
        Folder* folder = open_folder(folder_of(outputs[i]));
        const Answer answer =
            folder ? lock_bytes(folder->file, byte_of(outputs[i].filename().native()), 1)
                   : Answer::no_locks_here;
        if (answer == Answer::another_leaves && attempts-- > 0) {
            release();
            usleep(1000);
            i = 0;
            continue;
        }
        if (answer == Answer::held_by_another || answer == Answer::another_leaves) {
            release();
            throw CannotWrite(outputs[i].string() +
                              ": another run of grit is writing this file: wait for its end, or "
                              "write to another folder");
        }
        if (answer == Answer::taken && !is_still(folder->file, folder->lock.c_str()) &&
            attempts-- > 0) {
            release();
            i = 0;
            continue;
        }
        if (answer == Answer::taken) remove_left_behind(outputs[i]);
        ++i;
    }
}

void OutputLock::release() {
    for (const Folder& folder : folders) {
        held_locks.remove(folder.slot);
        remove_if_last(folder.file, folder.lock.c_str());
        close(folder.file);
    }
    folders.clear();
}

OutputLock::~OutputLock() { release(); }

void leave_output_locks() noexcept {
    held_locks.for_each([](const char* path, int file) { remove_if_last(file, path); });
}

}  // namespace element
