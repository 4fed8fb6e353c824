// SPDX-License-Identifier: BSD-3-Clause
// What becomes of the records of a run: a row each in the CSV, cycles, and the columns that are kept.
#pragma once

#include "cli/element/case_run.hpp"
#include "cli/element/cycles.hpp"
#include "cli/element/turns.hpp"
#include "cli/table/columns.hpp"
#include "cli/table/table_file.hpp"

namespace cli {

class RunWriter {
  public:
    RunWriter(const CaseFile& file, const CaseOutput& output, CaseResult& result);

    // number: from 1. Its first record may be one of increment 0, from which strains count anew.
    void begin_stage(int number, const CaseStage& stage);
    void increment(const element::Record& now);
    void record(const element::Record& record);
    void end_stage();
    // The rest of the result, and the end of the file.
    void complete();

  private:
    void start_from(const element::Record& record);

    const CaseOutput& output;
    CaseResult& result;
    Columns columns;
    Cycles cycles;
    TableFile file;
    std::vector<std::size_t> kept;  // columns of the row, in the order of result.table
    Setting setting;
    bool cyclic = false, started = false;
    element::Record last;  // of the stage before
    std::optional<Turns> turns;
    ShearPair reversal, farthest;
};

}  // namespace cli
