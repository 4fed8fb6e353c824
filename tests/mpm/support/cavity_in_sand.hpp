// SPDX-License-Identifier: BSD-3-Clause
// A rigid wall expands a cylindrical cavity in Lausitz sand, plane strain, from a = 0.15 m: by material points and
// contact, and by finite elements along the radius, which know no contact.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "support/contact_kind.hpp"
#include "support/lausitz.hpp"

namespace mpm_test {

struct CavityProblem {
    static constexpr double a = 0.15, outer = 3.0, grain_density = 2650.0;
    double void_ratio = 0.55;
    double local_damping = 0.0;
    double speed = 0.2, back = 0.01;  // of the wall outwards and inwards [m/s]
    double ramp = 0.02;               // from rest, and from out to in [s]
    double turn_at = 0.0741;          // displacement where the speed begins to change [m]
    double end = 0.46;                // [s]

    double turn() const { return ramp + (turn_at - 0.5 * speed * ramp) / speed; }
    double velocity(double t) const {
        if (t < ramp) return speed * t / ramp;
        const double after = (t - turn()) / ramp;
        return after <= 0.0 ? speed : std::max(speed - after * (speed + back), -back);
    }
    static double K0() { return 1.0 - std::sin(33.0 / 180.0 * 3.14159265358979323846); }
    void start(const ParticleView& q, std::ptrdiff_t p) const {
        q[column::S_zz][p] = -50e3;
        q[column::S_rr][p] = q[column::S_tt][p] = -50e3 * K0();
        q[Sand::state + GRIT_SAND_VOID_RATIO][p] = void_ratio;
        q[Sand::state + 1][p] = -1e-4;
    }
    double density() const { return grain_density / (1.0 + void_ratio); }
};

// What is seen while the wall moves.
struct CavityCurve {
    std::vector<double> time, displacement, pressure;  // [s], [m], [Pa], means over windows of time
    std::vector<double> r0, sigma_rr, sigma_tt;  // profile at 0.075 m on the way out [m], [Pa]

    // Of the wall, at a time.
    double pressure_at(double t) const {
        const auto i =
            static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), t) - time.begin());
        if (i == 0) return pressure.front();
        if (i == time.size()) return pressure.back();
        const double x = (t - time[i - 1]) / (time[i] - time[i - 1]);
        return (1.0 - x) * pressure[i - 1] + x * pressure[i];
    }
    double stress_at(double initial_radius) const {
        const auto i = std::clamp<std::size_t>(
            static_cast<std::size_t>(std::lower_bound(r0.begin(), r0.end(), initial_radius) -
                                     r0.begin()),
            1, r0.size() - 1);
        const double x = (initial_radius - r0[i - 1]) / (r0[i] - r0[i - 1]);
        return (1.0 - x) * sigma_rr[i - 1] + x * sigma_rr[i];
    }
};

// Pressures of the wall gathered over windows of time.
class WallRecord {
  public:
    explicit WallRecord(double length) : window(length) {}
    void add(double t, double dt, double displacement, double pressure, CavityCurve& curve) {
        impulse += pressure * dt;
        moved += displacement * dt;
        passed += dt;
        if (passed < window) return;
        curve.time.push_back(t - 0.5 * passed);
        curve.displacement.push_back(moved / passed);
        curve.pressure.push_back(impulse / passed);
        impulse = moved = passed = 0.0;
    }

  private:
    double window, impulse = 0.0, moved = 0.0, passed = 0.0;
};

// Linear elements along the radius, lumped mass, stresses by the sand's update.
struct CavityByElements : CavityProblem {
    int per_radius = 40;  // elements in a; they grow outwards from 2 a on
    double window = 1e-3;

