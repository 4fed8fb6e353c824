// SPDX-License-Identifier: BSD-3-Clause
#include "element/incremental_driver/output_file.hpp"

#include <cmath>

#include "element/text.hpp"

namespace incremental_driver {
namespace {

constexpr double least = 1e-99;  // Fortran programs stumble over exponents of three digits

void print_value(std::FILE* file, double value) {
    std::fprintf(file, " %21.14e", std::abs(value) < least ? 0.0 : value);
}

void print_names(std::FILE* file, const char* name, int count) {
    for (int i = 1; i <= count; ++i)
        std::fprintf(file, " %21s", element::text("%s(%d)", name, i).c_str());
}

}  // namespace

OutputFile::OutputFile(const std::filesystem::path& path, const std::string& heading, int nstatv)
    : file(path) {
    std::FILE* out = file.stream();
    print_names(out, "time", 2);
    print_names(out, "stran", 6);
    print_names(out, "stress", 6);
    print_names(out, "statev", nstatv);
    std::fputc('\n', out);
    if (!heading.empty()) std::fprintf(out, " %s\n", heading.c_str());
}

void OutputFile::row(const element::Record& record) {
    std::FILE* out = file.stream();
    // Step time starts anew nowhere in incrementalDriver: both columns are the time since the start.
    print_value(out, record.time);
    print_value(out, record.time);
    for (const double value : record.strain) print_value(out, value);
    for (const double value : record.stress) print_value(out, value);
    for (const double value : record.state) print_value(out, value);
    std::fputc('\n', out);
    ++count;
}

}  // namespace incremental_driver
