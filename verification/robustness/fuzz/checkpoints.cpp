// SPDX-License-Identifier: BSD-3-Clause
// Checkpoints of grit mpm. The first byte says whether the others are the file, or changes of a good one, as they are or with its
// checksums put right again, so that what is behind them is read: refused, or a simulation that can go on.
#include <algorithm>
#include <bit>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

#include <adapters/mpm/io/checksum.hpp>
#include <adapters/mpm/run/history.hpp>
#include <adapters/mpm/run/run.hpp>

#include "cli/mpm/case_file.hpp"
#include "cli/mpm/checkpoint.hpp"
#include "cli/mpm/saved_run.hpp"
#include "robustness/fuzz/bytes.hpp"
#include "robustness/fuzz/refusal.hpp"
#include "robustness/fuzz/scratch.hpp"

namespace {

using grit::mpm::checksum;

// Two bodies that touch, one with a law of sand.
constexpr char case_text[] = R"(
[grid]
geometry = "plane_strain"
[[grid.r]]
to_m = 1
cells = 4
[[grid.z]]
to_m = 1.5
cells = 6
[boundary]
left = "roller"
right = "roller"
bottom = "fixed"
[[body]]
name = "soil"
grain_density_kg_per_m3 = 2650
[[body.box]]
r_m = [0, 1]
z_m = [0, 0.5]
[body.sand]
name = "lausitz"
void_ratio = 0.65
[body.stress_at_rest]
surface_m = 0.5
surcharge_kPa = 10
K0 = 0.5
[[body]]
name = "block"
density_kg_per_m3 = 2000
[[body.box]]
r_m = [0.25, 0.75]
z_m = [0.5, 1]
[body.elastic]
youngs_modulus_kPa = 1e4
poissons_ratio = 0.2
[[contact]]
stiff = "block"
soft = "soil"
law = "LAW"
friction_coefficient = 0.3
[[stage]]
name = "fall"
[stage.until]
time_s = 1
[history]
interval_s = 0.01
)";

struct Original {
    grit::mpm::Case plan;
    std::string file;

    explicit Original(const char* law) {
        std::string text = case_text;
        text.replace(text.find("LAW"), 3, law);
        plan = cli::read_mpm_case(fuzz::scratch().write("case.toml", text)).plan;
        grit::mpm::Runner runner(plan);
        for (int i = 0; i < 3; ++i) runner.step();
        cli::SavedRun run;
        run.state = runner.state();
        run.ends = {"fall: by time"};
        run.history.assign(grit::mpm::history_columns().size(), 1.0);
        const std::filesystem::path place = fuzz::scratch().path() / "good.checkpoint";
        cli::write_mpm_checkpoint(place, runner.subject(), cli::bytes_of(run));
        std::ifstream in(place, std::ios::binary);
        file.assign(std::istreambuf_iterator<char>(in), {});
    }
};

template <class Number> Number at(const std::string& file, std::size_t place) {
    Number out{};
    if (place + sizeof out <= file.size()) std::memcpy(&out, file.data() + place, sizeof out);
    return out;
}
void put(std::string& file, std::size_t place, std::uint64_t number) {
    if (place + sizeof number <= file.size())
        std::memcpy(file.data() + place, &number, sizeof number);
}

// The layouts of cli/mpm/checkpoint.cpp and adapters/mpm/io/checkpoint.cpp.
void put_checksums_right(std::string& file) {
    const auto run_bytes = at<std::uint64_t>(file, 8);
    if (run_bytes > file.size() || 32 + run_bytes + 64 > file.size()) return;
    put(file, 16, checksum(file.data() + 32, run_bytes));
    put(file, 24, checksum(file.data(), 24));
    const std::size_t head = 32 + run_bytes, words = head + 64;
    const auto word_bytes = at<std::uint64_t>(file, head + 24),
               state_bytes = at<std::uint64_t>(file, head + 32);
    if (word_bytes > file.size() || state_bytes > file.size() ||
        words + word_bytes + state_bytes > file.size())
        return;
    put(file, head + 40, checksum(file.data() + words, word_bytes));
    put(file, head + 48, checksum(file.data() + words + word_bytes, state_bytes));
    put(file, head + 56, checksum(file.data() + head, 56));
}

// A place of the run's own state, or of the simulation's, where its numbers of eight bytes begin.
std::size_t place_in_state(const std::string& file, std::size_t any) {
    const auto run_bytes = at<std::uint64_t>(file, 8);
    if (run_bytes == 0 || run_bytes > file.size()) return any;
    const auto word_bytes = at<std::uint64_t>(file, 32 + run_bytes + 24);
    const std::size_t state = 32 + run_bytes + 64 + word_bytes;
    if (word_bytes > file.size() || state >= file.size()) return any;
    if (any % 4 == 0) return std::min(32 + any / 4 % run_bytes / 8 * 8, file.size() - 1);
    return state + any / 4 % (file.size() - state) / 8 * 8;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const Original nodal("geo"), surface("surface");
    fuzz::Bytes in(data, size);
    enum Kind { file_itself, damage, forgery };
    const int kind = in.below(4);
    const Original& original = in.below(2) == 0 ? nodal : surface;
    std::string file = original.file;
    if (kind == file_itself) {
        file = in.rest();
    } else {
        for (int edits = 1 + in.below(5); edits > 0 && file.size() > 128; --edits) {
            const int how = in.byte();
            std::size_t place = in.raw<std::uint32_t>() % file.size();
            // What is told is told right by who forges; all else is numbers.
            if (kind >= forgery) place = place_in_state(file, place);
            if (how >= 250) file.resize(place);
            else if (how >= 240) file.insert(place, file.substr(place / 2, 40));
            else if (how >= 200) put(file, place, in.raw<std::uint64_t>());
            else if (how >= 40) put(file, place, std::bit_cast<std::uint64_t>(in.number(1.0)));
            else file[place] = static_cast<char>(in.byte());
        }
        if (kind >= forgery) put_checksums_right(file);
    }
    const std::filesystem::path place = fuzz::scratch().write("x.checkpoint", file);
    grit::mpm::Runner runner(original.plan);
    try {
        const cli::MpmCheckpoint checkpoint(place);
        const cli::SavedRun run = cli::saved_run_of(
            checkpoint.runner(), original.plan.stages.size(), grit::mpm::history_columns().size());
        runner.resume(run.state);
        checkpoint.restore(runner.subject());
        for (int i = 0; i < 2 && !runner.finished(); ++i) runner.step();
    } catch (const std::runtime_error& refused) {
        fuzz::refusal = refused.what();
    } catch (const std::invalid_argument& refused) {
        fuzz::refusal = refused.what();
    }
    return 0;
}
