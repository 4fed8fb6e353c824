// SPDX-License-Identifier: BSD-3-Clause
#include "incremental_driver/output_file.hpp"

#include <cerrno>
#include <cmath>
#include <system_error>

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
    : place(path), aside(path) {
    aside += ".part";
    file = std::fopen(aside.c_str(), "w");
    if (!file) fail();
    print_names(file, "time", 2);
    print_names(file, "stran", 6);
    print_names(file, "stress", 6);
    print_names(file, "statev", nstatv);
    std::fputc('\n', file);
    if (!heading.empty()) std::fprintf(file, " %s\n", heading.c_str());
}

OutputFile::~OutputFile() {
    if (!file) return;
    std::fclose(file);
    std::error_code nobody_is_left_to_ask;
    std::filesystem::remove(aside, nobody_is_left_to_ask);
}

void OutputFile::row(const element::Record& record) {
    // Step time starts anew nowhere in incrementalDriver: both columns are the time since the start.
    print_value(file, record.time);
    print_value(file, record.time);
    for (const double value : record.strain) print_value(file, value);
    for (const double value : record.stress) print_value(file, value);
    for (const double value : record.state) print_value(file, value);
    std::fputc('\n', file);
    ++count;
}

void OutputFile::complete() {
    const bool failed = std::ferror(file) != 0;
    const bool not_closed = std::fclose(file) != 0;
    file = nullptr;
    if (failed || not_closed) {
        std::error_code ignored;
        std::filesystem::remove(aside, ignored);
        fail();
    }
    std::filesystem::rename(aside, place);
}

void OutputFile::fail() const {
    throw std::filesystem::filesystem_error("cannot write", place,
                                            std::error_code(errno, std::generic_category()));
}

}  // namespace incremental_driver
