// SPDX-License-Identifier: BSD-3-Clause
// The layout of libGRITUMAT.so.
#include <algorithm>

#include "adapters/abaqus/layout.hpp"

namespace grit::abaqus {

const Layout layout{GRIT_DEGREE,
                    "degrees",
                    "radians",
                    0,
                    GRIT_CLASSIC_VOID_RATIO,
                    [](const double* props, double* out, grit_error&) -> grit_status {
                        std::copy_n(props, GRIT_CLASSIC_NPROPS, out);
                        return GRIT_OK;
                    }};

}  // namespace grit::abaqus
