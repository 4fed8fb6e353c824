// SPDX-License-Identifier: BSD-3-Clause
// The cavity of cavity_in_sand.hpp in undrained sand, and what material points say of it.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/cavity_in_sand.hpp"

namespace mpm_test {

// Undrained, along the radius alone and without a grid: the pore pressure of each ring of sand says its volume, the volumes
// say where all rings are and what strains they have, the sand its effective stresses along them, and the balance of
// forces from the far side inwards the total ones, whose rest is the pore pressure; again until it is the one it began with.
// The balance has the inertia of v ~ 1/r.
class UndrainedCavity : public CavityProblem {
  public:
    struct State {
        double total, effective, pore;  // radial, compression positive [Pa]
    };

    // bulk_modulus: of the water [Pa]; infinite: r^2 - a^2 stays for each ring.
    UndrainedCavity(const CavityProblem& of, double bulk_modulus, int rings = 200)
        : CavityProblem(of), K_w(bulk_modulus) {
        const auto n = static_cast<std::size_t>(rings);
        for (std::size_t i = 0; i <= n; ++i)
            edges.push_back(a * std::pow(outer / a, static_cast<double>(i) / rings));
        Particles points(sand.own_columns());
        for (std::size_t i = 0; i < n; ++i) {
            points.add({std::sqrt(0.5 * (square(edges[i]) + square(edges[i + 1]))), 0.5, 0.01, 0.5,
                        density()},
                       true);
            start(points.view(), static_cast<std::ptrdiff_t>(i));
        }
        std::vector<double> r = edges, pore(n);
        const double step = 1e-4;  // of the wall [m]
        for (double u = 0.0; u < displacement(end);) {
            times.push_back(time_of(u));
            rings_at.push_back(note(points, r, pore));
            u += step;
            advance(points, r, pore, u);
        }
    }

    // Of the ring that was at r0, or of the wall, on the way out.
    State at(double r0, double t) const {
        const std::size_t i = before(times, t);
        const double x = (t - times[i]) / (times[i + 1] - times[i]);
        const State from = across(rings_at[i], r0), to = across(rings_at[i + 1], r0);
        return {(1.0 - x) * from.total + x * to.total,
                (1.0 - x) * from.effective + x * to.effective, (1.0 - x) * from.pore + x * to.pore};
    }

  private:
    struct Rings {
        std::vector<double> total, effective;  // at edges; of rings [Pa]
    };
    static double square(double x) { return x * x; }
    static std::size_t before(const std::vector<double>& of, double x) {
        const auto at = std::upper_bound(of.begin(), of.end(), x) - of.begin();
        return static_cast<std::size_t>(
            std::clamp<std::ptrdiff_t>(at, 1, static_cast<std::ptrdiff_t>(of.size()) - 1) - 1);
    }
    double time_of(double u) const {
        const double ramped = 0.5 * speed * ramp;
        return u < ramped ? std::sqrt(2.0 * u * ramp / speed) : ramp + (u - ramped) / speed;
    }
    // Total stress at edges.
    std::vector<double> balance(const Particles& points, const std::vector<double>& r) const {
        std::vector<double> out(r.size(), far_pressure());
        const double t = time_of(r[0] - a), flow = r[0] * velocity(t);
        for (std::size_t i = r.size() - 1; i-- > 0;) {
            const auto p = static_cast<std::ptrdiff_t>(i);
            const double ln = std::log(r[i + 1] / r[i]);
            const double inertia =
                density() * (flow_rate(t) * ln -
                             0.5 * square(flow) * (1.0 / square(r[i]) - 1.0 / square(r[i + 1])));
            out[i] =
                out[i + 1] + (points(column::S_tt, p) - points(column::S_rr, p)) * ln + inertia;
        }
        return out;
    }
    // The wall moves to a + u.
    void advance(Particles& points, std::vector<double>& r, std::vector<double>& pore,
                 double u) const {
        const Particles at_first = points;
        const std::vector<double> r_first = r;
        for (int iteration = 0; iteration < 12; ++iteration) {
            r[0] = a + u;
            for (std::size_t i = 0; i + 1 < r.size(); ++i) {
                const double e = void_ratio * std::exp(-pore[i] / K_w);
                const double J = (1.0 + e) / (1.0 + void_ratio);
                r[i + 1] = std::sqrt(square(r[i]) + J * (square(edges[i + 1]) - square(edges[i])));
            }
            points = at_first;
            for (std::size_t i = 0; i + 1 < r.size(); ++i) {
                const auto p = static_cast<std::ptrdiff_t>(i);
                const double volume = std::log((square(r[i + 1]) - square(r[i])) /
                                               (square(r_first[i + 1]) - square(r_first[i])));
                const double hoop = 0.5 * std::log((square(r[i]) + square(r[i + 1])) /
                                                   (square(r_first[i]) + square(r_first[i + 1])));
                Increments d{};
                d.strain[0][0] = volume - hoop;
                d.strain[2][0] = hoop;
                for (const int k : {0, 4, 8}) d.rotation[k][0] = 1.0;
                sand.update({points.view(), p, p + 1}, d);
            }
            const std::vector<double> total = balance(points, r);
            for (std::size_t i = 0; i < pore.size(); ++i)
                pore[i] = 0.5 * (total[i] + total[i + 1]) +
                          points(column::S_rr, static_cast<std::ptrdiff_t>(i));
            if (!std::isfinite(K_w)) return;
        }
    }
    Rings note(const Particles& points, const std::vector<double>& r,
               const std::vector<double>& pore) const {
        Rings out{balance(points, r), {}};
        for (std::size_t i = 0; i < pore.size(); ++i)
            out.effective.push_back(-points(column::S_rr, static_cast<std::ptrdiff_t>(i)));
        return out;
    }
    State across(const Rings& rings, double r0) const {
        const std::size_t i = before(edges, r0);
        const double x = (r0 - edges[i]) / (edges[i + 1] - edges[i]);
        // Rings are in the middle of their edges.
        const std::size_t last = rings.effective.size() - 2;
        const std::size_t j = x < 0.5 ? std::max<std::size_t>(i, 1) - 1 : std::min(i, last);
        const double y = (r0 - 0.5 * (edges[j] + edges[j + 1])) / (0.5 * (edges[j + 2] - edges[j]));
        State out{(1.0 - x) * rings.total[i] + x * rings.total[i + 1],
                  (1.0 - y) * rings.effective[j] + y * rings.effective[j + 1], 0.0};
        out.pore = out.total - out.effective;
        return out;
    }

