// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/io/checkpoint.hpp"

#include <algorithm>
#include <cstring>
#include <istream>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>

#include <grit/version.h>

#include "adapters/mpm/io/checkpoint_state.hpp"
#include "adapters/mpm/io/checksum.hpp"
#include "support/version_text.hpp"

namespace grit::mpm {
namespace {

constexpr char magic_text[8] = {'g', 'r', 'i', 't', ' ', 'm', 'p', 'm'};
constexpr std::uint32_t byte_order_mark = 0x01020304u, other_byte_order = 0x04030201u;
constexpr std::uint32_t format_now = 6;

struct Header {
    char magic[8];
    std::uint32_t byte_order, format;
    std::int32_t library_version, instruction_set;
    std::uint64_t word_bytes, state_bytes;
    std::uint64_t word_checksum, state_checksum;
    std::uint64_t header_checksum;  // of all before
};
static_assert(sizeof(Header) == 64);

std::uint64_t checksum_of(const Header& header) {
    return checksum(&header, offsetof(Header, header_checksum));
}

[[noreturn]] void refuse(const std::string& why) { throw std::runtime_error("checkpoint: " + why); }

Header read_header(std::istream& in, OtherBits bits) {
    Header header{};
    in.read(reinterpret_cast<char*>(&header), sizeof header);
    if (in.gcount() < static_cast<std::streamsize>(sizeof header.magic) ||
        std::memcmp(header.magic, magic_text, sizeof magic_text) != 0)
        refuse("this is none of grit's material-point driver");
    if (in.gcount() != static_cast<std::streamsize>(sizeof header))
        refuse("truncated after " + std::to_string(in.gcount()) + " bytes, within its header");
    if (header.byte_order == other_byte_order)
        refuse("written by a machine with another order of bytes");
    if (header.header_checksum != checksum_of(header))
        refuse("damaged: the header's checksum differs");
    if (header.format != format_now)
        refuse("its format is " + std::to_string(header.format) + ", this program reads " +
               std::to_string(format_now));
    if (header.library_version != grit_version())
        refuse("written with grit " + version_text(header.library_version) + ", this is " +
               version_text(grit_version()));
    if (header.instruction_set != grit_instruction_set() && bits == OtherBits::refused)
        refuse("written with the instruction set " + instruction_set_text(header.instruction_set) +
               ", this machine uses " + instruction_set_text(grit_instruction_set()) +
               ": other bits would follow");
    return header;
}

// In pieces, for a file may have lost what its header speaks of.
std::string read_bytes(std::istream& in, std::uint64_t count, std::uint64_t sum, const char* what) {
    constexpr std::uint64_t piece = 1u << 24;
    std::string out;
    while (out.size() < count) {
        const std::size_t before = out.size();
        out.resize(before + std::min<std::uint64_t>(piece, count - before));
        in.read(out.data() + before, static_cast<std::streamsize>(out.size() - before));
        if (static_cast<std::size_t>(in.gcount()) != out.size() - before)
            refuse(std::string("truncated: its ") + what + " has " + std::to_string(count) +
                   " bytes, " + std::to_string(before + static_cast<std::size_t>(in.gcount())) +
                   " are there");
    }
    if (checksum(out.data(), out.size()) != sum)
        refuse(std::string("damaged: the checksum of its ") + what + " differs");
    return out;
}

// The first line that differs.
void compare_words(const std::string& written, const std::string& here) {
    std::istringstream file(written), simulation(here);
    for (;;) {
        std::string theirs, ours;
        const bool more = static_cast<bool>(std::getline(file, theirs));
        const bool more_here = static_cast<bool>(std::getline(simulation, ours));
        if (!more && !more_here) return;
        if (theirs != ours)
            refuse("of another simulation: it has '" + theirs + "', this has '" + ours + "'");
    }
}

}  // namespace

void write_state(const std::string& words, const std::string& state, std::ostream& out) {
    Header header{{},
                  byte_order_mark,
                  format_now,
                  grit_version(),
                  grit_instruction_set(),
                  words.size(),
                  state.size(),
                  checksum(words.data(), words.size()),
                  checksum(state.data(), state.size()),
                  0};
    std::copy_n(magic_text, sizeof magic_text, header.magic);
    header.header_checksum = checksum_of(header);
    out.write(reinterpret_cast<const char*>(&header), sizeof header);
    out.write(words.data(), static_cast<std::streamsize>(words.size()));
    out.write(state.data(), static_cast<std::streamsize>(state.size()));
    out.flush();
    if (!out) throw std::runtime_error("checkpoint: it could not be written completely");
}

void read_state(std::istream& in, OtherBits bits, const std::string& words,
                const std::function<void(const std::string&)>& take) {
    const Header header = read_header(in, bits);
    const std::string theirs =
        read_bytes(in, header.word_bytes, header.word_checksum, "description");
    const std::string state = read_bytes(in, header.state_bytes, header.state_checksum, "state");
    if (in.peek() != std::istream::traits_type::eof())
        refuse("damaged: bytes follow where its state ends");
    compare_words(theirs, words);
    try {
        take(state);
    } catch (const std::runtime_error& error) {
        refuse(error.what());
    }
}

void save(const Simulation& simulation, std::ostream& out) {
    write_state(CheckpointState::words(simulation), CheckpointState::bytes(simulation), out);
}

void restore(Simulation& simulation, std::istream& in, OtherBits bits) {
    read_state(in, bits, CheckpointState::words(simulation),
               [&](const std::string& state) { CheckpointState::take(simulation, state); });
}

}  // namespace grit::mpm
