// SPDX-License-Identifier: BSD-3-Clause
#include "support/vumat_call.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "support/library.hpp"

namespace {

constexpr double canary = -7.25e77, rubbish = 3.5e33;
constexpr int place[6] = {0, 1, 2, 3, 5, 4};  // of 11 22 33 12 13 23 in 11 22 33 12 23 31

VumatFunction vumat() {
    return reinterpret_cast<VumatFunction>(symbol_of(GRIT_VUMAT_LIBRARY, "vumat_"));
}

}  // namespace

BlockArray::BlockArray(int n, int size, double fill)
    : block(n),
      memory(2 * margin + static_cast<std::size_t>(n) * static_cast<std::size_t>(size), canary) {
    std::fill_n(memory.begin() + margin, n * size, fill);
}

bool BlockArray::intact() const {
    const auto ours = [](double x) { return x == canary; };
    return std::all_of(memory.begin(), memory.begin() + margin, ours) &&
           std::all_of(memory.end() - margin, memory.end(), ours);
}

bool BlockArray::operator==(const BlockArray& other) const {
    return memory.size() == other.memory.size() &&
           std::memcmp(memory.data(), other.memory.data(), memory.size() * sizeof(double)) == 0;
}

VumatCall::VumatCall(int n, int shears, int statev)
    : nblock(n), nshr(shears), nstatev(statev),
      missing(), props{33.0, 0.0, 1e6, 0.25, 0.55, 0.95, 1.05, 0.25,
                       1.5,  5.0, 2.0, 1e-4, 0.5,  6.0,  0.0,  10.70},
      density(static_cast<std::size_t>(n), 1.8), strain_inc(n, 3 + shears, 0.0),
      rel_spin_inc(n, shears, 0.1), stretch(n, 3 + shears, 1.0), defgrad(n, 3 + 2 * shears, 0.5),
      stress_old(n, 3 + shears, 0.0), state_old(n, statev, 0.0), intern_old(n, 1, 5.0),
      inelas_old(n, 1, 6.0), stress_new(n, 3 + shears, rubbish), state_new(n, statev, rubbish),
      intern_new(n, 1, rubbish), inelas_new(n, 1, rubbish) {
    for (int i = 0; i < n; ++i)
        for (int c = 0; c < 3; ++c) stress_old(i, c) = -100.0;
}

void VumatCall::run(VumatFunction function) {
    const int nfieldv = 1, lanneal = 0;
    const double dt = 1e-6;
    std::vector<double> unused(static_cast<std::size_t>(3 * nblock + 3), 0.0);
    const double* none = unused.data();
    char cmname[80];
    std::memset(cmname, ' ', sizeof cmname);
    const auto given = [this](const char* name, auto* argument) {
        return missing == name ? nullptr : argument;
    };
    function(given("nblock", &nblock), given("ndir", &ndir), given("nshr", &nshr),
             given("nstatev", &nstatev), &nfieldv, given("nprops", &nprops), &lanneal, &step_time,
             &total_time, &dt, cmname, none, none, given("props", props.data()), density.data(),
             given("strainInc", strain_inc.data()), rel_spin_inc.data(), none, stretch.data(),
             defgrad.data(), none, given("stressOld", stress_old.data()),
             given("stateOld", state_old.data()), intern_old.data(), inelas_old.data(), none,
             stretch.data(), defgrad.data(), none, given("stressNew", stress_new.data()),
             given("stateNew", state_new.data()), intern_new.data(), inelas_new.data(),
             sizeof cmname);
}

void VumatCall::run() { run(vumat()); }

std::string VumatCall::complaint() {
    unload(GRIT_VUMAT_LIBRARY);
    testing::internal::CaptureStderr();
    run();
    return testing::internal::GetCapturedStderr();
}

void VumatCall::advance() {
    stress_old = stress_new;
    state_old = state_new;
    intern_old = intern_new;
    inelas_old = inelas_new;
}

void VumatCall::set_tolerance(double tolerance) {
    nprops = 17;
    props.resize(17);
    props[16] = tolerance;
}

void VumatCall::set_water(double K_w, double largest_tension, double itself) {
    nprops = 19;
    props.resize(19, 0.0);
    props[14] = K_w;
    props[17] = largest_tension;
    props[18] = itself;
}

void VumatCall::set_strain(int point, const double* d) {
    for (int c = 0; c < 3 + nshr; ++c) strain_inc(point, place[c]) = c < 3 ? d[c] : 0.5 * d[c];
}

std::vector<double> VumatCall::stress(int point) const {
    std::vector<double> out(6, 0.0);
    for (int c = 0; c < 3 + nshr; ++c)
        out[static_cast<std::size_t>(c)] = stress_new(point, place[c]);
    return out;
}

bool VumatCall::in_bounds() const {
    for (const BlockArray* a : {&strain_inc, &stress_old, &state_old, &intern_old, &inelas_old,
                                &stress_new, &state_new, &intern_new, &inelas_new})
        if (!a->intact()) return false;
    return true;
}
