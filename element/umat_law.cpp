// SPDX-License-Identifier: BSD-3-Clause
#include "element/umat_law.hpp"

#include "element/guarded.hpp"
#include "element/text.hpp"
#include "element/umat_function.hpp"

namespace element {
namespace {

// Fortran's order.
void copy_columns(const Matrix3& from, double* to) {
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) *to++ = from(row, column);
}

// The memory of one call, all of it the callee's to spoil.
struct UmatArguments {
    Guarded stress, statev, ddsdde{36}, props, dstran{6}, stran{6};
    double energy[3] = {}, rpl = 0.0, ddsddt[6] = {}, drplde[6] = {}, drpldt = 0.0;
    double time[2], dtime, temp, dtemp, predef[1] = {}, dpred[1] = {}, coords[3] = {};
    double drot[9], pnewdt = 1.0, celent = 1.0, dfgrd0[9], dfgrd1[9];
    int ndi = 3, nshr = 3, ntens = 6, nstatv, nprops, noel = 1, npt = 1, layer = 1, kspt = 1;
    int kstep, kinc;
    std::string cmname;

    UmatArguments(const UmatSource& source, const MaterialPoint& start, const StrainIncrement& d)
        : stress(6), statev(source.state_size),
          props(source.props.size()), time{d.step_time, d.total_time}, dtime(d.duration),
          temp(d.temperature), dtemp(d.temperature_change), nstatv(source.state_size),
          nprops(static_cast<int>(source.props.size())), kstep(d.step), kinc(d.number),
          cmname(source.material_name) {
        const Matrix3& Q = d.rotation;
        Vector6 rotated = start.stress;
        if (Q != Matrix3::Identity())
            rotated = stress_components(Q * stress_tensor(start.stress) * Q.transpose());
        stress.fill(rotated.data());
        statev.fill(start.state.data());
        props.fill(source.props.data());
        dstran.fill(d.strain.data());
        stran.fill(d.total_strain.data());
        copy_columns(Q, drot);
        copy_columns(d.gradient_before, dfgrd0);
        copy_columns(d.gradient_after, dfgrd1);
        cmname.resize(80, ' ');
    }

    void call(UmatFunction umat) {
        umat(stress.data(), statev.data(), ddsdde.data(), &energy[0], &energy[1], &energy[2], &rpl,
             ddsddt, drplde, &drpldt, stran.data(), dstran.data(), time, &dtime, &temp, &dtemp,
             predef, dpred, cmname.data(), &ndi, &nshr, &ntens, &nstatv, props.data(), &nprops,
             coords, drot, &pnewdt, &celent, dfgrd0, dfgrd1, &noel, &npt, &layer, &kspt, &kstep,
             &kinc, cmname.size());
    }

    // Names of the arrays written beyond their end, empty if none.
    std::string overrun() const {
        std::string out;
        if (!stress.intact()) out += " STRESS(6)";
        if (!statev.intact()) out += text(" STATEV(%d)", nstatv);
        if (!ddsdde.intact()) out += " DDSDDE(6,6)";
        if (!props.intact()) out += text(" PROPS(%d)", nprops);
        if (!dstran.intact()) out += " DSTRAN(6)";
        if (!stran.intact()) out += " STRAN(6)";
        return out;
    }

    bool finite() const { return stress.finite() && statev.finite() && ddsdde.finite(); }
};

}  // namespace

UmatLaw::UmatLaw(UmatSource given) : LibraryLaw(std::move(given), {"umat_", "UMAT", "umat"}) {}

Response UmatLaw::advance(const MaterialPoint& start, const StrainIncrement& increment) const {
    UmatArguments arguments(source, start, increment);
    arguments.call(function_as<UmatFunction>());
    Response out;
    if (const std::string overrun = arguments.overrun(); !overrun.empty()) {
        out.outcome = Outcome::hopeless;
        out.message = "the UMAT wrote beyond" + overrun + ": is NSTATV or NPROPS too small?";
        return out;
    }
    if (!(arguments.pnewdt >= 1.0) || !arguments.finite()) {
        out.outcome = Outcome::retry_smaller;
        out.reduction = arguments.pnewdt > 0.0 && arguments.pnewdt < 1.0 ? arguments.pnewdt : 0.5;
        out.message =
            arguments.pnewdt >= 1.0
                ? "the UMAT returned a value that is not finite"
                : text("the UMAT asked for a smaller increment (PNEWDT = %g)", arguments.pnewdt);
        return out;
    }
    out.end.stress = Vector6::Map(arguments.stress.data());
    out.end.state.assign(arguments.statev.data(), arguments.statev.data() + source.state_size);
    out.tangent = Eigen::Map<Eigen::Matrix<double, 6, 6>>(arguments.ddsdde.data());  // by columns
    return out;
}

}  // namespace element
