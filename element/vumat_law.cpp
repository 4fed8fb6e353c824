// SPDX-License-Identifier: BSD-3-Clause
#include "element/vumat_law.hpp"

#include <algorithm>
#include <cstddef>

#include <grit/classic_layout.h>

#include "element/guarded.hpp"
#include "element/text.hpp"

namespace element {
namespace {

using VumatFunction = void (*)(int* nblock, int* ndir, int* nshr, int* nstatev, int* nfieldv,
                               int* nprops, int* lanneal, double* step_time, double* total_time,
                               double* dt, char* cmname, double* coord_mp, double* char_length,
                               double* props, double* density, double* strain_inc,
                               double* rel_spin_inc, double* temp_old, double* stretch_old,
                               double* defgrad_old, double* field_old, double* stress_old,
                               double* state_old, double* ener_intern_old, double* ener_inelas_old,
                               double* temp_new, double* stretch_new, double* defgrad_new,
                               double* field_new, double* stress_new, double* state_new,
                               double* ener_intern_new, double* ener_inelas_new,
                               std::size_t cmname_length);

constexpr int block = 7;                      // the increment, and one beside it for each component
constexpr int place[6] = {0, 1, 2, 3, 5, 4};  // of 11 22 33 12 13 23 in 11 22 33 12 23 31

// Wide enough for the integration error of the law, narrow enough for its curvature.
double step_aside(const Vector6& strain) {
    return std::max(1e-7, 1e-2 * strain.cwiseAbs().maxCoeff());
}

// The memory of one call, all of it the callee's to spoil.
struct VumatArguments {
    Guarded strain_inc{6 * block}, stress_old{6 * block}, state_old, stress_new{6 * block},
        state_new, props;
    double one_each[9 * block], zero_each[9 * block] = {};
    double intern_new[block] = {}, inelas_new[block] = {}, temp_new[block] = {};
    double dt, step_time, total_time;
    int nblock = block, ndir = 3, nshr = 3, nstatev, nfieldv = 0, nprops, lanneal = 0;
    std::string cmname;

    VumatArguments(const UmatSource& source, const MaterialPoint& start, const StrainIncrement& d,
                   double aside)
        : state_old(block * source.state_size), state_new(block * source.state_size),
          props(source.props.size()), dt(d.duration > 0.0 ? d.duration : 1.0),
          step_time(d.step_time + dt), total_time(d.total_time + dt), nstatev(source.state_size),
          nprops(static_cast<int>(source.props.size())), cmname(source.material_name) {
        std::fill_n(one_each, 9 * block, 1.0);
        props.fill(source.props.data());
        cmname.resize(80, ' ');
        for (int i = 0; i < block; ++i) {
            for (int c = 0; c < 6; ++c) {
                const double strain = d.strain[c] + (c == i - 1 ? aside : 0.0);
                strain_inc.data()[i + block * place[c]] = c < 3 ? strain : 0.5 * strain;
                stress_old.data()[i + block * place[c]] = start.stress[c];
            }
            for (int k = 0; k < nstatev; ++k)
                state_old.data()[i + block * k] = start.state[static_cast<std::size_t>(k)];
        }
    }

    void call(VumatFunction vumat) {
        vumat(&nblock, &ndir, &nshr, &nstatev, &nfieldv, &nprops, &lanneal, &step_time, &total_time,
              &dt, cmname.data(), zero_each, one_each, props.data(), one_each, strain_inc.data(),
              zero_each, zero_each, one_each, one_each, zero_each, stress_old.data(),
              state_old.data(), zero_each, zero_each, temp_new, one_each, one_each, zero_each,
              stress_new.data(), state_new.data(), intern_new, inelas_new, cmname.size());
    }

    bool intact() const {
        return stress_new.intact() && state_new.intact() && stress_old.intact() &&
               state_old.intact() && strain_inc.intact() && props.intact();
    }

    // A point that strains and keeps its stress and state but for the mark that Grit's VUMAT leaves there (docs/umat.md).
    bool one_stood_still() {
        for (int i = 0; i < block; ++i) {
            bool strains = false, moved = false;
            for (int c = 0; c < 6; ++c) {
                strains = strains || strain_inc.data()[i + block * c] != 0.0;
                moved =
                    moved || stress_new.data()[i + block * c] != stress_old.data()[i + block * c];
            }
            for (int k = 0; k < nstatev; ++k)
                moved =
                    moved || (k != GRIT_CLASSIC_EVALUATIONS &&
                              state_new.data()[i + block * k] != state_old.data()[i + block * k]);
            const bool marked =
                nstatev > GRIT_CLASSIC_EVALUATIONS &&
                state_new.data()[i + block * GRIT_CLASSIC_EVALUATIONS] == GRIT_CLASSIC_FAILED;
            if (strains && marked && !moved) return true;
        }
        return false;
    }

    Vector6 stress(int i) {
        Vector6 out;
        for (int c = 0; c < 6; ++c) out[c] = stress_new.data()[i + block * place[c]];
        return out;
    }
};

}  // namespace

VumatLaw::VumatLaw(UmatSource given) : LibraryLaw(std::move(given), {"vumat_", "VUMAT", "vumat"}) {}

Response VumatLaw::advance(const MaterialPoint& start, const StrainIncrement& increment) const {
    Response out;
    if (increment.rotation != Matrix3::Identity()) {
        out.outcome = Outcome::hopeless;
        out.message = "a VUMAT has a frame that turns with the material: no steps with rotations";
        return out;
    }
    const double aside = step_aside(increment.strain);
    VumatArguments arguments(source, start, increment, aside);
    arguments.call(function_as<VumatFunction>());
    if (!arguments.intact()) {
        out.outcome = Outcome::hopeless;
        out.message =
            text("the VUMAT wrote beyond its arrays: is nstatev %d or nprops %d too small?",
                 arguments.nstatev, arguments.nprops);
        return out;
    }
    const bool finite = arguments.stress_new.finite() && arguments.state_new.finite();
    if (!finite || arguments.one_stood_still()) {
        out.outcome = Outcome::retry_smaller;
        out.reduction = 0.5;
        out.message = finite ? "the VUMAT left a point as it was, with STATEV(10) = -1: it cannot "
                               "go so far at once"
                             : "the VUMAT returned a value that is not finite";
        return out;
    }
    out.end.stress = arguments.stress(0);
    for (int k = 0; k < source.state_size; ++k)
        out.end.state.push_back(arguments.state_new.data()[block * k]);
    for (int c = 0; c < 6; ++c)
        out.tangent.col(c) = (arguments.stress(1 + c) - out.end.stress) / aside;
    return out;
}

}  // namespace element
