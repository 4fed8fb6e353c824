// SPDX-License-Identifier: BSD-3-Clause
// Bodies of material points on one grid, step after step.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "adapters/mpm/step/absorbing.hpp"
#include "adapters/mpm/step/account.hpp"
#include "adapters/mpm/step/cell_means.hpp"
#include "adapters/mpm/step/gather.hpp"
#include "adapters/mpm/step/loads.hpp"
#include "adapters/mpm/step/model.hpp"
#include "adapters/mpm/step/momentum.hpp"
#include "adapters/mpm/step/nodal_contacts.hpp"
#include "adapters/mpm/step/penalty_contacts.hpp"
#include "adapters/mpm/step/platens.hpp"
#include "adapters/mpm/step/scatter.hpp"
#include "adapters/mpm/step/step_size.hpp"
#include "adapters/mpm/step/stopwatch.hpp"
#include "adapters/mpm/step/surface_contacts.hpp"
#include "adapters/mpm/step/water.hpp"

namespace grit::mpm {

enum class Hold { across, both };

class Simulation {
  public:
    // exchange: of processes that share the grid, outlives this; null: there is one process.
    Simulation(Axis r, Axis z, const Settings& settings, Exchange* exchange = nullptr);

    // Before the first step.
    std::size_t add_body(Body body);
    void add_traction(Traction traction) { loads.add(std::move(traction)); }
    // Of a host with processes, each of which tells its own between steps; and the bodies that any of them may be on.
    void expect_tractions(std::size_t body, bool on_mixture) { loads.expect(body, on_mixture); }
    void set_tractions(std::vector<Traction> here) { loads.set(std::move(here)); }
    void add_contact(const ContactLaw& law) { contacts.add(law); }
    void add_contact(const PenaltyLaw& law) { penalties.add(law); }
    void add_contact(const SurfaceLaw& law) { surfaces.add(law); }
    // No velocity across nodes at r or z = at, and beyond; or none at all.
    void fix_below(int direction, double at, Hold hold = Hold::across);
    void fix_above(int direction, double at, Hold hold = Hold::across);
    // Water may leave there, at p_w = 0, though the grains are fixed.
    void drain_below(int direction, double at);
    void drain_above(int direction, double at);
    // Water comes in across nodes at r or z = at, and beyond, that hold the grains: its filter velocity over time [m/s].
    void pour_below(int direction, double at, std::function<double(double)> speed);
    void pour_above(int direction, double at, std::function<double(double)> speed);
    // Nodes on this line across z (direction 1; r: 0), and beyond, move as one across. Without an exchange.
    void tie_below(int direction, int line);
    void tie_above(int direction, int line);
    // The first or the last nodes along a direction take up waves; the first step finds balance there.
    void absorb_first(int direction, const WaveSpeeds& speeds);
    void absorb_last(int direction, const WaveSpeeds& speeds);
    void set_body_force(BodyForce force) { scatter.set_body_force(std::move(force)); }

    // Between steps, from the next one on.
    void set_gravity(Vector2 gravity);
    void set_local_damping(double share) { model.settings.local_damping = share; }
    void set_pic_rate(double rate) { model.settings.pic_rate = rate; }
    void set_cfl(double cfl);
    void set_largest_step(double step);

    // Throws std::runtime_error if particles leave the grid, MaterialFailure if the sand of one fails.
    void step();
    double time() const { return model.t; }
    // What the next step takes, no less and no more; 0 before the first one, until energy() was asked.
    double next_step() const { return model.dt; }
    // For hosts that ask for the motion of rigid bodies at the end of the next step: shortens it, once, if they
    // would move too far at the speed they were given now. True: ask again, it ends earlier.
    bool shorten_step() { return step_size.shorten(); }
    long steps() const { return model.steps; }
    // Where the time of all steps since it was built went.
    Seconds seconds() const;

