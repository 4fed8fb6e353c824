// SPDX-License-Identifier: BSD-3-Clause
// What lies between two bodies at a node, read and checked.
#pragma once

#include <limits>

#include "contact/nodal/node_checks.hpp"
#include "contact/nodal/node_views.hpp"

GRIT_KERNEL_BEGIN

// 1/x of a component of a view: divided once where all nodes share it.
template <class Real>
GRIT_INLINE Real inverse_of(const Real& x, const grit_view& view, int component) {
    if (view.point_stride == 0) {
        const double shared = view.base[component * view.component_stride];
        return Real(1.0 / max(shared, 1.0 / largest_number));
    }
    return Real(1.0) / max(x, Real(1.0 / largest_number));
}

// The cell along n, from the view of cell sizes or the edges of the cell, (C4).
template <class Real, int C>
GRIT_INLINE Cell<Real>
cell_along(const grit_view& cell_size, const grit_view& spacing, const Vector<Real, C>& n,
           const NodeIndices<lanes_of<Real>>& indices, const auto& only, MaskOf<Real>& good) {
    if (cell_size.base) {
        const Real d = only(load<Real>(cell_size, 0, indices));
        good = good & good_length(d);
        return {d, inverse_of(d, cell_size, 0)};
    }
    Vector<Real, C> cells;
    for (int i = 0; i < C; ++i) {
        const Real edge = only(load<Real>(spacing, i, indices));
        good = good & good_length(edge);
        cells[i] = n[i] * inverse_of(edge, spacing, i);
    }
    const Real inverse = max(sqrt(fused_dot(cells, cells)), Real(1.0 / largest_number));
    return {Real(1.0) / inverse, inverse};
}

template <class Real, int C> struct ReadApproach {
    Approach<Real, C> x;  // w is left to the caller
    MaskOf<Real> good, no_normal;
};

// views: grit_contact_nodes or grit_contact_pair; geo: law.geo, a constant to the caller who knows it
// (10 % of a node's time); only(): what may be looked at.
template <class Real, int C, class Views, class Only>
GRIT_INLINE ReadApproach<Real, C> read_approach(const Views& views, const Law& law, bool geo,
                                                const NodeIndices<lanes_of<Real>>& indices,
                                                const Only& only) {
    using Mask = MaskOf<Real>;
    ReadApproach<Real, C> r;
    r.x.n = only(load_vector<C, Real>(views.normal, indices));
    r.no_normal = zero_normal(r.x.n) & Mask(law.allow_zero_normal);
    r.good = good_normal(r.x.n) | r.no_normal;
    r.x.gap = Real(-std::numeric_limits<double>::infinity());
    if (views.gap.base) {
        r.x.gap = only(load<Real>(views.gap, 0, indices));
        r.good = r.good & good_signed_length(r.x.gap);
    }
    if (geo) {
        r.x.s = only(load<Real>(views.distance, 0, indices));
        Mask good_d(true);
        r.x.cell = cell_along(views.cell_size, views.spacing, r.x.n, indices, only, good_d);
        r.good = r.good & good_signed_length(r.x.s) & (good_d | r.no_normal);
    }
    if (law.adheres || law.springs) {
        r.x.area = only(load<Real>(views.contact_area, 0, indices));
        r.good = r.good & good_area(r.x.area);
    }
    r.x.has_pores = views.pore_impulse.base != nullptr;
    if (r.x.has_pores) {
        r.x.pore_impulse = only(load<Real>(views.pore_impulse, 0, indices));
        r.good = r.good & good_impulse(r.x.pore_impulse);
    }
    return r;
}

GRIT_KERNEL_END
