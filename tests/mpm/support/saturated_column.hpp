// SPDX-License-Identifier: BSD-3-Clause
// A confined column of elastic sand whose pores are full of water, and what is known of it (W3, W4).
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <adapters/mpm/case/build_case.hpp>

#include "support/alternating.hpp"
#include "support/plans.hpp"

namespace mpm_test {

using namespace grit::mpm;

struct SaturatedColumn {
    static constexpr double E = 10e6, K_w = 2.2e9, n = 0.4, rho_s = 2650.0, rho_w = 1000.0;
    static constexpr double rho_d = (1.0 - n) * rho_s, rho = rho_d + n * rho_w;
    static constexpr double height = 1.0;  // [m]
    int cells = 32;
    double conductivity = 0.0;  // [m/s]; 0: undrained
    double cfl = 0.4;
    int threads = 1;
    bool axisymmetric = false;
    bool closed = false;          // its top is a wall
    bool drained_bottom = false;  // flow may leave there as well
    bool implicit = false;        // its pore pressure
    bool under_plate = false;     // the load is on a plate on it, which no water passes
    double load = 0.0;            // on its top [Pa] ...
    double ramp = 0.0;            // ... within this time [s]
    double gravity = 0.0;
    double damping = 0.0;

    bool flows() const { return conductivity > 0.0; }
    double cell() const { return height / cells; }

    Case plan() const {
        Case out;
        out.name = "column";
        out.settings.axisymmetric = axisymmetric;
        out.settings.cfl = cfl;
        out.settings.threads = threads;
        out.settings.local_damping = damping;
        out.gravity = gravity;
        out.r = {0.0, {{cell(), 1, 1.0}}};
        const int above = closed ? 0 : under_plate ? 4 : 2;
        out.z = {0.0, {{closed ? height : height + above * cell(), cells + above, 1.0}}};
        for (const Side side : {Side::left, Side::right, Side::bottom})
            out.boundary[static_cast<int>(side)] = Boundary::roller;
        if (closed) out.boundary[static_cast<int>(Side::top)] = Boundary::roller;
        out.drained[static_cast<int>(Side::bottom)] = drained_bottom;
        BodyPlan body{};
        body.name = "sand";
        body.outlines = {Outline{{{0.0, 0.0}, {cell(), 0.0}, {cell(), height}, {0.0, height}}}};
        body.density = body_density();
        body.material = ElasticPlan{E, 0.0};
        WaterPlan water;
        water.drainage = flows() ? Drainage::flow : Drainage::undrained;
        water.conductivity = conductivity;
        water.implicit = implicit;
        water.porosity = n;
        water.grain_density = rho_s;
        if (gravity > 0.0) {
            water.table = height;
            body.geostatic = Geostatic{.surface = height, .surcharge = load};
        }
        body.water = water;
        out.bodies = {body};
        if (under_plate) add_plate(out);
        if (load > 0.0)
            out.tractions = {{.body = under_plate ? "plate" : "sand",
                              .edge = Edge::top,
                              .stress = ramp > 0.0 ? TimeTable{{0.0, ramp}, {0.0, load}}
                                                   : TimeTable{{0.0}, {load}}}};
        out.stages = {StagePlan{.name = "stage", .end = {.time = 1.0}}};
        out.history.body = "sand";
        return out;
    }
    void add_plate(Case& to) const {
        BodyPlan plate{};
        plate.name = "plate";
        const double top = height + 2.0 * cell();
        plate.outlines = {Outline{{{0.0, height}, {cell(), height}, {cell(), top}, {0.0, top}}}};
        plate.density = 2000.0;
        plate.material = ElasticPlan{10.0 * E, 0.0};
        to.bodies.push_back(plate);
        ContactPlan contact;
        contact.stiff = "plate";
        contact.soft = "sand";
        contact.at_surfaces = true;
        to.contacts = {contact};
    }
    double body_density() const { return flows() ? rho_d : rho; }

