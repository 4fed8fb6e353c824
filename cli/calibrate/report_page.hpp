// SPDX-License-Identifier: BSD-3-Clause
// What a calibration has found as one page of HTML with all its pictures in it.
#pragma once

#include "cli/calibrate/bands.hpp"
#include "cli/calibrate/calibration_case.hpp"
#include "cli/calibrate/calibration_result.hpp"
#include "cli/calibrate/next_test.hpp"
#include "element/atomic_file.hpp"

namespace cli {

// The file is complete but for its name. Throws element::CannotWrite.
void write_report_page(element::AtomicFile& page, const CalibrationCase& file,
                       const CalibrationResult& result, const std::vector<Band>& bands,
                       const std::vector<NextTest>& next);

}  // namespace cli
