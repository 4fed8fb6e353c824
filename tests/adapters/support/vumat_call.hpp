// SPDX-License-Identifier: BSD-3-Clause
// One call of vumat_ as Abaqus/Explicit makes it: arrays over a block of points, x(nblock, ...).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

extern "C" {
typedef void (*VumatFunction)(const int*, const int*, const int*, const int*, const int*,
                              const int*, const int*, const double*, const double*, const double*,
                              const char*, const double*, const double*, const double*,
                              const double*, const double*, const double*, const double*,
                              const double*, const double*, const double*, const double*,
                              const double*, const double*, const double*, const double*,
                              const double*, const double*, const double*, double*, double*,
                              double*, double*, std::size_t);
}

// x(block, size), with canaries at both ends.
class BlockArray {
  public:
    BlockArray(int block, int size, double fill);

    double* data() { return memory.data() + margin; }
    double& operator()(int point, int component) { return memory[at(point, component)]; }
    double operator()(int point, int component) const { return memory[at(point, component)]; }
    bool intact() const;
    bool operator==(const BlockArray& other) const;  // same bits

  private:
    static constexpr std::size_t margin = 8;
    std::size_t at(int point, int component) const {
        return margin + static_cast<std::size_t>(point + block * component);
    }
    int block;
    std::vector<double> memory;
};

// Hochstetten sand (kPa) at p = 100 kPa, e = 0.70, h = 0 in every point; new arrays hold rubbish.
struct VumatCall {
    explicit VumatCall(int nblock, int shears = 3, int nstatev = 14);

    int nblock, ndir = 3, nshr, nstatev, nprops = 16;
    double step_time = 1e-3, total_time = 1e-3;
    std::string missing;  // the name of an argument that is null
    std::vector<double> props, density;
    BlockArray strain_inc, rel_spin_inc, stretch, defgrad, stress_old, state_old, intern_old,
        inelas_old, stress_new, state_new, intern_new, inelas_new;

    void run(VumatFunction function);
    void run();
    // run() with a library that has said nothing yet: what it writes to stderr.
    std::string complaint();
    // What is new becomes old, for the next increment.
    void advance();
    // PROPS(17), which is not there without this.
    void set_tolerance(double tolerance);
    void set_water(double K_w, double largest_tension, double itself);  // as of a UmatCall
    // Strain increment of a point: 11 22 33 12 13 23 with engineering shear, as a UMAT takes it.
    void set_strain(int point, const double* d);
    // Stress of a point in the same order.
    std::vector<double> stress(int point) const;
    bool in_bounds() const;
};
