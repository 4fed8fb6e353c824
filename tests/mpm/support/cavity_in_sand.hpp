// SPDX-License-Identifier: BSD-3-Clause
// A rigid wall expands a cylindrical cavity in Lausitz sand, plane strain, from a = 0.15 m: by material points and
// contact, and by finite elements along the radius, which know no contact.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

#include "support/alternating.hpp"
#include "support/contact_kind.hpp"
#include "support/lausitz.hpp"

namespace mpm_test {

struct CavityProblem {
    static constexpr double a = 0.15, outer = 3.0, grain_density = 2650.0;
    double void_ratio = 0.55;
    double water_density = 0.0;  // of what fills the pores and moves with the grains [kg/m3]
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
    // d(a v)/dt on the way out [m2/s2]; where nothing is compressed a radius r has the velocity a v/r.
    double flow_rate(double t) const {
        const double v = velocity(t), acceleration = t < ramp ? speed / ramp : 0.0;
        return v * v + (a + displacement(t)) * acceleration;
    }
    // On the way out [m].
    double displacement(double t) const {
        return t < ramp ? 0.5 * speed * t * t / ramp : speed * (t - 0.5 * ramp);
    }
    static double K0() { return 1.0 - std::sin(33.0 / 180.0 * 3.14159265358979323846); }
    void start(const ParticleView& q, std::ptrdiff_t p) const {
        q[column::S_zz][p] = -50e3;
        q[column::S_rr][p] = q[column::S_tt][p] = -50e3 * K0();
        q[Sand::state + GRIT_SAND_VOID_RATIO][p] = void_ratio;
        q[Sand::state + 1][p] = -1e-4;
    }
    double density() const {
        return (grain_density + void_ratio * water_density) / (1.0 + void_ratio);
    }
    static double far_pressure() { return 50e3 * K0(); }
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
    int points = 1;       // of integration in an element
    bool mean = false;    // volumetric strain and mean stress of an element for all of its points
    double window = 1e-3;

    CavityCurve run() const {
        std::vector<double> r{a};
        for (double l = a / per_radius; r.back() < outer; l *= r.back() < 3.0 * a ? 1.0 : 1.03)
            r.push_back(r.back() + l);
        r.back() = outer;
        const std::size_t n = r.size();
        const std::vector<double> r0 = r;
        Sand material(lausitz(), options_with_tolerance(1e-4));
        Particles all(material.own_columns());
        std::vector<double> mass(n), v(n), f(n);
        for (std::size_t e = 0; e + 1 < n; ++e) {
            const double l = r[e + 1] - r[e], middle = 0.5 * (r[e] + r[e + 1]);
            for (int k = 0; k < points; ++k)
                all.add({place(r, e, k), 0.5, 0.5 * l / points, 0.5, density()}, true);
            mass[e] += density() * 0.5 * l * middle;
            mass[e + 1] += density() * 0.5 * l * middle;
        }
        const std::ptrdiff_t count = all.size();
        for (std::ptrdiff_t p = 0; p < count; ++p) start(all.view(), p);
        CavityCurve curve;
        WallRecord record(window);
        // Radial, hoop; against the middle of the step.
        std::vector<double> strain[2], moduli(static_cast<std::size_t>(count));
        for (std::vector<double>& each : strain) each.resize(static_cast<std::size_t>(count));
        double t = 0.0;
        while (t < end) {
            const ParticleView q = all.view();
            material.wave_moduli({q, 0, count}, moduli.data());
            double dt = 1e-4;
            for (std::size_t e = 0; e + 1 < n; ++e)
                for (int k = 0; k < points; ++k)
                    dt = std::min(dt, 0.3 * (r[e + 1] - r[e]) /
                                          std::sqrt(moduli[at(e, k)] / density()));
            std::fill(f.begin(), f.end(), 0.0);
            for (std::size_t e = 0; e + 1 < n; ++e) add_forces(q, r, e, f);
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
            for (std::size_t e = 0; e + 1 < n; ++e) add_strains(r, v, dt, e, strain);
            update(material, q, count, strain);
            for (std::size_t i = 0; i < n; ++i) r[i] += dt * v[i];
            t += dt;
            if (curve.r0.empty() && r[0] - a >= 0.075)
                for (std::size_t e = 0; e + 1 < n; ++e)
                    for (int k = 0; k < points; ++k) {
                        curve.r0.push_back(place(r0, e, k));
                        curve.sigma_rr.push_back(q[column::S_rr][at(e, k)]);
                        curve.sigma_tt.push_back(q[column::S_tt][at(e, k)]);
                    }
        }
        return curve;
    }

