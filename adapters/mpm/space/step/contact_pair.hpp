// SPDX-License-Identifier: BSD-3-Clause
// Contact of two bodies at the nodes in space, through the library: as step/contact_pair.hpp has it in the plane, over
// the nodes in contact alone.
#pragma once

#include <vector>

#include <grit/contact.h>
#include <grit/contact_distance.h>
#include <grit/contact_normals.h>

#include "adapters/mpm/space/step/domain_list.hpp"
#include "adapters/mpm/space/step/near_cells.hpp"
#include "adapters/mpm/step/contact_pair.hpp"

namespace grit::mpm::space {

using ContactLaw = mpm::ContactLaw;  // its options are given three components here

class ContactPair {
  public:
    // Fixed nodes of the model are known when it is made.
    ContactPair(const ContactLaw& law, const Model& model);
    // Velocities after the momentum update become those after contact.
    void correct(Model& model);
    const ContactLaw& law() const { return pair_law; }
    // Of the last step, of all processes.
    const grit_contact_totals& totals() const { return step_totals; }
    // Forces [N] on b of nodes whose normal points more sideways, as on a shaft, and more along z, as at a tip; the
    // largest gap at a node of both bodies [m], NaN: not measured.
    struct Measured {
        Vector3 sideways{0.0, 0.0, 0.0}, along_z{0.0, 0.0, 0.0};
        double largest_gap;
    };
    const Measured& measured() const { return step_measured; }
    // take(from, to, impulse on b [N s]) of each node that this process counts in the last step: along z what its weight
    // has the middle of.
    template <class Take> void each_impulse(const Take& take) const {
        for (std::size_t i = 0; i < counted; ++i) {
            const double z = position[3 * i + 2], half = 0.5 * spacing[3 * i + 2];
            const double* force = reports[i].force;
            take(z - half, z + half,
                 Vector3{step_size * force[0], step_size * force[1], step_size * force[2]});
        }
    }
    // Impulse on a body of the pair in the last step, its moment about a place [N s], [N m s].
    Twist impulse_on(std::size_t body, const Vector3& about) const;
    // The velocity of its rigid body that the impulses of the last step were found with.
    const Twist& velocity_found() const { return found; }
    template <class Self, class Archive> static void visit(Self& pair, Archive& archive) {
        archive.value(pair.step_totals);
        archive.value(pair.step_measured);
        archive.nodes(pair.touched);  // a step's only memory of contact
    }

  private:
    // A domain as contact sees it: corners, and of the nodes that it may have weight at those in contact.
    struct Reaching {
        Vector3 x, corner[8];
        double side[9];
        std::ptrdiff_t nodes[64];
        int count;
    };
    bool find_active(const Model& model);
    void copy_nodes(const Model& model);
    void find_pore_impulses();
    void find_normals();
    void find_normals(int source, const std::vector<std::ptrdiff_t>& nodes,
                      std::vector<double>& of);
    bool is_aside(std::size_t i) const;
    void find_reaching(Model& model);
    void share(std::vector<double>& minima, int each);
    void find_surfaces();
    void part_corners();
    void find_overlaps();
    double outside(const Vector3& x, std::size_t i) const;
    bool has_both_on_one_side(std::size_t i) const;
    bool is_beside(const Vector3& x, std::size_t i) const;
    grit_contact_surfaces surfaces(std::vector<double>& of);
    grit_contact_surfaces along_direction(int k);
    void find_reaches();
    void find_gates();
    grit_contact_options options_of(const Model& model) const;
    grit_contact_nodes nodes_of();
    void correct_nodes(const grit_contact_options& options, grit_contact_sums* sums);
    void apply(const Model& model);
    grit_contact_options meet_freely(const Model& model, const grit_contact_options& options);
    bool meet_freely(const RigidMotion& rigid, bool is_a, const grit_contact_options& law);
    void write_back(Model& model) const;
    void remember();

    ContactLaw pair_law;
    Exchange& exchange;
    std::vector<std::ptrdiff_t> active;  // nodes; all that follows is by their place here ...
    std::size_t counted = 0;             // the first ones are this process's in sums
    std::vector<double> mass_a, mass_b, motion_a, motion_b, slope_a, slope_b;
    std::vector<int> fixed_bits;
    std::vector<double> position, spacing, normal, surface, near_surface, centre, reach, distance,
        gap, gate_gap, overlap, area, pore_impulse;
    std::vector<Vector3> pores_a, pores_b;  // forces of pore pressures; empty: dry [N]
    static constexpr int directions = 5;    // that may part two corners
    std::vector<double> direction[directions], direction_surface;
    std::vector<char> closed;  // along its normal
    std::vector<std::ptrdiff_t> places, undefined, asked;
    std::vector<double> other_start;  // motion of the body beside a rigid one that is free
    std::vector<grit_contact_report> reports;
    std::vector<Reaching> reaching[2];  // of a and of b
    // ... but these: by node, or by cell.
    std::vector<int> place_of;  // -1: not in contact
    std::vector<char> touched;  // pressed in the step before
    NearCells near;             // from which a domain may reach a node in contact
    DomainList domains, corners;
    bool fixed_point;  // of sums of forces
    Twist found;
    double step_size = 0.0;  // [s]
    grit_contact_totals step_totals{};
    Measured step_measured{};
};

}  // namespace grit::mpm::space
