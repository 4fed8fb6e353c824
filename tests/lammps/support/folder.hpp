// SPDX-License-Identifier: BSD-3-Clause
// A folder in which programs run, and which vanishes with the test.
#pragma once

#include <filesystem>
#include <string>

struct Answer {
    int status = -1;   // of the program
    std::string text;  // stdout and stderr
    bool says(const std::string& words) const { return text.find(words) != std::string::npos; }
};

class Folder {
  public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    void write(const std::string& name, const std::string& text) const;
    std::string read(const std::string& name) const;
    Answer run(const std::string& command) const;
    const std::filesystem::path& path() const { return place; }

  private:
    std::filesystem::path place;
};