  private:
    std::size_t at(std::size_t e, int k) const {
        return e * static_cast<std::size_t>(points) + static_cast<std::size_t>(k);
    }
    double share(int k) const { return (k + 0.5) / points; }  // of an element's length
    double place(const std::vector<double>& r, std::size_t e, int k) const {
        return (1.0 - share(k)) * r[e] + share(k) * r[e + 1];
    }
    void add_forces(const ParticleView& q, const std::vector<double>& r, std::size_t e,
                    std::vector<double>& f) const {
        const double l = r[e + 1] - r[e], of_point = l / points;
        double pressure = 0.0, area = 0.0;
        for (int k = 0; k < points; ++k) {
            area += place(r, e, k);
            pressure += place(r, e, k) * of_both(q, e, k);
        }
        for (int k = 0; k < points; ++k) {
            const double more = mean ? pressure / area - of_both(q, e, k) : 0.0;
            const double radial = (q[column::S_rr][at(e, k)] + more) * place(r, e, k) / l;
            const double hoop = q[column::S_tt][at(e, k)] + more;
            f[e] += of_point * (radial - (1.0 - share(k)) * hoop);
            f[e + 1] -= of_point * (radial + share(k) * hoop);
        }
    }
    double of_both(const ParticleView& q, std::size_t e, int k) const {
        return 0.5 * (q[column::S_rr][at(e, k)] + q[column::S_tt][at(e, k)]);
    }
    void add_strains(const std::vector<double>& r, const std::vector<double>& v, double dt,
                     std::size_t e, std::vector<double>* strain) const {
        const double l = r[e + 1] - r[e], longer = dt * (v[e + 1] - v[e]);
        double volume = 0.0, area = 0.0;
        for (int k = 0; k < points; ++k) {
            const double outwards = dt * ((1.0 - share(k)) * v[e] + share(k) * v[e + 1]);
            strain[0][at(e, k)] = longer / (l + 0.5 * longer);
            strain[1][at(e, k)] = outwards / (place(r, e, k) + 0.5 * outwards);
            area += place(r, e, k);
            volume += place(r, e, k) * (strain[0][at(e, k)] + strain[1][at(e, k)]);
        }
        if (!mean) return;
        for (int k = 0; k < points; ++k) {
            const double more = 0.5 * (volume / area - strain[0][at(e, k)] - strain[1][at(e, k)]);
            for (const int c : {0, 1}) strain[c][at(e, k)] += more;
        }
    }
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
    double bulk_modulus = 0.0;  // of water in the pores, undrained; 0: dry [Pa]
    bool implicit = false;      // its pressure
    // On the sand, over time, instead of a wall [Pa].
    std::function<double(double)> pressure = nullptr;

    struct Row {
        double r0 = 0.0, sigma_rr = 0.0, p_w = 0.0;  // of particles, at 0.075 m [m], [Pa]
    };
    struct Result {
        CavityCurve curve;
        std::vector<Row> rows;
        double time_of_rows = 0.0, alternating = 0.0;  // of pore pressures of cells [Pa]
        double work;  // of the wall until 0.075 m [J] per radian and metre
    };

    Result run() const {
        const double h = a / cells;
        std::vector<double> nodes;
        for (int i = 0; (i - phase) * h < 4.0 * a; ++i) nodes.push_back((i - phase) * h);
        nodes[0] = 0.0;
        for (double l = h; nodes.back() < outer; l *= 1.06) nodes.push_back(nodes.back() + l);
        nodes.back() = outer;
        if (is_wet()) nodes.push_back(outer + 0.5 * a);  // the far side moves
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
        if (pressure) wall.prescribed_velocity = [](double) { return grit::Vector2{0.0, 0.0}; };
        simulation.add_body(std::move(wall));
        simulation.add_body(sand(nodes, h));
        simulation.fix_below(1, 0.0);
        simulation.fix_above(1, h);
        if (is_wet()) press_far_side(simulation);
        else simulation.fix_above(0, nodes.back());
        if (pressure) press(simulation, {0, 1}, Edge::left, pressure, 1.0);
        else
            add_contact(simulation, kind, 0.0,
                        {50e6, h, {{{a, 0.0}, {a, h}}}, {{{a, h}, {a, 0.0}}}});
        return watch(simulation, h);
    }

