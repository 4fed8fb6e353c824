// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/pictures.hpp"
#include "cli/plot/history_panels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "support/sand_box.hpp"
#include "support/workplace.hpp"

namespace {

using namespace cli_test;
using cli::mpm_field;

bool gnuplot() { return std::system("gnuplot --version > /dev/null 2>&1") == 0; }

std::size_t count(const std::string& text, const std::string& word) {
    std::size_t out = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
        ++out;
    return out;
}

class FieldPictures : public testing::Test {
  protected:
    FieldPictures() {
        for (int i = 0; i < 400; ++i) simulation->step();
    }
    std::size_t polygons(cli::FieldPicture picture) {
        picture.files.svg = true;
        EXPECT_EQ(cli::draw_field(here.path("x"), picture, fields), "");
        EXPECT_EQ(here.files(), (std::set<std::string>{"x.png", "x.svg"}));
        return count(here.text("x.svg"), "<polygon") + count(here.text("x.svg"), "<path fill");
    }
    Workplace here;
    std::unique_ptr<grit::mpm::Simulation> simulation = sand_box();
    cli::MpmFields fields{*simulation};
};

TEST_F(FieldPictures, ShowEveryDomainAndItsMirrorImage) {
    if (!gnuplot()) return;
    cli::FieldPicture picture{mpm_field("velocity"), "Falling sand", {}};
    const std::size_t half = polygons(picture);
    EXPECT_GE(half, 116u);
    picture.mirrored = true;
    EXPECT_GE(polygons(picture), half + 116);
    EXPECT_NE(here.text("x.svg").find("|velocity| [m/s]"), std::string::npos);
}

TEST_F(FieldPictures, ShowWhatIsInTheWindow) {
    if (!gnuplot()) return;
    cli::FieldPicture picture{mpm_field("void_ratio"), "Sand", {}};
    const std::size_t all = polygons(picture);
    picture.window = {0.0, 0.2, 0.0, 0.2};
    EXPECT_LE(polygons(picture), all - 60);
    picture.window = {5.0, 6.0, 5.0, 6.0};
    EXPECT_EQ(cli::draw_field(here.path("y"), picture, fields), "no particle is in the window");
}

TEST_F(FieldPictures, AreOfPixelsUnlessOtherFilesAreAskedFor) {
    if (!gnuplot()) return;
    const cli::FieldPicture picture{mpm_field("velocity"), "Falling sand", {}};
    EXPECT_EQ(cli::draw_field(here.path("z"), picture, fields), "");
    EXPECT_EQ(here.files(), std::set<std::string>{"z.png"});
}

TEST(HistoryPicture, HasAPanelForEachKindOfCurveThatTheHistoryHas) {
    if (!gnuplot()) return;
    const Workplace here;
    cli::Table history;
    for (const char* name : {"t", "depth", "tip_force", "shaft_force", "dt", "kinetic_energy",
                             "stored_energy", "external_work", "contact_loss"}) {
        std::vector<double> values;
        for (int i = 0; i < 200; ++i)
            values.push_back(history.columns.empty() ? 1e-3 * i : i * std::sin(0.05 * i));
        history.columns.push_back({name, "", values, ""});
    }
    const cli::Picture picture = cli::picture_of_histories({{"", history}}, "A pile");
    ASSERT_EQ(picture.panels.size(), 4u);
    EXPECT_EQ(picture.panels[1].series.size(), 2u);
    EXPECT_NEAR(picture.panels[3].series[0].y.back(), 1e6 * history.at("dt").back(), 1e-6);
    // Where no step was made there is neither its length nor a mean of forces, and the axis begins there all the same.
    EXPECT_EQ(picture.panels[0].series[0].x.front(), 0.0);
    for (const std::size_t panel : {1, 3}) {
        EXPECT_EQ(picture.panels[panel].series[0].x.front(), 1e-3);
        EXPECT_EQ(picture.panels[panel].x_from, 0.0);
    }
    EXPECT_EQ(cli::draw(here.path("x"), picture), "");
    EXPECT_NE(here.text("x.svg").find("kinetic"), std::string::npos);
}

}  // namespace
