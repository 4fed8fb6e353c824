// SPDX-License-Identifier: BSD-3-Clause
// A closed surface of triangles, as STL files have them, and what lies within it: of several shells, what lies within any of them, but
// for cavities, whose shells lie within others and face the other way.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "support/vector.hpp"

namespace grit::mpm {

class ClosedSurface {
  public:
    using Triangle = std::array<Vector3, 3>;

    // Corners of neighbours are the same numbers. Throws std::invalid_argument where an edge has not as many triangles
    // along it as against it, or no volume is enclosed. Shells that are inside out are turned.
    explicit ClosedSurface(std::vector<Triangle> of);

    // On which side of the surface a place is that lies on it, rounding decides.
    bool has(const Vector3& x) const;
    const Vector3& from() const { return least; }
    const Vector3& to() const { return most; }
    // Of shells that overlap, what they share counts for each.
    double volume() const { return enclosed; }
    std::size_t size() const { return triangles.size(); }
    // How often its triangles stand in lists, which is what it takes of memory.
    std::size_t listed() const { return order.size(); }
    // Counter-clockwise as seen from outside.
    const std::vector<Triangle>& outward() const { return triangles; }

  private:
    void check_edges() const;
    void turn_outward();
    void sort_into_columns();
    template <class Work> void each_column(const Triangle& t, const Work& work) const;
    std::size_t column(double x, int d) const;
    std::size_t column(const Vector3& x) const;

    std::vector<Triangle> triangles;
    Vector3 least, most;
    double enclosed = 0.0;
    // Triangles over each rectangle of a raster in x and y: those of column c are order[first[c]] to order[first[c + 1] - 1].
    std::size_t columns[2] = {};
    std::vector<std::size_t> first, order;
};

// An STL file, binary or text, its numbers times unit [m] and then moved. Throws std::invalid_argument naming the file and
// what is wrong with it.
ClosedSurface read_stl(const std::filesystem::path& file, double unit, const Vector3& moved);
// The two halves of that, for hosts of many processes, of which one reads.
std::string stl_bytes(const std::filesystem::path& file);
ClosedSurface surface_of_stl(const std::string& bytes, const std::filesystem::path& file,
                             double unit, const Vector3& moved);
// The text of an STL file [m] that gives the same surface, to the bit.
std::string stl_text(const ClosedSurface& surface);

}  // namespace grit::mpm
