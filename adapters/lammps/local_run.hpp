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
#include "adapters/lammps/node_items.hpp"
#include "adapters/mpm/run/run.hpp"

namespace grit::lammps {

// All columns of a particle.
struct PointRow {
    std::size_t body = 0;
    std::vector<double> columns;
};

// A run between two steps, but for its particles; independent of how the grid is cut. The same for all processes, but
// for nodes, of which each has some.
struct StoredRun {
    mpm::RunState state;
    double energy_scale = 0.0;  // [J]
    std::vector<mpm::StagePlan> stages;
    std::string common;  // see GridState
    NodeItems nodes;     // those with some word that is not 0

    template <class Self, class Archive> static void visit(Self& run, Archive& archive) {
        mpm::RunState::visit(run.state, archive);
        archive.value(run.energy_scale);
        archive.list(run.common);
        archive.value(run.nodes.words_each);
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

// Of each traction: which of the particles here it acts on.
using LoadedIds = std::vector<std::vector<int>>;

class LocalRun {
  public:
    LocalRun(FixCase plan, VariableAt variables);

    // Particles come here, to be there from settle() on; they may be taken away again before that.
    void put(int id, PointRow row) { waiting[id] = std::move(row); }
    // The columns of a particle that is here. Throws std::runtime_error if it is not.
    PointRow row(int id) const;
    // It leaves with the next settle().
    void leave(int id);
    void settle(const LoadedIds& loaded);

    // Builds what a run needs, once more if the grid is cut in another way. Every process must call it. Throws what
    // build_case throws.
    void start(const Cuts& cuts, const LoadedIds& loaded);
    // Of the step that the next start() begins with, and more of its nodes, as in NodeItems.
    void go_on_from(StoredRun run) { stored = std::make_unique<StoredRun>(std::move(run)); }
    void take_nodes(const std::vector<std::uint64_t>& words);
    std::size_t words_of_a_node() const { return stored ? stored->nodes.each() : 1; }
    // Particles may be on their way.
    StoredRun store() const;
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
    bool in_space() const { return plan.plan.space.has_value(); }
    // Of three normal ones that follow each other among the columns.
    int first_stress() const {
        return in_space() ? int{mpm::space::column::S_xx} : int{mpm::column::S_rr};
    }
    double time() const { return runner->subject().time(); }
    long steps() const { return runner->subject().steps(); }
    double next_step() const;
    // work(body, particles) of all bodies, their columns.
    template <class Work> void each_body(const Work& work) const {
        with([&](const auto& simulation) {
            for (std::size_t b = 0; b < simulation.bodies(); ++b)
                work(b, simulation.body(b).particles);
        });
    }
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
    // work(simulation), in the plane or in space.
    template <class Work> auto with(const Work& work) const {
        return in_space() ? work(*runner->space()) : work(runner->simulation());
    }
    bool is_cut(const Cuts& cuts) const;
    std::size_t asked_variable(const std::string& name, const std::string& stage, bool of_motion);
    void ask(AskedVariable& variable, double t);
    void take_particles_out();
    mpm::BuiltCase build();
    void build_plane(const mpm::BuiltCase& built);
    void build_space(const mpm::BuiltCase& built);
    std::vector<mpm::Traction> tractions(const mpm::Simulation& of, const LoadedIds& loaded) const;
    std::vector<mpm::space::Traction> tractions(const mpm::space::Simulation& of,
                                                const LoadedIds& loaded) const;
    mpm::Axis axis_here(int direction) const;
    // Of a body: those that wait to be here.
    template <class Particles> Particles particles_of(std::size_t body, int first_own) const;
    mpm::Body plane_body(std::size_t body);
    void check_beside_axis(const mpm::Body& body) const;
    mpm::space::Body space_body(std::size_t body);
    std::function<Vector2(double)> velocity_of(std::size_t body);
    std::function<Vector3(double)> with_variables(std::function<Vector3(double)> other,
                                                  const std::string (&names)[3],
                                                  const std::string& stage);
    std::size_t body_of(int id) const;
    std::vector<int> nodes_along() const;
    template <class Work> void each_node(const Work& work) const;
    NodeItems items() const;
    std::vector<std::uint64_t> nodes_here(const NodeItems& all) const;

    FixCase plan;
    VariableAt variables;
    std::vector<AskedVariable> asked;
    std::shared_ptr<mpm::Clock> clock;
    std::vector<std::vector<std::string>> names_of;           // columns of each body
    std::vector<std::optional<mpm::PoreWater>> waters;        // of each body
    std::vector<std::function<Vector2(double)>> edge_stress;  // of each traction in the plane ...
    std::vector<std::function<Vector3(double)>> face_stress;  // ... or in space
    std::vector<mpm::Axis> axes;                              // of the whole grid
    Cuts cut;
    std::unique_ptr<Halo> exchange;
    std::unique_ptr<mpm::Runner> runner;
    std::unique_ptr<StoredRun> stored;
    std::map<int, PointRow> waiting;
    std::vector<int> leaving;
};

}  // namespace grit::lammps
