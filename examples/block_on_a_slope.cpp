// SPDX-License-Identifier: BSD-3-Clause
// A rigid block slides down a slope in three dimensions, with Geo-contact at the nodes of a grid, in a material-point
// code of one's own in C++. The grid lies along the slope, and the block slides between its lines. Coulomb's law says
// v = g (sin a - mu cos a) t: the program prints both.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <grit/grit.h>

namespace {

using Vector = std::array<double, 3>;

constexpr double h = 0.1, dt = 1e-4, mass_of_particle = 2000.0 * (h / 2) * (h / 2) * (h / 2);
constexpr double slope = 0.5, mu = 0.3, gravity = 9.81;  // slope: the angle a [rad]
constexpr Vector downhill{0.8, 0.6, 0.0};
constexpr std::ptrdiff_t across = 12, up = 5, nodes = across * across * up;

[[noreturn]] void fail(grit_status status, const grit_error& error) {
    std::fprintf(stderr, "%s: %s\n", grit_status_name(status), error.message);
    std::exit(EXIT_FAILURE);
}

// Calls of Grit say what went wrong in an error; here that ends the program.
template <class Function, class... Arguments> void call(Function function, Arguments... arguments) {
    grit_error error{};
    if (const grit_status status = function(arguments..., &error); status != GRIT_OK)
        fail(status, error);
}

// Where the i-th of a box with so many along x and y is: column, row, layer.
Vector place_of(std::ptrdiff_t i, std::ptrdiff_t along_x, std::ptrdiff_t along_y) {
    const std::ptrdiff_t row = i / along_x, layer = row / along_y;
    return {static_cast<double>(i - row * along_x), static_cast<double>(row - layer * along_y),
            static_cast<double>(layer)};
}

// Quantities of nodes, one vector for each.
struct Grid {
    std::vector<Vector> position = std::vector<Vector>(nodes), normal = position,
                        velocity = position, at_rest = position;
    std::vector<double> mass = std::vector<double>(nodes), ground_mass = mass, distance = mass,
                        gap = mass;
    std::vector<std::array<double, 2>> surface = std::vector<std::array<double, 2>>(nodes);

    // The ground fills the lowest layer of cells; it does not move.
    Grid() {
        for (std::ptrdiff_t i = 0; i < nodes; ++i) {
            const auto at = static_cast<std::size_t>(i);
            const Vector place = place_of(i, across, across);
            for (std::size_t c = 0; c < 3; ++c) position[at][c] = h * place[c];
            normal[at] = {0.0, 0.0, -1.0};  // from the block (A) to the ground (B)
            ground_mass[at] = position[at][2] < 1.5 * h ? 1.0 : 0.0;
        }
    }
};

// The nodes of a particle's cell and its weights there.
struct Cell {
    std::array<std::ptrdiff_t, 8> node;
    std::array<double, 8> weight;

