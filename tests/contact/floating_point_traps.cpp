// SPDX-License-Identifier: BSD-3-Clause
// Hosts that trap division by zero and invalid operations, as Fortran debug builds do, meet none in nodes
// that are empty, out of contact, or hold anything where one body is alone.
#include <cfenv>
#include <limits>

#include <grit/version.h>

#include "support/nodes.hpp"

namespace {

using namespace tests;

TEST(FloatingPointTraps, AreNotSprungByGoodNodes) {
    const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
    for (int isa = GRIT_ISA_BASELINE; isa <= grit_instruction_set(); ++isa)
        for (const std::size_t count : {std::size_t(1), std::size_t(16)})
            for (std::size_t odd = 0; odd < 7; ++odd) {
                Nodes nodes = random_nodes(count, 3, 72);
                Node& x = nodes.node[count / 2];
                if (odd == 0) x.m_a = x.m_b = 0.0;
                if (odd == 1) x.m_a = 0.0;
                if (odd == 1) x.v_a = x.v_b = x.n = {nan, nan, nan};
                if (odd == 1) x.s = x.d = x.gap = nan;
                if (odd == 2) x.s = x.gap = infinity;
                if (odd == 3) x.n = {0.0, 0.0, 0.0};
                if (odd == 4) x.v_a = x.v_b;
                if (odd == 5) x.v_a = x.v_b + x.n;  // no slip
                if (odd == 6) x.n = {0.0, 0.0, 0.0};
                if (odd == 6) x.s = infinity;
                nodes.gated = true;
                grit_contact_options options = options_with();
                options.allow_zero_normal = 1;
                options.instruction_set = isa;
                options.adhesion = odd % 2 ? 1.0 : 0.0;
                options.time_step = 1e-3;
                options.contact_stiffness = odd == 0 || odd == 5 ? 0.0 : 1e5;
                std::feclearexcept(FE_ALL_EXCEPT);
                grit_contact_nodes views = nodes.views();
                const Vec edges = {0.1, 0.2, 0.3};
                if (odd == 6) views.cell_size = {};
                if (odd == 6) views.spacing = grit_view_of(edges.data(), 0, 1);
                EXPECT_EQ(nodes.correct(options, views, nodes.size()), GRIT_OK)
                    << nodes.error.message;
                EXPECT_EQ(std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW), 0)
                    << "isa " << isa << ", case " << odd << ", nodes " << count;
            }
}

}  // namespace
