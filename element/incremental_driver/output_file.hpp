// SPDX-License-Identifier: BSD-3-Clause
// The table that incrementalDriver writes.
#pragma once

#include <filesystem>
#include <string>

#include "element/atomic_file.hpp"
#include "element/record.hpp"

namespace incremental_driver {

// Columns of equal width: time(1) time(2) stran(1..6) stress(1..6) statev(1..nstatv), tension positive,
// 11 22 33 12 13 23, engineering shear. Throws element::CannotWrite.
class OutputFile {
  public:
    OutputFile(const std::filesystem::path& path, const std::string& heading, int nstatv);

    void row(const element::Record& record);
    void complete() { file.complete(); }
    long rows() const { return count; }

  private:
    element::AtomicFile file;
    long count = 0;
};

}  // namespace incremental_driver
