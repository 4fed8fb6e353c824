// SPDX-License-Identifier: BSD-3-Clause
// A binary tree of boxes: whose boxes meet a given one, in a time that hardly depends on how many there are.
#pragma once

#include <algorithm>
#include <limits>

#include "contact/surface/arena.hpp"
#include "support/vector.hpp"

namespace grit::surface {

template <int C> struct Box {
    Vector<double, C> low, high;

    static Box empty() {
        Box box;
        for (int c = 0; c < C; ++c) {
            box.low[c] = std::numeric_limits<double>::infinity();
            box.high[c] = -box.low[c];
        }
        return box;
    }
    void include(const Vector<double, C>& x) {
        for (int c = 0; c < C; ++c) {
            low[c] = std::min(low[c], x[c]);
            high[c] = std::max(high[c], x[c]);
        }
    }
    Box grown(double by) const {
        Box box = *this;
        for (int c = 0; c < C; ++c) {
            box.low[c] -= by;
            box.high[c] += by;
        }
        return box;
    }
    bool meets(const Box& other) const {
        bool yes = true;
        for (int c = 0; c < C; ++c) yes = yes && low[c] <= other.high[c] && other.low[c] <= high[c];
        return yes;
    }
};

template <int C> class BoxTree {
  public:
    // boxes outlive the tree.
    BoxTree(Arena& arena, const Box<C>* of_items, std::ptrdiff_t n) : boxes(of_items), items(n) {
        while ((per_leaf << levels) < n) ++levels;
        order = arena.take<std::ptrdiff_t>(n);
        nodes = arena.take<Box<C>>(std::ptrdiff_t{2} << levels);
        if (arena.is_overrun()) return;
        for (std::ptrdiff_t i = 0; i < n; ++i) order[i] = i;
        if (n > 0) build(1, 0, n, levels);
    }
    // take(item) for all whose boxes meet this one, in no particular order.
    template <class Take> void each(const Box<C>& box, const Take& take) const {
        any(box, [&](std::ptrdiff_t item) {
            take(item);
            return false;
        });
    }
    // ... until is(item) for one of them.
    template <class Is> bool any(const Box<C>& box, const Is& is) const {
        return items > 0 && any(box, 1, 0, items, levels, is);
    }

  private:
    static constexpr std::ptrdiff_t per_leaf = 4;

    void build(std::ptrdiff_t node, std::ptrdiff_t begin, std::ptrdiff_t end, int level) {
        Box<C> all = Box<C>::empty();
        for (std::ptrdiff_t i = begin; i < end; ++i) {
            all.include(boxes[order[i]].low);
            all.include(boxes[order[i]].high);
        }
        nodes[node] = all;
        if (level == 0) return;
        int longest = 0;
        for (int c = 1; c < C; ++c)
            if (all.high[c] - all.low[c] > all.high[longest] - all.low[longest]) longest = c;
        const auto centre = [&](std::ptrdiff_t i) {
            return boxes[i].low[longest] + boxes[i].high[longest];
        };
        const std::ptrdiff_t middle = begin + (end - begin) / 2;
        std::nth_element(order + begin, order + middle, order + end,
                         [&](std::ptrdiff_t i, std::ptrdiff_t j) {
                             return centre(i) != centre(j) ? centre(i) < centre(j) : i < j;
                         });
        build(2 * node, begin, middle, level - 1);
        build(2 * node + 1, middle, end, level - 1);
    }
    template <class Is>
    bool any(const Box<C>& box, std::ptrdiff_t node, std::ptrdiff_t begin, std::ptrdiff_t end,
             int level, const Is& is) const {
        if (!nodes[node].meets(box)) return false;
        if (level == 0) {
            for (std::ptrdiff_t i = begin; i < end; ++i)
                if (boxes[order[i]].meets(box) && is(order[i])) return true;
            return false;
        }
        const std::ptrdiff_t middle = begin + (end - begin) / 2;
        return any(box, 2 * node, begin, middle, level - 1, is) ||
               any(box, 2 * node + 1, middle, end, level - 1, is);
    }

    const Box<C>* boxes;
    std::ptrdiff_t items;
    std::ptrdiff_t* order = nullptr;
    Box<C>* nodes = nullptr;  // children of k: 2 k and 2 k + 1
    int levels = 0;
};

}  // namespace grit::surface