  private:
    bool is_wet() const { return bulk_modulus > 0.0; }
    static void press(Simulation& simulation, std::initializer_list<int> particles, Edge edge,
                      const std::function<double(double)>& by, double direction) {
        for (const int id : particles)
            simulation.add_traction({1, id, edge, [by, direction](double t) {
                                         return grit::Vector2{direction * by(t), 0.0};
                                     }});
    }
    static void press_far_side(Simulation& simulation) {
        const auto particles = static_cast<int>(simulation.body(1).particles.size());
        press(
            simulation, {particles - 2, particles - 1}, Edge::right,
            [](double) { return far_pressure(); }, -1.0);
    }
    // Without cavities: its pressure may fall by as much as it likes.
    PoreWater water(const Sand& material) const {
        PoreWater out;
        out.implicit = implicit;
        out.bulk_modulus = bulk_modulus;
        out.density = water_density;
        out.largest_tension = 1e12;
        out.first = column::own + material.own_columns();
        out.void_ratio_column = material.separation().void_ratio;
        return out;
    }
    Body sand(const std::vector<double>& nodes, double h) const {
        Body body;
        auto material = std::make_unique<Sand>(lausitz(), sand_options());
        if (is_wet()) body.water = water(*material);
        body.particles =
            Particles(material->own_columns() + (is_wet() ? body.water->columns() : 0));
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
            if (nodes[i + 1] < at + 1e-9 || nodes[i + 1] > outer) continue;
            const double from = std::max(nodes[i], at), whole = nodes[i + 1] - from;
            const int parts = whole < 0.2 * h ? 1 : per_cell;
            for (int k = 0; k < parts; ++k)
                add(from + whole * k / parts, from + whole * (k + 1) / parts);
        }
        body.material = std::move(material);
        for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) start(body.particles.view(), p);
        return body;
    }
    static double face(Simulation& simulation) {
        const ParticleView q = simulation.body(1).particles.view();
        const std::ptrdiff_t p = simulation.find(1, 0);
        return q[column::r][p] - q[column::F_rr][p] * q[column::l_r][p];
    }
    void note(Simulation& simulation, const std::vector<double>& r0, Result& out) const {
        const Body& sand = simulation.body(1);
        const ParticleView q = simulation.body(1).particles.view();
        out.rows.resize(r0.size() / 2);
        for (std::size_t i = 0; i < out.rows.size(); ++i) {
            const std::ptrdiff_t p = simulation.find(1, static_cast<int>(2 * i));
            Row& row = out.rows[i];
            row.r0 = r0[2 * i];
            row.sigma_rr += q[column::S_rr][p];
            if (is_wet()) row.p_w += sand.water->pressure(q, p);
        }
        out.time_of_rows += simulation.time();
        if (is_wet())
            out.alternating =
                std::max(out.alternating, mpm_test::alternating(pressures_along_r(simulation, 1)));
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
        int seen = 0;  // steps around 0.075 m
        while (simulation.time() < end) {
            const double t = simulation.time();
            simulation.step();
            const double dt = simulation.time() - t;
            const double v =
                pressure ? (face(simulation) - a - u) / dt : velocity(simulation.time());
            const double force =
                pressure ? pressure(t) * (a + u) * h : contact_force(simulation, kind, dt)[0];
            if (u < 0.075 && v > 0.0) out.work += force * v * dt / h;
            record.add(simulation.time(), dt, u, force / ((a + u) * h), out.curve);
            u += v * dt;
            // Undrained, the mean over 10 ms, which waves in it pass twice.
            const double around = is_wet() ? 1e-3 : 0.0;
            if (seen == 0 ? u >= 0.075 - around && v > 0.0 : is_wet() && u < 0.075 + around) {
                note(simulation, r0, out);
                ++seen;
            }
        }
        for (Row& row : out.rows) row = {row.r0, row.sigma_rr / seen, row.p_w / seen};
        out.time_of_rows /= std::max(seen, 1);
        return out;
    }
};

}  // namespace mpm_test
