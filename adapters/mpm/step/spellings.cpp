// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/spellings.hpp"

#include <stdexcept>
#include <string>

namespace grit::mpm {

std::string_view word_of(Spellings words, int value) {
    for (const Spelling& spelling : words)
        if (spelling.value == value) return spelling.word;
    throw std::logic_error("no word for value " + std::to_string(value));
}

}  // namespace grit::mpm
