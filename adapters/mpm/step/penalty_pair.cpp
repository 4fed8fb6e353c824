// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/penalty_pair.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "adapters/mpm/grid/grid_point.hpp"
#include "adapters/mpm/step/require.hpp"
#include "adapters/mpm/step/text.hpp"

namespace grit::mpm {
namespace {

// Weights of a vertex at the nodes that its body has mass at: their sum is 1, or 0 where there is none.
GridPoint point_of_body(const GridView& grid, const PenaltyBody& body, const double* x) {
    GridPoint at = grid_point(grid, x[0], x[1]);
    if (body.rigid) return at;
    double sum = 0.0;
    for (int i = 0; i < 4; ++i) {
        if (!(body.records[at.node[i]][record::m] > body.least_mass)) at.N[i] = 0.0;
        sum += at.N[i];
    }
    for (double& N : at.N) N = sum > 0.0 ? N / sum : 0.0;
    return at;
}

double length(const std::vector<double>& x, std::size_t from, std::size_t to) {
    return std::hypot(x[2 * to] - x[2 * from], x[2 * to + 1] - x[2 * from + 1]);
}

}  // namespace

PenaltyLaw penalty_law(double friction_coefficient, double multiple, double modulus, double cell) {
    PenaltyLaw law;
    grit_penalty_options_init(&law.options, sizeof law.options);
    law.options.friction_coefficient = friction_coefficient;
    law.options.depth_max = cell;
    if (grit_penalty_stiffness(multiple, modulus, cell, &law.options.normal_stiffness) != GRIT_OK)
        throw std::invalid_argument(
            "penalty contact: no stiffness of this modulus [Pa] and cell [m]");
    law.longest = cell;
    law.shortest = 0.2 * cell;
    return law;
}

PenaltyPair::PenaltyPair(const PenaltyLaw& law, bool axisymmetric, std::size_t nodes)
    : pair_law(law), nodal_stiffness(nodes), step_totals{}, next_totals{} {
    next_totals.struct_size = step_totals.struct_size = sizeof step_totals;
    pair_law.options.axisymmetric = axisymmetric;
    for (const int k : {0, 1}) {
        const BoundaryLine& given = k == 0 ? law.line_a : law.line_b;
        for (const Vector2& x : given.points)
            lines[k].position.insert(lines[k].position.end(), {x[0], x[1]});
        lines[k].closed = given.closed;
        lines[k].velocity.resize(lines[k].position.size());
        lines[k].history.resize(lines[k].position.size());
        remesh(lines[k]);
        lines[k].force.resize(lines[k].position.size());
        lines[k].stiffness.resize(lines[k].position.size() / 2);
    }
}

grit_penalty_surface PenaltyPair::surface(Line& line) {
    line.force.assign(line.position.size(), 0.0);
    line.stiffness.assign(line.position.size() / 2, 0.0);
    grit_penalty_surface s{};
    s.struct_size = sizeof s;
    s.closed = line.closed;
    s.count = line.count();
    s.position = grit_view_of(line.position.data(), 2, 1);
    s.velocity = grit_view_of(line.velocity.data(), 2, 1);
    s.history = grit_mutable_view_of(line.history.data(), 2, 1);
    s.force = grit_mutable_view_of(line.force.data(), 2, 1);
    s.stiffness = grit_mutable_view_of(line.stiffness.data(), 1, 1);
    return s;
}

void PenaltyPair::find_forces(double dt) {
    dt_before = dt;
    pair_law.options.time_step = dt > 0.0 ? dt : 1.0;  // at the start nothing has moved yet
    const grit_penalty_surface line_a = surface(lines[0]), line_b = surface(lines[1]);
    const std::size_t bytes = grit_penalty_workspace_size(line_a.count, line_b.count);
    workspace.resize(bytes / sizeof(std::uint64_t) + 1);
    grit_error error;
    require(grit_penalty_forces(&pair_law.options, &line_a, &line_b, workspace.data(), bytes,
                                &next_totals, &error),
            error, "penalty contact");
}

void PenaltyPair::find_step(const GridView& grid, const PenaltyBody& a, const PenaltyBody& b) {
    check_mass(grid, a, b, Vertices::pressed);
    find_stiffness(grid, lines[0], a, mass[0], stiffness[0]);
    find_stiffness(grid, lines[1], b, mass[1], stiffness[1]);
    grit_error error;
    const auto view = [](const std::vector<double>& x) { return grit_view_of(x.data(), 1, 1); };
    const grit_view m_a = view(mass[0]), m_b = view(mass[1]);
    const grit_view k_a = view(stiffness[0]), k_b = view(stiffness[1]);
    require(grit_penalty_stable_step(static_cast<std::ptrdiff_t>(mass[0].size()), &m_a, &k_a,
                                     static_cast<std::ptrdiff_t>(mass[1].size()), &m_b, &k_b, &step,
                                     &error),
            error, "penalty contact");
}

void PenaltyPair::check_mass(const GridView& grid, const PenaltyBody& a, const PenaltyBody& b,
                             Vertices which) const {
    for (const int k : {0, 1}) {
        const PenaltyBody& body = k == 0 ? a : b;
        const Line& line = lines[k];
        for (std::size_t v = 0; v < line.position.size() && !body.rigid; v += 2) {
            if (which == Vertices::pressed && !(line.stiffness[v / 2] > 0.0)) continue;
            const GridPoint at = point_of_body(grid, body, &line.position[v]);
            if (at.N[0] + at.N[1] + at.N[2] + at.N[3] > 0.0) continue;
            throw std::runtime_error("penalty contact of " + a.name + " and " + b.name +
                                     ": vertex " + std::to_string(v / 2) + " of the line of " +
                                     body.name + ", at " +
                                     place_text(line.position[v], line.position[v + 1]) +
                                     ", is in a cell where no node has mass of this body: "
                                     "nothing would take its force of " +
                                     text(std::hypot(line.force[v], line.force[v + 1])) +
                                     " N, or move it; does the line follow the body's surface?");
        }
    }
}

void PenaltyPair::push(const GridView& grid, const PenaltyBody& a, const PenaltyBody& b) {
    check_mass(grid, a, b, Vertices::pressed);
    step_totals = next_totals;
    for (const int k : {0, 1}) step_faces[k] = faces_of(lines[k]);
    scatter(grid, lines[0], a);
    scatter(grid, lines[1], b);
}

Faces PenaltyPair::faces_of(const Line& line) {
    Faces out;
    for (std::size_t v = 0; v < line.force.size(); v += 2) {
        const double f_r = line.force[v], f_z = line.force[v + 1];
        Vector2& face = std::fabs(f_r) > std::fabs(f_z) ? out.along_r : out.along_z;
        face[0] += f_r;
        face[1] += f_z;
    }
    return out;
}

// Forces to the nodes.
void PenaltyPair::scatter(const GridView& grid, const Line& line, const PenaltyBody& body) {
    if (body.rigid) return;
    for (std::size_t v = 0; v < line.stiffness.size(); ++v) {
        if (!(line.stiffness[v] > 0.0)) continue;
        const GridPoint at = point_of_body(grid, body, &line.position[2 * v]);
        for (int i = 0; i < 4; ++i) {
            NodeRecord& n = body.records[at.node[i]];
            n[record::f_r] += at.N[i] * line.force[2 * v];
            n[record::f_z] += at.N[i] * line.force[2 * v + 1];
        }
    }
}

// Mass and stiffness of the nodes that any vertex in contact touches.
void PenaltyPair::find_stiffness(const GridView& grid, const Line& line, const PenaltyBody& body,
                                 std::vector<double>& touched_mass, std::vector<double>& touched) {
    touched_mass.clear();
    touched.clear();
    if (body.rigid) return;
    for (std::size_t v = 0; v < line.stiffness.size(); ++v) {
        if (!(line.stiffness[v] > 0.0)) continue;
        const GridPoint at = point_of_body(grid, body, &line.position[2 * v]);
        for (int i = 0; i < 4; ++i)
            nodal_stiffness[static_cast<std::size_t>(at.node[i])] += at.N[i] * line.stiffness[v];
    }
    for (std::size_t v = 0; v < line.stiffness.size(); ++v) {
        if (!(line.stiffness[v] > 0.0)) continue;
        const GridPoint at = point_of_body(grid, body, &line.position[2 * v]);
        for (const std::ptrdiff_t node : at.node) {
            double& k = nodal_stiffness[static_cast<std::size_t>(node)];
            if (k > 0.0) {
                touched_mass.push_back(body.records[node][record::m]);
                touched.push_back(k);
            }
            k = 0.0;
        }
    }
}

void PenaltyPair::move(const GridView& grid, const PenaltyBody& a, const PenaltyBody& b,
                       double dt) {
    check_mass(grid, a, b, Vertices::all);
    taken = -advance(grid, a, dt, lines[0]) - advance(grid, b, dt, lines[1]);
    check_place(grid, a, b);
    remesh(lines[0]);
    remesh(lines[1]);
}

// A body whose stresses are no numbers takes its line along before any sum of energies says so.
void PenaltyPair::check_place(const GridView& grid, const PenaltyBody& a,
                              const PenaltyBody& b) const {
    const auto is_near = [](const AxisView& axis, double x) {
        const double first = axis.node[0], last = axis.node[axis.cells];
        return x >= 2.0 * first - last && x <= 2.0 * last - first;
    };
    for (const int k : {0, 1})
        for (std::size_t v = 0; v < lines[k].position.size(); v += 2) {
            const double r = lines[k].position[v], z = lines[k].position[v + 1];
            if (is_near(grid.r, r) && is_near(grid.z, z)) continue;
            throw std::runtime_error("penalty contact of " + a.name + " and " + b.name +
                                     ": vertex " + std::to_string(v / 2) + " of the line of " +
                                     (k == 0 ? a : b).name + " has moved to " + place_text(r, z) +
                                     ", off the grid; is cfl too large?");
        }
}

// Returns the work of the forces on the body: half on the way to where they act, half on the way on.
double PenaltyPair::advance(const GridView& grid, const PenaltyBody& body, double dt,
                            Line& line) const {
    double work = 0.0;
    for (std::size_t v = 0; v < line.position.size(); v += 2) {
        const GridPoint at = point_of_body(grid, body, &line.position[v]);
        double now[2] = {};
        for (int i = 0; i < 4; ++i)
            for (int c : {0, 1}) now[c] += at.N[i] * body.motions[at.node[i]][motion::v_r + c];
        for (std::size_t c = 0; c < 2; ++c) {
            work += 0.5 * line.force[v + c] * (dt_before * line.velocity[v + c] + dt * now[c]);
            line.velocity[v + c] = now[c];
            line.position[v + c] += dt * now[c];
        }
    }
    return work;
}

// Split what has become longer than the longest segment, merge what is shorter than the shortest.
void PenaltyPair::remesh(Line& line) {
    if (!(pair_law.longest > 0.0)) return;
    const std::size_t n = line.position.size() / 2, segments = line.closed ? n : n - 1;
    double total = 0.0;
    bool fits = true;
    for (std::size_t s = 0; s < segments; ++s) {
        const double l = length(line.position, s, (s + 1) % n);
        total += l;
        fits = fits && l <= pair_law.longest && l >= pair_law.shortest;
    }
    if (fits) return;
    const auto capacity = n + segments + static_cast<std::size_t>(2.0 * total / pair_law.longest);
    spare.position.resize(2 * capacity);
    spare.velocity.resize(2 * capacity);
    spare.history.resize(2 * capacity);
    parents.resize(2 * capacity);
    weight.resize(capacity);
    grit_penalty_remeshing r{};
    r.struct_size = sizeof r;
    r.closed = line.closed;
    r.longest = pair_law.longest;
    r.shortest = pair_law.shortest;
    r.tolerance = 0.5 * pair_law.shortest;
    r.count = static_cast<std::ptrdiff_t>(n);
    r.position = grit_view_of(line.position.data(), 2, 1);
    r.history = grit_view_of(line.history.data(), 2, 1);
    r.capacity = static_cast<std::ptrdiff_t>(capacity);
    r.new_position = grit_mutable_view_of(spare.position.data(), 2, 1);
    r.new_history = grit_mutable_view_of(spare.history.data(), 2, 1);
    r.parents = parents.data();
    r.weight = weight.data();
    const std::size_t bytes = grit_penalty_remesh_workspace_size(r.count);
    workspace.resize(bytes / sizeof(std::uint64_t) + 1);
    std::ptrdiff_t count = 0;
    grit_error error;
    require(grit_penalty_remesh(&r, workspace.data(), bytes, &count, &error), error,
            "penalty contact");
    const auto size = 2 * static_cast<std::size_t>(count);
    for (std::size_t v = 0; v < size; ++v) {
        const auto old = [&](std::size_t end) {
            return line.velocity[2 * static_cast<std::size_t>(parents[(v & ~1u) + end]) + (v & 1u)];
        };
        const double w = weight[v / 2];
        spare.velocity[v] = (1.0 - w) * old(0) + w * old(1);
    }
    spare.position.resize(size);
    spare.velocity.resize(size);
    spare.history.resize(size);
    line.position.swap(spare.position);
    line.velocity.swap(spare.velocity);
    line.history.swap(spare.history);
}

}  // namespace grit::mpm
