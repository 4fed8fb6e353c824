// SPDX-License-Identifier: BSD-3-Clause
// The library as a loader of MGIS meets it.
#include <gtest/gtest.h>

#include <cstddef>
#include <fstream>
#include <stdexcept>

#include "support/mgis_point.hpp"

namespace {

using namespace mgis_host;

TEST(MgisSymbols, LoadForEveryHypothesis) {
    for (const char* hypothesis : hypotheses) {
        const Behaviour b = load(hypothesis);
        EXPECT_EQ(b.size_of(b.gradients), b.components) << hypothesis;
        EXPECT_EQ(b.size_of(b.state_variables), b.components + 4) << hypothesis;
        EXPECT_FALSE(b.stored_energy);
        EXPECT_TRUE(b.dissipated_energy);
    }
}

TEST(MgisSymbols, AreNotThereForPlaneStress) {
    EXPECT_THROW(load("PlaneStress"), std::runtime_error);
}

TEST(MgisSymbols, AreAllOfUseToALoader) {
    std::set<std::string> used, listed;
    for (const char* hypothesis : hypotheses) used.merge(load(hypothesis).symbols);
    std::ifstream exports(GRIT_MGIS_EXPORTS);
    for (std::string symbol; std::getline(exports, symbol);) listed.insert(symbol);
    EXPECT_EQ(used, listed);
}

TEST(MgisSymbols, NameTheMaterialPropertiesInTheOrderOfTheClassicLayout) {
    const std::vector<std::string> expected = {
        "CriticalFrictionAngle", "PressureShift",
        "GranulateHardness",     "StiffnessExponent",
        "DensestVoidRatio",      "CriticalVoidRatio",
        "LoosestVoidRatio",      "PyknotropyExponent",
        "StiffnessVoidExponent", "ReversalStiffness",
        "TransverseStiffness",   "ElasticStrainRadius",
        "EvolutionExponent",     "StiffnessInterpolationExponent",
        "WaterStiffness",        "InitialVoidRatio"};
    EXPECT_EQ(load("Tridimensional").properties, expected);
}

TEST(MgisSymbols, NameTheStateVariablesWithTheirTypes) {
    const Behaviour b = load("PlaneStrain");
    const std::vector<Variable> expected = {{"IntergranularStrain", 1},
                                            {"VoidRatio", 0},
                                            {"Separation", 0},
                                            {"ExcessPorePressure", 0},
                                            {"FirstSubstep", 0}};
    ASSERT_EQ(b.state_variables.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(b.state_variables[i].name, expected[i].name);
        EXPECT_EQ(b.state_variables[i].type, expected[i].type) << expected[i].name;
    }
    EXPECT_EQ(b.place_of("VoidRatio"), 4);
}

TEST(MgisSymbols, AskForTheTemperatureAloneOfTheExternalStateVariables) {
    const Behaviour b = load("Tridimensional");
    ASSERT_EQ(b.external_variables.size(), 1u);
    EXPECT_EQ(b.external_variables[0].name, "Temperature");
}

// The library's structures and those of this test were declared apart; an Itanium ABI has these places.
TEST(MgisSymbols, ShareTheLayoutOfACallWithTheHost) {
    EXPECT_EQ(sizeof(StateView), 8 * sizeof(void*));
    EXPECT_EQ(offsetof(BehaviourDataView, K), 16u);
    EXPECT_EQ(offsetof(BehaviourDataView, rdt), 24u);
    EXPECT_EQ(offsetof(BehaviourDataView, speed_of_sound), 32u);
    EXPECT_EQ(offsetof(BehaviourDataView, s0), 40u);
    EXPECT_EQ(offsetof(BehaviourDataView, s1), 104u);
    EXPECT_EQ(sizeof(BehaviourDataView), 168u);
}

}  // namespace
