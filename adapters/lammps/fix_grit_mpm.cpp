// SPDX-License-Identifier: GPL-2.0-only
#include "adapters/lammps/fix_grit_mpm.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "adapters/lammps/guarded.hpp"
#include "adapters/mpm/run/history.hpp"

namespace grit::lammps {

using LAMMPS_NS::Comm;
using LAMMPS_NS::Fix;
using LAMMPS_NS::LAMMPS;

FixGritMpm::FixGritMpm(LAMMPS* host, int count, char** words) : Fix(host, count, words) {
    if (count < 4) error->all(FLERR, std::string("Illegal fix grit/mpm command: no geometry"));
    check_host();
    guarded([&] {
        const double box[2][2] = {{domain->boxlo[0], domain->boxhi[0]},
                                  {domain->boxlo[1], domain->boxhi[1]}};
        run = std::make_unique<LocalRun>(
            read_fix({words + 3, words + count}, box),
            [this](const std::string& name, double t) { return variable_at(name, t); });
        for (std::size_t b = 0; b < run->description().members.size(); ++b)
            most_columns = std::max(most_columns, run->column_names(b).size());
    });
    const FixCase& plan = run->description();
    for (std::size_t b = 0; b < plan.members.size(); ++b) {
        const Members& of = plan.members[b];
        const int number = of.type > 0 ? 0 : group->find(of.group);
        if (number < 0) error->all(FLERR, "Could not find fix grit/mpm body group ID " + of.group);
        if (of.type > atom->ntypes)
            error->all(FLERR, "Fix grit/mpm: there is no atom type " + std::to_string(of.type));
        member_bits.push_back(of.type > 0 ? 0 : group->bitmask[number]);
    }
    for (const std::string& name : plan.traction_groups)
        if (group->find(name) < 0)
            error->all(FLERR, "Could not find fix grit/mpm traction group ID " + name);

    time_integrate = 1;
    force_reneighbor = 1;
    next_reneighbor = -1;
    restart_global = 1;
    restart_peratom = 1;
    time_depend = 1;
    vector_flag = 1;
    size_vector = static_cast<int>(mpm::history_columns().size());
    global_freq = 1;
    extvector = 0;
    peratom_flag = 1;
    size_peratom_cols = static_cast<int>(most_columns);
    peratom_freq = 1;
    nevery = 1;
    maxexchange = static_cast<int>(most_columns) + 2;
    FixGritMpm::grow_arrays(atom->nmax);
    atom->add_callback(0);
    atom->add_callback(1);
    for (std::size_t b = 0; b < plan.points.size(); ++b)
        if (!plan.points[b].empty()) read_points(b);
}

FixGritMpm::~FixGritMpm() {
    atom->delete_callback(id, 0);
    atom->delete_callback(id, 1);
}

int FixGritMpm::setmask() {
    using namespace LAMMPS_NS::FixConst;
    return INITIAL_INTEGRATE | PRE_NEIGHBOR | POST_RUN;
}

void FixGritMpm::check_host() const {
    const auto refuse = [this](const char* why) {
        error->all(FLERR, std::string("Fix grit/mpm requires ") + why);
    };
    if (domain->dimension != 2) refuse("dimension 2");
    if (domain->triclinic) refuse("an orthogonal box");
    for (int d = 0; d < 2; ++d)
        for (int side = 0; side < 2; ++side)
            if (domain->boundary[d][side] != 1)
                refuse("fixed boundaries along x and y: boundary f f p");
    if (!atom->tag_enable || atom->map_style == 0)
        refuse("atom IDs and a map: atom_modify map yes");
    check_bricks();
}

void FixGritMpm::check_bricks() const {
    if (comm->layout == Comm::LAYOUT_TILED || comm->style != 0)
        error->all(FLERR,
                   std::string("Fix grit/mpm requires brick sub-domains, not those of balance "
                               "rcb: comm_style brick"));
}

void FixGritMpm::fail(const std::string& why) {
    if (comm->nprocs == 1) error->all(FLERR, "Fix grit/mpm: " + why);
    error->one(FLERR, "Fix grit/mpm: " + why);
}

void FixGritMpm::init() {
    check_host();
    check_variables();
    if (update->whichflag == 2)
        error->all(FLERR, std::string("Fix grit/mpm cannot be used with minimize"));
    if (std::string(update->integrate_style) != "verlet")
        error->all(FLERR, std::string("Fix grit/mpm requires run_style verlet"));
    int integrators = 0;
    for (int i = 0; i < modify->nfix; ++i) integrators += modify->fix[i]->time_integrate;
    if (integrators > 1)
        error->all(FLERR, std::string("Fix grit/mpm cannot share the atoms with another fix that "
                                      "moves them"));
}

// The sub-domains, as Domain::set_local_box cuts them.
Cuts FixGritMpm::cuts() const {
    Cuts out{world, {}, {comm->myloc[0], comm->myloc[1]}, {}};
    const double* splits[] = {comm->xsplit, comm->ysplit};
    for (std::size_t d = 0; d < 2; ++d) {
        for (int i = 0; i < comm->procgrid[d]; ++i)
            out.at[d].push_back(domain->boxlo[d] + domain->prd[d] * splits[d][i]);
        out.at[d].push_back(domain->boxhi[d]);
        for (int side = 0; side < 2; ++side) out.neighbour[d][side] = comm->procneigh[d][side];
    }
    return out;
}

int FixGritMpm::body_of(int i) const {
    const std::vector<Members>& members = run->description().members;
    int found = -1;
    for (std::size_t b = 0; b < members.size(); ++b) {
        const bool is_in = member_bits[b] ? (atom->mask[i] & member_bits[b]) != 0
                                          : atom->type[i] == members[b].type;
        if (!is_in) continue;
        if (found >= 0)
            error->one(FLERR, "Fix grit/mpm: atom " + std::to_string(atom->tag[i]) +
                                  " belongs to two bodies");
        found = static_cast<int>(b);
    }
    return found;
}

bool FixGritMpm::is_mine(int i) const { return (atom->mask[i] & groupbit) != 0; }

// All atoms are where they belong.
void FixGritMpm::setup_pre_neighbor() {
    long here = 0, wanted[2];
    for (int i = 0; i < atom->nlocal; ++i) here += is_mine(i) ? 1 : 0;
    guarded([&] {
        run->start(cuts(), traction_ids());
        const std::vector<std::vector<std::string>> due = std::move(stages_due);
        stages_due.clear();
        for (const std::vector<std::string>& words : due) begin_stage(words);
    });
    long counts[2] = {here, static_cast<long>(run->particles())};
    MPI_Allreduce(counts, wanted, 2, MPI_LONG, MPI_SUM, world);
    if (wanted[0] != wanted[1])
        error->all(FLERR, "Fix grit/mpm: " + std::to_string(wanted[0]) +
                              " atoms in its group, but " + std::to_string(wanted[1]) +
                              " material points");
    if (run->run().finished())
        error->all(FLERR, std::string("Fix grit/mpm: all stages have ended"));
    way = 0.0;
    ask_variables(&LocalRun::ask_for_motion_now);
    update->dt = run->simulation().next_step() > 0.0 ? run->simulation().next_step() : update->dt;
    traffic_before = run->halo().traffic();
    run_began = MPI_Wtime();
    first_step = update->ntimestep;
}

void FixGritMpm::pre_neighbor() {
    check_bricks();
    follow_cuts();
    way = 0.0;
}

// Sub-domains are the same for all processes: all of them start anew, or none.
void FixGritMpm::follow_cuts() {
    guarded_here([this] {
        if (run->is_cut_anew(cuts())) run->start(cuts(), traction_ids());
        else run->settle();
    });
}

void FixGritMpm::setup(int) {
    guarded_here([this] { show_columns(); });
}

// A run with "pre no" has no setup: it goes on with what the run before and commands have left.
void FixGritMpm::begin_run() {
    if (run->run().finished())
        error->all(FLERR, std::string("Fix grit/mpm: all stages have ended"));
    if (run->is_cut_anew(cuts()))
        error->all(FLERR, std::string("Fix grit/mpm: the sub-domains are other ones now, this run "
                                      "cannot be one with pre no"));
    guarded_here([this] { run->settle(); });
}

void FixGritMpm::initial_integrate(int) {
    if (update->ntimestep == update->firststep + 1) begin_run();
    ask_variables(&LocalRun::ask_for_step);
    guarded_here([this] {
        const int stage = run->run().state().stage;
        run->run().step();
        show_atoms();
        if (is_looked_at()) show_columns();
        if (run->run().state().stage != stage) timer->force_timeout();
    });
    const mpm::Simulation& simulation = run->simulation();
    update->atime = simulation.time();
    update->atimestep = update->ntimestep;
    update->dt = simulation.next_step();
    // The driver's sort has the same measure: one more step moves less than the other half.
    run->halo().max(&way, 1);
    if (way > 0.5 * run->slack()) next_reneighbor = update->ntimestep;
}

int FixGritMpm::modify_param(int count, char** words) {
    if (std::string(words[0]) != "stage" || count < 2) return 0;
    const std::vector<std::string> all(words + 1, words + count);
    guarded([&] {
        if (run->started()) begin_stage(all);
        else stages_due.push_back(all);
    });
    return count;
}

void FixGritMpm::begin_stage(const std::vector<std::string>& words) {
    mpm::Runner& runner = run->run();
    runner.begin(words[0], [&](const mpm::StagePlan& before) {
        return read_stage({words.begin() + 1, words.end()}, before,
                          runner.description().settings.scheme);
    });
}

void FixGritMpm::post_run() {
    if (!run->started()) return;
    timer->reset_timeout();
    guarded_here([this] { show_columns(); });
    report_traffic();
}

}  // namespace grit::lammps
