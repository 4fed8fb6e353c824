// SPDX-License-Identifier: BSD-3-Clause
#include "cli/process/standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

namespace cli {
namespace {

int first_error = 0;  // of standard output

void keep(int error) noexcept {
    if (first_error == 0) first_error = error != 0 ? error : EIO;
}

}  // namespace

void occupy_standard_streams() {
    // The lowest free number is given out: in this order each gets its own.
    for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(number, F_GETFD) != -1) continue;
        if (open("/dev/null", number == STDERR_FILENO ? O_WRONLY : O_RDONLY) != number)
            std::_Exit(1);  // nobody can be told
    }
}

void write_words(std::FILE* stream, std::string_view text) noexcept {
    errno = 0;
    if (std::fwrite(text.data(), 1, text.size(), stream) != text.size() && stream == stdout)
        keep(errno);
    else if (stream == stderr) std::fflush(stderr);
}

void flush_words() noexcept {
    errno = 0;
    if (std::fflush(stdout) != 0) keep(errno);
}

std::string unsaid() {
    flush_words();
    if (first_error == 0 && std::ferror(stdout) != 0) keep(EIO);
    if (first_error == 0) return {};
    return "standard output did not take all that was said: " +
           std::generic_category().message(first_error);
}

}  // namespace cli
