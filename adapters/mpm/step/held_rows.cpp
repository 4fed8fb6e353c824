// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/held_rows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace grit::mpm {
namespace {

double along(const Vector2& a, const Vector2& b) { return a[0] * b[0] + a[1] * b[1]; }

}  // namespace

void HeldRows::couple() {
    using Key = std::pair<std::size_t, std::size_t>;
    std::vector<Key> nodes;
    for (const Entry& e : entries) nodes.push_back({e.body, e.node});
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    std::vector<std::size_t> place;
    for (const Entry& e : entries)
        place.push_back(static_cast<std::size_t>(
            std::lower_bound(nodes.begin(), nodes.end(), Key{e.body, e.node}) - nodes.begin()));
    const auto n = static_cast<Eigen::Index>(holds.size());
    coupling.resize(n, n);
    struct Taken {
        Vector2 grains{0.0, 0.0}, water{0.0, 0.0};
    };
    std::vector<Taken> taken(nodes.size());
    for (Eigen::Index j = 0; j < n; ++j) {
        const Hold& from = holds[static_cast<std::size_t>(j)];
        for (std::size_t e = from.begin; e < from.end; ++e)
            taken[place[e]] = {entries[e].takes_grains, entries[e].takes_water};
        for (Eigen::Index i = 0; i < n; ++i) {
            const Hold& to = holds[static_cast<std::size_t>(i)];
            double sum = 0.0;
            for (std::size_t e = to.begin; e < to.end; ++e)
                sum += along(entries[e].of_grains, taken[place[e]].grains) +
                       along(entries[e].of_water, taken[place[e]].water);
            coupling(i, j) = sum;
        }
        for (std::size_t e = from.begin; e < from.end; ++e) taken[place[e]] = {};
    }
}

// Scaled to a diagonal of one; what rows that say the same are not told apart by is taken as equal.
void HeldRows::factor() {
    constexpr double alike = 1e-10;
    bearing.clear();
    for (std::size_t h = 0; h < holds.size(); ++h) {
        const auto i = static_cast<Eigen::Index>(h);
        if (holds[h].bears && coupling(i, i) > 0.0) bearing.push_back(h);
        holds[h].impulse = 0.0;
    }
    const auto n = static_cast<Eigen::Index>(bearing.size());
    const auto at = [this](Eigen::Index i) {
        return static_cast<Eigen::Index>(bearing[static_cast<std::size_t>(i)]);
    };
    scale.resize(n);
    for (Eigen::Index i = 0; i < n; ++i) scale[i] = 1.0 / std::sqrt(coupling(at(i), at(i)));
    Eigen::MatrixXd matrix(n, n);
    for (Eigen::Index j = 0; j < n; ++j)
        for (Eigen::Index i = 0; i < n; ++i)
            matrix(i, j) = scale[i] * scale[j] * coupling(at(i), at(j)) + (i == j ? alike : 0.0);
    factors.compute(matrix);
}

Eigen::VectorXd HeldRows::solve(const Eigen::VectorXd& values) const {
    if (values.size() == 0) return values;
    const Eigen::VectorXd scaled = scale.cwiseProduct(values);
    return scale.cwiseProduct(factors.solve(scaled));
}

double HeldRows::read(const Hold& hold, const std::vector<Vector2>& impulses) const {
    double sum = 0.0;
    for (std::size_t k = hold.first; k < hold.last; ++k)
        sum += along(pushes[k].answer, impulses[pushes[k].at]);
    return sum;
}

void HeldRows::read(const std::vector<Vector2>& impulses) const {
    given.resize(static_cast<Eigen::Index>(bearing.size()));
    for (std::size_t i = 0; i < bearing.size(); ++i)
        given[static_cast<Eigen::Index>(i)] = read(holds[bearing[i]], impulses);
}

void HeldRows::take(const Eigen::VectorXd& impulses, std::vector<Vector2>& from) const {
    for (std::size_t i = 0; i < bearing.size(); ++i) {
        const Hold& h = holds[bearing[i]];
        for (std::size_t k = h.first; k < h.last; ++k)
            from[pushes[k].at] =
                from[pushes[k].at] - impulses[static_cast<Eigen::Index>(i)] * pushes[k].answer;
    }
}

void HeldRows::hold(std::vector<Vector2>& velocities) const { take(solve(given), velocities); }

void HeldRows::hold_free(std::vector<Vector2>& velocities) const {
    Eigen::VectorXd free(static_cast<Eigen::Index>(bearing.size()));
    for (std::size_t i = 0; i < bearing.size(); ++i)
        free[static_cast<Eigen::Index>(i)] = holds[bearing[i]].free;
    take(solve(free), velocities);
}

bool HeldRows::find_impulses(const std::vector<Vector2>& impulses) {
    constexpr double enough = 1e-9;  // of the largest value
    std::vector<double> value;
    double largest = 0.0;
    for (const Hold& h : holds) {
        value.push_back(h.free + read(h, impulses));
        largest = std::max({largest, std::fabs(h.free), std::fabs(value.back())});
    }
    Eigen::VectorXd of_bearing(static_cast<Eigen::Index>(bearing.size()));
    for (std::size_t i = 0; i < bearing.size(); ++i)
        of_bearing[static_cast<Eigen::Index>(i)] = value[bearing[i]];
    const Eigen::VectorXd found = solve(of_bearing);
    for (std::size_t i = 0; i < bearing.size(); ++i)
        holds[bearing[i]].impulse = found[static_cast<Eigen::Index>(i)];
    bool changed = false;
    for (std::size_t h = 0; h < holds.size(); ++h) {
        Hold& of = holds[h];
        if (of.water >= 0) continue;
        double left = value[h];
        for (const std::size_t other : bearing)
            left -= coupling(static_cast<Eigen::Index>(h), static_cast<Eigen::Index>(other)) *
                    holds[other].impulse;
        const bool bears = of.bears ? of.impulse > 0.0 : left > enough * largest;
        changed = changed || bears != of.bears;
        of.bears = bears;
    }
    return changed;
}

}  // namespace grit::mpm
