// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/fields.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <fstream>
#include <numbers>
#include <random>

#include <adapters/mpm/case/build_case.hpp>
#include <element/atomic_file.hpp>
#include <fmt/format.h>

#include "cli/mpm/field_files.hpp"
#include "support/no_room.hpp"
#include "support/sand_box.hpp"
#include "support/workplace.hpp"
#include "support/xml.hpp"

namespace {

using namespace cli_test;
namespace c = grit::mpm::column;
using cli::mpm_field;

class Fields : public testing::Test {
  protected:
    Fields() { simulation->energy(); }  // finds the place of each id
    std::size_t at(std::size_t body, int id) const {
        return static_cast<std::size_t>(simulation->find(body, id));
    }
    double& value(std::size_t body, int id, int column) {
        return simulation->body(body).particles.view()[column][at(body, id)];
    }

    Workplace here;
    std::unique_ptr<grit::mpm::Simulation> simulation = sand_box();
    cli::MpmFields fields{*simulation};
};

TEST_F(Fields, HaveDifferentNamesAndAreAllOfSomeBody) {
    std::set<std::string> names;
    for (const cli::MpmField& field : cli::mpm_fields()) {
        EXPECT_TRUE(names.insert(field.name).second) << field.name;
        ASSERT_EQ(fields.has(0, field), field.of != cli::ShownOf::water) << field.name;
        if (field.of == cli::ShownOf::water) continue;
        const std::vector<double> values = fields.values(0, field);
        EXPECT_EQ(values.size(), 100u * static_cast<std::size_t>(field.components));
        for (const double x : values) EXPECT_TRUE(std::isfinite(x)) << field.name;
    }
    EXPECT_FALSE(fields.has(1, mpm_field("void_ratio")));
    EXPECT_TRUE(fields.has(1, mpm_field("q")));
    EXPECT_THROW(fields.values(1, mpm_field("void_ratio")), std::invalid_argument);
}

TEST(SaturatedFields, AreEffectiveAndTotalStressesAndTheFlow) {
    namespace mpm = grit::mpm;
    mpm::Case plan;
    plan.settings.axisymmetric = false;
    plan.r = plan.z = {0.0, {{1.0, 2, 1.0}}};
    mpm::BodyPlan body{};
    body.name = "sand";
    body.outlines = {mpm::Outline{{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}}};
    body.density = 2650.0;
    body.material = mpm::ElasticPlan{1e6, 0.25};
    body.geostatic = mpm::Geostatic{.surface = 1.0};
    body.water = mpm::WaterPlan{.drainage = mpm::Drainage::flow,
                                .grain_density = 2650.0,
                                .porosity = 0.4,
                                .conductivity = 1e-3,
                                .table = 1.0};
    plan.bodies = {body};
    const mpm::BuiltCase built = mpm::build_case(plan);
    mpm::Body& sand = built.simulation->body(0);
    sand.particles.view()[sand.water->velocity_column()][0] = 0.5;
    const cli::MpmFields fields(*built.simulation);
    const auto values = [&](const char* name) { return fields.values(0, mpm_field(name, false)); };
    // 1/8 m below the top, of the lowest particles 7/8.
    EXPECT_NEAR(values("pore_pressure")[0], 9.81 * 7.0 / 8.0, 1e-9);
    EXPECT_NEAR(values("stress_zz")[0], -0.6 * 1.65 * 9.81 * 7.0 / 8.0, 1e-9);
    EXPECT_NEAR(values("total_zz")[0], -(0.6 * 2.65 + 0.4) * 9.81 * 7.0 / 8.0, 1e-9);
    EXPECT_NEAR(values("total_xx")[0], values("stress_xx")[0] - values("pore_pressure")[0], 1e-12);
    EXPECT_NEAR(values("total_yy")[0], values("stress_yy")[0] - values("pore_pressure")[0], 1e-12);
    EXPECT_NEAR(values("porosity")[0], 0.4, 1e-12);
    EXPECT_NEAR(values("seepage")[0], 0.4 * 0.5, 1e-12);
}

TEST(FieldsInPlaneStrain, HaveTheAxesOfAPlane) {
    const std::vector<cli::MpmField>&around = cli::mpm_fields(true),
          &plane = cli::mpm_fields(false);
    ASSERT_EQ(around.size(), plane.size());
    std::set<std::string> renamed;
    for (std::size_t i = 0; i < plane.size(); ++i)
        if (std::string(around[i].name) != plane[i].name) renamed.insert(plane[i].name);
    EXPECT_EQ(renamed,
              (std::set<std::string>{"F_xx", "F_xz", "F_zx", "F_yy", "stress_xx", "stress_yy",
                                     "stress_xz", "h_xx", "h_yy", "h_xz", "total_xx", "total_yy"}));
    EXPECT_THROW(mpm_field("stress_rr", false), std::invalid_argument);
}

TEST_F(Fields, OfAnUnknownNameAreRefusedWithTheNearest) {
    try {
        mpm_field("viod_ratio");
        FAIL() << "no error";
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(), "no variable \"viod_ratio\"; nearest: void_ratio");
    }
}

