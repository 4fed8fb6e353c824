// SPDX-License-Identifier: BSD-3-Clause
// The rules of a case, for all who read one: readers of case files and of fix grit/mpm alike.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "adapters/mpm/case/case.hpp"

namespace grit::mpm {

// What a rule refuses. Who reads the case says where that stands, and spells its keys.
struct Refusal {
    std::string_view section;     // of case_words.hpp ...
    std::size_t number = 0;       // ... the one of bodies, tractions, contacts or stages, from 0
    std::string_view key;         // ... and in it; empty: all of it
    std::string words;            // behind the place
    std::string_view other = {};  // another key of the section, behind the words ...
    std::string more = {};        // ... and what follows that
};
using Refused = std::optional<Refusal>;

// What was said, where a plan looks alike if it was not.
struct Said {
    struct OfContact {
        bool power = false, distance = false;
    };
    bool left = false;                // side of the grid
    std::vector<OfContact> contacts;  // as many as the case has
};

// The first rule that is broken. Bodies and stages that are named must be there.
Refused check_case(const Case& plan, const Said& said);

// Names become parts of file names, of keys in [override] and of commands.
Refused check_name(std::string_view section, std::size_t number, const std::string& name);
Refused check_end(const Case& plan, std::size_t number, const StageEnd& end);

}  // namespace grit::mpm
