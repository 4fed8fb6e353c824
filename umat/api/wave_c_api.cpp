// SPDX-License-Identifier: BSD-3-Clause
// grit_sand_wave_moduli: checks the call, chooses the instruction set, words the failures.
#define GRIT_TARGET c_api
#include <grit/sand_operators.h>

#include "support/call_checks.hpp"
#include "support/instruction_set.hpp"
#include "umat/api/call.hpp"
#include "umat/batch/point.hpp"

using namespace grit;

extern "C" grit_status grit_sand_wave_moduli(const grit_sand* sand,
                                             const grit_sand_options* options, ptrdiff_t n,
                                             const grit_sand_points* points, double* moduli,
                                             grit_error* error) {
    SandCall call;
    const char* const name = "grit_sand_wave_moduli";
    GRIT_CHECK(read_call(name, sand, options, n, points, call, error));
    const grit_sand_options& o = *call.options;
    const grit_sand_points& q = *call.points;
    GRIT_CHECK(check_instruction_set(o.instruction_set, error));
    GRIT_CHECK(check_switch(o.intergranular_off, "intergranular_off", error));
    GRIT_CHECK(check_point_components(q.components, error));
    if (n == 0) return GRIT_OK;
    GRIT_CHECK(check_base(q.stress, "stress", error));
    GRIT_CHECK(check_base(q.state, "state", error));
    GRIT_CHECK(check_given(moduli, {name, "moduli"}, error));

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
        bad, c_api::largest_void_ratio, component(q.state, at, GRIT_SAND_VOID_RATIO));
}
