// SPDX-License-Identifier: BSD-3-Clause
// grit_sand_wave_moduli: checks the call, chooses the instruction set, words the failures.
#define GRIT_TARGET c_api
#include <grit/sand_operators.h>

#include "support/instruction_set.hpp"
#include "support/require.hpp"
#include "support/views.hpp"
#include "umat/api/call.hpp"
#include "umat/batch/point.hpp"

using namespace grit;

extern "C" grit_status grit_sand_wave_moduli(const grit_sand* sand,
                                             const grit_sand_options* options, ptrdiff_t n,
                                             const grit_sand_points* points, double* moduli,
                                             grit_error* error) {
    SandCall call;
    if (const grit_status s =
            read_call("grit_sand_wave_moduli", sand, options, n, points, call, error))
        return s;
    const grit_sand_options& o = *call.options;
    const grit_sand_points& q = *call.points;
    if (const grit_status s = check_instruction_set(o.instruction_set, error)) return s;
    GRIT_REQUIRE(is_switch(o.intergranular_off), "intergranular_off must be 0 or 1, got %d",
                 o.intergranular_off);
    GRIT_REQUIRE(q.components == 0 || q.components == 6 || q.components == 4,
                 "components must be 6 or 4 (11 22 33 12), got %d", q.components);
    if (n == 0) return GRIT_OK;
    GRIT_REQUIRE(q.stress.base, "stress has no base pointer");
    GRIT_REQUIRE(q.state.base, "state has no base pointer");
    GRIT_REQUIRE(moduli, "grit_sand_wave_moduli: moduli is null");

    const Material& m = material_of(*sand);
    const bool igs = m.has_intergranular_strain != 0.0 && !o.intergranular_off;
    const WaveModuliRequest request{&m, &q, n, moduli, igs};
    const std::ptrdiff_t bad = GRIT_DISPATCH(o.instruction_set, wave_moduli(request));
    if (bad < 0) return GRIT_OK;
    const std::ptrdiff_t at = q.index ? q.index[bad] : bad;
    return failure(
        error, GRIT_BAD_STATE, bad,
        "point %td: no wave modulus: stress must be finite and the void ratio in (0, %g], "
        "got %g",
        bad, c_api::largest_void_ratio,
        c_api::element(q.state.base, q.state.point_stride, q.state.component_stride, at,
                       GRIT_SAND_VOID_RATIO));
}