    CavityCurve run() const {
        std::vector<double> r{a};
        for (double l = a / per_radius; r.back() < outer; l *= r.back() < 3.0 * a ? 1.0 : 1.03)
            r.push_back(r.back() + l);
        r.back() = outer;
        const std::size_t n = r.size();
        const std::vector<double> r0 = r;
        Sand material(lausitz(), options_with_tolerance(1e-4));
        Particles elements(material.own_columns());
        std::vector<double> mass(n), v(n), f(n);
        for (std::size_t e = 0; e + 1 < n; ++e) {
            const double l = r[e + 1] - r[e], middle = 0.5 * (r[e] + r[e + 1]);
            elements.add({middle, 0.5, 0.5 * l, 0.5, density()}, true);
            start(elements.view(), static_cast<std::ptrdiff_t>(e));
            mass[e] += density() * 0.5 * l * middle;
            mass[e + 1] += density() * 0.5 * l * middle;
        }
        CavityCurve curve;
        WallRecord record(window);
        // Radial, hoop; against the middle of the step.
        std::vector<double> strain[2] = {std::vector<double>(n - 1), std::vector<double>(n - 1)};
        std::vector<double> moduli(n - 1);
        double t = 0.0;
        const auto count = static_cast<std::ptrdiff_t>(n - 1);
        while (t < end) {
            const ParticleView q = elements.view();
            material.wave_moduli({q, 0, count}, moduli.data());
            double dt = 1e-4;
            for (std::size_t e = 0; e + 1 < n; ++e)
                dt = std::min(dt, 0.3 * (r[e + 1] - r[e]) / std::sqrt(moduli[e] / density()));
            std::fill(f.begin(), f.end(), 0.0);
            for (std::size_t e = 0; e + 1 < n; ++e) {
                const double l = r[e + 1] - r[e], middle = 0.5 * (r[e] + r[e + 1]);
                const double radial = q[column::S_rr][e] * middle,
                             hoop = 0.5 * q[column::S_tt][e] * l;
                f[e] += radial - hoop;
                f[e + 1] -= radial + hoop;
            }
            // The wall holds its node, which has mass of its own.
            const double next = velocity(t + dt);
            const double wall = mass[0] * (next - v[0]) / dt - f[0];
            record.add(t + dt, dt, r[0] - a, wall / r[0], curve);
            for (std::size_t i = 1; i + 1 < n; ++i) {
                double force = f[i];
                if (local_damping > 0.0)
                    force -= local_damping * std::fabs(force) *
                             ((v[i] + 0.5 * dt * force / mass[i]) > 0.0 ? 1.0 : -1.0);
                v[i] += dt * force / mass[i];
            }
            v[0] = next;
            v[n - 1] = 0.0;
            for (std::size_t e = 0; e + 1 < n; ++e) {
                const double l = r[e + 1] - r[e], middle = 0.5 * (r[e] + r[e + 1]);
                const double longer = dt * (v[e + 1] - v[e]),
                             outwards = 0.5 * dt * (v[e + 1] + v[e]);
                strain[0][e] = longer / (l + 0.5 * longer);
                strain[1][e] = outwards / (middle + 0.5 * outwards);
            }
            update(material, q, count, strain);
            for (std::size_t i = 0; i < n; ++i) r[i] += dt * v[i];
            t += dt;
            if (curve.r0.empty() && r[0] - a >= 0.075)
                for (std::size_t e = 0; e + 1 < n; ++e) {
                    curve.r0.push_back(0.5 * (r0[e] + r0[e + 1]));
                    curve.sigma_rr.push_back(q[column::S_rr][e]);
                    curve.sigma_tt.push_back(q[column::S_tt][e]);
                }
        }
        return curve;
    }

  private:
    static void update(Sand& material, const ParticleView& q, std::ptrdiff_t n,
                       const std::vector<double>* strain) {
        for (std::ptrdiff_t begin = 0; begin < n; begin += Increments::capacity) {
            const std::ptrdiff_t end = std::min<std::ptrdiff_t>(begin + Increments::capacity, n);
            Increments d{};
            for (std::ptrdiff_t e = begin; e < end; ++e) {
                const auto i = static_cast<std::size_t>(e);
                d.strain[0][e - begin] = strain[0][i];
                d.strain[2][e - begin] = strain[1][i];
                for (const int k : {0, 4, 8}) d.rotation[k][e - begin] = 1.0;
            }
            material.update({q, begin, end}, d);
        }
    }
};

