// SPDX-License-Identifier: BSD-3-Clause
// The normal impulses of several pairs at one node together: (A + D) J = b, J >= 0, where b are the
// approach velocities, A J what the impulses take from them, and D = (1 - f_p)/(f_p m_r) J what (C5)
// leaves. Solved pair by pair the impulses of a light body between heavy ones need as many sweeps as the
// masses differ; here it is one small linear system per set of pairs that touch.
#pragma once

#include "contact/nodal/request.hpp"
#include "support/number.hpp"

GRIT_KERNEL_BEGIN

struct NormalSystem {
    int count;
    double M[most_pairs][most_pairs];  // A + D, symmetric, positive semi-definite
    double b[most_pairs];
    double J[most_pairs];

    // b - M J of a row, less what roundoff makes of it.
    double excess(int row) const {
        double r = b[row], size = fabs(b[row]);
        for (int c = 0; c < count; ++c) {
            r -= M[row][c] * J[c];
            size += fabs(M[row][c] * J[c]);
        }
        return fabs(r) <= 1e-14 * size ? 0.0 : r;
    }
};

// J of the pairs in the set, zero elsewhere, by Cholesky. A pair that the others hold already gets none.
inline void solve_set(NormalSystem& s, const bool set[most_pairs]) {
    int row_of[most_pairs], n = 0;
    for (int i = 0; i < s.count; ++i) {
        s.J[i] = 0.0;
        if (set[i]) row_of[n++] = i;
    }
    double L[most_pairs][most_pairs], y[most_pairs];
    bool held[most_pairs];
    for (int r = 0; r < n; ++r) {
        y[r] = s.b[row_of[r]];
        for (int c = 0; c <= r; ++c) {
            double x = s.M[row_of[r]][row_of[c]];
            for (int k = 0; k < c; ++k) x -= L[r][k] * L[c][k];
            if (c < r) L[r][c] = held[c] ? 0.0 : x / L[c][c];
            else {
                held[r] = !(x > 1e-12 * s.M[row_of[r]][row_of[r]]);
                L[r][r] = held[r] ? 1.0 : sqrt(x);
            }
        }
        for (int k = 0; k < r; ++k) y[r] -= L[r][k] * y[k];
        y[r] = held[r] ? 0.0 : y[r] / L[r][r];
    }
    for (int r = n - 1; r >= 0; --r) {
        if (held[r]) continue;
        for (int k = r + 1; k < n; ++k) y[r] -= L[k][r] * y[k];
        y[r] /= L[r][r];
        s.J[row_of[r]] = y[r];
    }
}

// By how much an approach is more than J takes, or less where it presses [velocity].
inline double error_of(const NormalSystem& s) {
    double largest = 0.0;
    for (int i = 0; i < s.count; ++i)
        largest = max(largest, s.J[i] > 0.0 ? fabs(s.excess(i)) : s.excess(i));
    return largest;
}

// Lawson & Hanson's active-set method. False if it ends without a solution within the tolerance [velocity].
inline bool solve_by_sets(NormalSystem& s, double tolerance) {
    bool set[most_pairs] = {};
    double J[most_pairs] = {};
    for (int step = 0; step < 3 * most_pairs; ++step) {
        int worst = -1;
        for (int i = 0; i < s.count; ++i) s.J[i] = J[i];
        double largest = tolerance;
        for (int i = 0; i < s.count; ++i)
            if (const double excess = s.excess(i); !set[i] && excess > largest) {
                largest = excess;
                worst = i;
            }
        if (worst < 0) break;
        set[worst] = true;
        for (;;) {  // towards the solution of the set, as far as all stay >= 0
            solve_set(s, set);
            double part = 1.0;
            int leaving = -1;
            for (int i = 0; i < s.count; ++i)
                if (set[i] && s.J[i] <= 0.0 && J[i] / (J[i] - s.J[i]) < part) {
                    part = J[i] / (J[i] - s.J[i]);
                    leaving = i;
                }
            for (int i = 0; i < s.count; ++i) J[i] += part * (s.J[i] - J[i]);
            if (leaving < 0) break;
            set[leaving] = false;
            J[leaving] = 0.0;
        }
    }
    for (int i = 0; i < s.count; ++i) s.J[i] = J[i];
    return error_of(s) <= 2.0 * tolerance;
}

// Rows that nearly say the same may send the sets round in circles: then by the proximal point method, (M + D) J' = b + D J
// with a small share D of the diagonal, which tells them apart. Where bodies are squeezed J grows by b/D a step, far beyond
// what parts others. False if there is no solution within the tolerance, or what roundoff makes of it.
inline bool solve_normals(NormalSystem& s, double tolerance) {
    if (solve_by_sets(s, tolerance)) return true;
    constexpr double share = 3e-12, roundoff = 3e-15, most = 4e9;
    constexpr int most_steps = 20;
    NormalSystem apart = s;
    double largest = 0.0;
    for (int i = 0; i < s.count; ++i) {
        apart.M[i][i] *= 1.0 + share;
        largest = max(largest, s.b[i]);
        s.J[i] = 0.0;
    }
    for (int step = 0; step < most_steps; ++step) {
        for (int i = 0; i < s.count; ++i) apart.b[i] = s.b[i] + share * s.M[i][i] * s.J[i];
        solve_by_sets(apart, tolerance);
        double size = 0.0;
        for (int i = 0; i < s.count; ++i) {
            s.J[i] = apart.J[i];
            size = max(size, s.M[i][i] * s.J[i]);
        }
        if (size > most * largest) return false;
        if (error_of(s) <= max(2.0 * tolerance, roundoff * size)) return true;
    }
    return false;
}

GRIT_KERNEL_END
