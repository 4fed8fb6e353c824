// SPDX-License-Identifier: BSD-3-Clause
// One run at a time writes a file. Names are locked in a file of the folder that holds them, .grit-lock,
// which is empty, vanishes with its last run and locks nothing if a run was killed.
#pragma once

#include <filesystem>
#include <vector>

namespace element {

class OutputLock {
  public:
    // Files whose folders are there. What killed runs left of them is removed. Throws CannotWrite if
    // another run holds one of them. Where the file system knows no locks there is none.
    explicit OutputLock(const std::vector<std::filesystem::path>& outputs);
    OutputLock(const OutputLock&) = delete;
    OutputLock& operator=(const OutputLock&) = delete;
    ~OutputLock();

  private:
    struct Folder {
        std::filesystem::path lock;
        int file;
        int slot;  // among the names for leave_output_locks
    };
    Folder* open_folder(const std::filesystem::path& folder);
    void release();
    std::vector<Folder> folders;
};

// Removes the files of locks whose destructors will not run. May be called by a signal handler.
void leave_output_locks() noexcept;

}  // namespace element
