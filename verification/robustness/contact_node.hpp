// SPDX-License-Identifier: BSD-3-Clause
// What trials of one pair of bodies at a node and of several have in common.
#pragma once

#include <string>

#include <grit/grit.h>

#include "robustness/campaign.hpp"
#include "robustness/vec.hpp"

namespace robustness::contact {

enum Count {
    nodes,
    inactive,
    open,
    stick,
    slip,
    sprung,
    refused,
    moved_to_edge,
    turned_to_edge,
    of_many,
    many_refused,
    many_not_converged,
    many_settled,
    many_without_friction,
    many_in_rings,
    many_else_squeezed,
    many_else_ended
};
enum Largest {
    momentum_error,
    energy_gain,
    friction_excess,
    approach_left,
    spring_energy_gain,
    spring_error,
    swap_error,
    galilei_error,
    turn_error,
    many_momentum,
    many_energy,
    many_work,
    many_impulse_error,
    many_friction_excess,
    many_approach_left,
    many_normal_error,
    many_friction_error,
    many_swap_error,
    many_galilei_error,
    many_turn_error
};
enum Rule {
    finite,
    untouched,
    open_untouched,
    same_bits,
    known_status,
    keeps_momentum,
    gains_no_energy,
    obeys_coulomb,
    pushes_only,
    closes_as_told,
    spring_gains_no_energy,
    spring_as_told,
    does_not_see_names,
    does_not_see_common_velocity,
    turns_along,
    many_keeps_momentum,
    many_gains_no_energy,
    rigid_stays,
    many_takes_work,
    many_moved_as_told,
    many_apart_untouched,
    many_pushes_only,
    many_obeys_coulomb,
    many_leaves_a_tenth,
    many_normal_as_told,
    many_friction_as_told,
    many_squeezed_by_rigid,
    many_numbers_are_names,
    many_does_not_see_names,
    many_does_not_see_common_velocity,
    many_turns_along,
    many_of_two_is_pair,
    many_same_bits,
    many_between_untouched,
    many_first_named,
    many_sums
};

struct Node {
    double m_a = 0.0, m_b = 0.0, distance = 0.0, cell = 1.0, gap = 0.0, area = 0.0, pore = 0.0;
    Vec normal{}, v_a{}, v_b{};
    grit_contact_report report{};

    double m_r() const { return m_a / (m_a + m_b) * m_b; }
    Vec w() const { return plus(v_a, -1.0, v_b); }
};

struct Call {
    grit_contact_options options;
    bool gap = false, area = false, pore = false;
};

constexpr double smallest_number = 1e-290;  // below, numbers have fewer digits

// u_n = share w_n + pushed, (C5) or (C9), u = J / m_r.
struct Answer {
    double share, pushed;
};

Vec impulse_of(const grit_contact_report& r);
double reduced_mass(const Call& call, const Node& x);  // m_r
// Coulomb's limit of J_t where J_n presses, both over size: less what water bears, and with adhesion.
double coulomb_limit(const Call& call, const Node& x, const grit_contact_report& r, double J_n,
                     double size);
// J_t beyond Coulomb's limit, both over size, as a share of 1 + the limit.
double friction_excess_of(const Call& call, const Node& x, const grit_contact_report& r,
                          double size);
double stiffness_of(const Call& call, const Node& x, double m_r);  // K dt^2 / m_r
inline bool measurable(double stiffness) { return stiffness < 1e100 && stiffness > 1e-100; }
Answer answer_of(const Call& call, const Node& x, double f_p, double m_r);
Node random_node(Random& random, const Call& call);
void correct(const Call& call, Node& x);
std::string program_of(const Call& call, const Node& x);

}  // namespace robustness::contact
