// SPDX-License-Identifier: BSD-3-Clause
// A workbook made of its parts.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <map>
#include <string>

#include <gtest/gtest.h>
#include <zip.h>

using Parts = std::map<std::string, std::string>;

class Book {
  public:
    explicit Book(const Parts& parts,
                  const std::filesystem::path& place = std::filesystem::temp_directory_path() /
                                                       ("grit_workbook_" +
                                                        std::to_string(getpid()) + ".xlsx"))
        : path(place) {
        std::filesystem::remove(path);
        zip_t* zip = zip_open(path.c_str(), ZIP_CREATE, nullptr);
        for (const auto& [name, text] : parts)
            zip_file_add(zip, name.c_str(), zip_source_buffer(zip, text.data(), text.size(), 0), 0);
        EXPECT_EQ(zip_close(zip), 0);
    }
    ~Book() { std::filesystem::remove(path); }
    Book(const Book&) = delete;
    Book& operator=(const Book&) = delete;

    const std::filesystem::path path;
};
