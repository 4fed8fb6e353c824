// SPDX-License-Identifier: BSD-3-Clause
#include "element/incremental_driver/restriction.hpp"

#include "element/errors.hpp"
#include "element/linear_sum.hpp"

namespace incremental_driver {
namespace {

// Adds factor times sd1 ... sd6 or ed1 ... ed6.
void add(const element::Term& term, Restriction& out) {
    const std::string& name = term.name;
    const bool known = name.size() == 3 && name[1] == 'd' && (name[0] == 's' || name[0] == 'e') &&
                       name[2] >= '1' && name[2] <= '6';
    if (!known)
        throw element::BadCase("a restriction speaks of sd1 ... sd6 and ed1 ... ed6, got \"" +
                               name + "\"");
    (name[0] == 's' ? out.stress : out.strain)[name[2] - '1'] += term.factor;
}

Restriction parse(const std::string& text) {
    element::SumReader reader("restriction", text);
    Restriction out;
    for (const element::Term& term : reader.sum()) add(term, out);
    if (!reader.take('=')) reader.fail("=");
    if (out.stress.isZero(0.0) && out.strain.isZero(0.0))
        throw element::BadCase("this restriction restricts nothing: all factors are 0");
    out.change = reader.number();
    reader.end();
    return out;
}

}  // namespace

Restriction read_restriction(const Lines& lines, const Line& line) {
    try {
        return parse(trimmed(line.text.substr(0, line.text.find_first_of("#!"))));
    } catch (const element::BadCase& error) {
        lines.fail(line.number, error.what());
    }
}

}  // namespace incremental_driver
