// SPDX-License-Identifier: GPL-2.0-only
// The run of a case on this process's part of the grid, with the particles that are here. Knows no LAMMPS.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "adapters/lammps/fix_case.hpp"
#include "adapters/lammps/halo.hpp"
#include "adapters/mpm/run/run.hpp"

namespace grit::lammps {

// All columns of a particle.
struct PointRow {
    std::size_t body = 0;
    std::vector<double> columns;
};

// How the grid is cut.
struct Cuts {
    MPI_Comm world;
    std::array<std::vector<double>, 2> at;  // along r and z, with both ends [m]
    std::array<int, 2> here;
    int neighbour[2][2];
};

// A run between two steps, but for its particles; independent of how the grid is cut.
struct StoredRun {
    mpm::RunState state;
    double energy_scale = 0.0;  // [J]
    std::vector<mpm::StagePlan> stages;
    std::string common;                // see GridState
    std::vector<std::uint64_t> nodes;  // of the whole grid

    template <class Self, class Archive> static void visit(Self& run, Archive& archive) {
        mpm::RunState::visit(run.state, archive);
        archive.value(run.energy_scale);
        archive.list(run.common);
        archive.list(run.nodes);
        archive.objects(run.stages);
    }
};

// The value of a variable at a time.
using VariableAt = std::function<double(const std::string& name, double t)>;

// A variable whose value a load or a motion takes.
struct AskedVariable {
    std::string name, from_stage;  // no stage: from the begin of the run
    bool of_motion = false;
    double value = 0.0;  // of this step
};

class LocalRun {
  public:
    LocalRun(FixCase plan, VariableAt variables);

    // Particles come here, to be there from settle() on; they may be taken away again before that.
    void put(int id, PointRow row) { waiting[id] = std::move(row); }
    // The columns of a particle that is here. Throws std::runtime_error if it is not.
    PointRow row(int id) const;
    // It leaves with the next settle().
    void leave(int id);
    void settle();

    // Builds what a run needs, once more if the grid is cut in another way. traction_ids: particles of each.
    // Every process must call it. Throws what build_case throws.
    void start(const Cuts& cuts, const std::vector<std::vector<int>>& traction_ids);
    // Of the step that the next start() begins with.
    void go_on_from(StoredRun run) { stored = std::make_unique<StoredRun>(std::move(run)); }
    // Every process must call it; particles may be on their way.
    StoredRun store();
    // There is something to store: it was started, or goes on from a stored run.
    bool has_begun() const { return runner || stored; }
    // The grid is not cut that way.
    bool is_cut_anew(const Cuts& cuts) const { return !is_cut(cuts); }

    // Asks for the values of all variables, in the same order on all processes: of loads at the begin of the
    // next step, of motions at its end, and again where these want it to end earlier. Only of motions, now: to
    // show them before a step.
    bool has_variables() const { return !asked.empty(); }
    void ask_for_step();
    void ask_for_motion_now();

    bool started() const { return runner != nullptr; }
    mpm::Runner& run() { return *runner; }
    mpm::Simulation& simulation() const { return runner->simulation(); }
    Halo& halo() { return *exchange; }
    const FixCase& description() const { return plan; }
    // How far particles may get since they were last sent to where they belong [m].
    double slack() const;
    const std::vector<std::string>& column_names(std::size_t body) const { return names_of[body]; }
    // Null: it has none.
    const mpm::PoreWater* water(std::size_t body) const {
        return waters[body] ? &*waters[body] : nullptr;
    }
    std::ptrdiff_t particles() const;

  private:
    bool is_cut(const Cuts& cuts) const;
    std::size_t asked_variable(const std::string& name, const std::string& stage, bool of_motion);
    void ask(AskedVariable& variable, double t);
    void take_particles_out();
    mpm::BuiltCase build(const std::vector<std::vector<int>>& traction_ids);
    void add_bodies(const mpm::BuiltCase& built);
    std::size_t body_of(int id) const;
    std::vector<std::uint64_t> nodes_here(const std::vector<std::uint64_t>& all) const;

    FixCase plan;
    VariableAt variables;
    std::vector<AskedVariable> asked;
    std::shared_ptr<mpm::Clock> clock;
    std::vector<std::vector<std::string>> names_of;     // columns of each body
    std::vector<std::optional<mpm::PoreWater>> waters;  // of each body
    mpm::Axis axis_r, axis_z;                           // of the whole grid
    Cuts cut;
    std::unique_ptr<Halo> exchange;
    std::unique_ptr<mpm::Runner> runner;
    std::unique_ptr<StoredRun> stored;
    std::map<int, PointRow> waiting;
    std::vector<int> leaving;
};

}  // namespace grit::lammps
