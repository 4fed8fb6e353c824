// SPDX-License-Identifier: BSD-3-Clause
#include "element/calibration/parameter_space.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace calibration {

double get(const grit_sand_parameters& parameters, int index) {
    double value = NAN;
    grit_sand_parameter_get(&parameters, index, &value);
    return value;
}

void set(grit_sand_parameters& parameters, int index, double value) {
    grit_sand_parameter_set(&parameters, index, value);
}

int parameter_index(const std::string& word) {
    for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i) {
        const grit_sand_parameter_info& info = *grit_sand_parameter_describe(i);
        if (word == info.symbol || word == info.name) return i;
    }
    return -1;
}

std::string symbol_of(int index) { return grit_sand_parameter_describe(index)->symbol; }

// A hardness and the radius of the elastic range are known to a factor.
bool FreeParameter::logarithmic() const {
    const grit_sand_parameter_info& info = *grit_sand_parameter_describe(index);
    return std::strcmp(info.symbol, "h_s") == 0 || std::strcmp(info.symbol, "R") == 0;
}

double FreeParameter::coordinate(double value) const {
    return logarithmic() ? std::log(value) : value;
}

double FreeParameter::value(double coordinate) const {
    return logarithmic() ? std::exp(coordinate) : coordinate;
}

grit_sand_parameters ParameterSpace::at(const Vector& x) const {
    grit_sand_parameters out = base;
    for (Eigen::Index k = 0; k < size(); ++k) {
        const FreeParameter& each = free[static_cast<std::size_t>(k)];
        set(out, each.index, each.value(x[k]));
    }
    for (const Tie& tie : ties) set(out, tie.index, tie.factor * get(out, tie.to));
    return out;
}

Vector ParameterSpace::coordinates(const grit_sand_parameters& parameters) const {
    Vector x(size());
    for (Eigen::Index k = 0; k < size(); ++k) {
        const FreeParameter& each = free[static_cast<std::size_t>(k)];
        x[k] = each.coordinate(get(parameters, each.index));
    }
    return x;
}

Vector ParameterSpace::lowest() const {
    Vector x(size());
    for (Eigen::Index k = 0; k < size(); ++k) {
        const FreeParameter& each = free[static_cast<std::size_t>(k)];
        x[k] = each.coordinate(each.lowest);
    }
    return x;
}

Vector ParameterSpace::highest() const {
    Vector x(size());
    for (Eigen::Index k = 0; k < size(); ++k) {
        const FreeParameter& each = free[static_cast<std::size_t>(k)];
        x[k] = each.coordinate(each.highest);
    }
    return x;
}

bool ParameterSpace::contains(const Vector& x) const {
    return (x.array() >= lowest().array()).all() && (x.array() <= highest().array()).all();
}

element::Directions ParameterSpace::directions() const {
    element::Directions out;
    for (const FreeParameter& each : free) out.push_back(each.index);
    for (const Tie& tie : ties) out.push_back(tie.index);
    return out;
}

Matrix ParameterSpace::chain(const Vector& x) const {
    Matrix out = Matrix::Zero(size() + static_cast<Eigen::Index>(ties.size()), size());
    for (Eigen::Index k = 0; k < size(); ++k) {
        const FreeParameter& each = free[static_cast<std::size_t>(k)];
        out(k, k) = each.logarithmic() ? each.value(x[k]) : 1.0;
    }
    for (std::size_t i = 0; i < ties.size(); ++i)
        if (const auto to = find(ties[i].to))
            out.row(size() + static_cast<Eigen::Index>(i)) = ties[i].factor * out.row(*to);
    return out;
}

std::optional<Eigen::Index> ParameterSpace::find(int index) const {
    const auto place = std::find_if(free.begin(), free.end(), [index](const FreeParameter& each) {
        return each.index == index;
    });
    if (place == free.end()) return std::nullopt;
    return static_cast<Eigen::Index>(place - free.begin());
}

}  // namespace calibration
