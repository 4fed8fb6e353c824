// SPDX-License-Identifier: GPL-2.0-only
// What fix grit/mpm reads: files of points, and its part of a restart file. The first letter says which.
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "adapters/lammps/points_file.hpp"
#include "adapters/lammps/run_bytes.hpp"
#include "adapters/mpm/io/checksum.hpp"
#include "robustness/fuzz/bytes.hpp"

namespace {

using namespace grit::lammps;

void read_points(const std::string& text) {
    const std::vector<std::string> names = {"r",    "z",    "v_r",  "v_z",  "mass", "V0",
                                            "l_r",  "l_z",  "F_rr", "F_rz", "F_zr", "F_zz",
                                            "F_tt", "S_rr", "S_zz", "S_tt", "S_rz", "e"};
    std::istringstream in(text);
    std::string line;
    std::getline(in, line);
    const PointsFile file(names, line, grit::mpm::words::Geometry::axisymmetric,
                          {{"S_rr", [](std::vector<double>& row) { return -row.back(); }}});
    std::vector<double> row(names.size(), 1.0);
    while (std::getline(in, line))
        if (PointsFile::id_of(line.c_str()) != 0) file.read(line.c_str(), row);
}

// As LAMMPS hands it over: a block of memory, whose length only it knows.
void read_restart(fuzz::Bytes& in) {
    constexpr std::uint64_t fingerprint = 7;
    StoredRun run;
    run.common = "common";
    run.nodes.words_each = 6;
    run.stages.resize(2);
    run.state.stage_time = {0.0, 1.0};
    std::string bytes = to_bytes(in.one_in(8) ? nullptr : &run, fingerprint);
    // Behind its head (run_bytes.cpp), which believes its length as it has no other; with the checksum of what is there now.
    constexpr std::size_t head = 24, sum_at = 16;
    while (in.left() > 2) {
        const std::size_t place = head + in.raw<std::uint16_t>() % (bytes.size() - head);
        bytes[place] = static_cast<char>(in.byte());
    }
    const std::uint64_t sum = grit::mpm::checksum(bytes.data() + head, bytes.size() - head);
    std::memcpy(bytes.data() + sum_at, &sum, sizeof sum);
    from_bytes(bytes.data(), fingerprint);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Bytes in(data, size);
    const int kind = in.byte();
    try {
        if (kind == 'p') read_points(in.rest());
        else read_restart(in);
    } catch (const std::invalid_argument&) {
    } catch (const std::runtime_error&) {
    }
    return 0;
}
