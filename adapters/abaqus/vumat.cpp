// SPDX-License-Identifier: BSD-3-Clause
// The VUMAT: a block of points per call. Its frame rotates with the material, so nothing is turned.
#include <algorithm>
#include <cstring>

#include "adapters/abaqus/complaint.hpp"
#include "adapters/abaqus/layout.hpp"
#include "adapters/abaqus/sizes.hpp"
#include "adapters/abaqus/vumat_arguments.hpp"
#include "adapters/host/failure.hpp"

namespace grit::abaqus {
namespace {

constexpr int chunk = 64;                     // points that go to the library at once
constexpr int place[6] = {0, 1, 2, 3, 5, 4};  // of 11 22 33 12 13 23 in a VUMAT

grit_status check_call(const VumatArguments& call, grit_error& error) {
    const auto refuse = [&](const char* what) { return refuse_null(what, error); };
    if (!call.nblock) return refuse("nblock");
    if (!call.ndir) return refuse("ndir");
    if (!call.nshr) return refuse("nshr");
    if (!call.nstatev) return refuse("nstatev");
    if (!call.nprops) return refuse("nprops");
    if (!call.props) return refuse("props");
    if (!call.strain_inc) return refuse("strainInc");
    if (!call.stress_old) return refuse("stressOld");
    if (!call.state_old) return refuse("stateOld");
    if (!call.stress_new) return refuse("stressNew");
    if (!call.state_new) return refuse("stateNew");
    if (*call.nblock < 0)
        return failure(error, GRIT_BAD_CALL, "nblock must be >= 0, got %d", *call.nblock);
    if (*call.ndir != 3 || (*call.nshr != 3 && *call.nshr != 1))
        return failure(error, GRIT_BAD_CALL,
                       "ndir must be 3 and nshr 3 or 1 (11 22 33 12), got %d and %d", *call.ndir,
                       *call.nshr);
    return check_sizes(*call.nprops, "nprops", *call.nstatev, "nstatev", error);
}

// A single-precision caller passes floats, and the first of them is phi_c.
grit_status check_precision(const VumatArguments& call, grit_error& error) {
    float first;
    std::memcpy(&first, call.props, sizeof first);
    const double limit = GRIT_DEGREE / layout.angle;
    const auto angle = [&](double x) { return x >= 10.0 * limit && x <= 60.0 * limit; };
    if (angle(call.props[0]) || !angle(first)) return GRIT_OK;
    return failure(error, GRIT_BAD_CALL,
                   "PROPS are in single precision: run Abaqus/Explicit with double=both");
}

// One block, with the numbers that every point needs.
class Block {
  public:
    Block(const VumatArguments& given, const Material& prepared)
        : call(given), material(prepared), n(*given.nblock), shears(*given.nshr) {}

    void update() {
        for (int first = 0; first < n; first += chunk) update(first, std::min(chunk, n - first));
    }

    // Where the material is wrong: no memory of the host is left as it was found.
    void stand_still() {
        for (int i = 0; i < n; ++i) {
            keep(i);
            state_new(i)[GRIT_CLASSIC_EVALUATIONS] = GRIT_CLASSIC_FAILED;
        }
    }

    // Before the first increment Abaqus/Explicit tries small strains on the points, for the speed of
    // waves, and keeps nothing of them: linear elasticity, lambda = mu, with the bound of the sand's
    // P-wave modulus, and the state as it was.
    void try_elastic() {
        for (int i = 0; i < n; ++i) {
            keep(i);
            Point start = read(i);
            grit_error error{};
            double modulus = 0.0, K = 0.0;
            grit_status status = complete_state(material, start, error);
            if (status == GRIT_OK) {
                status = grit_sand_wave_modulus(&material.sand, 0, start.stress,
                                                start.state[GRIT_SAND_VOID_RATIO], &modulus);
                if (status == GRIT_OK)
                    status = grit_sand_water_stiffness(&material.water, start.pore_pressure,
                                                       start.state[GRIT_SAND_VOID_RATIO], &K);
                if (status != GRIT_OK)
                    failure(error, status, "stress and void ratio must be finite, void ratio > 0");
            }
            if (status != GRIT_OK) {
                complain(error, "Grit VUMAT: point %d of a block of %d", i + 1, n);
                continue;
            }
            const double* d = start.strain_increment;
            const double lambda = modulus / 3.0;
            const double volumetric = (lambda + K) * (d[0] + d[1] + d[2]);
            for (int c = 0; c < 3 + shears; ++c)
                stress_new(i, c) +=
                    c < 3 ? 2.0 * lambda * d[c] + volumetric : lambda * d[c];  // d: engineering
        }
    }

