// SPDX-License-Identifier: BSD-3-Clause
// Two threads call umat_ and vumat_ on points of their own, some of which fail, in a program in which
// ThreadSanitizer sees every line of the adapter and of the library. It ends the program with an error
// where it finds a race; the results must be those of one thread after the other.
#include <array>
#include <cstdio>
#include <cstring>
#include <functional>
#include <thread>
#include <vector>

extern "C" {
void umat_(double*, double*, double*, double*, double*, double*, double*, double*, double*, double*,
           const double*, const double*, const double*, const double*, const double*, const double*,
           const double*, const double*, const char*, const int*, const int*, const int*,
           const int*, const double*, const int*, const double*, const double*, double*,
           const double*, const double*, const double*, const int*, const int*, const int*,
           const int*, const int*, const int*, std::size_t);
void vumat_(const int*, const int*, const int*, const int*, const int*, const int*, const int*,
            const double*, const double*, const double*, const char*, const double*, const double*,
            const double*, const double*, const double*, const double*, const double*,
            const double*, const double*, const double*, const double*, const double*,
            const double*, const double*, const double*, const double*, const double*,
            const double*, double*, double*, double*, double*, std::size_t);
}

namespace {

constexpr int points = 4, increments = 20, nstatv = 14, nprops = 16;

// Shared by both threads, as the PROPS of a material are.
constexpr double props[nprops] = {33.0, 0.0, 1.6e6, 0.19, 0.44, 0.85, 1.0, 0.25,
                                  1.0,  5.0, 2.0,   1e-4, 0.5,  6.0,  0.0, 10.6};

struct Results {
    std::array<double, points * 6> stress{};
    std::array<double, points * nstatv> statev{};
    std::array<double, points * 36> tangent{};
    std::array<double, 6 * points> block_stress{};
    int failures = 0;
};

void call_umat(Results& out, int point, const double* dstran) {
    const int n = 6, three = 3;
    double pnewdt = 1.0;
    umat_(&out.stress[6 * point], &out.statev[nstatv * point], &out.tangent[36 * point], nullptr,
          nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, dstran, nullptr, nullptr,
          nullptr, nullptr, nullptr, nullptr, nullptr, &three, &three, &n, &nstatv, props, &nprops,
          nullptr, nullptr, &pnewdt, nullptr, nullptr, nullptr, &point, &point, nullptr, nullptr,
          nullptr, nullptr, 0);
    if (pnewdt < 1.0) ++out.failures;
}

void call_vumat(Results& out, const double* strain) {
    const int three = 3, n = points;
    const double time = 1.0;
    std::array<double, 6 * points> strain_inc{}, old{};
    std::array<double, nstatv * points> state_old{}, state_new{};
    for (int i = 0; i < points; ++i)
        for (int c = 0; c < 6; ++c) {
            strain_inc[i + points * c] = strain[c];
            old[i + points * c] = c < 3 ? -100.0 - i : 0.0;
        }
    vumat_(&n, &three, &three, &nstatv, nullptr, &nprops, nullptr, &time, &time, &time, nullptr,
           nullptr, nullptr, props, nullptr, strain_inc.data(), nullptr, nullptr, nullptr, nullptr,
           nullptr, old.data(), state_old.data(), nullptr, nullptr, nullptr, nullptr, nullptr,
           nullptr, out.block_stress.data(), state_new.data(), nullptr, nullptr, 0);
}

// The points of one thread.
void work(Results& out, double side) {
    for (int i = 0; i < points; ++i)
        for (int c = 0; c < 3; ++c) out.stress[6 * i + c] = -100.0;
    for (int increment = 0; increment < increments; ++increment) {
        for (int i = 0; i < points; ++i) {
            const double d[6] = {-2e-4 * side, 4e-5 * i, 1e-5, 5e-5 * side, 0.0, -1e-5 * i};
            call_umat(out, i, d);
        }
        const double too_large[6] = {0.0, 0.0, 1.0 / 0.0, 0.0, 0.0, 0.0};
        call_umat(out, increment % points, too_large);  // both threads want to say so first
        const double d[6] = {-2e-4 * side, 4e-5, 1e-5, 5e-5, 0.0, -1e-5};
        call_vumat(out, d);
    }
}

bool same(const Results& a, const Results& b) {
    return std::memcmp(&a.stress, &b.stress, sizeof a.stress) == 0 &&
           std::memcmp(&a.statev, &b.statev, sizeof a.statev) == 0 &&
           std::memcmp(&a.tangent, &b.tangent, sizeof a.tangent) == 0 &&
           std::memcmp(&a.block_stress, &b.block_stress, sizeof a.block_stress) == 0;
}

}  // namespace

int main() {
    std::vector<Results> together(2), alone(2);
    std::thread first(work, std::ref(together[0]), 1.0), second(work, std::ref(together[1]), 0.7);
    first.join();
    second.join();
    work(alone[0], 1.0);
    work(alone[1], 0.7);
    for (std::size_t i = 0; i < 2; ++i)
        if (together[i].failures != increments || !same(together[i], alone[i])) {
            std::puts("two threads do not give what one gives");
            return 1;
        }
    std::printf("2 threads, %d points each, %d increments: as one thread, p11 %.6g kPa\n", points,
                increments, together[0].stress[0]);
    return 0;
}
