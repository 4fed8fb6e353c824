// SPDX-License-Identifier: BSD-3-Clause
// umat_, vumat_ and the behaviour of MGIS with any arguments that a host may pass: sizes, null pointers and numbers.
// Memory is as long as the sizes of the call say.
#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

#include <grit/classic_layout.h>

#include "adapters/abaqus/layout.hpp"
#include "adapters/abaqus/umat_arguments.hpp"
#include "adapters/abaqus/vumat_arguments.hpp"
#include "adapters/mgis/generic_behaviour.hpp"
#include "robustness/fuzz/bytes.hpp"

extern "C" {
int GritSand_Tridimensional(mfront_gb_BehaviourData*);
int GritSand_Axisymmetrical(mfront_gb_BehaviourData*);
int GritSand_PlaneStrain(mfront_gb_BehaviourData*);
int GritSand_GeneralisedPlaneStrain(mfront_gb_BehaviourData*);
}

namespace {

using fuzz::Bytes;
using fuzz::demand;

constexpr double usual_props[] = {33.0, 0.0,  1.6e6, 0.19, 0.44, 0.85, 1.0,  0.25, 1.0, 5.0,
                                  2.0,  1e-4, 0.5,   6.0,  0.0,  0.6,  1e-3, 0.0,  0.0};

std::vector<double> props_of(Bytes& in, int count) {
    std::vector<double> out(static_cast<std::size_t>(count < 0 ? 0 : count));
    for (std::size_t i = 0; i < out.size(); ++i) {
        const double usual = i < std::size(usual_props) ? usual_props[i] : 0.0;
        out[i] = in.one_in(10) ? in.number(usual) : usual;
    }
    if (out.size() > 14 && in.one_in(4)) out[14] = in.number(2e6);
    return out;
}

std::vector<double> numbers(Bytes& in, int count, double usual) {
    std::vector<double> out(static_cast<std::size_t>(count < 0 ? 0 : count));
    for (double& each : out) each = in.number(usual);
    return out;
}

// An argument, or what is missing.
template <class Number> Number* given(Bytes& in, Number* here) {
    return in.one_in(48) ? nullptr : here;
}

void try_umat(Bytes& in) {
    const int kind = in.below(3);
    int ndi = 3, nshr = kind == 0 ? 1 : kind == 1 ? 3 : 0, ntens = ndi + nshr;
    int nprops = in.one_in(4) ? in.below(20) : 17, nstatv = in.one_in(4) ? in.below(17) : 14;
    if (in.one_in(16)) ndi = in.byte() - 100;
    if (in.one_in(16)) nshr = in.byte() - 100;
    if (in.one_in(16)) ntens = in.below(7);
    if (in.one_in(32)) nprops = -nprops;
    const int noel = in.raw<int>(), npt = in.below(9);
    std::vector<double> stress = numbers(in, ntens, -100.0), statev = numbers(in, nstatv, 1e-6),
                        dstran = numbers(in, ntens, -1e-4),
                        ddsdde(static_cast<std::size_t>(ntens * ntens));
    if (nstatv > 6 && !in.one_in(4)) statev[6] = in.number(0.6);
    const std::vector<double> props = props_of(in, nprops);
    std::array<double, 9> drot = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    if (in.one_in(4)) drot[static_cast<std::size_t>(in.below(9))] = in.number(0.0);
    double sse = 0.0, pnewdt = 1.0;
    grit::abaqus::UmatArguments call{};
    call.stress = given(in, stress.data());
    call.statev = given(in, statev.data());
    call.ddsdde = given(in, ddsdde.data());
    call.sse = given(in, &sse);
    call.pnewdt = given(in, &pnewdt);
    call.dstran = given(in, dstran.data());
    call.drot = given(in, drot.data());
    call.props = given(in, props.data());
    call.ndi = given(in, &ndi);
    call.nshr = given(in, &nshr);
    call.ntens = given(in, &ntens);
    call.nstatv = given(in, &nstatv);
    call.nprops = given(in, &nprops);
    call.noel = given(in, &noel);
    call.npt = given(in, &npt);
    call.matrix = static_cast<grit::abaqus::Matrix>(in.below(3));
    grit::abaqus::run_umat(call);
    demand(!call.pnewdt || (pnewdt > 0.0 && pnewdt <= 1.0));
}

void try_vumat(Bytes& in) {
    const int nshr = in.one_in(2) ? 3 : 1, ndir = in.one_in(16) ? in.byte() - 100 : 3;
    const int nstatev = in.one_in(4) ? in.below(17) : 14, nprops = in.one_in(4) ? in.below(20) : 17;
    const int nblock = in.one_in(16) ? -in.below(3) : 1 + in.below(5), n = nblock < 0 ? 0 : nblock;
    std::vector<double> strain = numbers(in, n * (3 + nshr), -1e-4),
                        stress = numbers(in, n * (3 + nshr), -100.0),
                        state = numbers(in, n * nstatev, 1e-6), density = numbers(in, n, 1.6),
                        intern = numbers(in, n, 0.0), inelas = numbers(in, n, 0.0);
    if (nstatev > 6) std::generate_n(state.begin() + 6 * n, n, [&] { return in.number(0.6); });
    const std::vector<double> props = props_of(in, nprops);
    std::vector<double> new_stress(stress.size()), new_state(state.size()),
        new_intern(intern.size()), new_inelas(inelas.size());
    const double step_time = in.number(1e-3), total_time = in.number(1e-3);
    grit::abaqus::run_vumat(
        {given(in, &nblock), given(in, &ndir), given(in, &nshr), given(in, &nstatev),
         given(in, &nprops), given(in, &step_time), given(in, &total_time), given(in, props.data()),
         given(in, density.data()), given(in, strain.data()), given(in, stress.data()),
         given(in, state.data()), given(in, intern.data()), given(in, inelas.data()),
         given(in, new_stress.data()), given(in, new_state.data()), given(in, new_intern.data()),
         given(in, new_inelas.data())});
}

void try_mgis(Bytes& in) {
    using Integrate = int (*)(mfront_gb_BehaviourData*);
    constexpr Integrate all[] = {GritSand_Tridimensional, GritSand_Axisymmetrical,
                                 GritSand_PlaneStrain, GritSand_GeneralisedPlaneStrain};
    const int which = in.below(4), n = which == 0 ? 6 : 4, variables = n + 4;
    const std::vector<double> strain0 = numbers(in, n, 1e-3), strain1 = numbers(in, n, 1.1e-3),
                              stress0 = numbers(in, n, -100.0), props = props_of(in, 16);
    std::vector<double> state0 = numbers(in, variables, 1e-6), state1(state0.size()),
                        stress1(stress0.size()), K(static_cast<std::size_t>(n * n));
    if (!in.one_in(4)) state0[static_cast<std::size_t>(n)] = in.number(0.6);
    const double density = in.number(1.6), before = 1.0, temperature = 293.0;
    double stored = 0.0, dissipated = 0.0, rdt = in.number(1.0), speed = 0.0;
    std::array<char, grit::mgis::error_message_size> message{};
    K[0] = in.one_in(8) ? in.number(4.0) : in.below(8) - 3 + (in.one_in(4) ? 100 : 0);
    mfront_gb_BehaviourData call{};
    call.error_message = given(in, message.data());
    call.dt = in.number(1.0);
    call.K = given(in, K.data());
    call.rdt = given(in, &rdt);
    call.speed_of_sound = given(in, &speed);
    call.s0 = {given(in, strain0.data()), given(in, stress0.data()),
               given(in, &density),       given(in, props.data()),
               given(in, state0.data()),  given(in, &before),
               given(in, &before),        &temperature};
    call.s1 = {given(in, strain1.data()), given(in, stress1.data()),
               given(in, &density),       given(in, props.data()),
               given(in, state1.data()),  given(in, &stored),
               given(in, &dissipated),    &temperature};
    const int answer = all[which](in.one_in(128) ? nullptr : &call);
    demand(answer == grit::mgis::failed || answer == grit::mgis::reliable);
}

}  // namespace

// Complaints are many, and said on standard error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Bytes in(data, size);
    switch (in.below(3)) {
        case 0: try_umat(in); break;
        case 1: try_vumat(in); break;
        default: try_mgis(in);
    }
    return 0;
}