    // (W3)
    static double c_u() { return std::sqrt((E + K_w / n) / rho); }
    static double sum() { return (E + (1.0 - n) * (1.0 - n) * K_w / n) / rho_d + K_w / rho_w; }
    static double product() { return K_w * E / (rho_d * rho_w); }
    static double c_1() {
        return std::sqrt(0.5 * (sum() + std::sqrt(sum() * sum() - 4.0 * product())));
    }
    static double c_2() { return std::sqrt(product()) / c_1(); }
    // (W4)
    static double p_0(double q) { return q * (K_w / n) / (K_w / n + E); }
    double c_v() const { return conductivity / (rho_w * standard_gravity * (1.0 / E + n / K_w)); }
};

// Means of cells, from the bottom, each row from the left.
inline std::vector<double> pore_pressures(Simulation& simulation, int cells, int across = 1) {
    std::vector<double> sum(static_cast<std::size_t>(cells) * static_cast<std::size_t>(across)),
        count(sum.size());
    Body& body = simulation.body(0);
    const ParticleView q = body.particles.view();
    const GridView grid{simulation.axis_r().view(), simulation.axis_z().view()};
    for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) {
        const int i = std::min(grid.r.cell_of(q[column::r][p]), across - 1);
        const int j = std::min(grid.z.cell_of(q[column::z][p]), cells - 1);
        const auto cell = static_cast<std::size_t>(std::ptrdiff_t{j} * across + i);
        sum[cell] += body.water->pressure(q, p);
        count[cell] += 1.0;
    }
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] /= count[i];
    return sum;
}

// A case of a column, whose grains are Lausitz sand.
inline Case of_sand(Case plan) {
    SandPlan sand = lausitz_plan(0.7);
    sand.intergranular_rho = 1.0;
    plan.bodies[0].material = sand;
    return plan;
}

// After a load, all of which came before the end [s]: largest pressure and that of the lowest cell [Pa], what the top has sunk
// by [m], the next step [s], the energy residual by the work of the load.
struct Loaded {
    double largest_pressure, lowest_cell, settlement, dt, residual, alternating;
};

inline Loaded after_a_load(const SaturatedColumn& column, double end = 0.03) {
    BuiltCase built = build_case(column.plan());
    Simulation& simulation = *built.simulation;
    while (simulation.time() < end) simulation.step();
    const std::vector<double> p = pore_pressures(simulation, column.cells);
    const Particles& q = simulation.body(0).particles;
    const std::ptrdiff_t top = simulation.find(0, static_cast<int>(q.size()) - 1);
    const Energy energy = simulation.energy();
    return {*std::max_element(p.begin(), p.end()),
            p[0],
            column.height - q(column::z, top) - q(column::F_zz, top) * q(column::l_z, top),
            simulation.next_step(),
            energy.residual() / energy.external_work,
            alternating(p)};
}

struct Wave {
    double speed, residual, dt;
};

// The speed of the wave that stands in a closed column, a half wave long, from its fourth passage through zero;
// ratio: of the velocity of water to that of grains.
inline Wave standing_wave(SaturatedColumn column, double ratio) {
    column.closed = true;
    BuiltCase built = build_case(column.plan());
    Simulation& simulation = *built.simulation;
    Body& body = simulation.body(0);
    const auto shape = [&](std::ptrdiff_t p) {
        return std::sin(std::numbers::pi * body.particles(column::z, p) / column.height);
    };
    const ParticleView q = body.particles.view();
    for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p) {
        q[column::v_z][p] = 1e-3 * shape(p);
        if (column.flows())
            q[body.water->velocity_column() + 1][p] = 1e-3 * (ratio - 1.0) * shape(p);
    }
    const auto amplitude = [&] {
        double out = 0.0;
        for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p)
            out += body.particles(column::v_z, p) * shape(p);
        return out;
    };
    double before = amplitude();
    for (int passages = 0;;) {
        const double t = simulation.time();
        simulation.step();
        const double now = amplitude();
        if (before * now < 0.0 && ++passages == 4) {
            const double at = t + (simulation.time() - t) * before / (before - now);
            const Energy energy = simulation.energy();
            // Four passages: 3.5 half periods of L/c.
            return {3.5 * column.height / at, energy.residual() / energy.kinetic_0,
                    simulation.time() - t};
        }
        before = now;
        if (simulation.steps() > 2000000) throw std::runtime_error("no wave");
    }
}

