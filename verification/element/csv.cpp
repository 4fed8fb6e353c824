// SPDX-License-Identifier: BSD-3-Clause
#include "element/csv.hpp"

#include <cerrno>
#include <cstdio>
#include <system_error>

namespace element {
namespace {

constexpr double degree = 3.14159265358979323846 / 180.0;

constexpr const char* header =
    "axial_strain [-],volumetric_strain [-],p [kPa],q [kPa],void_ratio [-],"
    "mobilised_friction [deg],rho [-],"
    "stress_11 [kPa],stress_22 [kPa],stress_33 [kPa],stress_12 [kPa],stress_13 [kPa],"
    "stress_23 [kPa],"
    "strain_11 [-],strain_22 [-],strain_33 [-],gamma_12 [-],gamma_13 [-],gamma_23 [-],"
    "h_11 [-],h_22 [-],h_33 [-],h_12 [-],h_13 [-],h_23 [-],"
    "newton_iterations,rate_evaluations\n";

void print(std::FILE* file, const Vector6& values) {
    for (const double value : values) std::fprintf(file, ",%.12g", value);
}

void print(std::FILE* file, const Row& row) {
    std::fprintf(file, "%.12g,%.12g,%.12g,%.12g,%.12g,%.9g,%.9g", row.strain[0],
                 row.strain.head<3>().sum(), row.invariants.p, row.invariants.q, row.void_ratio,
                 row.invariants.mobilised_friction_angle / degree, row.invariants.rho);
    print(file, row.stress);
    print(file, row.strain);
    print(file, row.h);
    std::fprintf(file, ",%d,%d\n", row.iterations, row.evaluations);
}

[[noreturn]] void fail(const char* what, const std::filesystem::path& path) {
    throw std::filesystem::filesystem_error(what, path,
                                            std::error_code(errno, std::generic_category()));
}

}  // namespace

void write_aside(const std::filesystem::path& path, const std::function<void(std::FILE*)>& write) {
    std::filesystem::path aside = path;
    aside += ".part";
    std::FILE* file = std::fopen(aside.c_str(), "w");
    if (!file) fail("cannot write", aside);
    write(file);
    const bool failed = std::ferror(file) != 0;
    if (std::fclose(file) != 0 || failed) fail("cannot write", aside);
    std::filesystem::rename(aside, path);
}

void write_csv(const std::filesystem::path& path, const Case& test, const Run& run) {
    write_aside(path, [&](std::FILE* file) {
        const int version = grit_version();
        std::fprintf(file, "# Grit %d.%d.%d, case %s: %s\n", version / 10000, version / 100 % 100,
                     version % 100, test.name.c_str(), test.title.c_str());
        std::fprintf(file, "# sand %s, p0 %g kPa, e %.6g, tolerance %g\n", test.sand.c_str(),
                     test.start.pressure, run.rows.front().void_ratio, test.numerics.tolerance);
        std::fprintf(file, "# tension positive, order 11 22 33 12 13 23, engineering shear, "
                           "logarithmic strain; h intergranular strain\n");
        if (!run.failure.empty()) std::fprintf(file, "# STOPPED EARLY: %s\n", run.failure.c_str());
        std::fputs(header, file);
        for (const Row& row : run.rows) print(file, row);
    });
}

}  // namespace element
