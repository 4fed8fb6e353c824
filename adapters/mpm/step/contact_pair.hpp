// SPDX-License-Identifier: BSD-3-Clause
// Contact of two bodies at the nodes, through the library.
#pragma once

#include <vector>

#include <grit/contact.h>
#include <grit/contact_distance.h>
#include <grit/contact_normals.h>

#include "adapters/mpm/kernel/exchange.hpp"
#include "adapters/mpm/kernel/nodes.hpp"
#include "adapters/mpm/step/faces.hpp"
#include "adapters/mpm/step/near_cells.hpp"
#include "adapters/mpm/step/settings.hpp"

namespace grit::mpm {

struct ContactLaw {
    std::size_t a = 0, b = 1;  // bodies; a is the stiffer one
    grit_contact_options options{};
    int normal = GRIT_CONTACT_NORMAL_OF_A;
    int measure = GRIT_CONTACT_SUPPORT;
    bool gated = true;  // by the gap
};

// GRIT_CONTACT_GEO or _FRICTIONAL.
ContactLaw contact_law(int law, double friction_coefficient,
                       double penalty_power = GRIT_CONTACT_DEFAULT_PENALTY_POWER);
// Of a multiple of modulus / cell [Pa], [m]: the Geo-contact's (C9) and the surface contact's (V8) [Pa/m].
double contact_stiffness(double multiple, double modulus, double cell);

struct ContactBody {
    const NodeRecord* records;
    NodeMotion* motions;
    ParticleView particles;
    std::ptrdiff_t count;
    bool rigid;
    const double* met_masses =
        nullptr;  // of what has these motions, where records have another one's
    grit_view mass() const {
        if (met_masses) return grit_view_of(met_masses, 1, 1);
        return grit_view_of(reinterpret_cast<const double*>(records), record::size, 1);
    }
};

class ContactPair {
  public:
    ContactPair(const ContactLaw& law, const Settings& settings, const GridView& grid,
                const std::vector<std::uint8_t>& fixed);
    // Where the bodies meet, with normals and gaps; false: nowhere.
    bool find(const GridView& grid, const ContactBody& a, const ContactBody& b, Exchange& exchange);
    // work(node, normal from a to b) for the nodes that find has found.
    template <class Work> void each_found(const Work& work) const {
        for (const std::ptrdiff_t i : active) {
            const auto node = static_cast<std::size_t>(i);
            work(node, normal_at(node));
        }
    }
    // work(node, normal, f_p) for those of them that press, after correct.
    template <class Work> void each_pressed(const Work& work) const {
        for (std::size_t i = 0; i < active.size(); ++i) {
            const auto node = static_cast<std::size_t>(active[i]);
            if (touched[node]) work(node, normal_at(node), reports[i].penalty_factor);
        }
    }
    // What pore water presses with at a node that find has found, which does not rub [N s].
    void bear(std::size_t node, double impulse) {
        pore_impulse[node] = impulse;
        bears = true;
    }
    // Velocities after the momentum update become those after contact, once they are found.
    void correct(const ContactBody& a, const ContactBody& b, double dt, Exchange& exchange);
    const ContactLaw& law() const { return pair_law; }
    // Of the last step, of all processes.
    const grit_contact_totals& totals() const { return step_totals; }
    // Forces on b by where their node's normal points, and the largest gap at a node of both bodies
    // [m], NaN: not measured.
    struct Measured : Faces {
        double largest_gap;
    };
    const Measured& faces() const { return step_faces; }
    template <class Self, class Archive> static void visit(Self& pair, Archive& archive) {
        archive.value(pair.step_totals);
        archive.value(pair.step_faces);
        archive.nodes(pair.touched);  // a step's only memory of contact
    }

  private:
    struct Reaching;
    Vector2 normal_at(std::size_t node) const { return {normal[2 * node], normal[2 * node + 1]}; }
    bool find_active(const GridView& grid, const ContactBody& a, const ContactBody& b,
                     Exchange& exchange);
    void find_normals(const ContactBody& a, const ContactBody& b);
    void find_normals(const ContactBody& a, const ContactBody& b, int source,
                      const std::vector<std::ptrdiff_t>& nodes, std::vector<double>& of);
    template <bool axi> void measure(const GridView& grid, const ContactBody& body, int which);
    template <bool axi>
    void measure_directions(const GridView& grid, const ContactBody& body, int which);
    void find_surfaces(const GridView& grid, const ContactBody& a, const ContactBody& b,
                       Exchange& exchange);
    void part_corners(const GridView& grid, const ContactBody& a, const ContactBody& b,
                      Exchange& exchange);
    template <bool axi> void measure_overlaps(const GridView& grid, const ContactBody& soft);
    void find_overlaps(const GridView& grid, const ContactBody& soft, Exchange& exchange);
    double outside(const double* x, std::size_t node) const;
    bool has_both_on_one_side(std::size_t node) const;
    bool is_beside(const double* x, std::ptrdiff_t node) const;
    void add(const grit_contact_surfaces& to, int which, const double* x, const double* side,
             const std::ptrdiff_t* nodes, int count);
    grit_contact_surfaces surfaces(std::vector<double>& of);
    grit_contact_surfaces along_direction(int k);
    void find_reaches();
    void find_areas(const ContactBody& stiff);
    void find_gates();
    void remember();
    void sum_faces(bool measured, Exchange& exchange);

    ContactLaw pair_law;
    bool axisymmetric, fixed_point;
    std::vector<int> fixed_bits;
    std::vector<double> position, spacing, normal, surface, near_surface, centre, reach, distance,
        gap, gate_gap, overlap_gap, area, pore_impulse;
    static constexpr int directions = 4;  // that may part two corners
    std::vector<double> direction[directions], direction_surface;
    bool bears = false;                    // pore water
    std::vector<char> is_active, touched;  // touched: pressed in the step before
    std::vector<char> is_closed;           // along its normal
    NearCells near;                        // to active nodes
    std::vector<std::ptrdiff_t> active, undefined, closed;
    std::size_t counted = 0;  // the first ones of active are this process's in sums
    grit_contact_sums sums;
    std::vector<grit_contact_report> reports;
    grit_contact_totals step_totals;
    Measured step_faces;
};

}  // namespace grit::mpm
