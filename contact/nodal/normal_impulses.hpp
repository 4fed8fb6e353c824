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

// Lawson & Hanson's active-set method. False if there is no solution within the tolerance [velocity].
inline bool solve_normals(NormalSystem& s, double tolerance) {
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
    double largest = 0.0;
    for (int i = 0; i < s.count; ++i) s.J[i] = J[i];
    for (int i = 0; i < s.count; ++i)
        largest = max(largest, set[i] ? fabs(s.excess(i)) : s.excess(i));
    return largest <= 2.0 * tolerance;
}

GRIT_KERNEL_END
