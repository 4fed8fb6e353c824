// SPDX-License-Identifier: BSD-3-Clause
// The table that incrementalDriver writes.
#pragma once

#include <cstdio>
#include <filesystem>
#include <string>

#include "element/record.hpp"

namespace incremental_driver {

// Written beside its place and renamed when complete; removed if that never happens. Columns of equal
// width: time(1) time(2) stran(1..6) stress(1..6) statev(1..nstatv), tension positive, 11 22 33 12 13 23,
// engineering shear. Throws std::filesystem::filesystem_error.
class OutputFile {
  public:
    OutputFile(const std::filesystem::path& path, const std::string& heading, int nstatv);
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;
    ~OutputFile();

    void row(const element::Record& record);
    void complete();
    int rows() const { return count; }

  private:
    [[noreturn]] void fail() const;

    std::filesystem::path place, aside;
    std::FILE* file = nullptr;
    int count = 0;
};

}  // namespace incremental_driver
