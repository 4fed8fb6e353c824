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

std::string legible(std::string_view message) {
    constexpr std::size_t longest = 4000, kept = 1500;  // of either end
    std::string out;
    for (std::size_t i = 0; i < message.size(); ++i) {
        if (message.size() > longest && i == kept) {
            i = message.size() - kept;
            while (i > kept && (message[i] & 0xC0) == 0x80) --i;  // within a letter of UTF-8
            out += fmt::format(" ... ({} bytes) ... ", i - kept);
        }
        const auto each = static_cast<unsigned char>(message[i]);
        const bool long_code = each == 0xC2 && i + 1 < message.size() &&
                               static_cast<unsigned char>(message[i + 1]) < 0xA0;
        const bool code =
            (each < 0x20 && each != '\n' && each != '\t') || each == 0x7F || long_code;
        if (code) out += fmt::format("\\x{:02X}", each);
        else out += message[i];
    }
    return out;
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
