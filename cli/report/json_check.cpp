// SPDX-License-Identifier: BSD-3-Clause
#include "cli/report/json_check.hpp"

#include <algorithm>
#include <cctype>
#include <cstring>

#include <fmt/format.h>

namespace cli {
namespace {

constexpr int deepest_value = 200;  // lists in lists

// Reads on as long as what it meets is what has to be there (RFC 8259).
class JsonReader {
  public:
    explicit JsonReader(const std::string& whole) : text(whole) {}

    std::string problem() {
        const bool read = value(0);
        blanks();
        if (read && at == text.size()) return "";
        const auto line =
            1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
        return at == text.size() ? fmt::format("{}: it ends too early", line)
                                 : fmt::format("{}: \"{}\" is no JSON", line, next_word());
    }

  private:
    std::string next_word() const {
        constexpr std::size_t most = 20;
        std::size_t end = at;
        while (end < text.size() && end - at<most&& static_cast<unsigned char>(text[end])> ' ')
            ++end;
        return text.substr(at, std::max<std::size_t>(end - at, 1));
    }
    void blanks() {
        while (at < text.size() && std::strchr(" \t\r\n", text[at]) && text[at]) ++at;
    }
    bool take(char wanted) {
        blanks();
        return at < text.size() && text[at] == wanted && ++at;
    }
    bool word(const char* wanted) {
        if (text.compare(at, std::strlen(wanted), wanted) != 0) return false;
        at += std::strlen(wanted);
        return true;
    }
    bool digits() {
        const std::size_t from = at;
        while (at < text.size() && std::isdigit(static_cast<unsigned char>(text[at]))) ++at;
        return at > from;
    }
    bool number() {
        word("-");
        if (!word("0") && !digits()) return false;
        if (word(".") && !digits()) return false;
        if (!word("e") && !word("E")) return true;
        if (!word("+")) word("-");
        return digits();
    }
    bool escape() {
        if (at == text.size()) return false;
        if (!word("u")) return std::strchr("\"\\/bfnrt", text[at]) && text[at] && ++at;
        for (int i = 0; i < 4; ++i, ++at)
            if (at == text.size() || !std::isxdigit(static_cast<unsigned char>(text[at])))
                return false;
        return true;
    }
    bool string() {
        if (!take('"')) return false;
        while (at < text.size() && static_cast<unsigned char>(text[at]) >= ' ') {
            const char c = text[at++];
            if (c == '"') return true;
            if (c == '\\' && !escape()) return false;
        }
        return false;
    }
    // Between brackets, with commas.
    template <class One> bool list(char end, One&& one) {
        if (take(end)) return true;
        do
            if (!one()) return false;
        while (take(','));
        return take(end);
    }
    bool value(int depth) {
        if (depth > deepest_value) return false;
        blanks();
        if (take('[')) return list(']', [&] { return value(depth + 1); });
        if (take('{')) return list('}', [&] { return string() && take(':') && value(depth + 1); });
        if (at < text.size() && text[at] == '"') return string();
        return word("true") || word("false") || word("null") || number();
    }

    const std::string& text;
    std::size_t at = 0;
};

}  // namespace

std::string problem_of_json(const std::string& text) { return JsonReader(text).problem(); }

}  // namespace cli
