// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/case/closed_surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "adapters/mpm/step/text.hpp"

namespace grit::mpm {
namespace {

using Corner = std::array<double, 3>;
Corner corner_of(const Vector3& x) { return {x[0], x[1], x[2]}; }

std::string place_of(const Corner& x) {
    return "(" + text(x[0]) + ", " + text(x[1]) + ", " + text(x[2]) + ") m";
}

// The volume of the tetrahedron over a place.
double volume_over(const Vector3& place, const ClosedSurface::Triangle& t) {
    const Vector3 a = t[0] - place, b = t[1] - place, c = t[2] - place;
    double sum = 0.0;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        sum += a[i] * (b[j] * c[k] - b[k] * c[j]);
    }
    return sum / 6.0;
}

// Twice the area of a, b and (x, y), from the same two corners in the same order for both neighbours of an edge, so that
// no place falls between them or into both.
double side_of(const Vector3& a, const Vector3& b, double x, double y) {
    const bool ordered = corner_of(a) < corner_of(b);
    const Vector3 &p = ordered ? a : b, &q = ordered ? b : a;
    const double area = (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]);
    return ordered ? area : -area;
}

// Is the triangle above the place, 1 with its outer side up and -1 with that down; 0: it is not. An edge belongs to the side of
// positive areas.
int above(const ClosedSurface::Triangle& t, const Vector3& at) {
    double side[3];
    for (std::size_t i = 0; i < 3; ++i)
        side[i] = side_of(t[(i + 1) % 3], t[(i + 2) % 3], at[0], at[1]);
    const auto positive = [&t](std::size_t i, double area) {
        const Vector3 &a = t[(i + 1) % 3], &b = t[(i + 2) % 3];
        return area > 0.0 || (area == 0.0 && corner_of(a) < corner_of(b));
    };
    const bool first = positive(0, side[0]);
    if (positive(1, side[1]) != first || positive(2, side[2]) != first) return 0;
    const double sum = side[0] + side[1] + side[2];
    if (sum == 0.0) return 0;
    const double z = (side[0] * t[0][2] + side[1] * t[1][2] + side[2] * t[2][2]) / sum;
    if (!(z > at[2])) return 0;
    return first ? 1 : -1;
}

// Which triangles hang together by their corners.
class Shells {
  public:
    explicit Shells(const std::vector<ClosedSurface::Triangle>& triangles) {
        for (const ClosedSurface::Triangle& t : triangles) {
            std::size_t corner[3];
            for (std::size_t i = 0; i < 3; ++i) {
                const auto [place, is_new] = number.insert({corner_of(t[i]), leader.size()});
                if (is_new) leader.push_back(leader.size());
                corner[i] = place->second;
            }
            for (std::size_t i : {1, 2}) join(corner[0], corner[i]);
            first_corner.push_back(corner[0]);
        }
    }
    // The same for all triangles of a shell.
    std::size_t of(std::size_t triangle) { return leader_of(first_corner[triangle]); }

  private:
    std::size_t leader_of(std::size_t i) {
        while (leader[i] != i) i = leader[i] = leader[leader[i]];
        return i;
    }
    void join(std::size_t i, std::size_t j) { leader[leader_of(i)] = leader_of(j); }

    std::map<Corner, std::size_t> number;
    std::vector<std::size_t> leader, first_corner;
};

}  // namespace

ClosedSurface::ClosedSurface(std::vector<Triangle> of) : triangles(std::move(of)) {
    if (triangles.empty()) throw std::invalid_argument("a surface of no triangles");
    least = most = triangles[0][0];
    for (const Triangle& t : triangles)
        for (const Vector3& x : t)
            for (int d = 0; d < 3; ++d) {
                if (!std::isfinite(x[d]))
                    throw std::invalid_argument("a corner of a surface that is no number");
                least[d] = std::min(least[d], x[d]);
                most[d] = std::max(most[d], x[d]);
            }
    check_edges();
    sort_into_columns();
    turn_outward();
    const Vector3 size = most - least;
    if (!(enclosed > 1e-9 * size[0] * size[1] * size[2]))
        throw std::invalid_argument("a surface that encloses nothing");
}

