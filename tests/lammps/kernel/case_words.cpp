// SPDX-License-Identifier: BSD-3-Clause
// The table of the words of cases, and that the fix knows those it lists.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>

#include <adapters/lammps/fix_case.hpp>
#include <adapters/mpm/case/case_words.hpp>

namespace {

using namespace grit::mpm;

const grit::lammps::Box box{{{0.0, 30.0}, {0.0, 30.0}}};

std::string refusal_of(const std::vector<std::string>& words) {
    try {
        grit::lammps::read_fix(words, box);
    } catch (const std::invalid_argument& refused) {
        return refused.what();
    }
    return {};
}

std::string refusal_of_stage(const std::vector<std::string>& words) {
    try {
        grit::lammps::read_stage(words, {}, Case());
    } catch (const std::invalid_argument& refused) {
        return refused.what();
    }
    return {};
}

TEST(CaseWords, HaveOneRowForEachKeyAndWordsForEachChoice) {
    std::set<std::pair<std::string_view, std::string_view>> keys;
    for (const CaseWord& word : words::all) {
        EXPECT_TRUE(keys.insert({word.section, word.key}).second)
            << word.section << '.' << word.key;
        EXPECT_EQ(word.kind == Kind::choice, !word.words.empty()) << word.key;
        EXPECT_LE(word.range.low, word.range.high) << word.key;
        for (const Spelling& spelling : word.words)
            EXPECT_EQ(word_of(word.words, spelling.value), spelling.word);
        // A key says its unit, as far as it has one.
        const std::string key(word.key), unit(word.unit);
        const auto ends = [&](const char* ending) {
            const std::string_view last = ending;
            return key.size() > last.size() && key.substr(key.size() - last.size()) == last;
        };
        EXPECT_EQ(unit == "kPa", ends("_kPa")) << key;
        EXPECT_EQ(word.si, unit == "kPa" ? 1e3 : 1.0) << key;
        EXPECT_EQ(unit == "m/s", ends("_m_per_s")) << key;
        EXPECT_EQ(unit == "m/s²", ends("_m_per_s2")) << key;
        EXPECT_EQ(unit == "kg/m³", ends("_kg_per_m3")) << key;
        EXPECT_EQ(unit == "s", ends("_s") && !ends("_per_s")) << key;
        EXPECT_EQ(unit == "m", ends("_m")) << key;
    }
}

// What a plan says that says nothing is what a reader would take, and members keep what they are given.
template <class Plan> void expect_members_to_fit(std::span<const Member<Plan>> members) {
    for (const Member<Plan>& member : members) {
        const CaseWord& word = *member.word;
        Plan plan;
        const double plain = member.get(plan);
        if (word.kind == Kind::number && std::isfinite(plain)) {
            EXPECT_TRUE(word.si_range().has(plain)) << word.key;
        }
        double other = plain == 0.5 ? 0.25 : 0.5;
        if (word.kind == Kind::yes_or_no) other = 1.0 - plain;
        if (word.kind == Kind::integer) other = 7.0;
        if (word.kind == Kind::choice) other = word.words.back().value;
        member.set(plan, other);
        EXPECT_EQ(member.get(plan), other) << word.key;
        member.set(plan, plain);
        for (const Member<Plan>& each : members)
            EXPECT_EQ(each.get(plan), each.get(Plan())) << word.key << " sets " << each.word->key;
    }
}

TEST(CaseWords, AreEachOneMemberOfAPlanAlone) {
    expect_members_to_fit(numerics_members());
    expect_members_to_fit(contact_members());
    expect_members_to_fit(stage_members());
    expect_members_to_fit(end_members());
}

// Plans that are made without a reader.
TEST(CaseWords, SayForWhatIsNotGivenWhatPlansDo) {
    EXPECT_EQ(case_word("body", "particles_per_cell_r").otherwise_number(), BodyPlan{}.particles_r);
    EXPECT_EQ(case_word("body", "particles_per_cell_z").otherwise_number(), BodyPlan{}.particles_z);
    EXPECT_EQ(case_word("body.stress_at_rest", "surcharge_kPa").otherwise_number(),
              Geostatic{}.surcharge);
    EXPECT_EQ(case_word("contact", "stiffness_multiple").otherwise_number(),
              PenaltyPlan{}.stiffness_multiple);
    EXPECT_EQ(case_word("traction.pulses", "count").otherwise_number(), PulseTrain{}.count);
    EXPECT_EQ(case_word("traction.pulses", "start_s").otherwise_number(), PulseTrain{}.start);
    EXPECT_EQ(case_word("body.rigid", "velocity_r_m_per_s").otherwise_number(), 0.0);
    EXPECT_THROW(case_word("body.box", "particles_per_cell_r").otherwise_number(),
                 std::logic_error);
    EXPECT_THROW(case_word("body.elastic", "poissons_ratio").otherwise_number(), std::logic_error);
}

TEST(CaseWords, OfTheFixAreKnownToIt) {
    for (const FixKeyword& keyword : fix_keywords())
        EXPECT_EQ(refusal_of({"plane_strain", std::string(keyword.word)}).find("the command ends"),
                  0u)
            << keyword.word;
    for (const Member<Case>& member : numerics_members())
        EXPECT_EQ(refusal_of({"plane_strain", std::string(member.fix)}).find("the command ends"),
                  0u)
            << member.fix;
    for (const Member<StagePlan>& member : stage_members())
        EXPECT_EQ(refusal_of_stage({std::string(member.fix)}).find("the command ends"), 0u);
    for (const Member<StageEnd>& member : end_members())
        EXPECT_EQ(refusal_of_stage({std::string(member.fix)}).find("the command ends"), 0u);
    EXPECT_EQ(refusal_of({"plane_strain", "grud"}), "unknown keyword \"grud\"");
}

// Words that files alone have.
TEST(CaseWords, ThatTheFixDoesNotHaveAreRefusedWithThoseThatItHas) {
    EXPECT_EQ(refusal_of({"plane_strain", "boundary", "left", "absorbing"}),
              "the boundary of a side must be one of free, roller, fixed, got \"absorbing\"");
    EXPECT_EQ(refusal_of({"plane_strain", "contact", "a", "b", "penalty"}),
              "the law of a contact must be one of geo, frictional, surface, got \"penalty\"");
}

TEST(CaseWords, OfOtherLawsAreRefusedByAContactWithThoseThatHaveThem) {
    const auto of = [](const std::string& law, const std::string& word, const std::string& value) {
        return refusal_of({"plane_strain", "contact", "a", "b", law, "0.3", word, value});
    };
    EXPECT_EQ(of("surface", "power", "6"), "power belongs to the law geo, not to surface");
    EXPECT_EQ(of("surface", "normal", "soft"),
              "normal belongs to the laws geo and frictional, not to surface");
    EXPECT_EQ(of("surface", "gated", "no"),
              "gated belongs to the laws geo and frictional, not to surface");
    EXPECT_EQ(of("geo", "after_damping", "yes"),
              "after_damping belongs to the law surface, not to geo");
    EXPECT_EQ(of("frictional", "stiffness_multiple", "1"),
              "stiffness_multiple belongs to the laws geo and surface, not to frictional");
}

TEST(CaseWords, OfASurfaceThatIsToldAreForTheLawSurface) {
    const auto of = [](const std::string& geometry, const std::string& law,
                       const std::string& word = "stiff_surface",
                       const std::string& next = "nowhere.stl") {
        return refusal_of({geometry, "contact", "a", "b", law, "0.3", word, next});
    };
    EXPECT_EQ(of("space", "surface", "stiff_line", "2"), "stiff_line is not there in space");
    EXPECT_EQ(of("axisymmetric", "frictional", "stiff_line", "2"),
              "stiff_line belongs to the law surface, not to frictional");
    EXPECT_EQ(of("axisymmetric", "surface"), "stiff_surface is there in space alone");
    EXPECT_EQ(of("space", "geo"), "stiff_surface belongs to the law surface, not to geo");
}

}  // namespace