TEST_F(Fields, AreOfTheParticleWithThatNumberAfterManySorts) {
    for (int i = 0; i < 400; ++i) simulation->step();
    const int* ids = simulation->body(0).particles.ids();
    EXPECT_FALSE(std::is_sorted(ids, ids + 100));
    const std::vector<double> id = fields.values(0, mpm_field("id"));
    const std::vector<double> u = fields.values(0, mpm_field("displacement"));
    for (int i = 0; i < 100; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const int row = i / 10;
        EXPECT_EQ(id[k], i);
        EXPECT_NEAR(u[2 * k], value(0, i, c::r) - (i % 10 + 0.5) * 0.05, 1e-12);
        EXPECT_NEAR(u[2 * k + 1], value(0, i, c::z) - (row + 0.5) * 0.05, 1e-12);
    }
}

TEST_F(Fields, AreInTheirUnits) {
    simulation->step();
    for (const std::size_t body : {0u, 1u}) {
        value(body, 7, c::S_rr) = -100e3;
        value(body, 7, c::S_zz) = -300e3;
        value(body, 7, c::S_tt) = -110e3;
        value(body, 7, c::S_rz) = 20e3;
        const auto of = [&](const char* name) { return fields.values(body, mpm_field(name))[7]; };
        EXPECT_DOUBLE_EQ(of("stress_zz"), -300.0);
        EXPECT_DOUBLE_EQ(of("stress_rz"), 20.0);
        EXPECT_NEAR(of("p"), 170.0, 1e-12);
        // Deviator -70, 130, -60 and 20 twice.
        EXPECT_NEAR(of("q"), std::sqrt(1.5 * (4900 + 16900 + 3600 + 800)), 1e-10);
    }
    // Principal stresses 200 -+ sqrt(100^2 + 20^2) and 110, the middle one.
    const double radius = std::hypot(100.0, 20.0);
    EXPECT_NEAR(fields.values(0, mpm_field("friction_angle"))[7],
                std::asin(radius / 200.0) * 180.0 / std::numbers::pi, 1e-9);
    const double volume = std::numbers::pi * 0.05 * (std::pow(0.4, 2) - std::pow(0.35, 2));
    EXPECT_NEAR(fields.values(0, mpm_field("mass"))[7], 1700.0 * volume, 1e-10);
}

cli::MpmFieldFiles files_of(const Workplace& here, const cli::MpmFields& fields) {
    return {here.path("push"),
            {mpm_field("velocity"), mpm_field("void_ratio"), mpm_field("p")},
            fields};
}

TEST_F(Fields, AreWrittenAsQuadrilateralsThatShear) {
    value(0, 0, c::F_rz) = 0.5;
    value(0, 0, c::F_zz) = 1.2;
    value(1, 3, c::v_z) = -2.0;
    files_of(here, fields).write();
    EXPECT_EQ(here.files(), (std::set<std::string>{"push.pvd", "push_000000_hammer.vtu",
                                                   "push_000000_sand.vtu"}));
    const Element sand = read_xml(here.text("push_000000_sand.vtu"));
    EXPECT_EQ(sand.attributes.at("header_type"), "UInt64");
    const Element& piece = sand.first("Piece");
    EXPECT_EQ(piece.attributes.at("NumberOfPoints"), "400");
    EXPECT_EQ(piece.attributes.at("NumberOfCells"), "100");
    const auto corner = sand.array<double>("corners");
    ASSERT_EQ(corner.size(), 1200u);
    // Centre (0.025, 0.025), half sides 0.025: (0.025, 0) along r, (0.0125, 0.03) along z.
    const double expected[] = {-0.0125, -0.005, 0.0, 0.0375, -0.005, 0.0,
                               0.0625,  0.055,  0.0, 0.0125, 0.055,  0.0};
    for (std::size_t i = 0; i < 12; ++i) EXPECT_NEAR(corner[i], expected[i], 1e-15) << i;
    const auto offsets = sand.array<long>("offsets"), points = sand.array<long>("connectivity");
    ASSERT_EQ(points.size(), 400u);
    ASSERT_EQ(offsets.size(), 100u);
    for (std::size_t i = 0; i < 400; ++i) EXPECT_EQ(points[i], static_cast<long>(i));
    for (std::size_t i = 0; i < 100; ++i) EXPECT_EQ(offsets[i], static_cast<long>(4 * i + 4));
    EXPECT_EQ(sand.array<unsigned char>("types"), std::vector<unsigned char>(100, 9));
    EXPECT_EQ(sand.array<double>("void_ratio [-]"), std::vector<double>(100, 0.65));
    EXPECT_NEAR(sand.array<double>("p [kPa]")[99], 5.0, 1e-12);
    EXPECT_EQ(sand.array<double>("TimeValue"), std::vector<double>{0.0});

    const Element hammer = read_xml(here.text("push_000000_hammer.vtu"));
    EXPECT_EQ(hammer.array<double>("velocity [m/s]").size(), 48u);
    EXPECT_EQ(hammer.array<double>("velocity [m/s]")[10], -2.0);
    EXPECT_THROW(hammer.array<double>("void_ratio [-]"), std::runtime_error);
}

