// SPDX-License-Identifier: BSD-3-Clause
// What lies in a folder of results: files of one stem belong together.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cli {

struct Finding {
    std::string stem;  // below the folder: "contact/bar_impact"
    std::filesystem::path table, cycles, reference, picture, frames, numbers,
        words;  // .csv, _cycles.csv, _reference.csv, .png or .svg, .pvd, .json, .txt
    std::filesystem::path sand, sand_page;  // NAME_sand.toml and NAME_report.html of grit calibrate
    std::vector<std::filesystem::path> fields;  // NAME_FIELD.png or .svg of grit mpm
    bool shown = false;
};

// In the order of their names, numbers within names by their value. Throws BadInput where there is none.
std::vector<Finding> findings_in(const std::filesystem::path& folder);

// All bytes of a file. Throws BadInput.
std::string content_of(const std::filesystem::path& path);

struct StoryLine {
    int number = 0;  // in its file
    bool heading = false;
    std::string name;      // of results, * stands for anything; or the heading
    std::string sentence;  // about them
};

// Lines "== heading" and "NAME | sentence"; without a file none. Throws BadInput.
std::vector<StoryLine> read_story(const std::filesystem::path& path);

// Pictures NAME_FIELD go to the run NAME, but for those that the story names by all their letters.
void give_pictures_to_runs(std::vector<Finding>& findings, const std::vector<StoryLine>& story);

// Whether the stem, or its last part, is called so.
bool is_called(const Finding& finding, const std::string& name);

}  // namespace cli
