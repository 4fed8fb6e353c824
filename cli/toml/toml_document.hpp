// SPDX-License-Identifier: BSD-3-Clause
// A TOML file, or one that says in what it differs from another:
//
//   base = "other.toml"                 # relative to this file; may have a base of its own
//   name = "..."                        # and title: default the name of this file
//   [override]
//   "body.soil.sand.void_ratio" = 0.80  # keys of the other; of a list [[body]] by name or number
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include <toml++/toml.h>

#include "cli/toml/case_setting.hpp"

namespace cli {

// inputs: all files that were read. Throws BadInput naming file, line and key.
std::shared_ptr<const toml::table> parse_document(const std::filesystem::path& path,
                                                  std::vector<std::filesystem::path>* inputs,
                                                  const std::vector<CaseSetting>& settings = {});

}  // namespace cli
