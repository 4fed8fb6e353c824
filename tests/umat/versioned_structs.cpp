// SPDX-License-Identifier: BSD-3-Clause
// Structs of older and newer callers, told by struct_size.
#include <cmath>
#include <cstring>

#include "support/states.hpp"
#include "support/update.hpp"

namespace {

using namespace tests;

// A caller compiled against a later version: our struct with room behind it.
template <class Struct> struct Newer {
    Struct known;
    double unknown[2] = {0.0, 0.0};
};

TEST(VersionedStructs, ParametersOfANewerCallerAreAcceptedWhileTheirUnknownPartIsZero) {
    Newer<grit_sand_parameters> p;
    p.known = parameters_of("lausitz");
    p.known.struct_size = sizeof p;
    grit_sand sand;
    grit_error error{};
    EXPECT_EQ(grit_sand_prepare(&p.known, &sand, &error), GRIT_OK) << error.message;
    p.unknown[1] = 1.0;
    EXPECT_EQ(grit_sand_prepare(&p.known, &sand, &error), GRIT_BAD_CALL);
    EXPECT_NE(std::string(error.message).find("struct_size"), std::string::npos) << error.message;
}

TEST(VersionedStructs, ParametersThatAnOlderCallerDoesNotKnowHaveTheirDefaults) {
    grit_sand_parameters p = parameters_of("lausitz");
    p.struct_size = offsetof(grit_sand_parameters, reversal_stiffness);
    grit_sand sand;
    ASSERT_EQ(grit_sand_prepare(&p, &sand, nullptr), GRIT_OK);
    grit_sand_parameters returned;
    grit_sand_parameters_init(&returned, sizeof returned);
    ASSERT_EQ(grit_sand_parameters_of(&sand, &returned), GRIT_OK);
    EXPECT_EQ(returned.granulate_hardness, p.granulate_hardness);
    EXPECT_TRUE(std::isnan(returned.reversal_stiffness)) << "no intergranular strain";
}

TEST(VersionedStructs, InitWritesNoFurtherThanTheCallersStruct) {
    unsigned char bytes[sizeof(grit_sand_parameters)];
    std::memset(bytes, 0x77, sizeof bytes);
    const std::size_t size = offsetof(grit_sand_parameters, stiffness_exponent);
    auto* p = reinterpret_cast<grit_sand_parameters*>(bytes);
    ASSERT_EQ(grit_sand_parameters_init(p, size), GRIT_OK);
    for (std::size_t i = size; i < sizeof bytes; ++i) ASSERT_EQ(bytes[i], 0x77) << i;
    EXPECT_EQ(p->struct_size, size);
}

TEST(VersionedStructs, ImpossibleSizesAreRefused) {
    grit_sand_parameters p = parameters_of("lausitz");
    grit_sand sand;
    // Within a word: half of a pointer.
    for (const std::size_t size :
         {std::size_t(0), std::size_t(4), sizeof p - 1, sizeof p - 4, std::size_t(1) << 40}) {
        p.struct_size = size;
        EXPECT_EQ(grit_sand_prepare(&p, &sand, nullptr), GRIT_BAD_CALL) << size;
        grit_sand_options options;
        EXPECT_EQ(grit_sand_options_init(&options, size), GRIT_BAD_CALL) << size;
    }
}

TEST(VersionedStructs, OptionsOfOlderAndNewerCallersGiveTheSameResult) {
    const Sand& sand = four_sands()[0];
    Random random(20);
    const Point start = point_of(random_state(sand, random));
    const Voigt dE = voigt_strain(1e-4 * random.direction());
    Point expected = start;
    update(sand, expected, dE.data(), options_with(1e-7));

    grit_sand_options older = options_with(1e-7);
    older.struct_size = offsetof(grit_sand_options, evaluation_limit);
    Point a = start;
    EXPECT_EQ(update(sand, a, dE.data(), older).status, GRIT_OK);
    if (options_with().instruction_set == GRIT_ISA_BEST) {
        EXPECT_TRUE(same_bits(a, expected));
    }

    Newer<grit_sand_options> newer;
    newer.known = options_with(1e-7);
    newer.known.struct_size = sizeof newer;
    Point b = start;
    EXPECT_EQ(update(sand, b, dE.data(), newer.known).status, GRIT_OK);
    EXPECT_TRUE(same_bits(b, expected));
}

// The struct of a caller that does not know "substep", and of one that knows more.
template <class Call> void expect_same_of_older_and_newer_points(const Point& start, Call call) {
    const Voigt dE = voigt_strain(Vec(1e-4 * Vec::Unit(0)));
    const auto points_at = [&](Point& p, std::size_t size) {
        Newer<grit_sand_points> q{};
        q.known.struct_size = size;
        q.known.strain_increment = grit_view_of(dE.data(), 6, 1);
        q.known.stress = grit_mutable_view_of(p.stress, 6, 1);
        q.known.state = grit_mutable_view_of(p.state, GRIT_SAND_STATE_SIZE, 1);
        return q;
    };
    Point expected = start, a = start, b = start;
    ASSERT_EQ(call(points_at(expected, sizeof(grit_sand_points)).known), GRIT_OK);
    auto older = points_at(a, offsetof(grit_sand_points, substep));
    older.known.substep = {nullptr, 7, 7};  // not the caller's to say
    older.known.substep.base = &older.unknown[0];
    EXPECT_EQ(call(older.known), GRIT_OK);
    EXPECT_TRUE(same_bits(a, expected));
    EXPECT_EQ(older.unknown[0], 0.0);
    auto newer = points_at(b, sizeof(Newer<grit_sand_points>));
    EXPECT_EQ(call(newer.known), GRIT_OK);
    EXPECT_TRUE(same_bits(b, expected));
    newer.unknown[1] = 1.0;
    EXPECT_EQ(call(newer.known), GRIT_BAD_CALL);
}

TEST(VersionedStructs, PointsOfOlderAndNewerCallersGiveTheSameResult) {
    const Sand& sand = four_sands()[0];
    Random random(22);
    const Point start = point_of(random_state(sand, random));
    const grit_sand_options options = options_with();
    expect_same_of_older_and_newer_points(start, [&](const grit_sand_points& q) {
        return grit_sand_update(sand, &options, 1, &q, nullptr, nullptr);
    });
    double modulus[2] = {};
    int calls = 0;
    expect_same_of_older_and_newer_points(start, [&](const grit_sand_points& q) {
        const grit_status status =
            grit_sand_wave_moduli(sand, &options, 1, &q, &modulus[calls++ > 0], nullptr);
        EXPECT_EQ(modulus[calls > 1], modulus[0]);
        return status;
    });
}

TEST(VersionedStructs, ResultsReachOnlyAsFarAsTheCallersStruct) {
    const Sand& sand = four_sands()[0];
    grit_sand_scalar_factors f{};
    f.struct_size = offsetof(grit_sand_scalar_factors, f_d);
    f.f_d = -7.0;
    const double stress[6] = {-100.0, -100.0, -100.0, 0.0, 0.0, 0.0};
    ASSERT_EQ(grit_sand_factors(sand, stress, 0.6, &f), GRIT_OK);
    EXPECT_GT(f.F, 0.0);
    EXPECT_EQ(f.f_d, -7.0);
}

}  // namespace
