// SPDX-License-Identifier: BSD-3-Clause
#include "element/incremental_driver/parameters.hpp"

#include "element/incremental_driver/lines.hpp"
#include "element/text.hpp"

namespace incremental_driver {
namespace {

constexpr int most_props = 10000;

std::string without_quotes(std::string name) {
    std::erase_if(name, [](char c) { return c == '\'' || c == '"'; });
    return name;
}

}  // namespace

Parameters read_parameters(const std::filesystem::path& path) {
    Lines lines(path);
    Parameters out;
    const Line& name = lines.next("the name of the material");
    // Abaqus hands over 80 characters.
    out.name = without_quotes(Fields(lines, name).word().value_or("")).substr(0, 80);
    const int count = Fields(lines, lines.next("nprops")).whole("nprops", 1, most_props);
    for (int i = 1; i <= count; ++i) {
        const std::string what = element::text("PROPS(%d) of %d", i, count);
        const Line& line = lines.next(what);
        out.props.push_back(Fields(lines, line).single(what));
        out.lines.push_back(line.number);
    }
    return out;
}

}  // namespace incremental_driver
