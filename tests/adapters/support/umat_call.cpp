// SPDX-License-Identifier: BSD-3-Clause
#include "support/umat_call.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "support/library.hpp"

UmatFunction umat() {
    return reinterpret_cast<UmatFunction>(symbol_of(GRIT_UMAT_LIBRARY, "umat_"));
}

UmatCall UmatCall::hochstetten() {
    UmatCall call;
    const double props[] = {33.0, 0.0, 1e6, 0.25, 0.55, 0.95, 1.05, 0.25,
                            1.5,  5.0, 2.0, 1e-4, 0.5,  6.0,  0.0,  10.70};
    for (int i = 0; i < static_cast<int>(std::size(props)); ++i) call.props[i] = props[i];
    for (int c = 0; c < 3; ++c) call.stress[c] = -100.0;
    call.statev.close_beyond(call.nstatv);
    call.props.close_beyond(call.nprops);  // a canary is no tolerance: who reads it is refused
    return call;
}

UmatCall UmatCall::after(const std::array<double, 6>& stress,
                         const std::vector<std::array<double, 6>>& increments) {
    UmatCall call = hochstetten();
    std::copy(stress.begin(), stress.end(), call.stress.data());
    for (const std::array<double, 6>& d : increments) {
        call.set_dstran(d[0], d[1], d[2], d[3], d[4], d[5]);
        call.run();
        EXPECT_EQ(call.pnewdt, 1.0);
    }
    return call;
}

void UmatCall::use_components(int n) {
    ntens = n;
    nshr = n - 3;
    stress.close_beyond(n);
    dstran.close_beyond(n);
    ddsdde.close_beyond(n * n);
}

bool UmatCall::in_bounds() const {
    return stress.intact_beyond(ntens) && statev.intact_beyond(nstatv) &&
           ddsdde.intact_beyond(ntens * ntens);
}

void UmatCall::set_tolerance(double tolerance) {
    nprops = 17;
    props[16] = tolerance;
}

void UmatCall::set_water(double K_w, double largest_tension, double itself) {
    nprops = 19;
    props[14] = K_w;
    props[16] = 0.0;
    props[17] = largest_tension;
    props[18] = itself;
}

void UmatCall::set_dstran(double e11, double e22, double e33, double g12, double g13, double g23) {
    const double given[] = {e11, e22, e33, g12, g13, g23};
    for (int c = 0; c < ntens; ++c) dstran[c] = given[c];
}

bool UmatCall::same_results(const UmatCall& other) const {
    return stress == other.stress && statev == other.statev && ddsdde == other.ddsdde;
}

bool UmatCall::finite() const {
    double sum = 0.0;
    for (int c = 0; c < ntens; ++c) sum += 0.0 * stress[c];
    for (int i = 0; i < nstatv; ++i) sum += 0.0 * statev[i];
    for (int i = 0; i < ntens * ntens; ++i) sum += 0.0 * ddsdde[i];
    return sum == 0.0;
}

std::string UmatCall::complaint() {
    unload(GRIT_UMAT_LIBRARY);
    testing::internal::CaptureStderr();
    run();
    return testing::internal::GetCapturedStderr();
}

void UmatCall::run() { run(umat()); }

void UmatCall::run(UmatFunction function) {
    const char cmname[80] = "SAND";
    const double zero[6] = {}, time[2] = {}, dtime = 0.0;
    double unused[6] = {};
    const int one = 1;
    if (sparse) {
        function(stress.data(), statev.data(), ddsdde.data(), nullptr, nullptr, nullptr, nullptr,
                 nullptr, nullptr, nullptr, nullptr, dstran.data(), nullptr, nullptr, nullptr,
                 nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, &ntens, &nstatv,
                 props.data(), &nprops, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr,
                 nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, 0);
        return;
    }
    const auto given = [this](const char* name, auto* argument) {
        return missing == name ? nullptr : argument;
    };
    function(given("STRESS", stress.data()), given("STATEV", statev.data()), ddsdde.data(),
             &energy[0], &energy[1], &energy[2], unused, unused, unused, unused, zero,
             given("DSTRAN", dstran.data()), time, &dtime, zero, zero, zero, zero, cmname, &ndi,
             &nshr, given("NTENS", &ntens), given("NSTATV", &nstatv), given("PROPS", props.data()),
             given("NPROPS", &nprops), zero, drot, &pnewdt, zero, identity, identity, &noel, &npt,
             &one, &one, &one, &one, sizeof cmname);
}
