// SPDX-License-Identifier: BSD-3-Clause
// The punch of tests/mpm by bilinear finite elements in axisymmetry: no contact, its surface is held but at the
// corner, where contact would have to pull.
#pragma once

#include <Eigen/Sparse>
#include <cmath>
#include <vector>

#include <tests/mpm/support/punch.hpp>

namespace mpm_test {

// Lines from the corner of the punch to `to`: the first one `least` away, each cell longer than the one before by a
// share, none longer than `most`.
inline std::vector<double> lines_from_corner(double least, double share, double most, double to) {
    std::vector<double> out{0.0};
    for (double l = least; out.back() + l < to; l = std::min(l * (1.0 + share), most))
        out.push_back(out.back() + l);
    if (to - out.back() < 0.5 * (out.back() - out[out.size() - 2])) out.pop_back();
    out.push_back(to);
    return out;
}

// lines(to): those from the corner to a distance. The punch moves the soil's corner down along with it, or lets it go.
template <class Lines> double punch_by_elements_between(const Lines& lines, bool holds_corner) {
    using P = Punch;
    std::vector<double> r, z;
    const std::vector<double> inwards = lines(P::R), outwards = lines(P::width - P::R);
    const std::vector<double> up = lines(P::embedded), down = lines(P::depth - P::embedded);
    for (std::size_t i = inwards.size(); i-- > 1;) r.push_back(P::R - inwards[i]);
    for (const double x : outwards) r.push_back(P::R + x);
    for (std::size_t i = up.size(); i-- > 1;) z.push_back(-P::embedded + up[i]);
    for (const double x : down) z.push_back(-P::embedded - x);
    const int i_corner = static_cast<int>(inwards.size()) - 1;
    const int j_corner = static_cast<int>(up.size()) - 1;
    const int n_r = static_cast<int>(r.size()), n_z = static_cast<int>(z.size());
    const auto node = [=](int i, int j) { return j * n_r + i; };
    const auto is_soil = [=](int i, int j) { return i >= i_corner || j >= j_corner; };  // cell

    const double lambda = P::E * P::nu / ((1.0 + P::nu) * (1.0 - 2.0 * P::nu));
    const double mu = 0.5 * P::E / (1.0 + P::nu);
    Eigen::Matrix4d D = Eigen::Matrix4d::Zero();  // rr zz tt rz
    D.topLeftCorner<3, 3>().setConstant(lambda);
    D.topLeftCorner<3, 3>().diagonal().array() += 2.0 * mu;
    D(3, 3) = mu;

    const int unknowns = 2 * n_r * n_z;
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<char> used(static_cast<std::size_t>(n_r * n_z));
    const double g = 0.5773502691896258;
    for (int j = 0; j + 1 < n_z; ++j)
        for (int i = 0; i + 1 < n_r; ++i) {
            if (!is_soil(i, j)) continue;
            const int corner[4] = {node(i, j + 1), node(i + 1, j + 1), node(i + 1, j), node(i, j)};
            const double a = r[i + 1] - r[i], b = z[j] - z[j + 1];
            Eigen::Matrix<double, 8, 8> K = Eigen::Matrix<double, 8, 8>::Zero();
            for (const double x : {-g, g})
                for (const double y : {-g, g}) {
                    const double N[4] = {(1 - x) * (1 - y) / 4, (1 + x) * (1 - y) / 4,
                                         (1 + x) * (1 + y) / 4, (1 - x) * (1 + y) / 4};
                    const double N_x[4] = {-(1 - y) / 4, (1 - y) / 4, (1 + y) / 4, -(1 + y) / 4};
                    const double N_y[4] = {-(1 - x) / 4, -(1 + x) / 4, (1 + x) / 4, (1 - x) / 4};
                    const double at = 0.5 * (r[i] + r[i + 1]) + 0.5 * x * a;
                    Eigen::Matrix<double, 4, 8> B = Eigen::Matrix<double, 4, 8>::Zero();
                    for (int k = 0; k < 4; ++k) {
                        B(0, 2 * k) = 2.0 * N_x[k] / a;
                        B(1, 2 * k + 1) = 2.0 * N_y[k] / b;
                        B(2, 2 * k) = N[k] / at;
                        B(3, 2 * k) = 2.0 * N_y[k] / b;
                        B(3, 2 * k + 1) = 2.0 * N_x[k] / a;
                    }
                    K += 0.25 * a * b * at * B.transpose() * D * B;
                }
            for (int k = 0; k < 8; ++k) {
                used[static_cast<std::size_t>(corner[k / 2])] = 1;
                for (int l = 0; l < 8; ++l)
                    entries.emplace_back(2 * corner[k / 2] + k % 2, 2 * corner[l / 2] + l % 2,
                                         K(k, l));
            }
        }
    Eigen::SparseMatrix<double> K(unknowns, unknowns);
    K.setFromTriplets(entries.begin(), entries.end());
    // Held: 1; pushed down by one: 2.
    std::vector<int> held(static_cast<std::size_t>(unknowns));
    for (int j = 0; j < n_z; ++j)
        for (int i = 0; i < n_r; ++i) {
            int& u_r = held[2 * static_cast<std::size_t>(node(i, j))];
            int& u_z = held[2 * static_cast<std::size_t>(node(i, j)) + 1];
            if (!used[static_cast<std::size_t>(node(i, j))]) u_r = u_z = 1;
            if (i == 0 || i == n_r - 1 || (i == i_corner && j < j_corner)) u_r = 1;
            if (j == n_z - 1) u_z = 1;
            if (j == j_corner && (i < i_corner || (holds_corner && i == i_corner))) u_z = 2;
        }
    Eigen::VectorXd u = Eigen::VectorXd::Zero(unknowns);
    for (int k = 0; k < unknowns; ++k)
        if (held[static_cast<std::size_t>(k)] == 2) u[k] = -1.0;
    const Eigen::VectorXd load = K * u;
    std::vector<int> place(static_cast<std::size_t>(unknowns), -1);
    int free = 0;
    for (int k = 0; k < unknowns; ++k)
        if (!held[static_cast<std::size_t>(k)]) place[static_cast<std::size_t>(k)] = free++;
    std::vector<Eigen::Triplet<double>> of_free;
    Eigen::VectorXd right(free);
    for (const auto& e : entries) {
        const int row = place[static_cast<std::size_t>(e.row())];
        const int column = place[static_cast<std::size_t>(e.col())];
        if (row >= 0 && column >= 0) of_free.emplace_back(row, column, e.value());
    }
    for (int k = 0; k < unknowns; ++k)
        if (place[static_cast<std::size_t>(k)] >= 0)
            right[place[static_cast<std::size_t>(k)]] = -load[k];
    Eigen::SparseMatrix<double> A(free, free);
    A.setFromTriplets(of_free.begin(), of_free.end());
    const Eigen::VectorXd solved =
        Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(A).solve(right);
    for (int k = 0; k < unknowns; ++k)
        if (place[static_cast<std::size_t>(k)] >= 0)
            u[k] = solved[place[static_cast<std::size_t>(k)]];
    const Eigen::VectorXd force = K * u;
    double sum = 0.0;
    for (int k = 0; k < unknowns; ++k)
        if (held[static_cast<std::size_t>(k)] == 2) sum -= force[k];
    return 2.0 * 3.141592653589793 * sum;
}

// Finest at the corner, where stresses have no limit: fine: how many times finer than R/1000 there, and how much
// slower cells grow.
inline double punch_by_elements(double fine) {
    using P = Punch;
    return punch_by_elements_between(
        [fine](double to) {
            return lines_from_corner(1e-3 * P::R / fine, 0.3 / fine, 0.25 * P::R / fine, to);
        },
        true);
}

// All cells R / cells: what a grid with a line at either face can know.
inline double punch_by_equal_elements(int cells, bool holds_corner) {
    const double h = Punch::R / cells;
    return punch_by_elements_between(
        [h](double to) {
            std::vector<double> out;
            for (int i = 0; i <= std::lround(to / h); ++i) out.push_back(i * h);
            return out;
        },
        holds_corner);
}

}  // namespace mpm_test