// A thick cylinder of undrained sand, eight cells across its wall, under a pressure inside: widening of its inner
// face [of Lame's], and the largest error of a pore pressure [of the pressure].
struct SaturatedCylinder {
    double widening, pressure_error;
};

inline SaturatedCylinder inflate_saturated_cylinder(bool implicit = false) {
    constexpr double a = 0.5, b = 1.0, h = 0.0625, pressure = 1000.0, E = 1e7, nu = 0.3;
    constexpr double n = 0.4, K_w = 2.2e9;
    Case plan;
    plan.name = "cylinder";
    plan.settings.local_damping = 0.5;
    plan.gravity = 0.0;
    plan.r = {0.0, {{b + 2.0 * h, 18, 1.0}}};
    plan.z = {0.0, {{2.0 * h, 2, 1.0}}};
    for (const Side side : {Side::left, Side::bottom, Side::top})
        plan.boundary[static_cast<int>(side)] = Boundary::roller;
    BodyPlan body{};
    body.name = "wall";
    body.outlines = {Outline{{{a, 0.0}, {b, 0.0}, {b, 2.0 * h}, {a, 2.0 * h}}}};
    body.density = 2000.0;
    body.material = ElasticPlan{E, nu};
    body.water = WaterPlan{.bulk_modulus = K_w, .grain_density = 2650.0, .porosity = n};
    body.water->implicit = implicit;
    plan.bodies = {body};
    plan.tractions = {{.body = "wall",
                       .edge = Edge::left,
                       .direction = {1.0, 0.0},
                       .stress = TimeTable{{0.0}, {pressure}}}};
    plan.stages = {StagePlan{.name = "stage", .local_damping = 0.5, .end = {.time = 1.0}}};
    plan.history.body = "wall";
    BuiltCase built = build_case(plan);
    Simulation& simulation = *built.simulation;
    while (simulation.time() < 0.5) simulation.step();
    // Undrained moduli: those of the skeleton, and of the water besides.
    constexpr double G = 0.5 * E / (1.0 + nu), K = E / (3.0 * (1.0 - 2.0 * nu)) + K_w / n;
    constexpr double lambda = K - 2.0 / 3.0 * G, share = pressure * a * a / (b * b - a * a);
    constexpr double strain = share / (lambda + G),
                     exact_u = 0.5 * strain * a + share * b * b / (2.0 * G * a);
    const Particles& q = simulation.body(0).particles;
    const std::ptrdiff_t inner = simulation.find(0, 0);
    const double u = q(column::r, inner) - q(column::F_rr, inner) * q(column::l_r, inner) - a;
    SaturatedCylinder out{u / exact_u, 0.0};
    const ParticleView view = simulation.body(0).particles.view();
    for (std::ptrdiff_t p = 0; p < q.size(); ++p)
        out.pressure_error = std::max(
            out.pressure_error,
            std::fabs(simulation.body(0).water->pressure(view, p) + K_w / n * strain) / pressure);
    return out;
}

