// SPDX-License-Identifier: BSD-3-Clause
// The UMAT: one material point per call.
#include <cmath>
#include <limits>

#include <grit/sand.h>
#include <grit/sand_operators.h>

#include "adapters/abaqus/complaint.hpp"
#include "adapters/abaqus/layout.hpp"
#include "adapters/abaqus/point.hpp"
#include "adapters/abaqus/sizes.hpp"
#include "adapters/abaqus/umat_arguments.hpp"
#include "adapters/host/failure.hpp"

namespace grit::abaqus {
namespace {

// PNEWDT where the cause does not say how much smaller an increment must be.
constexpr double default_reduction = 0.25;

// Nine entries below it are denormal or zero: DROT that was not set.
constexpr double smallest_normal = std::numeric_limits<double>::min();

// The share of L in the symmetric tangent (docs/adr/0006).
constexpr double share_of_L = 0.5;

grit_status check_call(const UmatArguments& call, grit_error& error) {
    const auto refuse = [&](const char* what) { return refuse_null(what, error); };
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
    return check_sizes(*call.nprops, "NPROPS", *call.nstatv, "NSTATV", error);
}

Point read_point(const UmatArguments& call, const Material& material) {
    Point p;
    for (int c = 0; c < 6; ++c) {
        const bool carried = c < *call.ntens;
        p.strain_increment[c] = carried ? call.dstran[host.order[c]] : 0.0;
        p.stress[c] = carried ? call.stress[host.order[c]] : 0.0;
    }
    read_state({call.statev, 1, *call.nstatv}, *call.ntens - 3, material, p);
    return p;
}

// To the nearest rotation, where Q is nearly one: MOOSE's, a truncated series, is off by 2e-4 at a tenth of
// a radian. What is farther off is left to the library to refuse. Newton's iteration for the polar factor; true: Q is a rotation now.
bool project(double Q[9]) {
    const auto cofactor = [&Q](int r, int c) {
        const int r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
        return Q[3 * r1 + c1] * Q[3 * r2 + c2] - Q[3 * r1 + c2] * Q[3 * r2 + c1];
    };
    for (int i = 0; i < 4; ++i) {
        double inverse_transposed[9];
        const double det = Q[0] * cofactor(0, 0) + Q[1] * cofactor(0, 1) + Q[2] * cofactor(0, 2);
        double off = 0.0;
        for (int k = 0; k < 9; ++k) {
            inverse_transposed[k] = cofactor(k / 3, k % 3) / det;
            off = std::fmax(off, std::fabs(inverse_transposed[k] - Q[k]));
        }
        if (!(det > 0.0 && off < 1e-2)) return false;
        if (off <= 1e-14) return true;
        for (int k = 0; k < 9; ++k) Q[k] = 0.5 * (Q[k] + inverse_transposed[k]);
    }
    return false;
}

bool rests(const UmatArguments& call) {
    double size = 0.0;
    for (int c = 0; c < *call.ntens; ++c) size += std::fabs(call.dstran[c]);
    return size == 0.0;
}

// Meant as a rotation: its columns are nearly of length 1 and nearly at right angles.
bool resembles_rotation(const double Q[9]) {
    bool near = true;  // never of what is not a number
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) {
            const double product = Q[a] * Q[b] + Q[3 + a] * Q[3 + b] + Q[6 + a] * Q[6 + b];
            near = near && std::fabs(product - (a == b ? 1.0 : 0.0)) < 0.5;
        }
    return near;
}

// DROT as a row-major Q. False where nothing is to be turned: null, the identity, or nothing above the
// denormals, which is how hosts without finite rotations fill it. Hosts that ask for the first stiffness
// without a strain may not have set DROT at all: then what does not even resemble a rotation is none.
bool read_rotation(const UmatArguments& call, double Q[9]) {
    if (!call.drot || *call.ntens == 3) return false;
    const bool in_plane = *call.ntens != 6;
    double size = 0.0, from_identity = 0.0;  // sums of magnitudes: 0 exactly where all are
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) {
            const double unit = r == c ? 1.0 : 0.0;
            const bool carried = !in_plane || (r < 2 && c < 2);
            const double entry = carried ? call.drot[r + 3 * c] : unit;
            if (carried) size += std::fabs(entry);
            from_identity += std::fabs(entry - unit);
            Q[3 * r + c] = entry;
        }
    if (size < smallest_normal || from_identity == 0.0) return false;
    const bool meant = !rests(call) || resembles_rotation(Q);
    const bool turns = project(Q);
    return turns || meant;
}

