// SPDX-License-Identifier: BSD-3-Clause
#include "cli/report/json_text.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

namespace cli {
namespace {

constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::array<int, 256> places() {
    std::array<int, 256> out;
    out.fill(-1);
    for (int i = 0; i < 64; ++i) out[static_cast<unsigned char>(digits[i])] = i;
    return out;
}

}  // namespace

std::string json_text(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += {'\\', c};
        else if (static_cast<unsigned char>(c) < ' ' || c == '<')
            out += fmt::format("\\u{:04x}", static_cast<int>(c));
        else out += c;
    }
    return out + '"';
}

std::string json_numbers(const std::vector<double>& values) {
    std::string out = "[";
    for (const double value : values) {
        if (out.size() > 1) out += ',';
        out += std::isfinite(value) ? fmt::format("{:.6g}", value) : "null";
    }
    return out + "]";
}

std::string base64(const std::string& bytes) {
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned word = 0;
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        for (std::size_t k = 0; k < 3; ++k)
            word = word << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            out += k > count ? '=' : digits[word >> (18 - 6 * k) & 63];
    }
    return out;
}

std::string from_base64(const std::string& text) {
    static const std::array<int, 256> place = places();
    std::string out;
    out.reserve(text.size() / 4 * 3);
    unsigned word = 0;
    int bits = 0;
    for (const char c : text) {
        if (c == '=') break;
        const int digit = place[static_cast<unsigned char>(c)];
        if (digit < 0) return "";
        word = word << 6 | static_cast<unsigned>(digit);
        bits += 6;
        if (bits >= 8) {
            bits -= 8;
            out += static_cast<char>(word >> bits & 255);
        }
    }
    return out;
}

}  // namespace cli
