// SPDX-License-Identifier: BSD-3-Clause
// Rows of the files that tell the fix what atoms do not have.
#include <gtest/gtest.h>

#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include <adapters/lammps/points_file.hpp>
#include <adapters/mpm/kernel/particles.hpp>
#include <adapters/mpm/space/kernel/particles.hpp>

namespace {

using grit::lammps::PointsFile;
using grit::mpm::words::Geometry;
namespace plane = grit::mpm::column;
namespace space = grit::mpm::space::column;

PointsFile file(Geometry geometry, const std::string& first_line) {
    const auto names =
        geometry == Geometry::space
            ? std::vector<std::string>(std::begin(space::names), std::end(space::names))
            : std::vector<std::string>(std::begin(plane::names), std::end(plane::names));
    return {names, first_line, geometry, {}};
}

void expect_refused(const PointsFile& of, const char* line, const char* why) {
    std::vector<double> row{1.0, 0.0, 0.0, 0.0};
    try {
        of.read(line, row);
        ADD_FAILURE() << line;
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
    }
}

TEST(PointsFile, HasVolumeAndMassOfABrickWhereTheyAreLeftOut) {
    const PointsFile of = file(Geometry::space, "id l_x l_y l_z density");
    std::vector<double> row{1.0, 2.0, 3.0, 0.0, 0.0, 0.0};
    of.read("7 0.5 1 2 1000", row);
    EXPECT_EQ(row[space::V0], 8.0);
    EXPECT_EQ(row[space::mass], 8000.0);
    EXPECT_EQ(row[space::F_yy], 1.0);
    EXPECT_EQ(row[space::z], 3.0);
    const PointsFile round = file(Geometry::axisymmetric, "id l_r l_z density");
    row = {2.0, 3.0, 0.0, 0.0};
    round.read("7 0.5 1 1000", row);
    EXPECT_EQ(row[plane::V0], 4.0);
}

TEST(PointsFile, RefusesIdsThatNoAtomHas) {
    EXPECT_EQ(PointsFile::id_of("2147483647 1"), 2147483647);
    EXPECT_EQ(PointsFile::id_of(""), 0);
    for (const char* line : {"4294967297 1", "2147483648", "-1 2", "0 1", "one 1"}) {
        try {
            PointsFile::id_of(line);
            ADD_FAILURE() << line;
        } catch (const std::invalid_argument& error) {
            EXPECT_NE(std::string(error.what()).find("[1, 2147483647], got"), std::string::npos)
                << error.what();
        }
    }
}

// Found by a fuzzer.
TEST(PointsFile, RefusesVolumesThatOverflow) {
    expect_refused(file(Geometry::space, "id l_x l_y l_z density"), "1 1e200 1e200 1 1000",
                   "point 1: the volume must be > 0 and finite, got inf m³");
}

TEST(PointsFile, NamesTheColumnAndTheWordOfWhatIsWrong) {
    const PointsFile of = file(Geometry::axisymmetric, "id l_r l_z density");
    expect_refused(of, "1 0.5 one 1000",
                   "point 1: column l_z must be a finite number, got \"one\"");
    expect_refused(of, "1 0.5 1 nan",
                   "point 1: column density must be a finite number, got \"nan\"");
    expect_refused(of, "1 0.5 1 ", "point 1: column density is missing");
    expect_refused(of, "1 -0.5 1 1000",
                   "point 1: half side l_r must be > 0 and finite, got -0.5 m");
    expect_refused(of, "1 0.5 1 0", "point 1: the mass must be > 0 and finite, got 0 kg/rad");
}

TEST(PointsFile, RefusesWhatIsTurnedInsideOut) {
    expect_refused(file(Geometry::space, "id F_xx l_x l_y l_z density"), "1 -1 1 1 1 1000",
                   "point 1: det F must be positive, got -1");
    expect_refused(file(Geometry::space, "id F_xx F_xy F_yx F_yy l_x l_y l_z density"),
                   "1 0 1 1 0 1 1 1 1000", "det F must be positive, got -1");
    expect_refused(file(Geometry::plane_strain, "id F_rr F_rz F_zr F_zz l_r l_z density"),
                   "1 1 2 2 1 1 1 1000", "det F must be positive, got -3");
    std::vector<double> row;
    EXPECT_NO_THROW(file(Geometry::space, "id F_xx F_xy F_yx F_yy l_x l_y l_z density")
                        .read("1 0 -1 1 0 1 1 1 1000", row));
}

}  // namespace
