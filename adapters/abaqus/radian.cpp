// SPDX-License-Identifier: BSD-3-Clause
// The layout of libGRITUMATR.so.
#include "adapters/abaqus/layout.hpp"
#include "adapters/host/failure.hpp"

namespace grit::abaqus {
namespace {

// In this family PROPS(2) is Poisson's ratio, which the sand does not need, or a pressure, which would
// change its answers: that one must not be passed over.
grit_status classic_props(const double* props, double* out, grit_error& error) {
    const double nu = props[GRIT_RADIAN_POISSON_RATIO];
    if (!(nu >= 0.0 && nu < 0.5))
        return failure(error, GRIT_BAD_PARAMETER,
                       "PROPS(2) (nu, not used) must be in [0, 0.5), got %g: a pressure p_c is not "
                       "supported, p_t of the classic layout (libGRITUMAT.so) shifts the pressure",
                       nu);
    grit_radian_to_classic(props, out);
    return GRIT_OK;
}

}  // namespace

const Layout layout{
    1.0,          "radians", "degrees", GRIT_RADIAN_INTERGRANULAR_STRAIN, GRIT_RADIAN_VOID_RATIO,
    classic_props};

}  // namespace grit::abaqus
