// SPDX-License-Identifier: BSD-3-Clause
// Pore water of bodies that have it, beside the passes of a step. The pressure is explicit, drag implicit node by node:
// neither the other passes nor particles know how.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "adapters/mpm/kernel/pore_water.hpp"
#include "adapters/mpm/step/implicit_pressure.hpp"
#include "adapters/mpm/step/integer_records.hpp"
#include "adapters/mpm/step/momentum.hpp"

namespace grit::mpm {

class Water {
  public:
    Water(Model& of, Momentum& of_nodes) : model(of), momentum(of_nodes) {}
    void add_body();
    // Water may leave across these nodes, at p_w = 0.
    void drain(int direction, std::size_t node);

    // Water comes in across these nodes, along a direction times a sign: its filter velocity over time [m/s].
    struct Inflow {
        int direction;
        double sign;
        std::vector<std::size_t> nodes;
        std::function<double(double)> speed;
    };
    void pour(Inflow inflow);
    // Of each inflow direction, sign and nodes.
    std::vector<double> inflow_words() const;
    // Force on a node's grains and water by their shares of the volume, once both know theirs [N].
    void load(std::size_t body, std::size_t node, const Vector2& force);
    // What it works on, before and after the step together [m/s]: (1 - n) v_s + n v_w, of which a side takes what is meant
    // for water that it holds.
    double loaded_velocity(std::size_t body, std::size_t node, int direction) const;
    // These nodes move as one: a platen, which no water passes.
    void tie(TiedNodes nodes);
    const std::vector<TiedNodes>& tied() const { return platens; }
    // Bits of what platens hold; empty: nothing.
    const std::vector<std::uint8_t>& tied_nodes() const { return tied_bits; }
    // take(mass, motion) of all that has a velocity of its own at such nodes and is free along them.
    template <class Take> void each_mass(const TiedNodes& tied, const Take& take) {
        const int bit = tied.direction == 0 ? fixed::r : fixed::z;
        for (std::size_t i = 0; i < model.parts.size(); ++i) {
            Part& part = model.parts[i];
            if (part.body.rigid()) continue;
            for (const std::size_t node : tied.nodes) {
                const double m = part.records[node][record::m];
                if (!(m > part.least_mass) || (model.fixed_nodes[node] & bit)) continue;
                take(m, part.motions[node]);
                if (const double m_w = water_mass(i, node); m_w > 0.0)
                    take(m_w, bodies[i].flowing[node]);
            }
        }
    }

    // For a scatter: the mean pressures of cells, before it; its sums, which it may begin again, and what a strip has there;
    // true: they must be done again; once it is done.
    void find_pressures();
    void begin_sums();
    WaterScatter scattered(std::size_t body, int strip);
    bool check_sums();
    void finish_sums();
    // Once the stresses are scattered: the force of the pressure.
    void push();
    // After the forces: grains and water drag each other.
    void drag();
    // Impulse of the pressure on a node, along a normal [N s].
    double impulse(std::size_t body, std::size_t node, const Vector2& normal) const;
    // Where another body is, too, before their contact: grains and water meet it as one mass, which has the mean of
    // their velocities along the normal and the grains' beside it.
    void join(std::size_t body, std::size_t node, const Vector2& normal);
    const double* met_masses(std::size_t body) const { return bodies[body].met_masses.data(); }
    NodeMotion* met_motions(std::size_t body) { return bodies[body].met_motions.data(); }
    // After it, where that body presses: what it changed them by; along the normal they move alike.
    void part(std::size_t body, std::size_t node, const Vector2& normal);
    // Of water that flows at a node, as surfaces meet it: mass, 0: there is none; what drag of this step gives for a
    // velocity against the grains [kg]; porosity; bits of what is held; that velocity, and the one before the step.
    struct Pores {
        double mass = 0.0, drag = 0.0, porosity = 0.0;
        std::uint8_t fixed = 0;
        Vector2 seepage{0.0, 0.0}, seepage_before{0.0, 0.0};
    };
    Pores pores(std::size_t body, std::size_t node) const;
    // After it: its velocity against the grains, which get theirs now and have been dragged the while.
    void follow(std::size_t body, std::size_t node, const Vector2& grains, const Vector2& seepage);
    // What bears in the cell of a particle, its mean, between push and update [Pa].
    double pressure_at(std::size_t body, std::ptrdiff_t particle) const;
    // A node of a body where another one presses on it now.
    struct Pressed {
        std::size_t node, other;
        Vector2 normal;
        double share;  // of the approach that the contact takes: 1 leaves them one velocity across
        double impulse = 0.0;  // out: on the other body along the normal [N s]
    };
    bool has(std::size_t body) const { return model.parts[body].body.water.has_value(); }
    bool is_implicit(std::size_t body) const {
        return has(body) && model.parts[body].body.water->implicit;
    }
    // Of its solver, since it was built.
    long iterations(std::size_t body) const { return bodies[body].implicit->iterations(); }
    // Times that what bears, cells or points along surfaces, was not the same twice.
    long unsettled(std::size_t body) const {
        return bodies[body].implicit->unsettled() + bodies[body].unsettled;
    }
    // After contact, of a body with implicit pressure: it gets what the pressure changes by in the step.
    // surfaces: of its contacts at these, whose rows get the impulses of the end.
    void change(std::size_t body, std::vector<Pressed>& pressed,
                const std::vector<SurfaceRows*>& surfaces);
    // Values of a row: normal and tangential approach, flow of the water of a and of b; of the velocities now (or before
    // the step) [m/s].
    std::array<double, 4> values(const SurfaceRows& of, const SurfaceRow& row, bool now) const;
    // After contact: nodes as a gather wants them, and what it takes of a strip.
    void close();
    WaterGather gathered(std::size_t body, int strip);
    // Once the particles have moved: their pressures.
    void update();
    bool is_anywhere() const;
    // Speeds of particles as they are, before the first step.
    void measure();

