// SPDX-License-Identifier: BSD-3-Clause
// Data of a page as JSON, such that no text in it can end the script that holds it.
#pragma once

#include <string>
#include <vector>

namespace cli {

std::string json_text(const std::string& text);
// Six digits; null where it is no number.
std::string json_numbers(const std::vector<double>& values);
std::string base64(const std::string& bytes);
// The bytes; empty where text is not base64.
std::string from_base64(const std::string& text);

}  // namespace cli
