// SPDX-License-Identifier: BSD-3-Clause
// Element tests as TOML files; verification/cases/every_key.toml shows and explains every key.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <grit/grit.h>

#include "cli/element/reference.hpp"
#include "cli/element/stage_reader.hpp"
#include "cli/toml/case_setting.hpp"
#include "element/grit_law.hpp"
#include "element/library_law.hpp"
#include "element/simulate.hpp"
#include "element/start.hpp"
#include "element/step.hpp"

namespace cli {

struct Limits {
    std::optional<int> increments;
    std::optional<double> milliseconds;  // of computing, the fastest of five runs
};

// --umat FILE --layout LAYOUT
struct UmatChoice {
    std::filesystem::path library;  // empty: Grit's own law, or as the case says
    std::string layout;  // of PROPS and STATEV where the case has none: classic or radian
};

struct CaseFile {
    std::filesystem::path path;
    std::string name;     // of the files it writes
    std::string title;    // for people
    std::string sand;     // name of the sand, for people
    std::string sample;   // row of the table of samples, empty: none
    std::string variant;  // of --vary, "void_ratio = 0.6", empty: none
    std::string changes;  // by options of the command line, "with start.void_ratio=0.7"
    grit_sand_parameters parameters{};
    element::GritLawOptions options;  // evaluation_limit, tolerance
    std::optional<element::UmatSource> umat;
    std::vector<double> umat_state;
    double umat_pore_pressure = 0.0;  // what bears at the start, if it is not in its stress [kPa]
    element::Start start;             // [kPa]
    std::shared_ptr<const element::Law> law;
    const element::GritLaw* own_law = nullptr;  // if law is Grit's
    element::MaterialPoint point;               // to start from
    std::vector<CaseStage> stages;
    element::Settings settings;
    Limits limits;
    Reference reference;
    std::string picture;                        // kind of picture, see panels.hpp
    std::vector<std::filesystem::path> inputs;  // all files that were read

    // What each of its results begins with: who made it, of what, and what differs from the file.
    std::vector<std::string> heading() const;
};

// One case, or one for each row of its table of samples, with the law of this library, if any. Throws BadInput naming file, line and key.
// sand: a name of the catalogue or a file, whose parameters take the place of the case's, empty: none. settings: "KEY=VALUE",
// see toml_document.hpp.
std::vector<CaseFile> read_case_file(const std::filesystem::path& path, const UmatChoice& umat,
                                     const std::filesystem::path& sand = {},
                                     const std::vector<CaseSetting>& settings = {});

}  // namespace cli
