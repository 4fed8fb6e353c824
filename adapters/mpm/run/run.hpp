// SPDX-License-Identifier: BSD-3-Clause
// A case, stage after stage, one step at a time.
#pragma once

#include <array>
#include <functional>

#include "adapters/mpm/run/subject.hpp"

namespace grit::mpm {

// What a run is worth knowing of. Whole bodies: in axisymmetry 2 pi times the sums per radian.
struct HistoryRow {
    int stage = 0;  // from 1
    long step = 0;
    double t = 0.0;  // [s]
    int blow = 0;    // of the pulses that the stage counts, see StageEnd
    double depth = 0.0,
           velocity = 0.0;  // of the driven body, downwards, since the start [m], [m/s]
    // Mean forces since the row before [N]: of contacts on the driven body, upwards, where it faces down
    // or up and where it faces sideways; of tractions on it, downwards; of the bottom, upwards; of local
    // damping on the driven body, upwards.
    double tip_force = 0.0, shaft_force = 0.0, hammer_force = 0.0, base_force = 0.0,
           damping_force = 0.0;
    // In space, of contacts on the driven body: means alike along x, y and z [N], and of their moments about the origin [N m].
    std::array<double, 6> contact{};
    Energy energy;                // [J]
    double driven_stored = 0.0;   // now in the driven body [J]
    double residual_share = 0.0;  // of the energy turned over [-]
    double dt = 0.0;              // of the last step [s]
    double largest_gap = 0.0;     // between bodies at a node of both [m]; NaN: not measured
    double unbalanced_share = 0.0;
    // Of particles with pore water [Pa]; NaN: there are none.
    double least_pore_pressure = 0.0, largest_pore_pressure = 0.0;
    double water_mass = 0.0;  // of water that flows [kg]; NaN: none does
    // Of contacts on the driven body by height, means alike along x, y and z of each part [N].
    std::vector<double> profile;
};

// All that a run knows besides its simulation.
struct RunState {
    int stage = 0;  // from 0; number of stages: finished
    double last_dt = 0.0;
    double start_level = 0.0, stage_level = 0.0;  // [m]
    double next_row = 0.0;                        // [s]
    // Impulses since the last row [N s]: tip, shaft, hammer, base, damping; those of contacts along x, y and z and their
    // moments [N m s].
    std::array<double, 11> impulse{};
    std::vector<double> profile;     // ... of contacts by height, x, y and z of each part
    double row_time = 0.0;           // of the last row [s]
    std::vector<double> stage_time;  // when stages began [s]; infinite: not yet

    template <class Self, class Archive> static void visit(Self& state, Archive& archive) {
        archive.value(state.stage);
        for (auto* number : {&state.last_dt, &state.start_level, &state.stage_level,
                             &state.next_row, &state.row_time})
            archive.value(*number);
        archive.value(state.impulse);
        archive.list(state.profile);
        archive.list(state.stage_time);
    }
};

// Why a stage has ended.
enum class Ended { not_yet, by_time, by_depth, by_blows, at_rest };

class Runner {
  public:
    // Throws std::invalid_argument, see build_case.
    explicit Runner(const Case& plan);
    // Of a simulation that was built of it otherwise.
    Runner(Case plan, BuiltCase built);

    bool finished() const { return state_now.stage == static_cast<int>(plan.stages.size()); }
    // Throws std::runtime_error naming time, step, term and limit if the energy balance breaks, or if a
    // stage waits for blows that do not come, or what Simulation::step throws.
    void step();
    // A row is due: at the start, after an interval and at the end of a stage.
    bool row_is_due() const { return due; }
    HistoryRow row();
    // What row() would say; forces go on being means since the row before.
    HistoryRow row_so_far();

    // How the last stage that ended did so.
    Ended ended() const { return how; }
    // Share of the stage that is done, as far as its time, depth or blows tell; NaN: they do not.
    double share_done();

    // Throws std::invalid_argument for an interval between outputs that no step could ever keep.
    void check_interval(const std::string& name, double interval) const;

    const Case& description() const { return plan; }
    // What it runs; of one in the plane, the simulation itself.
    Subject& subject() { return *run_on; }
    Simulation& simulation() { return *built.simulation; }
    space::Simulation* space() { return built.space.get(); }
    std::ptrdiff_t particles() const { return particle_count; }
    // Of the whole driven body [kg]; 0 if it is rigid.
    double driven_mass() const { return mass_of_driven; }
    int blow() const;
    // Of the driven body since the start [m].
    double depth() { return state_now.start_level - level(); }

    const RunState& state() const { return state_now; }
    // What matters in an energy balance at the least, measured at the start [J].
    double energy_scale() const { return least_energy; }
    void set_energy_scale(double energy) { least_energy = energy; }
    // For hosts that describe a stage when it begins: the next one, or what is left of this one. describe
    // gets it as it is planned; later ones begin with the same, but without an end. Throws
    // std::invalid_argument if it is neither, or waits for blows that its train does not have.
    void begin(const std::string& stage,
               const std::function<StagePlan(const StagePlan&)>& describe);

    // Goes on from there; the state of the simulation is to be restored afterwards.
    void resume(const RunState& state);
    // ... and, once it is, how steps are taken as the case says it now.
    void take_steps();

  private:
    void begin_stage();
    double level();
    Ended end_of_stage();
    bool at_rest();
    void measure_bodies();
    void check_energy();
    struct Blows;
    Blows blows() const;

    Case plan;
    BuiltCase built;
    std::unique_ptr<Subject> run_on;
    std::size_t driven = 0;
    std::ptrdiff_t particle_count = 0;
    double whole = 1.0;  // of a radian or of a metre
    // What matters at the least [J]: the weight sunk by a cell, or all bodies strained by 1e-4.
    double least_energy = 0.0;
    double mass_of_driven = 0.0;  // whole [kg]
    double wave_time = 0.0;       // the least that a wave needs for a cell at the start [s]
    bool due = true;
    Ended how = Ended::not_yet;
    RunState state_now;
};

}  // namespace grit::mpm