// Terzaghi's column, drained at its top, at a time T = c_v t/L^2 after the middle of a ramp of this length, along which its load
// came: pressure at a level and settlement [of p_0 and of its end].
inline double terzaghi_sum(double T, double ramp, double (*of_mode)(double M, double at),
                           double at) {
    double sum = 0.0;
    for (int m = 0; m < 100; ++m) {
        const double M = 0.5 * std::numbers::pi * (2 * m + 1), x = 0.5 * M * M * ramp;
        // The mean of what began along the ramp, sinh(x)/x exp(-M^2 T).
        sum += of_mode(M, at) *
               (x > 1e-6 ? 0.5 * (std::exp(x - M * M * T) - std::exp(-x - M * M * T)) / x
                         : std::exp(-M * M * T));
    }
    return sum;
}
inline double terzaghi_pressure(double T, double height_share, double ramp = 0.0) {
    return terzaghi_sum(
        T, ramp, [](double M, double at) { return 2.0 / M * std::sin(M * (1.0 - at)); },
        height_share);
}
inline double terzaghi_settlement(double T, double ramp = 0.0) {
    return 1.0 - terzaghi_sum(
                     T, ramp, [](double M, double) { return 2.0 / (M * M); }, 0.0);
}

struct Consolidation {
    double T;                         // c_v t/L^2
    double pressure, exact_pressure;  // in the lowest cell [p_0]
    double settlement, exact_settlement;
    double alternating;  // [p_0]
    double
        profile_error;  // of the pressures of all cells, RMS [p_0]; of a column drained at its top alone
    double residual;  // of the energy balance [work of the load]
};

// log2 of what an error is by that of the grid before, with half as many cells.
inline double observed_order(double coarse, double fine) { return std::log2(coarse / fine); }

// Drained at the bottom too, it is two columns of half the height, and the cell is the one above the middle.
// The load comes within T = 0.02, and T counts from the middle of that. It strains the column by 1e-5, for what follows is linear.
inline std::vector<Consolidation> consolidate(SaturatedColumn column,
                                              const std::vector<double>& times) {
    constexpr double load = 1e2, ramp = 0.02;
    const bool from_both = column.drained_bottom && !column.under_plate;
    const double L = column.height, way = from_both ? 0.5 * L : L;
    const double unit = way * way / column.c_v();
    const auto cell = static_cast<std::size_t>(from_both            ? column.cells / 2
                                               : column.under_plate ? column.cells - 1
                                                                    : 0);
    column.load = load;
    column.ramp = ramp * unit;
    BuiltCase built = build_case(column.plan());
    Simulation& simulation = *built.simulation;
    const Particles& q = simulation.body(0).particles;
    const auto top = static_cast<int>(q.size()) - 1;
    const auto pressures_now = [&] { return pore_pressures(simulation, column.cells); };
    const auto settlement_now = [&] {
        const std::ptrdiff_t p = simulation.find(0, top);
        return L - q(column::z, p) - q(column::F_zz, p) * q(column::l_z, p);
    };
    // Of what settles in time, and at once.
    const double at_end = load * L / column.E,
                 at_once = load * L / (column.E + column.K_w / column.n);
    std::vector<Consolidation> out;
    for (const double T : times) {
        const double t = T * unit + 0.5 * column.ramp;
        while (simulation.time() + simulation.next_step() < t || simulation.steps() == 0)
            simulation.step();
        const double before = simulation.time(), u = settlement_now();
        std::vector<double> p = pressures_now();
        simulation.step();
        const double share = (t - before) / (simulation.time() - before);
        const double p_0 = SaturatedColumn::p_0(load);
        const std::vector<double> after = pressures_now();
        double squares = 0.0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            p[i] = (p[i] + share * (after[i] - p[i])) / p_0;
            const double level = (static_cast<double>(i) + 0.5) * column.cell() / L;
            const double error = p[i] - terzaghi_pressure(T, level, ramp);
            squares += error * error;
        }
        const Energy energy = simulation.energy();
        out.push_back({T, p[cell], terzaghi_pressure(T, 0.5 * column.cell() / way, ramp),
                       (u + share * (settlement_now() - u) - at_once) / (at_end - at_once),
                       terzaghi_settlement(T, ramp), alternating(after) / p_0,
                       std::sqrt(squares / column.cells),
                       energy.residual() / energy.external_work});
    }
    return out;
}

}  // namespace mpm_test
