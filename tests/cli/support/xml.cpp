// SPDX-License-Identifier: BSD-3-Clause
#include "support/xml.hpp"

#include <cstdint>
#include <cstring>
#include <stdexcept>

namespace cli_test {
namespace {

class Reader {
  public:
    explicit Reader(const std::string& all) : text(all) {}

    Element document() {
        if (text.starts_with("<?xml")) at = text.find("?>") + 2;
        space();
        while (text.compare(at, 4, "<!--") == 0) comment();
        Element out = element();
        space();
        if (at != text.size()) fail("something behind the root");
        return out;
    }

  private:
    [[noreturn]] void fail(const std::string& why) const {
        throw std::runtime_error("xml, byte " + std::to_string(at) + ": " + why);
    }
    char now() const {
        if (at >= text.size()) fail("ends early");
        return text[at];
    }
    void space() {
        while (at < text.size() && std::strchr(" \n\t\r", text[at])) ++at;
    }
    void comment() {
        const std::size_t end = text.find("--", at + 4);
        if (end == std::string::npos || text.compare(end, 3, "-->") != 0) fail("-- in a comment");
        at = end + 3;
        space();
    }
    void expect(const std::string& word) {
        if (text.compare(at, word.size(), word) != 0) fail("no " + word);
        at += word.size();
    }
    std::string name() {
        std::string out;
        while (std::isalnum(static_cast<unsigned char>(now())) || now() == '_') out += text[at++];
        if (out.empty()) fail("no name");
        return out;
    }
    std::string until(char end) {
        std::string out;
        while (now() != end) {
            if (now() == '<') fail("a bare <");
            if (now() == '&') out += entity();
            else out += text[at++];
        }
        return out;
    }
    char entity() {
        for (const auto& [word, letter] : std::map<std::string, char>{
                 {"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}})
            if (text.compare(at, word.size(), word) == 0) {
                at += word.size();
                return letter;
            }
        fail("a bare &");
    }
    Element element() {
        Element out;
        expect("<");
        out.name = name();
        for (space(); now() != '>' && now() != '/'; space()) {
            const std::string key = name();
            expect("=\"");
            if (!out.attributes.emplace(key, until('"')).second) fail(key + " twice");
            expect("\"");
        }
        if (now() == '/') {
            expect("/>");
            return out;
        }
        expect(">");
        for (;;) {
            out.text += until('<');
            if (text.compare(at, 2, "</") == 0) break;
            out.children.push_back(element());
        }
        expect("</" + out.name + ">");
        return out;
    }

    const std::string& text;
    std::size_t at = 0;
};

std::string from_base64(const std::string& code) {
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    if (code.size() % 4 != 0) throw std::runtime_error("base64 of odd length");
    std::string out;
    for (std::size_t i = 0; i < code.size(); i += 4) {
        std::uint32_t three = 0;
        std::size_t padding = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t value = letters.find(code[i + k]);
            padding += code[i + k] == '=';
            if (value == std::string::npos && (code[i + k] != '=' || i + 4 != code.size()))
                throw std::runtime_error("no letter of base64");
            three = three << 6 | static_cast<std::uint32_t>(value == std::string::npos ? 0 : value);
        }
        for (std::size_t k = 0; k + padding < 3; ++k)
            out += static_cast<char>(three >> (16 - 8 * k) & 255u);
    }
    return out;
}

}  // namespace

std::vector<const Element*> Element::all(const std::string& wanted) const {
    std::vector<const Element*> out;
    for (const Element& child : children) {
        if (child.name == wanted) out.push_back(&child);
        for (const Element* below : child.all(wanted)) out.push_back(below);
    }
    return out;
}

const Element& Element::first(const std::string& wanted) const {
    const auto found = all(wanted);
    if (found.empty()) throw std::runtime_error("no element " + wanted);
    return *found.front();
}

std::string Element::bytes_of(const std::string& wanted) const {
    for (const Element* array : all("DataArray")) {
        if (array->attributes.at("Name") != wanted) continue;
        const std::string block = from_base64(array->text);
        std::uint64_t length = 0;
        if (block.size() < sizeof length) throw std::runtime_error("no length of " + wanted);
        std::memcpy(&length, block.data(), sizeof length);
        if (block.size() != sizeof length + length)
            throw std::runtime_error("length of " + wanted + " differs");
        return block.substr(sizeof length);
    }
    throw std::runtime_error("no array " + wanted);
}

template <class Number> std::vector<Number> Element::array(const std::string& wanted) const {
    const std::string bytes = bytes_of(wanted);
    std::vector<Number> out(bytes.size() / sizeof(Number));
    std::memcpy(out.data(), bytes.data(), out.size() * sizeof(Number));
    return out;
}
template std::vector<double> Element::array(const std::string&) const;
template std::vector<long> Element::array(const std::string&) const;
template std::vector<unsigned char> Element::array(const std::string&) const;

Element read_xml(const std::string& text) { return Reader(text).document(); }

}  // namespace cli_test
