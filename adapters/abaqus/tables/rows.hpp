// SPDX-License-Identifier: BSD-3-Clause
// What stands in PROPS and STATEV of both layouts: the one source of the tables in docs/umat.md and in
// the input decks. Places come from the headers that the libraries are compiled with.
#pragma once

#include <string>
#include <vector>

namespace grit::abaqus {

struct Row {
    int first, last;  // places from 1
    std::string symbol, plain_symbol;
    std::string unit;
    std::string meaning;
    std::string range;    // of a parameter
    std::string in, out;  // of a state variable
};

enum class LayoutName { classic, radian };

std::vector<Row> props_rows(LayoutName layout);
std::vector<Row> statev_rows(LayoutName layout);

}  // namespace grit::abaqus
