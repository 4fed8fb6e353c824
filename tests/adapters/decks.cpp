// SPDX-License-Identifier: BSD-3-Clause
// The input decks that ship hold a material that the library takes, and what hosts want around it.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "support/umat_call.hpp"

namespace {

struct Deck {
    std::vector<double> constants;  // all numbers below *USER MATERIAL
    int depvar = 0;
    std::string material, text;
};

std::vector<double> numbers_of(std::string line) {
    for (char& c : line)
        if (c == ',') c = ' ';
    std::istringstream in(line);
    std::vector<double> out;
    for (double x; in >> x;) out.push_back(x);
    return out;
}

Deck read(const std::string& name) {
    std::ifstream file(GRIT_DECKS "/" + name);
    EXPECT_TRUE(file) << name;
    Deck out;
    std::string keyword;
    for (std::string line; std::getline(file, line);) {
        out.text += line + "\n";
        if (line.rfind("**", 0) == 0) continue;
        if (line.rfind("*", 0) == 0) {
            keyword = line.substr(0, line.find(','));
            if (keyword == "*MATERIAL") out.material = line.substr(line.find("NAME=") + 5);
            continue;
        }
        const std::vector<double> numbers = numbers_of(line);
        if (keyword == "*USER MATERIAL")
            out.constants.insert(out.constants.end(), numbers.begin(), numbers.end());
        if (keyword == "*DEPVAR") out.depvar = static_cast<int>(numbers.at(0));
    }
    return out;
}

TEST(Decks, HoldAMaterialThatTheLibraryTakes) {
    for (const char* name : {"abaqus_standard.inp", "abaqus_explicit.inp", "calculix.inp"}) {
        const Deck deck = read(name);
        ASSERT_GE(deck.constants.size(), 16U) << name;
        UmatCall call = UmatCall::hochstetten();
        for (int i = 0; i < 16; ++i) call.props[i] = deck.constants[static_cast<std::size_t>(i)];
        EXPECT_EQ(deck.depvar, 14);
        call.set_dstran(-1e-4, 0, 0);
        call.run();
        EXPECT_EQ(call.pnewdt, 1.0) << name;
        EXPECT_NEAR(call.statev[6], 0.60, 1e-3) << name;
    }
}

// Sixteen constants fill two lines: CalculiX then reads a third, with a temperature.
TEST(Decks, GiveCalculixTheLineThatSixteenConstantsNeed) {
    EXPECT_EQ(read("calculix.inp").constants.size(), 17U);
    EXPECT_EQ(read("abaqus_standard.inp").constants.size(), 16U);
    EXPECT_EQ(read("abaqus_explicit.inp").constants.size(), 16U);
}

TEST(Decks, NameTheLibraryAndTheFunctionThatCalculixLoads) {
    EXPECT_EQ(read("calculix.inp").material, "@ABAQUS_GRITUMAT_SAND");
}

TEST(Decks, AskAbaqusStandardForTheUnsymmetricSolver) {
    EXPECT_NE(read("abaqus_standard.inp").text.find("CONSTANTS=16, UNSYMM"), std::string::npos);
}

}  // namespace
