// SPDX-License-Identifier: BSD-3-Clause
// Columns of numbers of particles, as a structure of arrays, and their ids: in the plane and in space.
#pragma once

#include <cstddef>
#include <vector>

namespace grit::mpm {

class ParticleColumns {
  public:
    // What processes hand to each other: all columns of a particle with its id. The last particle takes the
    // place of one that is removed.
    void add(int of_id, const double* row);
    void remove(std::ptrdiff_t p);

    std::ptrdiff_t size() const { return count; }
    int column_count() const { return columns; }
    const int* ids() const { return id.data(); }
    double operator()(int c, std::ptrdiff_t p) const {
        return data[static_cast<std::size_t>(c * stride + p)];
    }

    // Particle order[p] becomes particle p. Allocates on its first call only.
    void permute(const std::vector<int>& order);

    template <class Self, class Archive> static void visit(Self& particles, Archive& archive) {
        archive.ids(particles.id);
        for (int c = 0; c < particles.columns; ++c)
            archive.own(particles.data.data() + c * particles.stride,
                        static_cast<std::size_t>(particles.count));
    }

  protected:
    explicit ParticleColumns(int all_columns) : columns(all_columns) {}
    // Place of one more particle, whose id is the order of adding.
    std::ptrdiff_t append();
    void grow();

    int columns;
    std::ptrdiff_t count = 0, stride = 0;  // column c of particle p is data[c * stride + p]
    std::vector<double> data, spare;
    std::vector<int> id, spare_id;
};

}  // namespace grit::mpm
