// SPDX-License-Identifier: BSD-3-Clause
#include "element/exit_condition.hpp"

#include "element/errors.hpp"
#include "element/linear_sum.hpp"
#include "element/text.hpp"

namespace element {

Quantity linear_quantity(std::function<double(const Record&)> value) {
    auto change = [value](const Record&, const Record& by) { return value(by); };
    return {std::move(value), std::move(change)};
}

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

double change(const Condition& condition, const Record& at, const Record& by) {
    double sum = 0.0;
    for (const Condition::Addend& addend : condition.sum) {
        if (!addend.quantity.change)
            throw BadCase(text("\"%s\" speaks of a quantity without derivatives: a step that ends "
                               "exactly there cannot be differentiated",
                               condition.text.c_str()));
        sum += addend.factor * addend.quantity.change(at, by);
    }
    return sum;
}

bool holds(const Condition& condition, const Record& record) {
    const double value = excess(condition, record);
    return condition.comparison == Comparison::less ? value < 0.0 : value > 0.0;
}

}  // namespace element
