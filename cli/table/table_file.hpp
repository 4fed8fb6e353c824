// SPDX-License-Identifier: BSD-3-Clause
// A CSV written row by row.
#pragma once

#include "cli/table/table.hpp"
#include "element/atomic_file.hpp"

namespace cli {

// Comments, a header "name [unit],...", rows, comments. It appears when it is complete. Throws
// element::CannotWrite.
class TableFile {
  public:
    // Names and units of the columns alone.
    TableFile(const std::filesystem::path& path, const std::vector<std::string>& comments,
              const std::vector<Column>& columns);

    void row(const std::vector<double>& values);
    void comment(const std::string& text);
    void flush() { file.flush(); }
    void complete() { file.complete(); }
    void complete_on_disk() { file.complete_on_disk(); }
    // Where it cannot be completed: what is there of it, in whole lines, as another file. False: it cannot.
    bool keep_rows(const std::filesystem::path& place) { return file.keep_lines(place); }

  private:
    element::AtomicFile file;
};

void write_table(const std::filesystem::path& path, const std::vector<std::string>& comments,
                 const Table& table);

}  // namespace cli
