// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm_saved_run.hpp"

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace cli {
namespace {

using grit::mpm::RunState;

constexpr std::uint64_t format = 3;  // of these bytes

class Writer {
  public:
    template <class Number> void operator()(const Number& number) {
        static_assert(std::is_trivially_copyable_v<Number>);
        bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
    }
    template <class Number> void operator()(const std::vector<Number>& numbers) {
        (*this)(static_cast<std::uint64_t>(numbers.size()));
        for (const Number& number : numbers) (*this)(number);
    }
    void operator()(const std::string& text) {
        (*this)(static_cast<std::uint64_t>(text.size()));
        bytes += text;
    }
    std::string bytes;
};

class Reader {
  public:
    explicit Reader(std::string_view all) : rest(all) {}
    template <class Number> void operator()(Number& number) {
        std::memcpy(&number, take(sizeof number).data(), sizeof number);
    }
    template <class Number> void operator()(std::vector<Number>& numbers) {
        std::uint64_t size = 0;
        (*this)(size);
        if (size > rest.size()) fail();
        numbers.resize(size);
        for (Number& number : numbers) (*this)(number);
    }
    void operator()(std::string& text) {
        std::uint64_t size = 0;
        (*this)(size);
        text = take(size);
    }
    void end() const {
        if (!rest.empty()) fail();
    }

  private:
    [[noreturn]] static void fail() {
        throw std::runtime_error("checkpoint: the state of the run is not as long as it says");
    }
    std::string_view take(std::size_t size) {
        if (size > rest.size()) fail();
        const std::string_view out = rest.substr(0, size);
        rest.remove_prefix(size);
        return out;
    }
    std::string_view rest;
};

template <class Run, class Visitor> void visit(Run& run, Visitor& visitor) {
    auto& state = run.state;
    visitor(state.stage);
    visitor(state.last_dt);
    visitor(state.start_level);
    visitor(state.stage_level);
    visitor(state.next_row);
    visitor(state.impulse);
    visitor(state.row_time);
    visitor(state.stage_time);
    visitor(run.ends);
    visitor(run.history);
    visitor(run.frames);
    visitor(run.next_frame);
}

}  // namespace

std::string bytes_of(const SavedRun& run) {
    Writer writer;
    writer(format);
    visit(run, writer);
    return std::move(writer.bytes);
}

SavedRun saved_run_of(std::string_view bytes, std::size_t stages, std::size_t columns) {
    Reader reader(bytes);
    std::uint64_t found = 0;
    reader(found);
    if (found != format)
        throw std::runtime_error("checkpoint: another version of this program wrote it");
    SavedRun out;
    visit(out, reader);
    reader.end();
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
