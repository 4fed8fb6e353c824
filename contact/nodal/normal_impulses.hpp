// SPDX-License-Identifier: BSD-3-Clause
// The normal impulses of several pairs at one node together: b - M u - yield u <= 0, with equality where u > 0, u >= 0; b are
// approach velocities, u = J / m_r, M u what the impulses take from the approaches, yield u what (C5) or (C9) leave.
// Solved pair by pair the impulses of a light body between heavy ones need as many sweeps as the masses differ.
//
// That is the point nearest to the velocities, each times the root of its mass, in which no pair approaches faster than it may.
// It is found by the dual method of Goldfarb & Idnani (1983), with an orthonormal basis of what the pressing pairs do: M itself
// would hold the heavier of two bodies in the last digits of the lighter one's entry.
#pragma once

#include "contact/nodal/request.hpp"
#include "support/number.hpp"
#include "support/pack.hpp"
#include "support/vector.hpp"

GRIT_KERNEL_BEGIN

template <int C> class NormalSystem {
  public:
    void begin() { pairs = pressing = entries = 0; }
    // The first of its entries.
    int add_body() {
        const int first_entry = entries;
        entries += C;
        return first_entry;
    }
    // A pair of bodies, by their first entries, its normal and the roundoff of its approach [velocity]. A body's velocity, times
    // the root of its mass, changes by -+ sqrt(share) n per J / sqrt(m_r).
    void add(const int bodies[2], const double share[2], const Vector<double, C>& n, double m_r,
             double yield, double of_approach) {
        double* direction = directions[pairs];
        for (double& e : directions[pairs]) e = 0.0;
        for (int side = 0; side < 2; ++side) {
            const double size = side == 0 ? sqrt(share[0]) : -sqrt(share[1]);
            first[pairs][side] = bodies[side];
            for (int c = 0; c < C; ++c) direction[bodies[side] + c] = size * n[c];
        }
        spring[pairs] = -1;
        if (yield > 0.0) {
            spring[pairs] = entries++;
            direction[spring[pairs]] = sqrt(yield);
        }
        is_pressing[pairs] = false;
        root[pairs] = sqrt(m_r);
        roundoff[pairs++] = of_approach;
    }
    int count() const { return pairs; }

    // The impulses u for approaches b. False if there are none that leave no more than the tolerance [velocity]. Where a
    // solution must be, as no two bodies are rigid that move differently, what is left for want of digits is left; so is
    // everywhere what is roundoff alone.
    bool solve(const double* b, double tolerance, bool must_be) {
        approach = b;
        begin_again();
        bool aside[most_pairs] = {};
        int steps = 0;
        for (int p = worst(tolerance, aside); p >= 0 && steps < most_steps;
             p = worst(tolerance, aside)) {
            Parts of;
            split(p, of);
            ++steps;
            bool taken = false;
            if (!is_roundoff(p, of)) {
                Set before;
                if (must_be) before = set();
                taken = take_in(p, of, steps);
                if (!taken && !must_be) return false;
                if (!taken) restore(before);
            }
            if (taken && presses(p)) {
                for (bool& each : aside) each = false;
            } else {
                aside[p] = true;
            }
        }
        explain();
        approach = nullptr;
        return true;
    }
    // What may be left of a pair's approach.
    double allowed(int p, double tolerance) const { return max(tolerance, roundoff[p]); }
    // Of a pair, J / m_r.
    double u(int p) const { return impulse[p] / root[p]; }
    // What u has to become more so that the pairs that press take what is left of their approaches [velocity].
    void add_for(const double* of_approach, double* u_more) const {
        double y[most_pairs], more[most_pairs] = {};
        answer(of_approach, y, more);
        for (int p = 0; p < pairs; ++p) u_more[p] = more[p] / root[p];
    }
    // Of an entry of velocities times root of mass, what all impulses change, and the length of all changes.
    double change_of(int entry) const { return change[entry]; }
    double change_in_all() const { return sqrt(dot(change, change)); }
    bool presses(int p) const { return is_pressing[p]; }

  private:
    using Lanes = typename VectorTypes<native_lanes>::RealInPlace;
    static constexpr int most_entries = (C * most_bodies + most_pairs + 7) / 8 * 8;
    static constexpr std::size_t alignment = 64;
    static constexpr double epsilon = 2.2e-16;
    static constexpr int most_steps = 16 * most_pairs;
    // Between a direction and those that press: what is less is roundoff.
    static constexpr double least_sine = 1e-12;
    // Of the terms of an impulse, likewise.
    static constexpr double least_part = 1e-12;

    struct Set {
        int pressing;
        int pair_of[most_pairs];
    };
    Set set() const {
        Set now;
        now.pressing = pressing;
        for (int c = 0; c < pressing; ++c) now.pair_of[c] = pair_of[c];
        return now;
    }
    void restore(const Set& before) {
        begin_again();
        for (int c = 0; c < before.pressing; ++c) append(before.pair_of[c]);
        settle();
    }
    void begin_again() {
        pressing = 0;
        for (int p = 0; p < pairs; ++p) is_pressing[p] = false;
        clear();
    }
    void clear() {
        for (int p = 0; p < pairs; ++p) impulse[p] = 0.0;
        for (int k = 0; k < packs(); ++k) lanes(change)[k] = Lanes{};
    }

    // In lanes; entries that are not used are zeros.
    int packs() const { return (entries + native_lanes - 1) / native_lanes; }
    static const Lanes* lanes(const double* a) { return reinterpret_cast<const Lanes*>(a); }
    static Lanes* lanes(double* a) { return reinterpret_cast<Lanes*>(a); }
    double dot(const double* a, const double* b) const {
        Pack<native_lanes> sum(0.0);
        for (int k = 0; k < packs(); ++k) sum = sum + Pack<native_lanes>(lanes(a)[k] * lanes(b)[k]);
        double all = sum[0];
        for (int lane = 1; lane < native_lanes; ++lane) all += sum[lane];
        return all;
    }
    void copy(const double* from, double* to) const {
        for (int k = 0; k < packs(); ++k) lanes(to)[k] = lanes(from)[k];
    }
    void add_times(double times, const double* x, double* to) const {
        for (int k = 0; k < packs(); ++k) lanes(to)[k] += times * lanes(x)[k];
    }
    double excess(int p) const {
        double sum = 0.0;
        for (const int begin : first[p])
            for (int c = 0; c < C; ++c) sum = fma(directions[p][begin + c], change[begin + c], sum);
        if (spring[p] >= 0) sum = fma(directions[p][spring[p]], change[spring[p]], sum);
        return approach[p] + sum / root[p];
    }

    // The pair with the largest excess of those that are not set aside, -1: none.
    int worst(double tolerance, const bool* aside) const {
        int worst = -1;
        double largest = 0.0;
        for (int p = 0; p < pairs; ++p) {
            if (aside[p] || presses(p)) continue;
            if (const double of_pair = excess(p); of_pair > max(largest, allowed(p, tolerance))) {
                largest = of_pair;
                worst = p;
            }
        }
        return worst;
    }

    // What a direction has of those of the basis, and beside them; where little is left of it twice, as once leaves roundoff of
    // the basis.
    struct Parts {
        alignas(alignment) double beside[most_entries];
        double share[most_pairs];
        double length2;  // of beside
        double doubt;    // what of beside may be roundoff [length]
        bool independent;
    };
    void split(int p, Parts& of) const {
        copy(directions[p], of.beside);
        for (int c = 0; c < pressing; ++c) of.share[c] = 0.0;
        const double all = dot(of.beside, of.beside);
        of.length2 = all;
        for (int time = 0; time < 2 && (time == 0 || of.length2 < 0.25 * all); ++time) {
            for (int c = 0; c < pressing; ++c) {
                const double more = dot(basis[c], of.beside);
                of.share[c] += more;
                add_times(-more, basis[c], of.beside);
            }
            of.length2 = dot(of.beside, of.beside);
        }
        of.independent = of.length2 > least_sine * least_sine * all;
        of.doubt = epsilon * sqrt(all);
        for (int c = 0; c < pressing; ++c) of.doubt += fabs(of.share[c]) * doubt[c];
    }
    void append(int p, const Parts& of) {
        const double length = sqrt(of.length2);
        for (int c = 0; c < pressing; ++c) factor[pressing][c] = of.share[c];
        factor[pressing][pressing] = length;
        doubt[pressing] = of.doubt / length;
        for (int k = 0; k < packs(); ++k) lanes(basis[pressing])[k] = lanes(of.beside)[k] / length;
        is_pressing[p] = true;
        pair_of[pressing++] = p;
    }
    // Once more; it may have been roundoff.
    void append(int p) {
        Parts of;
        split(p, of);
        if (of.length2 > 0.0) append(p, of);
        else impulse[p] = 0.0;
    }
    void remove(int place) {
        const int all = pressing;
        for (int c = place; c < all; ++c) is_pressing[pair_of[c]] = false;
        pressing = place;
        for (int c = place + 1; c < all; ++c) append(pair_of[c]);
    }
    // x of R x = y, R the factors' columns.
    void solve_upper(double* x) const {
        for (int c = pressing - 1; c >= 0; --c) {
            for (int k = c + 1; k < pressing; ++k) x[c] -= factor[k][c] * x[k];
            x[c] /= factor[c][c];
        }
    }
    // What the terms of x are, all together.
    void find_sizes(const double* y, double* size) const {
        for (int c = pressing - 1; c >= 0; --c) {
            size[c] = fabs(y[c]);
            for (int k = c + 1; k < pressing; ++k) size[c] += fabs(factor[k][c]) * size[k];
            size[c] /= factor[c][c];
        }
    }
    // y of R^T y = approaches, and the impulses R^-1 y of the pairs that press.
    void answer(const double* of_approach, double* y, double* impulse_of_pair) const {
        double x[most_pairs];
        for (int c = 0; c < pressing; ++c) {
            y[c] = root[pair_of[c]] * of_approach[pair_of[c]];
            for (int k = 0; k < c; ++k) y[c] -= factor[c][k] * y[k];
            x[c] = y[c] /= factor[c][c];
        }
        solve_upper(x);
        for (int c = 0; c < pressing; ++c) impulse_of_pair[pair_of[c]] = x[c];
    }
    // Impulses and change of the pairs that press, from nothing but these. Roundoff may have let one in that pulls.
    void settle() {
        double y[most_pairs];
        for (int pulling = 0; pulling >= 0;) {
            clear();
            answer(approach, y, impulse);
            pulling = -1;
            for (int c = 0; c < pressing; ++c)
                if (impulse[pair_of[c]] < (pulling < 0 ? 0.0 : impulse[pair_of[pulling]]))
                    pulling = c;
            if (pulling >= 0) remove(pulling);
        }
        for (int c = 0; c < pressing; ++c) add_times(-y[c], basis[c], change);
    }

    // Impulses that do what is changed, as far as they have digits.
    void explain() {
        alignas(alignment) double off[most_entries];
        double more[most_pairs];
        copy(change, off);
        for (int c = 0; c < pressing; ++c)
            add_times(impulse[pair_of[c]], directions[pair_of[c]], off);
        for (int c = 0; c < pressing; ++c) more[c] = -dot(basis[c], off);
        solve_upper(more);
        for (int c = 0; c < pressing; ++c)
            if (impulse[pair_of[c]] + more[c] < 0.0) return;
        for (int c = 0; c < pressing; ++c) impulse[pair_of[c]] += more[c];
    }

    // Would nothing but roundoff let the pair press beside the others: of what is left of it, and of its approach?
    bool is_roundoff(int p, const Parts& of) const {
        if (of.length2 > of.doubt * of.doubt) return false;
        double size[most_pairs];
        find_sizes(of.share, size);
        double rough = root[p] * roundoff[p];
        for (int c = 0; c < pressing; ++c)
            rough += size[c] * root[pair_of[c]] * roundoff[pair_of[c]];
        return root[p] * excess(p) <= rough;
    }
    // Lets a pair press, and those be that pull then. False if the impulses grow for ever, or steps do.
    bool take_in(int p, Parts& of, int& steps) {
        for (; steps < most_steps; ++steps) {
            double gives_way[most_pairs], size[most_pairs];  // impulses by that of p
            for (int c = 0; c < pressing; ++c) gives_way[c] = of.share[c];
            solve_upper(gives_way);
            find_sizes(of.share, size);
            double least = infinity;
            int leaving = -1;
            for (int c = 0; c < pressing; ++c)
                if (gives_way[c] > least_part * size[c] &&
                    impulse[pair_of[c]] < least * gives_way[c]) {
                    least = impulse[pair_of[c]] / gives_way[c];
                    leaving = c;
                }
            if (leaving < 0 && !of.independent) return false;
            const double full =
                of.independent ? max(root[p] * excess(p), 0.0) / of.length2 : infinity;
            if (full <= least) {
                append(p, of);
                settle();
                ++steps;
                return true;
            }
            for (int c = 0; c < pressing; ++c) impulse[pair_of[c]] -= least * gives_way[c];
            impulse[p] += least;
            if (of.independent) add_times(-least, of.beside, change);
            impulse[pair_of[leaving]] = 0.0;
            remove(leaving);
            split(p, of);
        }
        return false;
    }

    static constexpr double infinity = __builtin_huge_val();
    int pairs, entries;        // in the order in which bodies and springs come
    int first[most_pairs][2];  // entries of A and B
    int spring[most_pairs];    // entry, -1: none
    alignas(alignment) double directions[most_pairs][most_entries];
    double root[most_pairs];           // of m_r
    double roundoff[most_pairs];       // of approaches
    const double* approach = nullptr;  // of pairs [velocity]
    double impulse[most_pairs];        // J / sqrt(m_r)
    // Of velocities times root of mass; of what springs yield.
    alignas(alignment) double change[most_entries];
    // Those that press: directions = basis R.
    int pressing;
    bool is_pressing[most_pairs];
    int pair_of[most_pairs];
    alignas(alignment) double basis[most_pairs][most_entries];
    double doubt[most_pairs];               // of basis, what may be roundoff
    double factor[most_pairs][most_pairs];  // a column of R after the other
};

GRIT_KERNEL_END
