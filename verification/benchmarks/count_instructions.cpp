// SPDX-License-Identifier: BSD-3-Clause
// The 320 single calls once, their instructions to be counted by callgrind, which knows no AVX-512:
//   valgrind --tool=callgrind --toggle-collect=counted count_instructions INCREMENT ISA PER_CALL TANGENT
//   valgrind --tool=callgrind --toggle-collect=counted count_instructions INCREMENT LIBRARY LAYOUT.toml
// ISA as GRIT_ISA_..., PER_CALL points per call, TANGENT as GRIT_TANGENT_...; or through umat_ of a library.
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <stdexcept>

#include "sand_points.hpp"
#include "umat_calls.hpp"

extern "C" {
__attribute__((noinline)) void counted(const std::function<void()>& work) { work(); }
}

namespace {

using namespace benchmarks;

void count_c_abi(const SandRequest& request, std::size_t per_call) {
    const auto& calls = calls_of(request.increment);
    SandPoints points =
        SandPoints::structures(calls, calls.size(), request.tangent != GRIT_TANGENT_NONE);
    const grit_sand sand = lausitz();
    const grit_sand_options options = request.options();
    counted([&] { update(sand, options, points, 0, points.size(), per_call); });
    std::cout << points.size() << " points\n";
}

void count_umat(double increment, const std::string& library, const std::string& file) {
    UmatLayout layout = read_umat_layout(file);
    UmatPoints points(calls_of(increment), layout);
    const element::UmatFunction umat = open_umat(library);
    counted([&] { run_umat(umat, layout, !layout.ddsdde_may_be_null, points); });
    std::cout << points.size() << " points\n";
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const double increment = argc > 1 ? std::atof(argv[1]) : 0.0;
        if (argc == 4) count_umat(increment, argv[2], argv[3]);
        else if (argc == 5)
            count_c_abi({.increment = increment,
                         .tangent = std::atoi(argv[4]),
                         .instruction_set = std::atoi(argv[2])},
                        static_cast<std::size_t>(std::atoi(argv[3])));
        else
            throw std::runtime_error(
                "needs INCREMENT ISA PER_CALL TANGENT or INCREMENT LIBRARY LAYOUT");
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "count_instructions: " << error.what() << '\n';
        return 2;
    }
}
