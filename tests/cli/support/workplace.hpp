// SPDX-License-Identifier: BSD-3-Clause
// A folder in which the program grit runs, and which vanishes with the test.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

struct Answer {
    int status = -1;   // of the program, 128 + signal if it died of one
    std::string text;  // stdout and stderr

    bool says(const std::string& words) const { return text.find(words) != std::string::npos; }
};

using Values = std::vector<double>;

class Workplace {
  public:
    Workplace();
    ~Workplace();
    Workplace(const Workplace&) = delete;
    Workplace& operator=(const Workplace&) = delete;

    void write(const std::string& name, const std::string& text) const;
    // Lausitz sand at 100 kPa, e 0.6, and these stages, as NAME.toml.
    void write_case(const std::string& name, const std::string& stages) const;
    // grit with these arguments, in the folder.
    Answer grit(const std::string& arguments) const;
    // The same in the background, sent this signal 0.2 s after it has written this file anew: by default the lock that
    // a run into the folder out begins with. The shell does these commands first.
    Answer interrupted(const std::string& arguments, const std::string& signal,
                       const std::string& file = "out/.grit-lock",
                       const std::string& first = "true") const;
    // grit element on NAME.toml, without pictures, into the folder out.
    Answer run(const std::string& name, const std::string& options = "") const;
    // Columns of out/NAME.csv by name without unit.
    std::map<std::string, Values> result(const std::string& name) const;
    std::string text(const std::string& name) const;
    std::set<std::string> files(const std::string& below = ".") const;
    std::filesystem::path path(const std::string& name) const { return place / name; }

  private:
    std::filesystem::path place;
};

// A text with all of one word replaced by another.
inline std::string replaced(std::string text, const std::string& old, const std::string& by) {
    for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos; at += by.size())
        text.replace(at, old.size(), by);
    return text;
}