    bool flows(std::size_t body) const { return has(body) && model.parts[body].body.water->flows; }
    const std::vector<WaterSums>& sums(std::size_t body) const { return bodies[body].sums; }
    // What impulses of the pressure took in the last step, at the nodes that this process counts [J].
    struct Taken {
        Total contact = {}, rigid_work = {};  // those on other bodies
        Total implicit = {}, side_work = {};
    };
    const Taken& taken() const { return impulses_took; }
    // What it adds to the square of the speed of waves, at the most, here [m2/s2].
    double speed2(std::size_t body) const;
    // Of water that flows, along z on a node in the last step: of its pressure, its weight and its loads [N].
    double force_z(std::size_t body, std::size_t node) const;
    // Of drag on the grains, in the lanes other [N s], between drag and update; null: nothing flows.
    const NodeMotion* drag_impulses(std::size_t body) const {
        return flows(body) ? bodies[body].volume.data() : nullptr;
    }
    // Of water that flows, n (v_w - v_s) of a node in the last step [m/s].
    Vector2 seepage(std::size_t body, std::size_t node) const {
        const NodeMotion& v = bodies[body].volume[node];
        return {v[motion::other_r], v[motion::other_z]};
    }
    const std::vector<std::uint8_t>& drained_nodes() const { return drained; }

    template <class Self, class Archive> static void visit(Self& water, Archive& archive) {
        for (auto& body : water.bodies) {
            IntegerRecords::visit(body.integers, archive);
            if (body.implicit) ImplicitPressure::visit(*body.implicit, archive);
            archive.nodes(body.records);
            archive.nodes(body.volume);
        }
    }

  private:
    // One direction of a node: what an impulse of the pressure changes the velocities by [1/kg].
    struct Answer {
        double grains, water, drag;  // drag: impulse on the grains, by the pressure's [-]
    };
    struct OfBody {
        std::vector<WaterCell> cells = {};
        std::vector<WaterPlace> places = {};  // of particles
        std::vector<NodeRecord> records = {};
        IntegerRecords integers = {};                       // of these, in fixed point
        std::vector<NodeMotion> flowing = {}, volume = {};  // of water that flows
        std::vector<Vector2> loaded = {};                   // by its share of loads [N]
        std::vector<double> met_masses = {};                // as other bodies meet it
        std::vector<NodeMotion> met_motions = {};
        std::vector<WaterSums> sums = {};  // of each strip
        std::vector<double> speed2 = {};
        std::optional<ImplicitPressure> implicit = {};
        long unsettled = 0;  // of points along surfaces
        std::vector<Vector2> volume_velocity = {}, held_velocity = {}, impulse = {};
        std::vector<std::array<Answer, 2>> answers = {};  // of a node along r, z
        Answers all_answers = {};                         // as the pressure's equation has them
        HeldRows held = {};
    };
    // Impulses of the pressure along a normal [N s]; those on the other body make their sum zero.
    struct Wall {
        std::size_t body, other, node;
        Vector2 normal;
        double on_grains, on_water;
    };
    void account_for(const Wall& wall);
    bool counts(std::size_t node) const;  // in sums of this process
    Answer answer(std::size_t body, std::size_t node, bool grains_free, bool water_free) const;
    double porosity(std::size_t body, std::size_t node) const;
    double water_mass(std::size_t body, std::size_t node) const;
    bool has_pores(std::size_t body, std::size_t node) const;
    // A node that another body presses on: the normal along which it is free, and what an impulse on this body moves both by.
    struct Together {
        Pressed* at;
        Vector2 normal;
        double per_mass, other_per_mass;  // [1/kg]
    };
    // Lanes of the volume velocity (1 - n) v_s + n v_w of a node, their sum [m/s].
    double volume_velocity(std::size_t body, std::size_t node, int lane, int other_lane) const;
    void find_answers(std::size_t body);
    // answer: of the volume velocity to an impulse, along r and z [1/kg].
    CompactAnswer compact_answers(std::size_t body, std::size_t node, const Vector2& answer) const;
    Mobility mobility(std::size_t body, std::size_t node, int direction) const;
    void give_back(const std::vector<SurfaceRows*>& surfaces);
    void hold_surfaces(std::size_t body, const std::vector<SurfaceRows*>& surfaces);
    void push_surfaces(const HeldRows& held);
    // grains: change of their velocity; against: of the water's against them [m/s].
    void move(std::size_t body, std::size_t node, int direction, double grains, double against);
    std::vector<Together> hold_together(std::size_t body, std::vector<Pressed>& pressed);
    void push_by(std::size_t body, std::size_t node, const Vector2& impulse);
    std::uint8_t fixed_bits(std::size_t node) const;
    void hold_platens(std::size_t body);
    void push_platens(std::size_t body);
    Wall push_together(std::size_t body, const Together& together, const Vector2& impulse);
    WaterNodeCall nodes(std::size_t body, int strip);
    template <class Do> void naming(std::size_t body, const Do& act) const;
    void sum_cells();
    void measure(std::size_t body, int strip);

    Model& model;
    Momentum& momentum;
    std::vector<OfBody> bodies;
    Taken impulses_took;
    std::vector<std::uint8_t> drained;  // bits of nodes; empty: none
    std::vector<TiedNodes> platens;
    std::vector<std::uint8_t> tied_bits;
    std::vector<Inflow> inflows;
    std::vector<Vector2> poured;  // filter velocities of nodes; empty: none [m/s]
};

}  // namespace grit::mpm
