// SPDX-License-Identifier: BSD-3-Clause
#include "support/compare.hpp"

#include <algorithm>
#include <cmath>

#include <element/incremental_driver/run.hpp>

double difference(const Table& a, const Table& b) {
    double worst = a.size() == b.size() ? 0.0 : INFINITY;
    const std::size_t ends[] = {2, 8, 14, 20, 28};  // time, strain, stress, h, the other ones
    std::size_t begin = 0;
    for (const std::size_t end : ends) {
        const bool alone = end == 28;
        double scale = 0.0, gap = 0.0;
        for (std::size_t c = begin; c < end; ++c) {
            if (alone) scale = gap = 0.0;
            for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
                scale = std::max(scale, std::abs(a[i][c]));
                const double apart = std::abs(a[i][c] - b[i][c]);
                gap = std::max(gap, std::isnan(apart) ? INFINITY : apart);
            }
            if (gap > 0.0) worst = std::max(worst, gap / scale);
        }
        begin = end;
    }
    return worst;
}

Table of_files(const std::filesystem::path& folder, const std::string& output, int headings,
               const std::filesystem::path& umat) {
    const Folder out;
    incremental_driver::run({folder, out.path(), umat});
    return read_table(out.path(output), headings);
}