TEST_F(Fields, AreListedWithTheirTimesAlsoByARunThatGoesOn) {
    cli::MpmFieldFiles first = files_of(here, fields);
    first.write();
    simulation->step();
    first.write();
    cli::MpmFieldFiles second = files_of(here, fields);
    second.resume(first.times());
    simulation->step();
    second.write();
    const Element list = read_xml(here.text("push.pvd"));
    const auto entries = list.all("DataSet");
    ASSERT_EQ(entries.size(), 6u);
    for (const Element* entry : entries)
        EXPECT_TRUE(here.files().contains(entry->attributes.at("file")));
    EXPECT_EQ(entries[5]->attributes.at("file"), "push_000002_hammer.vtu");
    EXPECT_EQ(std::stod(entries[5]->attributes.at("timestep")), simulation->time());
    EXPECT_EQ(entries[5]->attributes.at("part"), "1");
}

TEST_F(Fields, AreNamedByNoListOfAnOlderRun) {
    cli::MpmFieldFiles(here.path("x"), {mpm_field("q")}, fields).write();
    const std::string older = here.text("x_000000_sand.vtu");
    std::filesystem::remove(here.path("x_000000_hammer.vtu"));
    std::filesystem::create_directory(here.path("x_000000_hammer.vtu"));  // which cannot be written
    cli::MpmFieldFiles files(here.path("x"), {mpm_field("p")}, fields);
    EXPECT_THROW(files.write(), element::CannotWrite);
    EXPECT_NE(here.text("x_000000_sand.vtu"), older);
    EXPECT_EQ(here.text("x.pvd").find("DataSet"), std::string::npos) << here.text("x.pvd");
}

TEST_F(Fields, OfBodiesWhoseNamesMakeNoFileNamesGetOthers) {
    simulation->body(0).name = simulation->body(1).name = "a/b";
    files_of(here, fields).write();
    EXPECT_EQ(here.files(), (std::set<std::string>{"push.pvd", "push_000000_a_b.vtu",
                                                   "push_000000_a_bbody1.vtu"}));
}

TEST_F(Fields, ThatFindNoRoomLeaveNoHalfWrittenFile) {
    cli::MpmFieldFiles files = files_of(here, fields);
    files.write();
    const std::string list = here.text("push.pvd");
    simulation->step();
    const NoRoom full(10000);
    EXPECT_THROW(files.write(), element::CannotWrite);
    EXPECT_EQ(here.text("push.pvd"), list);
    EXPECT_EQ(here.files().size(), 3u);
    EXPECT_EQ(files.times().size(), 1u);
}

// Bytes that this program has handed to the system for writing.
std::uint64_t bytes_written() {
    std::ifstream account("/proc/self/io");
    std::uint64_t value = 0;
    for (std::string word; account >> word >> value;)
        if (word == "wchar:") return value;
    return 0;
}

TEST_F(Fields, CostAsMuchToWriteAtEveryTime) {
    if (bytes_written() == 0) return;  // no account
    cli::MpmFieldFiles files = files_of(here, fields);
    const auto cost = [&] {
        const std::uint64_t before = bytes_written();
        files.write();
        return bytes_written() - before;
    };
    cost();
    const std::uint64_t early = cost();
    for (int i = 0; i < 200; ++i) files.write();
    EXPECT_LT(cost(), early + 100);
    EXPECT_EQ(read_xml(here.text("push.pvd")).all("DataSet").size(), 406u);
}

