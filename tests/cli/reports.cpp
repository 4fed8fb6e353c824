// SPDX-License-Identifier: BSD-3-Clause
// grit report: what it finds in a folder, and what it cannot read.
#include <gtest/gtest.h>

#include <filesystem>

#include "support/workplace.hpp"

namespace {

const std::string table = "# Grit 0.1.0, case x: One test\na,b\n1,2\n2,3\n";

class Report : public testing::Test {
  protected:
    Report() {
        for (const char* folder : {"r/dense_v2", "lab"})
            std::filesystem::create_directories(here.path(folder));
        here.write("r/dense.csv", table);
    }
    // The page of the folder r.
    std::string page(const std::string& options = "") {
        answer = here.grit("report r " + options);
        EXPECT_EQ(answer.status, 0) << answer.text;
        return here.text("r/index.html");
    }
    Workplace here;
    Answer answer;
};

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST_F(Report, GivesARunThePicturesBesideItAlone) {
    for (const char* name : {"r/dense_p.svg", "r/dense_v2/q.svg"}) here.write(name, "<svg></svg>");
    const std::string text = page();
    EXPECT_TRUE(has(text, "picture: p<")) << answer.text;
    EXPECT_TRUE(has(text, "alt=\"dense_v2/q\""));
}

TEST_F(Report, SaysWhichFrameCannotBeReadAndShowsTheRest) {
    here.write("r/run.pvd", "<VTKFile type=\"Collection\"><Collection><DataSet timestep=\"0\" "
                            "part=\"0\" file=\"run_0.vtu\"/></Collection></VTKFile>");
    here.write("r/foreign.pvd", "<VTKFile/>");
    const std::string text = page();
    EXPECT_TRUE(has(text, "class=\"bad\">r/run_0.vtu")) << answer.text;
    EXPECT_TRUE(has(text, "class=\"bad\">r/foreign.pvd")) << answer.text;
    EXPECT_TRUE(has(text, "One test"));
    EXPECT_TRUE(answer.says("run_0.vtu")) << answer.text;
}

TEST_F(Report, SaysWhichLineOfItsStoryIsOfNoResult) {
    here.write("story.txt", "== Part\nsparse | This sentence is lost.\ndense | This is not.\n");
    EXPECT_TRUE(has(page("--story story.txt"), "This is not."));
    EXPECT_TRUE(answer.says("story.txt:2: no result is called sparse")) << answer.text;
}

TEST_F(Report, LetsNoNumbersEndItsScript) {
    here.write("r/n.json", "{\"a\": \"<!-- <script>\", \"b\": \"</script>\"}");
    const std::string text = page();
    EXPECT_TRUE(has(text, "{\"a\": \"\\u003c!-- \\u003cscript>\", \"b\": \"\\u003c/script>\"}"));
}

TEST_F(Report, CallsALinkByItsOwnName) {
    here.write("lab/long.csv", table);
    for (const char* name : {"r/one.csv", "r/two.csv"})
        std::filesystem::create_symlink("../lab/long.csv", here.path(name));
    const std::string text = page();
    for (const char* name : {"id=\"one\"", "id=\"two\""}) EXPECT_TRUE(has(text, name)) << name;
}

}  // namespace
