// SPDX-License-Identifier: BSD-3-Clause
// Bodies of material points in space on one grid, step after step.
#pragma once

#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "adapters/mpm/space/step/contact_pair.hpp"
#include "adapters/mpm/space/step/gather.hpp"
#include "adapters/mpm/space/step/loads.hpp"
#include "adapters/mpm/space/step/scatter.hpp"
#include "adapters/mpm/space/step/surface_pair.hpp"
#include "adapters/mpm/step/stopwatch.hpp"

namespace grit::mpm::space {

enum class Hold { across, all };

class Simulation {
  public:
    // exchange: of processes that share the grid, outlives this; null: there is one process. Throws
    // std::invalid_argument for settings that are not there in space.
    Simulation(std::array<Axis, 3> axes, const Settings& settings, Exchange* exchange = nullptr)
        : model(std::move(axes), settings, exchange) {}

    // Before the first step.
    std::size_t add_body(Body body);
    void add_traction(Traction traction) { loads.add(std::move(traction)); }
    // Of a host with processes, each of which tells its own between steps; and the bodies that any of them may be on.
    void expect_tractions(std::size_t body) { loads.expect(body); }
    void set_tractions(std::vector<Traction> here) { loads.set(std::move(here)); }
    // After what fixes nodes.
    void add_contact(const ContactLaw& law);
    void add_contact(const SurfaceLaw& law);
    // No velocity across nodes at x, y or z = at, and beyond; or none at all.
    void fix_below(int direction, double at, Hold hold = Hold::across);
    void fix_above(int direction, double at, Hold hold = Hold::across);
    void set_body_force(BodyForce force) { scatter.set_body_force(std::move(force)); }

    // Between steps, from the next one on.
    void set_gravity(const Vector3& gravity) { model.gravity = gravity; }
    void set_local_damping(double share) { model.settings.local_damping = share; }
    void set_pic_rate(double rate) { model.settings.pic_rate = rate; }
    void set_cfl(double cfl);
    void set_largest_step(double step);

    // Throws std::runtime_error if particles leave the grid, MaterialFailure if the sand of one fails.
    void step();
    double time() const { return model.t; }
    // What the next step takes; 0 before the first one, until energy() was asked.
    double next_step() const { return model.dt; }
    // For hosts that ask for the motion of rigid bodies at the end of the next step: shortens it, once, if they
    // would move too far at the speed they were given now. True: ask again, it ends earlier.
    bool shorten_step();
    long steps() const { return model.steps; }
    // Where the time of all steps since it was built went.
    Seconds seconds() const;
    // Goes over all particles.
    Energy energy();

    Body& body(std::size_t i) { return model.parts[i].body; }
    const Body& body(std::size_t i) const { return model.parts[i].body; }
    std::size_t bodies() const { return model.parts.size(); }
    const std::vector<NodeRecord>& records(std::size_t i) const { return model.parts[i].records; }
    const std::vector<NodeMotion>& motions(std::size_t i) const { return model.parts[i].motions; }
    // Least mass of a node of a body that moves [kg].
    double least_mass(std::size_t i) const { return model.parts[i].least_mass; }
    const std::vector<std::uint8_t>& constraints() const { return model.fixed_nodes; }
    const ContactPair& contact(std::size_t i) const { return contacts[i]; }
    std::size_t contact_count() const { return contacts.size(); }
    const SurfacePair& surface_contact(std::size_t i) const { return surfaces[i]; }
    std::size_t surface_contact_count() const { return surfaces.size(); }
    std::size_t traction_count() const { return loads.count(); }
    std::vector<double> traction_words() const { return loads.words(); }
    // Of all tractions on a body in the last step, on all processes [N].
    Vector3 traction_force(std::size_t body) const { return loads.force(body); }
    // Along z, of local damping on a body in the last step, on all processes [N s].
    double damping_impulse(std::size_t body) const;
    const Axis& axis(int direction) const {
        return model.axis[static_cast<std::size_t>(direction)];
    }
    // Edge of a cell, of all processes [m].
    double shortest_cell() const { return model.shortest; }
    const Settings& current_settings() const { return model.settings; }
    const Vector3& gravity() const { return model.gravity; }
    // Particle with this id; -1: another process has it.
    std::ptrdiff_t find(std::size_t i, int id) const { return model.parts[i].find(id); }
    // Between steps, after particles of a body came from or went to other processes.
    void particles_changed(std::size_t body);
    // For sums over all processes, which each of them must ask for.
    Exchange& shared() const { return model.exchange; }

    // All that a step leaves for the next one, or for those who look on.
    template <class Self, class Archive> static void visit(Self& simulation, Archive& archive) {
        Model::visit(simulation.model, archive);
        archive.value(simulation.started);
        Scatter::visit(simulation.scatter, archive);
        Loads::visit(simulation.loads, archive);
        for (auto& contact : simulation.contacts) ContactPair::visit(contact, archive);
        for (auto& contact : simulation.surfaces) SurfacePair::visit(contact, archive);
        archive.value(simulation.largest_speed);
        archive.value(simulation.energies);
    }
    // Once its state is another one: where each id is.
    void index_ids();

  private:
    void start();
    void advance();
    void correct_contacts();
    void damp_and_close();
    void finish();
    void add_up();
    void measure_speeds();
    void decide_step();
    double fastest_rigid(double at) const;
    double stable(double at) const;
    void begin_rigid(std::size_t body);
    // found: the velocity that contact took it for.
    void push_rigid(std::size_t body, const Twist& impulse, const Twist& found);
    void finish_rigid(std::size_t body);
    void measure_energy();
    [[noreturn]] void report_lost(std::ptrdiff_t count) const;
    NodeCall node_call(std::size_t body, std::size_t begin, std::size_t end);
    void fix(int direction, Hold hold, const std::function<bool(double)>& where);

    Model model;
    CellMeans means{model};
    Water water{model};
    Scatter scatter{model, means, water};
    Gather gather{model, means, water};
    Loads loads{model};
    std::vector<ContactPair> contacts;
    std::vector<SurfacePair> surfaces;
    SurfaceCalls surface_calls;
    std::vector<std::vector<NodeSums>> node_sums;  // of each body's chunks
    Energy energies;
    std::vector<double> maxima;  // of each body
    double largest_speed = 0.0;  // v + c [m/s]
    bool started = false;
    Seconds spent;  // but what the materials took
};

}  // namespace grit::mpm::space
