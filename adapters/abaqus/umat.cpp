// SPDX-License-Identifier: BSD-3-Clause
// The UMAT: one material point per call, prepared from PROPS every time, nothing kept between calls.
#include <cstddef>

#include <grit/sand.h>

#include "adapters/abaqus/classic_props.hpp"
#include "adapters/abaqus/classic_statev.hpp"
#include "adapters/abaqus/complaint.hpp"

namespace grit::abaqus {
namespace {

grit_status check_call(const UmatArguments& call, grit_error& error) {
    const auto refuse = [&](const char* what) {
        return failure(error, GRIT_BAD_CALL, "%s is a null pointer", what);
    };
    if (!call.stress) return refuse("STRESS");
    if (!call.statev) return refuse("STATEV");
    if (!call.dstran) return refuse("DSTRAN");
    if (!call.props) return refuse("PROPS");
    if (!call.ntens) return refuse("NTENS");
    if (!call.nstatv) return refuse("NSTATV");
    if (!call.nprops) return refuse("NPROPS");
    const int n = *call.ntens;
    const int ndi = call.ndi ? *call.ndi : (n == 3 ? 0 : 3);
    const int nshr = call.nshr ? *call.nshr : n - ndi;
    if (ndi != 3 || nshr != n - 3 || (n != 6 && n != 4 && n != 3))
        return failure(error, GRIT_BAD_CALL,
                       "NTENS must be 6, 4 (11 22 33 12) or 3 (11 22 33) with NDI 3, got NTENS %d, "
                       "NDI %d, NSHR %d: plane stress is not supported",
                       n, ndi, nshr);
    if (*call.nprops < GRIT_CLASSIC_NPROPS)
        return failure(error, GRIT_BAD_CALL, "NPROPS must be at least %d (*USER MATERIAL), got %d",
                       GRIT_CLASSIC_NPROPS, *call.nprops);
    if (*call.nstatv < GRIT_CLASSIC_NSTATV)
        return failure(error, GRIT_BAD_CALL,
                       "NSTATV must be at least %d, better %d (*DEPVAR), got %d",
                       GRIT_CLASSIC_NSTATV, GRIT_CLASSIC_NSTATV + 1, *call.nstatv);
    return GRIT_OK;
}

// DROT as a row-major Q. False where nothing is to be turned: null, the identity, or all zero, which
// is how hosts without finite rotations fill it.
bool read_rotation(const UmatArguments& call, double Q[9]) {
    if (!call.drot || *call.ntens == 3) return false;
    bool zero = true;
    bool identity = true;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) {
            const double unit = r == c ? 1.0 : 0.0;
            const bool carried = *call.ntens == 6 || (r < 2 && c < 2);  // in the plane, or all
            const double entry = carried ? call.drot[r + 3 * c] : unit;
            zero = zero && (!carried || entry == 0.0);
            identity = identity && entry == unit;
            Q[3 * r + c] = entry;
        }
    return !zero && !identity;
}

grit_status update(const UmatArguments& call, const grit_sand& sand, Point& point,
                   double tangent[36], grit_sand_report& report, grit_error& error) {
    grit_sand_options options;
    grit_sand_options_init(&options, sizeof options);
    options.tangent = call.ddsdde ? GRIT_TANGENT_CONSISTENT : GRIT_TANGENT_NONE;
    options.stress_is_rotated = 1;  // Abaqus has rotated STRESS, but no tensor in STATEV
    double Q[9];
    grit_sand_points views{};
    views.struct_size = sizeof views;
    views.components = 6;
    views.strain_increment = grit_view_of(point.strain_increment, 6, 1);
    if (read_rotation(call, Q)) views.rotation_increment = grit_view_of(Q, 9, 1);
    views.stress = grit_mutable_view_of(point.stress, 6, 1);
    views.state = grit_mutable_view_of(point.state, GRIT_SAND_STATE_SIZE, 1);
    views.tangent = grit_mutable_matrix_view_of(tangent, 36, 6, 1);
    views.substep = grit_mutable_view_of(&point.substep, 1, 1);
    return grit_sand_update(&sand, &options, 1, &views, &report, &error);
}

void write_tangent(const UmatArguments& call, const double tangent[36], double K_w) {
    const int n = *call.ntens;
    for (int r = 0; r < n; ++r)
        for (int c = 0; c < n; ++c)
            call.ddsdde[r + n * c] = tangent[6 * r + c] + (r < 3 && c < 3 ? K_w : 0.0);
}

grit_status run(const UmatArguments& call, grit_sand_report& report, grit_error& error) {
    if (const grit_status s = check_call(call, error)) return s;
    ClassicProps props;
    if (const grit_status s = read_props(call.props, props, error)) return s;
    grit_sand sand;
    if (const grit_status s = grit_sand_prepare(&props.parameters, &sand, &error)) return s;

    Point start = read_point(call);
    double& e = start.state[GRIT_SAND_VOID_RATIO];
    if (e < GRIT_CLASSIC_NO_VOID_RATIO)
        if (const grit_status s =
                initial_void_ratio(sand, props.e_0, mean_pressure(start), e, error))
            return s;
    Point end = start;
    double tangent[36];
    if (const grit_status s = update(call, sand, end, tangent, report, error)) return s;

    const double* d = start.strain_increment;
    end.pore_stress += props.K_w * (d[0] + d[1] + d[2]);  // (W1)
    write_point(call, start, end);
    write_output(call, sand, end, report.evaluations);
    if (call.ddsdde) write_tangent(call, tangent, props.K_w);
    return GRIT_OK;
}

}  // namespace
}  // namespace grit::abaqus

extern "C" {

// Abaqus, CalculiX, OpenSees, Kratos, MOOSE: reals are double, integers are int. The name of the
// material and its hidden length are never looked at, for one host passes a single character.
__attribute__((visibility("default"))) void
umat_(double* STRESS, double* STATEV, double* DDSDDE, double* /*SSE*/, double* /*SPD*/,
      double* /*SCD*/, double* /*RPL*/, double* /*DDSDDT*/, double* /*DRPLDE*/, double* /*DRPLDT*/,
      const double* /*STRAN*/, const double* DSTRAN, const double* /*TIME*/,
      const double* /*DTIME*/, const double* /*TEMP*/, const double* /*DTEMP*/,
      const double* /*PREDEF*/, const double* /*DPRED*/, const char* /*CMNAME*/, const int* NDI,
      const int* NSHR, const int* NTENS, const int* NSTATV, const double* PROPS, const int* NPROPS,
      const double* /*COORDS*/, const double* DROT, double* PNEWDT, const double* /*CELENT*/,
      const double* /*DFGRD0*/, const double* /*DFGRD1*/, const int* NOEL, const int* NPT,
      const int* /*LAYER*/, const int* /*KSPT*/, const int* /*KSTEP*/, const int* /*KINC*/,
      std::size_t /*length of CMNAME*/) {
    using namespace grit::abaqus;
    const UmatArguments call{STRESS, STATEV, DDSDDE, PNEWDT, DSTRAN, DROT, PROPS,
                             NDI,    NSHR,   NTENS,  NSTATV, NPROPS, NOEL, NPT};
    grit_sand_report report{};
    report.step_reduction = 1.0;
    grit_error error{};
    if (run(call, report, error) != GRIT_OK) fail(call, error, report.step_reduction);
}
}
