// SPDX-License-Identifier: BSD-3-Clause
// "s1 - 2*s3 < -400": when a step ends before its time.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "element/record.hpp"

namespace element {

// Of a point.
struct Quantity {
    std::function<double(const Record&)> value;
    // How it changes at a record that changes by another, to first order; empty: that is not known.
    std::function<double(const Record& at, const Record& by)> change = {};

    double operator()(const Record& record) const { return value(record); }
};
// A sum of numbers of a record times constants.
Quantity linear_quantity(std::function<double(const Record&)> value);

// What a name means; throws BadCase for an unknown one, listing those known.
using Vocabulary = std::function<Quantity(const std::string& name)>;

enum class Comparison { less, greater };

// True where the sum of factor times quantity is < or > limit.
struct Condition {
    struct Addend {
        double factor = 1.0;
        Quantity quantity;
    };
    std::vector<Addend> sum;
    Comparison comparison = Comparison::less;
    double limit = 0.0;
    std::string text;  // as written, for messages
};

// Reads "s1 < -400", "-s1 + 2*s3 > 100"; throws BadCase naming the position of the error.
Condition parse_condition(const std::string& text, const Vocabulary& vocabulary);

// The sum of a condition minus its limit.
double excess(const Condition& condition, const Record& record);
bool holds(const Condition& condition, const Record& record);
// Of the sum, where the record changes: to first order. Throws BadCase where that is not known.
double change(const Condition& condition, const Record& at, const Record& by);

// The names of incrementalDriver (which takes no principal values):
//   s1 s2 s3 s12 s13 s23  stress of the law       e1 e2 e3 g12 g13 g23  strain
//   p = -(s1+s2+s3)/3, P = sqrt3 p, q = Q = -(s1-s3)
//   ev = -(e1+e2+e3), eP = ev/sqrt3, eq = -2/3 (e1-e3), eQ = -sqrt(2/3) (e1-e3)
//   v1 v2 ...  state variables, also by their names
// and of Grit: pw pore pressure, time, sI sII sIII principal stresses (sI largest, tension positive).
Vocabulary incremental_driver_words(std::vector<std::string> state_names);

}  // namespace element