    explicit Cell(const Vector& x) {
        for (std::size_t k = 0; k < 8; ++k) {
            const std::array<std::size_t, 3> far_side{k % 2, k / 2 % 2, k / 4};
            std::array<std::ptrdiff_t, 3> at;
            weight[k] = 1.0;
            for (std::size_t c = 0; c < 3; ++c) {
                const double cell = std::floor(x[c] / h), part = x[c] / h - cell;
                at[c] =
                    static_cast<std::ptrdiff_t>(cell) + static_cast<std::ptrdiff_t>(far_side[c]);
                weight[k] *= far_side[c] ? part : 1.0 - part;
            }
            node[k] = (at[2] * across + at[1]) * across + at[0];
        }
    }
};

template <class T> grit_view view(const std::vector<T>& values, std::ptrdiff_t components) {
    return grit_view_of(reinterpret_cast<const double*>(values.data()), components, 1);
}
template <class T> grit_mutable_view out(std::vector<T>& values, std::ptrdiff_t components) {
    return grit_mutable_view_of(reinterpret_cast<double*>(values.data()), components, 1);
}

// Distance of the block's surface to the nodes, and the gap to the ground, whose surface is at z = h.
void measure(Grid& grid, const std::vector<Vector>& block) {
    static constexpr double sides[3][3] = {{h / 4, 0, 0}, {0, h / 4, 0}, {0, 0, h / 4}};
    static constexpr double wide[3][3] = {{h / 2, 0, 0}, {0, h / 2, 0}, {0, 0, h / 2}};
    grit_contact_surfaces surfaces{};
    surfaces.struct_size = sizeof surfaces;
    surfaces.components = 3;
    surfaces.nodes = nodes;
    surfaces.position = view(grid.position, 3);
    surfaces.normal = view(grid.normal, 3);
    surfaces.surface = out(grid.surface, 2);
    call(grit_contact_surfaces_reset, &surfaces);
    const auto add = [&](int body, const std::vector<Vector>& x, const double* side) {
        std::vector<std::array<std::ptrdiff_t, 8>> reached;
        for (const Vector& each : x) reached.push_back(Cell(each).node);
        grit_contact_domains domains{};
        domains.struct_size = sizeof domains;
        domains.body = body;
        domains.sides = 3;
        domains.nodes_each = 8;
        domains.node = reached.data()->data();
        domains.position = view(x, 3);
        domains.side = grit_matrix_view_of(side, 0, 3, 1);
        call(grit_contact_surfaces_add, &surfaces, static_cast<std::ptrdiff_t>(x.size()), &domains);
    };
    std::vector<Vector> ground;
    for (std::ptrdiff_t i = 0; i < (across - 1) * (across - 1); ++i) {
        const Vector place = place_of(i, across - 1, across - 1);
        ground.push_back({h * (place[0] + 0.5), h * (place[1] + 0.5), 0.5 * h});
    }
    add(GRIT_CONTACT_BODY_A, block, sides[0]);
    add(GRIT_CONTACT_BODY_B, ground, wide[0]);
    grit_contact_distances distances{};
    distances.struct_size = sizeof distances;
    distances.distance = out(grid.distance, 1);
    distances.gap = out(grid.gap, 1);
    call(grit_contact_surfaces_finish, &surfaces, nodes, &distances);
}

// One step of Geo-contact against the ground; the totals tell its force.
grit_contact_totals press(Grid& grid) {
    static const double spacing[3] = {h, h, h};
    grit_contact_options options{};
    grit_contact_options_init(&options, sizeof options);
    options.friction_coefficient = mu;
    options.time_step = dt;
    options.rigid = GRIT_CONTACT_B_RIGID;
    grit_contact_nodes at{};
    at.struct_size = sizeof at;
    at.mass_a = view(grid.mass, 1);
    at.mass_b = view(grid.ground_mass, 1);
    at.normal = view(grid.normal, 3);
    at.distance = view(grid.distance, 1);
    at.gap = view(grid.gap, 1);
    at.spacing = grit_view_of(spacing, 0, 1);
    at.velocity_a = out(grid.velocity, 3);
    at.velocity_b = out(grid.at_rest, 3);
    static grit_contact_sums sums;
    sums = {};
    call(grit_contact_correct, &options, nodes, &at, static_cast<grit_contact_report*>(nullptr),
         &sums);
    grit_contact_totals totals{};
    totals.struct_size = sizeof totals;
    grit_contact_sums_read(&sums, &totals);
    return totals;
}

}  // namespace

int main() {
    // 6 x 6 x 4 particles, two a cell and direction: a block of 0.3 x 0.3 x 0.2 m that touches the ground.
    std::vector<Vector> block;
    for (std::ptrdiff_t i = 0; i < 6 * 6 * 4; ++i) {
        const Vector place = place_of(i, 6, 6);
        block.push_back({0.2 + h / 2 * (place[0] + 0.5), 0.2 + h / 2 * (place[1] + 0.5),
                         h + h / 2 * (place[2] + 0.5)});
    }
    const Vector g{gravity * std::sin(slope) * downhill[0], gravity * std::sin(slope) * downhill[1],
                   -gravity * std::cos(slope)};
    const double mass = mass_of_particle * static_cast<double>(block.size());
    Grid grid;
    Vector v{};
    double normal_force = 0.0;
    constexpr int steps = 3000, settled = 1500;  // the force is a mean from then on
    for (int step = 0; step < steps; ++step) {
        // Particles to nodes: all have the velocity of the block.
        grid.mass.assign(grid.mass.size(), 0.0);
        for (const Vector& x : block) {
            const Cell cell(x);
            for (std::size_t k = 0; k < 8; ++k)
                grid.mass[static_cast<std::size_t>(cell.node[k])] +=
                    cell.weight[k] * mass_of_particle;
        }
        for (Vector& each : grid.velocity)
            for (std::size_t c = 0; c < 3; ++c) each[c] = v[c] + dt * g[c];
        measure(grid, block);
        const grit_contact_totals totals = press(grid);
        // Back to the block, which is rigid and does not turn.
        v = {};
        for (std::size_t i = 0; i < grid.mass.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c) v[c] += grid.mass[i] * grid.velocity[i][c] / mass;
        for (Vector& x : block)
            for (std::size_t c = 0; c < 3; ++c) x[c] += dt * v[c];
        if (step >= settled) normal_force -= totals.force_on_b[2] / (steps - settled);
    }
    const double t = steps * dt;
    std::printf("after %.2f s: %.4f m/s downhill, by Coulomb's law %.4f; across the slope %.1e\n",
                t, v[0] * downhill[0] + v[1] * downhill[1],
                gravity * (std::sin(slope) - mu * std::cos(slope)) * t,
                v[0] * downhill[1] - v[1] * downhill[0]);
    std::printf("mean force on the ground %.2f N, the weight across it %.2f N\n", normal_force,
                mass * gravity * std::cos(slope));
}
