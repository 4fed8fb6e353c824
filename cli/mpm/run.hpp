// SPDX-License-Identifier: BSD-3-Clause
// A material-point case computed: history, checkpoints, progress.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <adapters/mpm/kernel/material_failure.hpp>
#include <adapters/mpm/run/run.hpp>

#include "cli/mpm/case_file.hpp"
#include "cli/mpm/field_files.hpp"
#include "cli/mpm/progress.hpp"
#include "cli/mpm/saved_run.hpp"
#include "cli/table/table_file.hpp"

namespace cli {

struct MpmRunOptions {
    std::filesystem::path history, checkpoint;  // files
    std::filesystem::path fields;               // stem of files, of pictures too
    std::filesystem::path failure;              // where a particle that fails is replayed
    std::optional<FieldsPlan> shown;
    double checkpoint_minutes = 0.0;  // 0: when it is interrupted, only
    bool restart = false;             // from the checkpoint
    bool quiet = false;
    bool field_svg = false;               // pictures of fields as .svg too
    std::string changes = {};             // of the case by options, "with KEY=VALUE", empty: none
    std::vector<std::string> given = {};  // as of MpmCaseFile
};

class MpmRun {
  public:
    // Throws BadInput for a checkpoint that cannot be used.
    MpmRun(const MpmRunOptions& options, grit::mpm::Runner& runner);

    // Why it stopped early; empty: it did not.
    std::string go();
    // Curves of the history, and the fields of [fields] as they are now. False if one could not be written.
    bool draw();
    double seconds() const { return progress.seconds(); }

  private:
    using Clock = std::chrono::steady_clock;
    void resume();
    std::string compute();
    std::string replay(const grit::mpm::MaterialFailure& error);
    void step();
    void row();
    void frame();
    void stage_ended(int stage);
    // Why there is no new checkpoint; empty: there is. The one before stays.
    std::string save();
    std::filesystem::path incomplete() const;
    void complete_history(const std::string& failure);
    std::string here();

    const MpmRunOptions& options;
    grit::mpm::Runner& runner;
    MpmProgress progress;
    std::unique_ptr<ShownFields> fields;  // count displacements from the start
    std::optional<MpmFieldFiles> field_files;
    SavedRun done;  // ends, history and frames
    std::optional<TableFile> history;
    Clock::time_point saved;
};

}  // namespace cli