    Body& body(std::size_t i) { return model.parts[i].body; }
    const Body& body(std::size_t i) const { return model.parts[i].body; }
    const std::vector<NodeRecord>& records(std::size_t body) const {
        return model.parts[body].records;
    }
    const std::vector<NodeMotion>& motions(std::size_t body) const {
        return model.parts[body].motions;
    }
    std::size_t bodies() const { return model.parts.size(); }
    bool rigid(std::size_t body) const { return model.parts[body].body.rigid(); }
    const ContactPair& contact(std::size_t i) const { return contacts[i]; }
    // Of pore pressures on its body b in the last step, besides those of the contact [N].
    const Faces& pore_faces(std::size_t contact) const { return contacts.pore_faces(contact); }
    const PenaltyPair& penalty_contact(std::size_t i) const { return penalties[i]; }
    const SurfacePair& surface_contact(std::size_t i) const { return surfaces[i]; }
    std::size_t contact_count() const { return contacts.count(); }
    std::size_t penalty_contact_count() const { return penalties.count(); }
    std::size_t surface_contact_count() const { return surfaces.count(); }
    std::size_t traction_count() const { return loads.count(); }
    std::vector<double> traction_words() const { return loads.words(); }
    // Of all tractions on a body in the last step, on all processes [N].
    Vector2 traction_force(std::size_t body) const { return loads.force(body); }
    // Along z, of local damping on a body in the last step, on all processes [N s].
    double damping_impulse(std::size_t body) const { return momentum.damping_impulse(body); }
    // Least mass of a node of a body that moves [kg].
    double least_mass(std::size_t body) const { return model.parts[body].least_mass; }
    const std::vector<std::uint8_t>& constraints() const { return model.fixed_nodes; }
    const AbsorbingSides& absorbing() const { return sides; }
    // Directions of platens, each with its nodes behind it.
    std::vector<double> platen_nodes() const { return platens.words(); }
    const Water& pore_water() const { return water; }
    const Axis& axis_r() const { return model.r; }
    const Axis& axis_z() const { return model.z; }
    // Edge of a cell, of all processes [m].
    double shortest_cell() const { return model.shortest; }
    const Settings& current_settings() const { return model.settings; }
    // Particle with this id; -1: another process has it.
    std::ptrdiff_t find(std::size_t body, int id) const { return model.parts[body].find(id); }
    // Between steps, after particles of a body came from or went to other processes.
    void particles_changed(std::size_t body);
    // Goes over all particles of all processes.
    Energy energy();
    // For sums over all processes, which each of them must ask for.
    Exchange& shared() const { return model.exchange; }

    // All that a step leaves for the next one, or for those who look on. Left out is what every step makes
    // anew, and what follows from the rest: see archive.hpp.
    template <class Self, class Archive> static void visit(Self& simulation, Archive& archive) {
        Model::visit(simulation.model, archive);
        archive.value(simulation.started);
        Scatter::visit(simulation.scatter, archive);
        Momentum::visit(simulation.momentum, archive);
        Water::visit(simulation.water, archive);
        Loads::visit(simulation.loads, archive);
        Platens::visit(simulation.platens, archive);
        AbsorbingSides::visit(simulation.sides, archive);
        NodalContacts::visit(simulation.contacts, archive);
        PenaltyContacts::visit(simulation.penalties, archive);
        SurfaceContacts::visit(simulation.surfaces, archive);
        StepSize::visit(simulation.step_size, archive);
        Account::visit(simulation.account, archive);
    }
    // Once its state is another one: where each id is.
    void index_ids();

  private:
    void start();
    void finish();

    Model model;
    CellMeans means{model};
    Momentum momentum{model};
    Water water{model, momentum};
    Scatter scatter{model, means, water};
    Loads loads{model, water};
    Platens platens{model, water};
    AbsorbingSides sides;
    NodalContacts contacts{model, water};
    PenaltyContacts penalties{model, scatter};
    SurfaceContacts surfaces{model, water};
    Gather gather{model, means, water};
    StepSize step_size{model, penalties, water};
    Account account{model};
    bool started = false;
    Seconds spent;  // but what the materials took
};

}  // namespace grit::mpm
