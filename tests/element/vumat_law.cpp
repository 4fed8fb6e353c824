// SPDX-License-Identifier: BSD-3-Clause
// A law behind a VUMAT symbol: the same sand, without a tangent of its own and without rotations.
#include <element/vumat_law.hpp>

#include <gtest/gtest.h>

#include <element/umat_law.hpp>

#include "support/lausitz.hpp"

namespace {

using namespace tests;
using namespace element;

UmatSource source_of(const char* library) {
    UmatSource source;
    source.library = library;
    source.props = {33.0, 0.0, 1.6e6, 0.19, 0.44, 0.85, 1.0, 0.25,
                    1.0,  5.0, 2.0,   1e-4, 0.5,  6.0,  0.0, 10.7};
    source.state_size = 14;
    return source;
}

StrainIncrement increment_of_all_components() {
    StrainIncrement increment;
    increment.strain << -0.001, 0.0004, 0.0001, 0.0003, -0.0002, 0.0001;
    return increment;
}

TEST(VumatLaw, ComesToTheStressOfTheUmatAndNearItsTangent) {
    const UmatLaw umat(source_of(GRIT_UMAT_LIBRARY));
    const VumatLaw vumat(source_of(GRIT_VUMAT_LIBRARY));
    EXPECT_EQ(vumat.symbol(), "vumat_");
    const MaterialPoint start = umat.start(-100.0 * unit_tensor(), {0, 0, 0, 0, 0, 0, 0.7});
    const Response a = umat.advance(start, increment_of_all_components());
    const Response b = vumat.advance(start, increment_of_all_components());
    ASSERT_EQ(b.outcome, Outcome::done);
    EXPECT_EQ(a.end.stress, b.end.stress);
    EXPECT_EQ(a.end.state, b.end.state);
    EXPECT_LE((a.tangent - b.tangent).norm(), 0.02 * a.tangent.norm());
}

// It keeps such a point as it was and says so in STATEV(10): not done, but to be tried with less.
TEST(VumatLaw, IsAskedForLessWhereItLeavesAPointAsItWas) {
    const VumatLaw law(source_of(GRIT_VUMAT_LIBRARY));
    const MaterialPoint start = law.start(-100.0 * unit_tensor(), {0, 0, 0, 0, 0, 0, 0.8});
    StrainIncrement increment;
    increment.strain << -0.22, 0, 0, 0, 0, 0;
    const Response response = law.advance(start, increment);
    EXPECT_EQ(response.outcome, Outcome::retry_smaller);
    EXPECT_GT(response.reduction, 0.0);
    EXPECT_NE(response.message.find("STATEV(10)"), std::string::npos) << response.message;
    increment.strain *= 0.5;
    EXPECT_EQ(law.advance(start, increment).outcome, Outcome::done);
}

TEST(VumatLaw, RefusesRotations) {
    const VumatLaw law(source_of(GRIT_VUMAT_LIBRARY));
    StrainIncrement increment = increment_of_all_components();
    increment.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    const Response response =
        law.advance(law.start(-100.0 * unit_tensor(), {0, 0, 0, 0, 0, 0, 0.7}), increment);
    EXPECT_EQ(response.outcome, Outcome::hopeless);
    EXPECT_NE(response.message.find("rotations"), std::string::npos);
}

TEST(VumatLaw, IsFoundInALibraryThatHasNoUmat) {
    EXPECT_EQ(open_library_law(source_of(GRIT_VUMAT_LIBRARY))->symbol(), "vumat_");
    EXPECT_EQ(open_library_law(source_of(GRIT_UMAT_LIBRARY))->symbol(), "umat_");
}

}  // namespace
