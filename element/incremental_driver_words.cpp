// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <Eigen/Eigenvalues>

#include "element/errors.hpp"
#include "element/exit_condition.hpp"
#include "element/text.hpp"

namespace element {
namespace {

constexpr const char* quantities[] = {"s1",  "s2",  "s3",  "s12",  "s13", "s23", "e1",  "e2", "e3",
                                      "g12", "g13", "g23", "p",    "q",   "P",   "Q",   "ev", "eq",
                                      "eP",  "eQ",  "pw",  "time", "sI",  "sII", "sIII"};

constexpr std::size_t first_principal = 22;  // and the last three: all others are linear

double principal(const Vector6& stress, int from_smallest) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(
        Eigen::Matrix3d(stress_tensor(stress)), Eigen::EigenvaluesOnly);
    return eigen.eigenvalues()[from_smallest];
}

double principal_change(const Vector6& stress, const Vector6& by, int from_smallest) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(
        Eigen::Matrix3d(stress_tensor(stress)));
    const Eigen::Vector3d n = eigen.eigenvectors().col(from_smallest);
    return n.dot(Eigen::Matrix3d(stress_tensor(by)) * n);
}

double known_quantity(std::size_t index, const Record& record) {
    const Vector6 &s = record.stress, &e = record.strain;
    const double root3 = std::sqrt(3.0);
    const double p = -(s[0] + s[1] + s[2]) / 3.0, q = -(s[0] - s[2]);
    const double ev = -(e[0] + e[1] + e[2]), e13 = e[0] - e[2];
    switch (index) {
        case 12: return p;
        case 13: return q;
        case 14: return root3 * p;
        case 15: return q;
        case 16: return ev;
        case 17: return -2.0 / 3.0 * e13;
        case 18: return ev / root3;
        case 19: return -std::sqrt(2.0 / 3.0) * e13;
        case 20: return record.pore_pressure;
        case 21: return record.time;
        case 22: return principal(s, 2);
        case 23: return principal(s, 1);
        case 24: return principal(s, 0);
        default: break;
    }
    return index < 6 ? s[static_cast<int>(index)] : e[static_cast<int>(index) - 6];
}

// 1 for "v1", 0 if the name is not of this form.
std::size_t state_number(const std::string& name) {
    if (name.size() < 2 || name.size() > 7 || name[0] != 'v') return 0;
    const bool digits = std::all_of(name.begin() + 1, name.end(),
                                    [](unsigned char c) { return c >= '0' && c <= '9'; });
    return digits ? std::strtoul(name.c_str() + 1, nullptr, 10) : 0;
}

}  // namespace

Vocabulary incremental_driver_words(std::vector<std::string> state_names) {
    return [names = std::move(state_names)](const std::string& name) -> Quantity {
        const auto* const found = std::find(std::begin(quantities), std::end(quantities), name);
        if (found != std::end(quantities)) {
            const auto index = static_cast<std::size_t>(found - std::begin(quantities));
            Quantity out = linear_quantity(
                [index](const Record& record) { return known_quantity(index, record); });
            if (index >= first_principal)
                out.change = [index](const Record& at, const Record& by) {
                    return principal_change(at.stress, by.stress, 24 - static_cast<int>(index));
                };
            return out;
        }
        const auto of_state = [](std::size_t index) -> Quantity {
            return linear_quantity([index](const Record& record) { return record.state[index]; });
        };
        if (const std::size_t number = state_number(name)) {
            if (number <= names.size()) return of_state(number - 1);
            throw BadCase(text("there is no %s: the law has %d state variables", name.c_str(),
                               static_cast<int>(names.size())));
        }
        const auto state = std::find(names.begin(), names.end(), name);
        if (state != names.end()) return of_state(static_cast<std::size_t>(state - names.begin()));
        std::string list;
        for (const char* each : quantities) list += std::string(" ") + each;
        throw BadCase(text("unknown quantity \"%s\"; known are%s, v1 v2 ... and the names of the "
                           "state variables",
                           name.c_str(), list.c_str()));
    };
}

}  // namespace element
