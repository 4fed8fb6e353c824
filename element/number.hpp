// SPDX-License-Identifier: BSD-3-Clause
// Numbers in files, the same everywhere: a point before the decimals, exponents with E or D as Fortran
// writes them, an optional sign.
#pragma once

#include <optional>
#include <string_view>

namespace element {

// The finite number that the whole text is, blanks around it apart.
std::optional<double> number_of(std::string_view text);

// Characters of the number that the text begins with, sign included; 0: none.
std::size_t number_length(std::string_view text);

}  // namespace element
