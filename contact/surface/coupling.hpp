// SPDX-License-Identifier: BSD-3-Clause
// Sweeps over the rows of all pairs of a call: those that have nodes in common are swept together until none of them
// changes, for what bears in one is the load of another.
#pragma once

#include <algorithm>
#include <cmath>

#include "contact/surface/ascending.hpp"
#include "contact/surface/system.hpp"

namespace grit::surface {

// A pair whose rows are to be swept.
template <int C> struct Sweeping {
    System<C>* rows;
    double mu;
    int limit;
    double tolerance;
};

struct Swept {
    std::ptrdiff_t sweeps;
    double residual, largest_approach;
};

template <int C> class Coupling {
  public:
    Coupling(Arena& memory, std::ptrdiff_t pairs) : arena(memory), n(pairs) {}

    // False where the workspace is too small. Rows are built, and outlive this.
    bool find(const Sweeping<C>* of_pairs) {
        given = of_pairs;
        outcome = arena.take<Swept>(n);
        enough = arena.take<double>(n);
        leader = arena.take<std::ptrdiff_t>(n);
        order = arena.take<std::ptrdiff_t>(n);
        first_link = arena.take<std::ptrdiff_t>(n + 1);
        if (arena.is_overrun()) return false;
        for (std::ptrdiff_t p = 0; p < n; ++p) leader[p] = p;
        std::fill_n(first_link, n + 1, 0);
        if (n > 1 && !find_common_nodes()) return false;
        for (std::ptrdiff_t p = 0; p < n; ++p) order[p] = p;
        sort_ascending(order, order + n, [this](std::ptrdiff_t x, std::ptrdiff_t y) {
            return leader[x] != leader[y] ? leader[x] < leader[y] : x < y;
        });
        return true;
    }
    // Velocities of all pairs, in place: those of nodes in common are the same in all of them.
    void sweep() {
        for (std::ptrdiff_t from = 0, to = 0; from < n; from = to) {
            while (to < n && leader[order[to]] == leader[order[from]]) ++to;
            sweep_group({from, to});
        }
    }
    const Swept& of(std::ptrdiff_t pair) const { return outcome[pair]; }

  private:
    // A node of one pair; place: in its system, common: among those that several have.
    struct Link {
        int body;
        std::ptrdiff_t number, pair, place, common;
        bool is_same_node(const Link& o) const { return body == o.body && number == o.number; }
    };

    bool find_common_nodes() {
        Growing<Link> found(arena);
        for (std::ptrdiff_t p = 0; p < n; ++p)
            given[p].rows->each_common_node(
                [&](int body, std::ptrdiff_t number, std::ptrdiff_t place) {
                    found.add({body, number, p, place, -1});
                });
        const std::ptrdiff_t count = found.size();
        link = found.close();
        if (arena.is_overrun()) return false;
        sort_ascending(link, link + count, [](const Link& x, const Link& y) {
            if (x.body != y.body) return x.body < y.body;
            return x.number != y.number ? x.number < y.number : x.pair < y.pair;
        });
        std::ptrdiff_t kept = 0, n_common = 0;
        for (std::ptrdiff_t i = 0, end = 0; i < count; i = end) {
            while (end < count && link[end].is_same_node(link[i])) ++end;
            if (end == i + 1) continue;
            for (std::ptrdiff_t k = i; k < end; ++k) {
                join(link[i].pair, link[k].pair);
                link[kept] = link[k];
                link[kept++].common = n_common;
            }
            ++n_common;
        }
        sort_ascending(link, link + kept, [](const Link& x, const Link& y) {
            return x.pair != y.pair ? x.pair < y.pair : x.common < y.common;
        });
        for (std::ptrdiff_t i = 0; i < kept; ++i) ++first_link[link[i].pair + 1];
        for (std::ptrdiff_t p = 0; p < n; ++p) first_link[p + 1] += first_link[p];
        for (std::ptrdiff_t p = 0; p < n; ++p) leader[p] = leader_of(p);
        common = arena.take<Motion<C>>(n_common);
        if (arena.is_overrun()) return false;
        for (std::ptrdiff_t p = n; p-- > 0;) give(p);  // the first pair's are those of all
        return true;
    }
    std::ptrdiff_t leader_of(std::ptrdiff_t pair) const {
        while (leader[pair] != pair) pair = leader[pair];
        return pair;
    }
    void join(std::ptrdiff_t pair, std::ptrdiff_t other) {
        pair = leader_of(pair), other = leader_of(other);
        leader[std::max(pair, other)] = std::min(pair, other);
    }

    void take(std::ptrdiff_t pair) {
        for (std::ptrdiff_t i = first_link[pair]; i < first_link[pair + 1]; ++i)
            given[pair].rows->set_motion(link[i].place, common[link[i].common]);
    }
    void give(std::ptrdiff_t pair) {
        for (std::ptrdiff_t i = first_link[pair]; i < first_link[pair + 1]; ++i)
            common[link[i].common] = given[pair].rows->motion(link[i].place);
    }
    struct Group {
        std::ptrdiff_t from, to;  // in order
    };
    template <class Do> void each_of(const Group& group, bool forth, const Do& act) {
        for (std::ptrdiff_t i = group.from; i < group.to; ++i)
            act(order[forth ? i : group.from + group.to - 1 - i]);
    }

    void sweep_group(const Group& group) {
        double largest = 0.0;  // change that is wanted
        int limit = 0;
        bool rubs = false;
        each_of(group, true, [&](std::ptrdiff_t pair) {
            take(pair);
            const auto start = given[pair].rows->begin();
            outcome[pair] = {0, 0.0, start.largest_approach};
            largest = std::max(largest, start.largest_change);
            limit = std::max(limit, given[pair].limit);
            rubs = rubs || given[pair].mu > 0.0;
        });
        if (largest == 0.0) return;
        each_of(group, true, [&](std::ptrdiff_t pair) {
            enough[pair] =
                std::max(given[pair].tolerance * largest, given[pair].rows->smallest_change());
        });
        bool is_done = false;
        for (std::ptrdiff_t sweeps = 0; sweeps < limit && !is_done; ++sweeps) {
            is_done = true;
            const bool forth = sweeps % 2 == 0;
            each_of(group, forth, [&](std::ptrdiff_t pair) {
                take(pair);
                outcome[pair].residual = given[pair].rows->sweep(given[pair].mu, forth);
                outcome[pair].sweeps = sweeps + 1;
                give(pair);
                is_done = is_done && !(outcome[pair].residual > enough[pair]);
            });
        }
        if (rubs) keep_energy(group);
        each_of(group, true, [&](std::ptrdiff_t pair) { take(pair); });
    }
    // Impulses that friction's unfinished sweeps made too large: scaled until no kinetic energy is gained but what layers
    // give at these.
    void keep_energy(const Group& group) {
        Work sum;
        each_of(group, true, [&](std::ptrdiff_t pair) {
            take(pair);
            given[pair].rows->add_work(sum);
        });
        const double layers = std::max(sum.given, 0.0);
        if (!(sum.twice_kinetic > 2.0 * (sum.work + layers)) || !(sum.twice_kinetic > 0.0)) return;
        // work s - twice_kinetic s^2 / 2 + layers = 0
        const double root = std::sqrt(sum.work * sum.work + 2.0 * sum.twice_kinetic * layers);
        const double share = std::max((sum.work + root) / sum.twice_kinetic, 0.0);
        each_of(group, true, [&](std::ptrdiff_t pair) {
            take(pair);
            given[pair].rows->scale(share);
            give(pair);
        });
    }

    Arena& arena;
    std::ptrdiff_t n;
    const Sweeping<C>* given = nullptr;
    Swept* outcome = nullptr;
    double* enough = nullptr;              // change of a velocity that ends sweeps, of a pair
    std::ptrdiff_t* leader = nullptr;      // of the pairs that hang together, the first
    std::ptrdiff_t* order = nullptr;       // of pairs, by these
    std::ptrdiff_t* first_link = nullptr;  // of a pair
    Link* link = nullptr;
    Motion<C>* common = nullptr;
};

}  // namespace grit::surface