grit_status update(const UmatArguments& call, const Material& material, Point& point,
                   double tangent[36], grit_sand_report& report, grit_error& error) {
    grit_sand_options options = material.options;
    options.tangent = call.ddsdde ? GRIT_TANGENT_CONSISTENT : GRIT_TANGENT_NONE;
    options.stress_is_rotated = 1;  // Abaqus has rotated STRESS, but no tensor in STATEV
    double Q[9];
    grit_sand_points views = views_of(&point);
    if (read_rotation(call, Q)) views.rotation_increment = grit_view_of(Q, 9, 1);
    views.tangent = grit_mutable_matrix_view_of(tangent, 36, 6, 1);
    const grit_sand_water water = water_of(material, &point);
    return grit_sand_update_undrained(&material.sand, &options, &water, 1, &views, &report, &error);
}

void write_stress(const UmatArguments& call, const Point& start, const Point& end) {
    double work = 0.0;  // of the total stress, trapezoidal
    for (int c = 0; c < *call.ntens; ++c) {
        double& stress = call.stress[host.order[c]];
        const double before = stress;
        stress = total_stress(start, end, c, before);
        work += 0.5 * (before + stress) * start.strain_increment[c];
    }
    if (call.sse) *call.sse += work;
}

// The symmetric part alone lets Newton's method diverge where N is large; a share of L, symmetric and
// positive definite, holds it back in the soft directions and costs little in the stiff ones.
void symmetrise(const Material& material, const Point& end, double tangent[36]) {
    double L[36];
    grit_sand_stiffness(&material.sand, end.stress, end.state[GRIT_SAND_VOID_RATIO], L, nullptr);
    for (int r = 0; r < 6; ++r)
        for (int c = 0; c <= r; ++c)
            tangent[6 * r + c] = tangent[6 * c + r] =
                0.5 * (tangent[6 * r + c] + tangent[6 * c + r]) + share_of_L * L[6 * r + c];
}

void write_tangent(const UmatArguments& call, const double tangent[36]) {
    const int n = *call.ntens;
    for (int r = 0; r < n; ++r)
        for (int c = 0; c < n; ++c) {
            const int row = host.order[r], column = host.order[c];
            call.ddsdde[call.matrix == Matrix::rows ? n * row + column : row + n * column] =
                tangent[6 * r + c];
        }
}

grit_status run(const UmatArguments& call, grit_sand_report& report, grit_error& error) {
    if (const grit_status s = check_call(call, error)) return s;
    const Material* prepared = nullptr;
    if (const grit_status s = read_props(call.props, *call.nprops, prepared, error)) return s;
    const Material& material = *prepared;
    Point start = read_point(call, material);
    if (const grit_status s = complete_state(material, start, error)) return s;
    Point end = start;
    double tangent[36];
    if (const grit_status s = update(call, material, end, tangent, report, error)) return s;

    write_stress(call, start, end);
    write_state({call.statev, 1, *call.nstatv}, material, end, report.evaluations);
    if (call.ddsdde && call.matrix == Matrix::symmetric) symmetrise(material, end, tangent);
    if (call.ddsdde) write_tangent(call, tangent);
    return GRIT_OK;
}

}  // namespace

void run_umat(const UmatArguments& call) {
    grit_sand_report report{};
    report.step_reduction = 1.0;
    grit_error error;  // left as it is unless something is said: to blank it takes time
    if (run(call, report, error) == GRIT_OK) return;
    const double reduction =
        report.step_reduction < 1.0 ? report.step_reduction : default_reduction;
    // Some hosts hand the same PNEWDT to one point after the other: never raise what one has asked for.
    if (call.pnewdt && !(*call.pnewdt > 0.0 && *call.pnewdt < reduction)) *call.pnewdt = reduction;
    complain(error, "Grit UMAT: element %d, point %d", call.noel ? *call.noel : 0,
             call.npt ? *call.npt : 0);
}

}  // namespace grit::abaqus
