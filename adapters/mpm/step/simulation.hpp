// SPDX-License-Identifier: BSD-3-Clause
// Bodies of material points on one grid, step after step.
#pragma once

#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "adapters/mpm/kernel/exchange.hpp"
#include "adapters/mpm/kernel/nodes.hpp"
#include "adapters/mpm/kernel/strips.hpp"
#include "adapters/mpm/step/absorbing.hpp"
#include "adapters/mpm/step/contact_pair.hpp"
#include "adapters/mpm/step/penalty_pair.hpp"
#include "adapters/mpm/step/settings.hpp"
#include "adapters/mpm/step/stopwatch.hpp"
#include "adapters/mpm/step/thread_pool.hpp"
#include "adapters/mpm/step/traction.hpp"

namespace grit::mpm {

enum class Hold { across, both };

class Simulation {
  public:
    // exchange: of processes that share the grid, outlives this; null: there is one process.
    Simulation(Axis r, Axis z, const Settings& settings, Exchange* exchange = nullptr);

    // Before the first step.
    std::size_t add_body(Body body);
    void add_traction(Traction traction);
    void add_contact(const ContactLaw& law);
    void add_contact(const PenaltyLaw& law);
    // No velocity across nodes at r or z = at, and beyond; or none at all.
    void fix_below(int direction, double at, Hold hold = Hold::across);
    void fix_above(int direction, double at, Hold hold = Hold::across);
    // The first or the last nodes along a direction take up waves; the first step finds balance there.
    void absorb_first(int direction, const WaveSpeeds& speeds);
    void absorb_last(int direction, const WaveSpeeds& speeds);
    // Fills the columns b_r, b_z, an acceleration besides gravity, for time t.
    using BodyForce =
        std::function<void(ParticleView, std::ptrdiff_t begin, std::ptrdiff_t end, double t)>;
    void set_body_force(BodyForce force) { body_force = std::move(force); }

    // Between steps, from the next one on.
    void set_gravity(Vector gravity);
    void set_local_damping(double share) { settings.local_damping = share; }
    void set_pic_rate(double rate) { settings.pic_rate = rate; }
    void set_cfl(double cfl);

    // Throws std::runtime_error if particles leave the grid, MaterialFailure if the sand of one fails.
    void step();
    double time() const { return t; }
    // What the next step takes, no less and no more; 0 before the first one, until energy() was asked.
    double next_step() const { return dt; }
    // For hosts that ask for the motion of rigid bodies at the end of the next step: shortens it, once, if they
    // would move too far at the speed they were given now. True: ask again, it ends earlier.
    bool shorten_step();
    long steps() const { return step_count; }
    // Where the time of all steps since it was built went.
    Seconds seconds() const;

    Body& body(std::size_t i) { return parts[i].body; }
    const std::vector<NodeRecord>& records(std::size_t body) const { return parts[body].records; }
    const std::vector<NodeMotion>& motions(std::size_t body) const { return parts[body].motions; }
    std::size_t bodies() const { return parts.size(); }
    bool rigid(std::size_t body) const { return parts[body].body.rigid(); }
    const ContactPair& contact(std::size_t i) const { return contacts[i]; }
    const PenaltyPair& penalty_contact(std::size_t i) const { return penalties[i]; }
    std::size_t contact_count() const { return contacts.size(); }
    std::size_t penalty_contact_count() const { return penalties.size(); }
    // Of all tractions on a body in the last step, on all processes [N].
    Vector traction_force(std::size_t body) const;
    // Along z, of local damping on a body in the last step, on all processes [N s].
    double damping_impulse(std::size_t body) const;
    // Least mass of a node of a body that moves [kg].
    double least_mass(std::size_t body) const { return parts[body].least_mass; }
    const std::uint8_t* constraints() const { return fixed_nodes.data(); }
    const AbsorbingSides& absorbing() const { return absorbing_sides; }
    const Axis& axis_r() const { return r_axis; }
    const Axis& axis_z() const { return z_axis; }
    // Edge of a cell, of all processes [m].
    double shortest_cell() const { return shortest; }
    const Settings& current_settings() const { return settings; }
    // Particle with this id; -1: another process has it.
    std::ptrdiff_t find(std::size_t body, int id) const;
    // Between steps, after particles of a body came from or went to other processes.
    void particles_changed(std::size_t body);
    // Goes over all particles of all processes.
    Energy energy();
    // For sums over all processes, which each of them must ask for.
    Exchange& shared() const { return exchange; }

