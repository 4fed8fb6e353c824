// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/checkpoint.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include <adapters/mpm/io/checksum.hpp>
#include <fmt/format.h>

#include "element/atomic_file.hpp"

namespace cli {
namespace {

namespace fs = std::filesystem;

struct Header {
    char magic[8];
    std::uint64_t bytes, checksum;  // of the runner's state
    std::uint64_t header_checksum;  // of all before

    std::uint64_t own() const {
        return grit::mpm::checksum(this, offsetof(Header, header_checksum));
    }
};
static_assert(sizeof(Header) == 32);
constexpr char magic_text[8] = {'g', 'r', 'i', 't', ' ', 'r', 'u', 'n'};

Header header_of(std::string_view runner) {
    Header header{{}, runner.size(), grit::mpm::checksum(runner.data(), runner.size()), 0};
    std::memcpy(header.magic, magic_text, sizeof magic_text);
    header.header_checksum = header.own();
    return header;
}

[[noreturn]] void refuse(const fs::path& place, std::string_view why) {
    throw std::runtime_error(fmt::format("{}: {}", place.string(), why));
}

// No more than its first word where that is another's.
std::string bytes_of(const fs::path& place) {
    errno = 0;
    std::ifstream file(place, std::ios::binary);
    std::string out(sizeof magic_text, '\0');
    file.read(out.data(), static_cast<std::streamsize>(out.size()));
    out.resize(static_cast<std::size_t>(file.gcount()));
    if (out == std::string_view(magic_text, sizeof magic_text))
        out.append(std::istreambuf_iterator<char>(file), {});
    if (!file.is_open() || file.bad() || fs::is_directory(place))
        refuse(place, fmt::format("cannot read this checkpoint: {}",
                                  std::generic_category().message(errno ? errno : EISDIR)));
    return out;
}

}  // namespace

void write_mpm_checkpoint(const fs::path& place, const grit::mpm::Subject& simulation,
                          std::string_view runner) {
    const Header header = header_of(runner);
    std::ostringstream state;
    simulation.save(state);
    element::AtomicFile file(place);
    file.write({reinterpret_cast<const char*>(&header), sizeof header});
    file.write(runner);
    file.write(state.view());
    file.complete_on_disk();
}

MpmCheckpoint::MpmCheckpoint(const fs::path& path) : place(path) {
    const std::string file = bytes_of(place);
    Header header{};
    if (file.size() < sizeof header.magic || std::memcmp(file.data(), magic_text, 8) != 0)
        refuse(place, "this is no checkpoint of grit mpm");
    if (file.size() < sizeof header)
        refuse(place,
               fmt::format("checkpoint: truncated after {} bytes, within its header", file.size()));
    std::memcpy(&header, file.data(), sizeof header);
    if (header.header_checksum != header.own())
        refuse(place, "checkpoint: damaged: the first header's checksum differs");
    if (file.size() - sizeof header < header.bytes)
        refuse(place, fmt::format("checkpoint: truncated: {} bytes of the run, {} are there",
                                  header.bytes, file.size() - sizeof header));
    runner_state = file.substr(sizeof header, header.bytes);
    if (header.checksum != grit::mpm::checksum(runner_state.data(), runner_state.size()))
        refuse(place, "checkpoint: damaged: the checksum of the run's own state differs");
    simulation_state = file.substr(sizeof header + header.bytes);
}

void MpmCheckpoint::restore(grit::mpm::Subject& simulation, grit::mpm::OtherBits bits) const {
    std::istringstream in(simulation_state);
    try {
        simulation.restore(in, bits);
    } catch (const std::runtime_error& error) {
        refuse(place, error.what());
    }
}

}  // namespace cli