    double K_w;
    mutable Sand sand{lausitz(), options_with_tolerance(1e-5)};
    std::vector<double> edges;  // at the start [m]
    std::vector<double> times;
    std::vector<Rings> rings_at;
};

// Until 75 mm, in means over 10 ms: waves of the undrained sand pass twice in it.
inline CavityByPoints undrained_cavity(double void_ratio, int cells) {
    CavityByPoints out;
    out.void_ratio = void_ratio;
    out.cells = cells;
    out.water_density = 1000.0;
    out.bulk_modulus = 2.2e9;
    out.ramp = 0.05;
    out.turn_at = 0.08;
    out.end = 0.41;
    out.window = 0.01;
    out.cell_mean = true;
    return out;
}

// Of the wall's pressure from 5 mm on, or of the way of the face where a pressure is given; at 75 mm of the innermost
// particle, and the largest of those up to two radii.
struct CavityErrors {
    double wall_most = 0.0, wall_mean = 0.0;
    double effective = 0.0, pore = 0.0, effective_most = 0.0, pore_most = 0.0;
    double wall, exact_wall;  // at the end [Pa] or [m]
    double alternating;       // of pore pressures of cells [Pa]
    CavityByPoints::Row innermost;
    UndrainedCavity::State exact_innermost;
};

inline CavityErrors compare(const CavityByPoints& points, const UndrainedCavity& exact) {
    const CavityByPoints::Result seen = points.run();
    CavityErrors out{};
    double sum = 0.0, exact_sum = 0.0;
    for (std::size_t i = 0; i < seen.curve.time.size(); ++i) {
        const double t = seen.curve.time[i], u = points.displacement(t);
        if (u < 0.005 || u > 0.075) continue;
        out.wall = points.pressure ? seen.curve.displacement[i] : seen.curve.pressure[i];
        out.exact_wall = points.pressure ? u : exact.at(CavityProblem::a, t).total;
        out.wall_most = std::max(out.wall_most, std::fabs(out.wall / out.exact_wall - 1.0));
        sum += out.wall;
        exact_sum += out.exact_wall;
    }
    out.wall_mean = sum / exact_sum - 1.0;
    out.alternating = seen.alternating;
    for (std::size_t i = seen.rows.size(); i-- > 0;) {
        const CavityByPoints::Row& row = seen.rows[i];
        if (row.r0 > 2.0 * CavityProblem::a) continue;
        const UndrainedCavity::State here = exact.at(row.r0, seen.time_of_rows);
        out.effective = -row.sigma_rr / here.effective - 1.0;
        out.pore = row.p_w / here.pore - 1.0;
        out.effective_most = std::max(out.effective_most, std::fabs(out.effective));
        out.pore_most = std::max(out.pore_most, std::fabs(out.pore));
        out.innermost = row;
        out.exact_innermost = here;
    }
    return out;
}

}  // namespace mpm_test
