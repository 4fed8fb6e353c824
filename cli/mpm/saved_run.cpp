// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/saved_run.hpp"

#include <cstdint>
#include <stdexcept>
#include <utility>

#include <adapters/mpm/io/archive.hpp>

namespace cli {
namespace {

using grit::mpm::ByteReader;
using grit::mpm::ByteWriter;

constexpr std::uint64_t format = 5;  // of these bytes

}  // namespace

std::string bytes_of(const SavedRun& run) {
    ByteWriter writer;
    writer.value(format);
    SavedRun::visit(run, writer);
    return std::move(writer.out);
}

SavedRun saved_run_of(std::string_view bytes, std::size_t stages, std::size_t columns) {
    ByteReader reader(bytes.data(), bytes.size());
    SavedRun out;
    try {
        std::uint64_t found = 0;
        reader.value(found);
        if (found != format) throw std::runtime_error("another version of this program wrote it");
        SavedRun::visit(out, reader);
        if (reader.left() > 0)
            throw std::runtime_error("the state of the run is not as long as it says");
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(std::string("checkpoint: ") + error.what());
    }
    if (out.state.stage_time.size() != stages || out.state.stage < 0 ||
        out.state.stage > static_cast<int>(stages))
        throw std::runtime_error("checkpoint: its case has " +
                                 std::to_string(out.state.stage_time.size()) +
                                 " stages, this one has " + std::to_string(stages));
    if (out.history.size() % columns != 0)
        throw std::runtime_error("checkpoint: its history has other columns");
    return out;
}

}  // namespace cli
