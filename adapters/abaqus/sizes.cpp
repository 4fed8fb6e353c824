// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/abaqus/sizes.hpp"

#include "adapters/host/failure.hpp"

namespace grit::abaqus {

grit_status refuse_null(const char* name, grit_error& error) {
    return failure(error, GRIT_BAD_CALL, "%s is a null pointer", name);
}

grit_status check_sizes(int nprops, const char* nprops_name, int nstatv, const char* nstatv_name,
                        grit_error& error) {
    if (nprops < GRIT_CLASSIC_NPROPS)
        return failure(error, GRIT_BAD_CALL, "%s must be at least %d (*USER MATERIAL), got %d",
                       nprops_name, GRIT_CLASSIC_NPROPS, nprops);
    if (nstatv < GRIT_CLASSIC_NSTATV)
        return failure(error, GRIT_BAD_CALL, "%s must be at least %d, better %d (*DEPVAR), got %d",
                       nstatv_name, GRIT_CLASSIC_NSTATV, GRIT_CLASSIC_NSTATV + 1, nstatv);
    return GRIT_OK;
}

grit_sand_points views_of(Point* points) {
    constexpr std::ptrdiff_t stride = sizeof(Point) / sizeof(double);
    static_assert(sizeof(Point) % sizeof(double) == 0);
    grit_sand_points views{};
    views.struct_size = sizeof views;
    views.components = 6;
    views.strain_increment = grit_view_of(points->strain_increment, stride, 1);
    views.stress = grit_mutable_view_of(points->stress, stride, 1);
    views.state = grit_mutable_view_of(points->state, stride, 1);
    views.substep = grit_mutable_view_of(&points->substep, stride, 1);
    return views;
}

}  // namespace grit::abaqus