// A shell that faces inward is a cavity where it lies within others, and else inside out. So is all of the file where what it
// encloses is less than nothing.
void ClosedSurface::turn_outward() {
    Shells shells(triangles);
    std::map<std::size_t, std::vector<std::size_t>> of_shell;
    for (std::size_t i = 0; i < triangles.size(); ++i) of_shell[shells.of(i)].push_back(i);
    const auto volume_of = [this](const std::vector<std::size_t>& shell) {
        const Vector3 place = triangles[shell.front()][0];
        double sum = 0.0;
        for (const std::size_t i : shell) sum += volume_over(place, triangles[i]);
        return sum;
    };
    const auto turn = [this](const std::vector<std::size_t>& shell) {
        for (const std::size_t i : shell) std::swap(triangles[i][1], triangles[i][2]);
    };
    double largest = 0.0;
    for (const auto& [shell, of] : of_shell)
        if (const double volume = volume_of(of); std::fabs(volume) > std::fabs(largest))
            largest = volume;
    if (largest < 0.0)
        for (const auto& [shell, of] : of_shell) turn(of);
    for (const auto& [shell, of] : of_shell) {
        if (!(volume_of(of) < 0.0)) continue;
        const Vector3& place = triangles[of.front()][0];
        int around = 0;
        const std::size_t c = column(place);
        for (std::size_t i = first[c]; i < first[c + 1]; ++i)
            if (shells.of(order[i]) != shell) around += above(triangles[order[i]], place);
        if (around == 0) turn(of);
    }
    for (const auto& [shell, of] : of_shell) enclosed += volume_of(of);
}

void ClosedSurface::check_edges() const {
    std::map<std::pair<Corner, Corner>, int> along;  // less those against it
    for (const Triangle& t : triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const Corner a = corner_of(t[i]), b = corner_of(t[(i + 1) % 3]);
            if (a < b) ++along[{a, b}];
            else if (b < a) --along[{b, a}];
        }
    for (const auto& [edge, count] : along)
        if (count != 0)
            throw std::invalid_argument("a surface that is not closed: the edge from " +
                                        place_of(edge.first) + " to " + place_of(edge.second) +
                                        " has no triangle on one of its sides");
}

std::size_t ClosedSurface::column(double x, int d) const {
    const auto k = static_cast<std::size_t>(d);
    const double share = (x - least[d]) / (most[d] - least[d]);
    const double place = std::floor(share * static_cast<double>(columns[k]));
    return std::min(columns[k] - 1, static_cast<std::size_t>(std::max(0.0, place)));
}

std::size_t ClosedSurface::column(const Vector3& x) const {
    return column(x[1], 1) * columns[0] + column(x[0], 0);
}

// work(column) of each that a triangle's shadow reaches, row by row: all of those around a sliver would be as many as
// there are. What rounding may do to a place is beside it.
template <class Work> void ClosedSurface::each_column(const Triangle& t, const Work& work) const {
    const double beside[2] = {1e-9 * (most[0] - least[0]), 1e-9 * (most[1] - least[1])};
    const auto [low, high] = std::minmax({t[0][1], t[1][1], t[2][1]});
    const double height = (most[1] - least[1]) / static_cast<double>(columns[1]);
    const std::size_t last = column(high + beside[1], 1);
    for (std::size_t j = column(low - beside[1], 1); j <= last; ++j) {
        const double floor = least[1] + static_cast<double>(j) * height - beside[1];
        const double ceiling = floor + height + 2.0 * beside[1];
        double from = most[0], to = least[0];
        const auto reach = [&](double x) {
            from = std::min(from, x);
            to = std::max(to, x);
        };
        for (std::size_t i = 0; i < 3; ++i) {
            const Vector3 &p = t[i], &q = t[(i + 1) % 3];
            if (p[1] >= floor && p[1] <= ceiling) reach(p[0]);
            for (const double y : {floor, ceiling})
                if ((p[1] < y) != (q[1] < y))
                    reach(p[0] + (y - p[1]) / (q[1] - p[1]) * (q[0] - p[0]));
        }
        if (!(from <= to)) continue;
        const std::size_t end = column(to + beside[0], 0);
        for (std::size_t i = column(from - beside[0], 0); i <= end; ++i) work(j * columns[0] + i);
    }
}

// About as many columns as triangles, fewer where these are so long that they would be listed too often.
void ClosedSurface::sort_into_columns() {
    constexpr std::size_t most_listed = 32;  // times a triangle, on average
    auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(triangles.size())));
    side = std::clamp<std::size_t>(side, 1, 2000);
    for (;; side = (side + 1) / 2) {
        columns[0] = columns[1] = side;
        first.assign(side * side + 1, 0);
        std::size_t listed = 0;
        for (const Triangle& t : triangles) {
            each_column(t, [&](std::size_t c) {
                ++first[c + 1];
                ++listed;
            });
            if (side > 1 && listed > most_listed * triangles.size()) break;
        }
        if (side == 1 || listed <= most_listed * triangles.size()) break;
    }
    for (std::size_t c = 1; c < first.size(); ++c) first[c] += first[c - 1];
    order.resize(first.back());
    std::vector<std::size_t> next = first;
    for (std::size_t i = 0; i < triangles.size(); ++i)
        each_column(triangles[i], [&](std::size_t c) { order[next[c]++] = i; });
}