  private:
    friend struct CheckpointMembers;
    friend struct SharedState;
    struct Part {
        Body body;
        Strips strips;
        std::vector<NodeRecord> records = {};
        std::vector<NodeMotion> motions = {};
        std::vector<Vector> internal = {};  // nodal forces of stresses and penalties [N]
        std::vector<Vector> loads = {};     // nodal forces of tractions, if there are any [N]
        std::vector<NodeIntegers> integers = {};
        std::vector<FixedPoint> fixed_points = {};  // of each strip
        std::array<double, record::size> scale = {};
        Separation separation = {};
        CellMean mean = {};  // of the vectors that follow, if wanted
        std::vector<CellIntegers> cells = {};
        std::vector<Deferred> deferred = {};
        std::vector<std::ptrdiff_t> by_id = {};  // particles, ids ascending
        double least_mass = 0.0;
        std::vector<NodeRecord> ahead = {};  // masses at the end of the step, for penalty contact
        std::vector<char> pressed = {};      // strips near vertices that press
        std::vector<GatherSums> gather_sums = {};   // of each strip
        std::vector<double> speed = {};             // largest v + c of each strip [m/s]
        std::vector<Total> viscous_loss = {};       // of each strip in this step [J]
        std::vector<double> material_seconds = {};  // of each strip since it was built
        std::vector<double> most_stress = {};       // largest mean stress of each strip [Pa]
        std::vector<NodeSums> node_sums = {};       // of each strip's rows
        std::vector<Increments> increments = {};    // of each strip
    };
    // Rows of nodes of a strip; the last one has one more.
    struct Rows {
        std::ptrdiff_t begin, end;
    };
    GridView grid() const { return {r_axis.view(), z_axis.view()}; }
    Rows nodes_of(int strip) const;
    NodeCall node_call(Part& part, int strip) const;
    void fix(int direction, Hold hold, const std::function<bool(double)>& where);
    void absorb(int direction, int line, double cell, const WaveSpeeds& speeds);
    void start();
    void sort();
    static void find_places(Part& part);
    void find_mean_stresses();
    // Into records, or ahead of the bodies that have them.
    enum class Into { records, ahead };
    void scatter(unsigned parts_wanted, Into into = Into::records);
    void scatter_strips(unsigned parts_wanted, Into into);
    void scatter_fixed(unsigned parts_wanted, Into into);
    bool rescale(unsigned parts_wanted, Into into);
    void clear();
    void load();
    double load_quantum() const;
    void start_velocities();
    void keep_internal_forces();
    void advance();
    double stable_step(double speed) const;
    double rigid_speed(double at) const;
    void decide_step();
    void find_penalty_forces();
    bool find_pressed_strips();
    void push_contacts();
    void push_absorbing();
    void correct_contacts();
    void move_contacts();
    PenaltyBody penalty_body(std::size_t body, Into into);
    void close();
    void gather(unsigned tasks, double by);
    template <class Work> void each_range(const Part& part, int strip, const Work& work);
    void gather_strip(Part& part, int strip, unsigned tasks, double by);
    void deform_strip(Part& part, int strip);
    double update(Part& part, int strip, const Range& range);
    double update_viscosity(Part& part, int strip, const Range& range, const double* moduli);
    void update_stress(const Part& part, const Range& range, const Increments& increments) const;
    void remap();
    void account();
    void find_largest();
    [[noreturn]] void report_lost(long count) const;
    void measure_energy();
    void measure_speed();

    Settings settings;
    Axis r_axis, z_axis;
    std::vector<std::uint8_t> fixed_nodes;
    std::vector<Part> parts;
    std::vector<Traction> tractions;
    std::vector<EdgeForces> edge_loads;
    std::vector<ContactPair> contacts;
    std::vector<PenaltyPair> penalties;
    AbsorbingSides absorbing_sides;
    BodyForce body_force;
    Exchange alone;
    Exchange& exchange;
    ThreadPool pool;
    Energy sums;
    Total load_work, absorbed, held_work;  // of tractions and absorbing sides in this step [J]
    std::vector<double> maxima;            // of each body
    double shortest = 0.0;                 // edge of a cell, of all processes [m]
    double t = 0.0, dt = 0.0, dt_before = 0.0, drift = 0.0;
    double largest_speed = 0.0;  // v + c [m/s]
    long step_count = 0;
    bool started = false;
    Seconds spent;  // but what the materials took
};

}  // namespace grit::mpm