  private:
    double strain(int i, int c) const { return call.strain_inc[i + n * place[c]]; }
    double stress_old(int i, int c) const { return call.stress_old[i + n * place[c]]; }
    double& stress_new(int i, int c) const { return call.stress_new[i + n * place[c]]; }
    Statev state_new(int i) const { return {call.state_new + i, n, *call.nstatev}; }

    // What the host had, for a point that does not move, and for what stands behind STATEV(14).
    void keep(int i) const {
        for (int c = 0; c < 3 + shears; ++c) stress_new(i, c) = stress_old(i, c);
        for (int k = 0; k < *call.nstatev; ++k) state_new(i)[k] = call.state_old[i + n * k];
        if (call.ener_intern_new && call.ener_intern_old)
            call.ener_intern_new[i] = call.ener_intern_old[i];
        if (call.ener_inelas_new && call.ener_inelas_old)
            call.ener_inelas_new[i] = call.ener_inelas_old[i];
    }

    // After keep(i): stateNew is stateOld.
    Point read(int i) const {
        Point p{};
        for (int c = 0; c < 3 + shears; ++c) {
            p.strain_increment[c] = c < 3 ? strain(i, c) : 2.0 * strain(i, c);
            p.stress[c] = stress_old(i, c);
        }
        read_state(state_new(i), shears, material, p);
        return p;
    }

    void write(int i, const Point& start, const Point& end, int evaluations) const {
        double work = 0.0;  // of the total stress, trapezoidal
        for (int c = 0; c < 3 + shears; ++c) {
            const double before = stress_old(i, c), after = total_stress(start, end, c, before);
            stress_new(i, c) = after;
            work += 0.5 * (before + after) * start.strain_increment[c];
        }
        write_state(state_new(i), material, end, evaluations);
        if (call.density && call.ener_intern_new && call.ener_intern_old && call.density[i] > 0.0)
            call.ener_intern_new[i] += work / call.density[i];
    }

    void stand_still(int i, const grit_error& why) const {
        complain(why, "Grit VUMAT: point %d of a block of %d", i + 1, n);
        state_new(i)[GRIT_CLASSIC_EVALUATIONS] = GRIT_CLASSIC_FAILED;
    }

    // The words of a call are those of its first failure; a point that fails changes nothing, and has its own when it is alone.
    grit_error why_not(const grit_sand_options& options, const grit_sand_water& water,
                       grit_sand_points views, const std::ptrdiff_t& point) const {
        grit_error error{};
        views.index = &point;
        grit_sand_update_undrained(&material.sand, &options, &water, 1, &views, nullptr, &error);
        return error;
    }

    void update(int first, int count) {
        Point start[chunk], end[chunk];
        std::ptrdiff_t able[chunk];
        std::ptrdiff_t able_count = 0;
        for (int k = 0; k < count; ++k) {
            keep(first + k);
            start[k] = read(first + k);
            grit_error error{};
            if (complete_state(material, start[k], error) == GRIT_OK) able[able_count++] = k;
            else stand_still(first + k, error);
            end[k] = start[k];
        }
        grit_sand_report reports[chunk]{};
        grit_error error{};
        grit_sand_points views = views_of(end);
        views.index = able;
        const grit_sand_options options = material.options;
        const grit_sand_water water = water_of(material, end);
        grit_sand_update_undrained(&material.sand, &options, &water, able_count, &views, reports,
                                   &error);
        for (std::ptrdiff_t r = 0; r < able_count; ++r) {
            const int k = static_cast<int>(able[r]);
            if (reports[r].status != GRIT_OK) {
                stand_still(first + k, reports[r].status == error.status
                                           ? error
                                           : why_not(options, water, views, able[r]));
                continue;
            }
            write(first + k, start[k], end[k], reports[r].evaluations);
        }
    }

    const VumatArguments& call;
    const Material& material;
    int n, shears;
};

grit_status run(const VumatArguments& call, grit_error& error) {
    if (call.nblock && *call.nblock == 0) return GRIT_OK;  // of no points nothing is asked
    if (const grit_status s = check_call(call, error)) return s;
    if (const grit_status s = check_precision(call, error)) return s;
    const Material* material = nullptr;
    const grit_status status = read_props(call.props, *call.nprops, material, error);
    Block block(call, *material);
    if (status != GRIT_OK) {
        block.stand_still();
        return status;
    }
    if (call.step_time && call.total_time && *call.step_time == 0.0 && *call.total_time == 0.0)
        block.try_elastic();
    else block.update();
    return GRIT_OK;
}

}  // namespace

void run_vumat(const VumatArguments& call) {
    grit_error error{};
    if (run(call, error) != GRIT_OK) complain(error, "Grit VUMAT");
}

}  // namespace grit::abaqus
