// SPDX-License-Identifier: BSD-3-Clause
// As much XML as files of VTK need: elements, attributes and text, all closed in order.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace cli_test {

struct Element {
    std::string name;
    std::map<std::string, std::string> attributes;
    std::vector<Element> children;
    std::string text;

    // Below it, at any depth, in the order of the file.
    std::vector<const Element*> all(const std::string& wanted) const;
    // The first of that name. Throws std::runtime_error if there is none.
    const Element& first(const std::string& wanted) const;
    // The data array of this name, decoded: length and bytes must agree.
    template <class Number> std::vector<Number> array(const std::string& wanted) const;

  private:
    std::string bytes_of(const std::string& wanted) const;
};

// Throws std::runtime_error naming what is not well formed.
Element read_xml(const std::string& text);

extern template std::vector<double> Element::array(const std::string&) const;
extern template std::vector<long> Element::array(const std::string&) const;
extern template std::vector<unsigned char> Element::array(const std::string&) const;

}  // namespace cli_test
