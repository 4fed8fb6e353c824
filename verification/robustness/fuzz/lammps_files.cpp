// SPDX-License-Identifier: GPL-2.0-only
// What fix grit/mpm reads: files of points in the plane, around an axis and in space, and its part of a restart file. The first
// letter says which.
#include <cstdint>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "adapters/lammps/points_file.hpp"
#include "adapters/lammps/run_bytes.hpp"
#include "adapters/mpm/io/checksum.hpp"
#include "adapters/mpm/kernel/particles.hpp"
#include "adapters/mpm/space/kernel/particles.hpp"
#include "robustness/fuzz/bytes.hpp"
#include "robustness/fuzz/refusal.hpp"

namespace {

using namespace grit::lammps;
using grit::mpm::words::Geometry;

// Of a body of sand. As the fix: what stands in front is the position and velocity of the atom.
void read_points(const std::string& text, Geometry geometry) {
    namespace plane = grit::mpm::column;
    namespace space = grit::mpm::space::column;
    const bool in_space = geometry == Geometry::space;
    std::vector<std::string> names(std::begin(plane::names), std::end(plane::names));
    if (in_space) names.assign(std::begin(space::names), std::end(space::names));
    names.emplace_back("e");
    std::istringstream in(text);
    std::string line;
    std::getline(in, line);
    const PointsFile file(names, line, geometry,
                          {{"q", [](std::vector<double>& row) { return -row.back(); }}});
    while (std::getline(in, line)) {
        if (PointsFile::id_of(line.c_str()) == 0) continue;
        std::vector<double> row(in_space ? 6 : 4, 1.0);
        file.read(line.c_str(), row);
        fuzz::demand(row.size() == names.size());
    }
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
        switch (kind) {
            case 'p': read_points(in.rest(), Geometry::plane_strain); break;
            case 'a': read_points(in.rest(), Geometry::axisymmetric); break;
            case 's': read_points(in.rest(), Geometry::space); break;
            default: read_restart(in);
        }
    } catch (const std::invalid_argument& refused) {
        fuzz::refusal = refused.what();
    } catch (const std::runtime_error& refused) {
        fuzz::refusal = refused.what();
    }
    return 0;
}
