// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/saved_run.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <utility>

#include <adapters/mpm/io/archive.hpp>

namespace cli {
namespace {

using grit::mpm::ByteReader;
using grit::mpm::ByteWriter;

constexpr std::uint64_t format = 6;  // of these bytes

// What takes effect when a run goes on, by the parts of its key.
bool may_change(const std::string& key) {
    const std::string first = key.substr(0, key.find('.')), last = key.substr(key.rfind('.') + 1);
    if (first == "title" || first == "fields") return true;
    if (first == "numerics")
        return last == "threads" || last == "cfl" || last == "largest_step_s" ||
               last == "local_damping" || last == "pic_rate_per_s" ||
               last == "energy_residual_limit";
    if (first == "history") return last == "interval_s";
    if (first == "stage") return key != first && last != "gravity";
    const bool is_over_time = last == "time_s" || last == "stress_kPa" || last == "speed_m_per_s";
    if (first == "traction") return is_over_time || key.find(".pulses.") != std::string::npos;
    if (first == "inflow") return is_over_time;
    return first == "body" && key.find(".rigid.") != std::string::npos &&
           (is_over_time || last.starts_with("velocity_") || last.starts_with("angular_velocity_"));
}

// "KEY = VALUE" of both; empty: one has not got it.
using Both = std::map<std::string, std::array<std::string, 2>>;

void add(const std::vector<std::string>& lines, std::size_t which, Both& to) {
    for (const std::string& line : lines) {
        const std::size_t at = line.find(" = ");
        to[line.substr(0, at)][which] = line.substr(at + 3);
    }
}

}  // namespace

void compare_cases(const std::vector<std::string>& written, const std::vector<std::string>& here) {
    Both all;
    add(written, 0, all);
    add(here, 1, all);
    for (const auto& [key, values] : all) {
        if (values[0] == values[1] || may_change(key)) continue;
        const auto text = [](const std::string& value) {
            return value.empty() ? std::string("nothing") : value;
        };
        throw std::runtime_error("checkpoint: of a case that says " + text(values[0]) + " for " +
                                 key + ", this one " + text(values[1]) +
                                 ": a run goes on with what it began with");
    }
}

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