TEST_F(Fields, OfAKilledRunAreAllInAListThatIsWellFormed) {
    std::mt19937 random(23);
    std::size_t seen = 0;
    for (int trial = 0; trial < 60; ++trial) {
        int times[2] = {-1, -1};  // a byte goes through for each time that is written
        ASSERT_EQ(pipe(times), 0);
        const pid_t child = fork();
        if (child == 0) {
            cli::MpmFieldFiles files = files_of(here, fields);
            do files.write();
            while (write(times[1], "t", 1) == 1);
        }
        close(times[1]);
        char byte = 0;
        for (unsigned long left = 1 + random() % 4; left > 0; --left)
            ASSERT_EQ(read(times[0], &byte, 1), 1);
        usleep(static_cast<useconds_t>(random() % 5000));
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        close(times[0]);
        const Element list = read_xml(here.text("push.pvd"));
        const auto entries = list.all("DataSet");
        seen += entries.size();
        for (std::size_t i = 0; i < entries.size(); ++i)
            ASSERT_EQ(entries[i]->attributes.at("file"),
                      fmt::format("push_{:06}_{}.vtu", i / 2, i % 2 == 0 ? "sand" : "hammer"));
        EXPECT_FALSE(
            here.files().contains(fmt::format("push_{:06}_sand.vtu", entries.size() / 2 + 1)));
        std::filesystem::remove(here.path("push.pvd"));
        for (const std::string& file : here.files()) std::filesystem::remove(here.path(file));
    }
    EXPECT_GE(seen, 120u);
}

TEST_F(Fields, ThatFindNoRoomInTheListLeaveItWellFormed) {
    cli::PvdFile list(here.path("push.pvd"), {{{0.0, 0, "a.vtu"}}});
    const std::size_t size = here.text("push.pvd").size();
    const cli::PvdEntry one = {1.0, 0, "a_file_with_a_long_name_that_does_not_fit.vtu"};
    std::size_t entries = 1;
    std::string before;
    for (std::size_t more = 0; more + 300 < size; more += 97) {
        const NoRoom full(size + more);
        for (bool fits = true; fits && entries < 1000;) {
            before = here.text("push.pvd");
            try {
                list.add({one});
                ++entries;
            } catch (const element::CannotWrite&) {
                fits = false;
            }
        }
        EXPECT_EQ(here.text("push.pvd"), before);
        EXPECT_EQ(read_xml(before).all("DataSet").size(), entries);
        EXPECT_EQ(before.size(), size);
    }
    EXPECT_GT(entries, 30u);
    list.add({one});
    EXPECT_EQ(read_xml(here.text("push.pvd")).all("DataSet").size(), entries + 1);
    EXPECT_GT(here.text("push.pvd").size(), size);
}

// A system that kills a program writes what is within a page whole or not at all.
TEST_F(Fields, HaveNoEntryOfTheListInTwoPages) {
    cli::PvdFile list(here.path("push.pvd"), {{{0.0, 0, "a.vtu"}}});
    std::size_t size = 0;
    for (int i = 1; i < 2000; ++i) {
        const std::string before = here.text("push.pvd");
        list.add({{0.1 * i, 0, "soil.vtu"}, {0.1 * i, 1, "pile.vtu"}});
        const std::string after = here.text("push.pvd");
        if (after.size() != size) {  // written anew, beside
            size = after.size();
            continue;
        }
        std::vector<std::size_t> changed;
        for (std::size_t at = 0; at < size; ++at)
            if (before[at] != after[at]) changed.push_back(at);
        for (std::size_t k = 0; k < 2; ++k) {
            const std::size_t from =
                after.find("<DataSet", k == 0 ? changed.front() : after.rfind("<DataSet"));
            EXPECT_EQ(from / 4096, after.find('>', from) / 4096) << i;
        }
        EXPECT_EQ(after.find("<DataSet"), before.find("<DataSet"));
    }
    EXPECT_EQ(read_xml(here.text("push.pvd")).all("DataSet").size(), 3999u);
}

TEST_F(Fields, HaveTheSameListWhetherItGrewOrWasMadeOfAllOfThem) {
    std::vector<std::vector<cli::PvdEntry>> frames;
    for (int i = 0; i < 500; ++i)
        frames.push_back({{0.1 * i, 0, "soil.vtu"}, {0.1 * i, 1, "pile.vtu"}});
    cli::PvdFile grown(here.path("grown.pvd"), {frames.front()});
    for (std::size_t i = 1; i < frames.size(); ++i) grown.add(frames[i]);
    const cli::PvdFile made(here.path("made.pvd"), frames);
    EXPECT_EQ(here.text("grown.pvd"), here.text("made.pvd"));
}

}  // namespace