// Material points, one cell high.
struct CavityByPoints : CavityProblem {
    ContactKind kind = ContactKind::surface;
    int cells = 6;     // in a
    int per_cell = 2;  // particles along r
    bool cell_mean = false;
    double pic_rate = 0.0;
    double phase = 0.0;  // of the wall against the grid at the start [cells]
    double window = 1e-3;

    struct Row {
        double r0, sigma_rr;  // of particles, at 0.075 m [m], [Pa]
    };
    struct Result {
        CavityCurve curve;
        std::vector<Row> rows;
        double work;  // of the wall until 0.075 m [J] per radian and metre
    };

    Result run() const {
        const double h = a / cells;
        std::vector<double> nodes;
        for (int i = 0; (i - phase) * h < 4.0 * a; ++i) nodes.push_back((i - phase) * h);
        nodes[0] = 0.0;
        for (double l = h; nodes.back() < outer; l *= 1.06) nodes.push_back(nodes.back() + l);
        nodes.back() = outer;
        Simulation simulation(Axis(nodes), Axis(std::vector<double>{0.0, h}),
                              {.axisymmetric = true,
                               .cfl = 0.4,
                               .pic_rate = pic_rate,
                               .local_damping = local_damping,
                               .cell_mean = cell_mean});
        Body wall = make_box({a - 2.0 * h, a, 0.0, h, 4, 2, 1000.0}, true, nullptr);
        wall.prescribed_velocity = [problem = CavityProblem(*this)](double t) {
            return grit::Vector2{problem.velocity(t), 0.0};
        };
        simulation.add_body(std::move(wall));
        simulation.add_body(sand(nodes, h));
        simulation.fix_below(1, 0.0);
        simulation.fix_above(1, h);
        simulation.fix_above(0, nodes.back());
        add_contact(simulation, kind, 0.0, {50e6, h, {{{a, 0.0}, {a, h}}}, {{{a, h}, {a, 0.0}}}});
        return watch(simulation, h);
    }

  private:
    Body sand(const std::vector<double>& nodes, double h) const {
        Body body;
        auto material = std::make_unique<Sand>(lausitz(), sand_options());
        body.particles = Particles(material->own_columns());
        const auto add = [&](double from, double to) {
            for (const double z : {0.25, 0.75})
                body.particles.add(
                    {0.5 * (from + to), z * h, 0.5 * (to - from), 0.25 * h, density()}, true);
        };
        // Parts of h from the wall on; beyond the fine part, parts of the grid's cells.
        const double width = h / per_cell;
        double at = a;
        for (; at < 4.0 * a - 1e-9; at += width) add(at, at + width);
        for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
            if (nodes[i + 1] < at + 1e-9) continue;
            const double from = std::max(nodes[i], at), whole = nodes[i + 1] - from;
            const int parts = whole < 0.2 * h ? 1 : per_cell;
            for (int k = 0; k < parts; ++k)
                add(from + whole * k / parts, from + whole * (k + 1) / parts);
        }
        body.material = std::move(material);
        for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) start(body.particles.view(), p);
        return body;
    }
    Result watch(Simulation& simulation, double h) const {
        Result out;
        out.work = 0.0;
        WallRecord record(window);
        std::vector<double> r0(static_cast<std::size_t>(simulation.body(1).particles.size()));
        for (std::size_t id = 0; id < r0.size(); ++id)
            r0[id] =
                simulation.body(1).particles(column::r, simulation.find(1, static_cast<int>(id)));
        double u = 0.0;
        while (simulation.time() < end) {
            const double t = simulation.time();
            simulation.step();
            const double dt = simulation.time() - t, v = velocity(simulation.time());
            const double force = contact_force(simulation, kind, dt)[0];
            if (u < 0.075 && v > 0.0) out.work += force * v * dt / h;
            record.add(simulation.time(), dt, u, force / ((a + u) * h), out.curve);
            u += v * dt;
            if (out.rows.empty() && u >= 0.075) {
                const Particles& q = simulation.body(1).particles;
                for (std::size_t id = 0; id < r0.size(); id += 2)
                    out.rows.push_back(
                        {r0[id], q(column::S_rr, simulation.find(1, static_cast<int>(id)))});
            }
        }
        return out;
    }
};

}  // namespace mpm_test