bool ClosedSurface::has(const Vector3& x) const {
    for (int d = 0; d < 3; ++d)
        if (!(x[d] >= least[d] && x[d] <= most[d])) return false;
    const std::size_t c = column(x);
    int around = 0;
    for (std::size_t i = first[c]; i < first[c + 1]; ++i) around += above(triangles[order[i]], x);
    return around != 0;
}

namespace {

constexpr std::size_t most_triangles = 10'000'000, binary_head = 84, binary_triangle = 50;

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what) {
    throw std::invalid_argument(file.filename().string() + ": " + what);
}

template <class Number> Number number_at(const std::string& bytes, std::size_t at) {
    Number out;
    std::memcpy(&out, bytes.data() + at, sizeof out);
    return out;
}

// A binary file may begin with "solid" as well; its length gives it away.
bool is_binary(const std::string& bytes) {
    return bytes.size() >= binary_head &&
           bytes.size() ==
               binary_head +
                   binary_triangle * std::size_t{number_at<std::uint32_t>(bytes, binary_head - 4)};
}

std::vector<ClosedSurface::Triangle> triangles_of_bytes(const std::string& bytes) {
    std::vector<ClosedSurface::Triangle> out((bytes.size() - binary_head) / binary_triangle);
    std::size_t at = binary_head;
    for (ClosedSurface::Triangle& t : out) {
        at += 3 * sizeof(float);  // its normal
        for (Vector3& x : t)
            for (int d = 0; d < 3; ++d, at += sizeof(float)) x[d] = number_at<float>(bytes, at);
        at += 2;
    }
    return out;
}

std::vector<ClosedSurface::Triangle> triangles_of_text(const std::filesystem::path& file,
                                                       const std::string& bytes) {
    std::istringstream in(bytes);
    std::string word;
    in >> word;
    if (word != "solid")
        fail(file, "is no STL file: it neither begins with solid nor has the length that a binary "
                   "one says");
    std::vector<ClosedSurface::Triangle> out;
    ClosedSurface::Triangle t;
    for (std::size_t corner = 0; in >> word;) {
        if (word == "facet" && corner % 3 != 0) fail(file, "a facet of fewer than three corners");
        if (word != "vertex") continue;
        Vector3& x = t[corner % 3];
        if (!(in >> x[0] >> x[1] >> x[2]))
            fail(file, "corner " + std::to_string(corner + 1) + " has not three numbers");
        if (++corner % 3 == 0) out.push_back(t);
    }
    return out;
}

}  // namespace

std::string stl_text(const ClosedSurface& surface) {
    std::ostringstream out;
    out.precision(17);
    out << "solid grit\n";
    for (const ClosedSurface::Triangle& t : surface.outward()) {
        out << "facet normal 0 0 0\nouter loop\n";  // those who want a normal have its corners
        for (const Vector3& x : t) out << "vertex " << x[0] << ' ' << x[1] << ' ' << x[2] << '\n';
        out << "endloop\nendfacet\n";
    }
    out << "endsolid grit\n";
    return out.str();
}

std::string stl_bytes(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) fail(file, "cannot be read");
    std::error_code unknown;
    const auto size = std::filesystem::file_size(file, unknown);
    if (unknown) fail(file, "is no file");
    constexpr std::size_t longest = std::size_t{1} << 30;
    if (size > longest) fail(file, "is longer than 1024 MiB, the most that is read");
    return {std::istreambuf_iterator<char>(in), {}};
}

ClosedSurface surface_of_stl(const std::string& bytes, const std::filesystem::path& file,
                             double unit, const Vector3& moved) {
    auto triangles = is_binary(bytes) ? triangles_of_bytes(bytes) : triangles_of_text(file, bytes);
    if (triangles.size() > most_triangles)
        fail(file, "has " + std::to_string(triangles.size()) + " triangles, at most " +
                       std::to_string(most_triangles) + " are possible");
    for (ClosedSurface::Triangle& t : triangles)
        for (Vector3& x : t) x = unit * x + moved;
    try {
        return ClosedSurface(std::move(triangles));
    } catch (const std::invalid_argument& error) {
        fail(file, error.what());
    }
}

ClosedSurface read_stl(const std::filesystem::path& file, double unit, const Vector3& moved) {
    return surface_of_stl(stl_bytes(file), file, unit, moved);
}

}  // namespace grit::mpm
