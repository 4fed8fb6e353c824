// SPDX-License-Identifier: BSD-3-Clause
#include "element/exit_condition.hpp"

#include "element/linear_sum.hpp"

namespace element {

Condition parse_condition(const std::string& text, const Vocabulary& vocabulary) {
    SumReader reader("condition", text);
    Condition out;
    out.text = text;
    for (const Term& term : reader.sum()) out.sum.push_back({term.factor, vocabulary(term.name)});
    if (reader.take('<')) out.comparison = Comparison::less;
    else if (reader.take('>')) out.comparison = Comparison::greater;
    else reader.fail("< or >");
    out.limit = reader.number();
    reader.end();
    return out;
}

double excess(const Condition& condition, const Record& record) {
    double sum = 0.0;
    for (const Condition::Addend& addend : condition.sum)
        sum += addend.factor * addend.quantity(record);
    return sum - condition.limit;
}

bool holds(const Condition& condition, const Record& record) {
    const double value = excess(condition, record);
    return condition.comparison == Comparison::less ? value < 0.0 : value > 0.0;
}

}  // namespace element
