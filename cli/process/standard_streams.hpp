// SPDX-License-Identifier: BSD-3-Clause
// What the program says. A full disk or a reader that went away ends no run: it goes on, and the exit
// status of the program tells that not all of its words arrived.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace cli {

// Numbers 0 to 2 that the program was started without are taken, or the first files it opens would get
// them, and with them all that is said. Writing to a standard output that was closed fails.
// Before anything opens a file.
void occupy_standard_streams();

void write_words(std::FILE* stream, std::string_view text) noexcept;

// To standard output: results.
template <class... Args> void say(fmt::format_string<Args...> text, Args&&... args) {
    write_words(stdout, fmt::format(text, std::forward<Args>(args)...));
}

// To standard error: progress and errors.
template <class... Args> void warn(fmt::format_string<Args...> text, Args&&... args) {
    write_words(stderr, fmt::format(text, std::forward<Args>(args)...));
}

// A message that quotes what stands in files, for a terminal: without codes that command it, the middle of a long one left out.
std::string legible(std::string_view message);

void flush_words() noexcept;  // of standard output

// Why standard output did not take all that was said, empty: it did.
std::string unsaid();

}  // namespace cli
