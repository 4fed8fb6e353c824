// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/space/step/free_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "adapters/mpm/space/kernel/place.hpp"

namespace grit::mpm::space {
namespace {

constexpr double tolerance = 0.25;  // share of a width: domains no farther apart leave no free face

// Corner c of a domain: bit k says on which side along r_k.
Vector3 corner_of_domain(const NearDomain& q, int c) {
    Vector3 out = q.x;
    for (int k = 0; k < 3; ++k) out = out + (c >> k & 1 ? 1.0 : -1.0) * q.r[k];
    return out;
}

}  // namespace

void FreeFaces::list(const GridView& grid, const std::vector<NearDomain>& domains) {
    const std::size_t n = domains.size();
    cell_of.resize(n);
    covering.resize(n);
    largest = {0.0, 0.0, 0.0};
    for (std::size_t i = 0; i < n; ++i) {
        const NearDomain& q = domains[i];
        const baseline::Domain a = baseline::reciprocal({{q.r[0], q.r[1], q.r[2]}});
        Covering& of = covering[i];
        of.x = q.x;
        double shortest = norm(q.r[0]);
        for (int k = 0; k < 3; ++k) {
            of.a[k] = a.r[k];
            of.extent[k] = std::fabs(q.r[0][k]) + std::fabs(q.r[1][k]) + std::fabs(q.r[2][k]);
            largest[k] = std::max(largest[k], of.extent[k]);
            shortest = std::min(shortest, norm(q.r[k]));
        }
        of.near = tolerance * 2.0 * shortest;
        cell_of[i] = grid.cell_of(q.x);
    }
    sort_by_cells(grid);
}

void FreeFaces::sort_by_cells(const GridView& grid) {
    const std::ptrdiff_t along_x = grid.axis[0].cells, along_y = grid.axis[1].cells;
    by_cell.resize(cell_of.size());
    std::iota(by_cell.begin(), by_cell.end(), 0);
    const auto cell = [this](std::ptrdiff_t i) { return cell_of[static_cast<std::size_t>(i)]; };
    std::sort(by_cell.begin(), by_cell.end(), [&](std::ptrdiff_t i, std::ptrdiff_t j) {
        return cell(i) != cell(j) ? cell(i) < cell(j) : i < j;
    });
    for (const int k : {0, 1}) first_row[k] = std::numeric_limits<int>::max(), last_row[k] = -1;
    for (const std::ptrdiff_t of : cell_of)
        for (const int k : {0, 1}) {
            const auto at =
                static_cast<int>(k == 0 ? of / along_x % along_y : of / along_x / along_y);
            first_row[k] = std::min(first_row[k], at);
            last_row[k] = std::max(last_row[k], at);
        }
    first_of_row.clear();
    auto next = by_cell.begin();
    for (int z = first_row[1]; z <= last_row[1]; ++z)
        for (int y = first_row[0]; y <= last_row[0]; ++y) {
            const std::ptrdiff_t begin = grid.cell(0, y, z);
            while (next != by_cell.end() && cell(*next) < begin) ++next;
            first_of_row.push_back(next - by_cell.begin());
        }
    first_of_row.push_back(static_cast<std::ptrdiff_t>(by_cell.size()));
}

// Domains whose boxes are no farther away than a place outside of a face is.
void FreeFaces::find_neighbours(const GridView& grid, std::ptrdiff_t i) {
    neighbours.clear();
    const Covering& own = covering[static_cast<std::size_t>(i)];
    const Vector3 about = (1.0 + 2.0 * tolerance) * own.extent;
    int first[3], last[3];
    for (int d = 0; d < 3; ++d) {
        const AxisView& axis = grid.axis[d];
        const double reach = about[d] + largest[d];
        first[d] = axis.cell_of(std::max(own.x[d] - reach, axis.node[0]));
        last[d] = axis.cell_of(std::min(own.x[d] + reach, axis.node[axis.cells]));
    }
    const int rows = last_row[0] - first_row[0] + 1;
    const auto is_before = [this](std::ptrdiff_t domain, std::ptrdiff_t cell) {
        return cell_of[static_cast<std::size_t>(domain)] < cell;
    };
    for (int z = std::max(first[2], first_row[1]); z <= std::min(last[2], last_row[1]); ++z)
        for (int y = std::max(first[1], first_row[0]); y <= std::min(last[1], last_row[0]); ++y) {
            const auto row = static_cast<std::size_t>((z - first_row[1]) * rows + y - first_row[0]);
            const std::ptrdiff_t from = grid.cell(first[0], y, z), to = grid.cell(last[0], y, z);
            const auto end = by_cell.begin() + first_of_row[row + 1];
            for (auto at =
                     std::lower_bound(by_cell.begin() + first_of_row[row], end, from, is_before);
                 at != end && cell_of[static_cast<std::size_t>(*at)] <= to; ++at) {
                const std::ptrdiff_t other = *at;
                if (other == i) continue;
                const Covering& of = covering[static_cast<std::size_t>(other)];
                bool is_near = true;
                for (int d = 0; d < 3; ++d)
                    is_near = is_near && std::fabs(of.x[d] - own.x[d]) <= of.extent[d] + about[d];
                if (is_near) neighbours.push_back(other);
            }
        }
}

// Four places, each in the middle of a quarter of the face, outside along the other sides, as a neighbour that is skewed
// alike lies.
bool FreeFaces::is_free(const NearDomain& q, int direction, double side) const {
    const Vector3 *r = q.r, &u = r[(direction + 1) % 3], &v = r[(direction + 2) % 3];
    const Vector3 middle = q.x + (1.0 + 2.0 * tolerance) * side * r[direction];
    int covered = 0;
    for (int k = 0; k < 4; ++k) {
        const Vector3 at = middle + (k & 1 ? 0.5 : -0.5) * u + (k & 2 ? 0.5 : -0.5) * v;
        covered += std::any_of(neighbours.begin(), neighbours.end(), [&](std::ptrdiff_t other) {
            return covering[static_cast<std::size_t>(other)].has(at);
        });
    }
    return covered < 4;
}

void FreeFaces::add_face(const NearDomain& q, std::ptrdiff_t i, int direction, double side,
                         TriangleMesh& out) {
    const int d = 1 << direction, u = 1 << (direction + 1) % 3, v = 1 << (direction + 2) % 3;
    const int base = side > 0.0 ? d : 0;
    int around[4] = {base, base | u, base | u | v, base | v};
    if (side < 0.0) std::swap(around[1], around[3]);
    for (const int c : around) {
        std::ptrdiff_t& place = corner_of[static_cast<std::size_t>(c)];
        if (place < 0) {
            place = static_cast<std::ptrdiff_t>(corners.size());
            const Vector3 x = corner_of_domain(q, c);
            corners.push_back({x, i, place, 0.6 * x[0] + 0.53 * x[1] + 0.59 * x[2]});
        }
        out.middle.push_back(place);
    }
    out.domain.insert(out.domain.end(), 4, i);  // of its four triangles
}

std::ptrdiff_t FreeFaces::root(std::ptrdiff_t c) {
    const auto of = [this](std::ptrdiff_t k) -> std::ptrdiff_t& {
        return corners[static_cast<std::size_t>(k)].root;
    };
    while (of(c) != c) c = of(c) = of(of(c));
    return c;
}

// Corners of neighbours; vertices are in the order of the first of their corners.
void FreeFaces::join(TriangleMesh& out) {
    const std::size_t n = corners.size();
    order.resize(n);
    for (std::size_t i = 0; i < n; ++i) order[i] = static_cast<std::ptrdiff_t>(i);
    std::sort(order.begin(), order.end(), [this](std::ptrdiff_t i, std::ptrdiff_t j) {
        const double a = corners[static_cast<std::size_t>(i)].place;
        const double b = corners[static_cast<std::size_t>(j)].place;
        return a != b ? a < b : i < j;
    });
    for (std::size_t i = 0; i < n; ++i) {
        const Corner& one = corners[static_cast<std::size_t>(order[i])];
        const double near = covering[static_cast<std::size_t>(one.domain)].near;
        for (std::size_t j = i + 1; j < n; ++j) {
            const Corner& other = corners[static_cast<std::size_t>(order[j])];
            if (other.place - one.place > near) break;  // the direction is no longer than 1
            if (other.domain == one.domain ||
                norm(other.x - one.x) >
                    std::min(near, covering[static_cast<std::size_t>(other.domain)].near))
                continue;
            const std::ptrdiff_t a = root(order[i]), b = root(order[j]);
            corners[static_cast<std::size_t>(std::max(a, b))].root = std::min(a, b);
        }
    }
    std::vector<std::ptrdiff_t>& vertex = order;
    std::vector<double>& number = corners_of_vertex;
    number.clear();
    for (std::size_t c = 0; c < n; ++c) {
        const auto first = static_cast<std::size_t>(root(static_cast<std::ptrdiff_t>(c)));
        if (first == c) {
            vertex[c] = static_cast<std::ptrdiff_t>(number.size());
            number.push_back(0.0);
            out.position.insert(out.position.end(), 3, 0.0);
        } else {
            vertex[c] = vertex[first];
        }
        const auto v = static_cast<std::size_t>(vertex[c]);
        number[v] += 1.0;
        for (int k = 0; k < 3; ++k)
            out.position[3 * v + static_cast<std::size_t>(k)] += corners[c].x[k];
    }
    for (std::size_t k = 0; k < out.position.size(); ++k) out.position[k] /= number[k / 3];
    for (std::ptrdiff_t& corner : out.middle) corner = vertex[static_cast<std::size_t>(corner)];
    for (std::size_t f = 0; f < out.middle.size(); f += 4) {
        Vector3 x{0.0, 0.0, 0.0};
        for (std::size_t k = 0; k < 4; ++k) {
            x = x + 0.25 * out.vertex(out.middle[f + k]);
            out.facet.insert(out.facet.end(),
                             {out.middle[f + k], out.middle[f + (k + 1) % 4], out.vertices()});
        }
        out.position.insert(out.position.end(), x.c, x.c + 3);
    }
}

void FreeFaces::find(const GridView& grid, const std::vector<NearDomain>& domains,
                     TriangleMesh& out) {
    out.clear();
    corners.clear();
    list(grid, domains);
    for (std::size_t i = 0; i < domains.size(); ++i) {
        const auto place = static_cast<std::ptrdiff_t>(i);
        find_neighbours(grid, place);
        corner_of.fill(-1);
        for (int d = 0; d < 3; ++d)
            for (const double side : {-1.0, 1.0})
                if (is_free(domains[i], d, side)) add_face(domains[i], place, d, side, out);
    }
    join(out);
}

}  // namespace grit::mpm::space
