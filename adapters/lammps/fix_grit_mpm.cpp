// SPDX-License-Identifier: GPL-2.0-only
#include "adapters/lammps/fix_grit_mpm.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "adapters/lammps/points_file.hpp"
#include "adapters/lammps/run_bytes.hpp"
#include "adapters/lammps/words.hpp"
#include "adapters/mpm/case/closed_surface.hpp"
#include "adapters/mpm/case/initial_state.hpp"
#include "adapters/mpm/run/history.hpp"
#include "adapters/mpm/step/column_names.hpp"
#include "adapters/mpm/step/text.hpp"
#include "adapters/mpm/step/thread_pool.hpp"

namespace grit::lammps {

using LAMMPS_NS::Comm;
using LAMMPS_NS::Fix;
using LAMMPS_NS::LAMMPS;

namespace {

constexpr std::size_t chunk = 1 << 20;  // bytes that are sent at once

// Whole lines; empty: the end.
std::string next_lines(std::ifstream& file) {
    std::string out, line;
    while (out.size() < chunk && std::getline(file, line)) out += line + '\n';
    return out;
}

// The pore_fields of plane or space, where any body has water behind the columns of the longest. value: of a column.
template <class Value>
void show_pores(const mpm::PoreWater* water, int first_stress, const Value& value, double* to) {
    const double p_w = water ? water->bearing(value(water->first)) : 0.0;
    to[0] = p_w;
    for (int k = 0; k < 3; ++k) to[k + 1] = value(first_stress + k) - p_w;
}

mpm::words::Geometry geometry_of(const mpm::Case& plan) {
    using mpm::words::Geometry;
    if (plan.space) return Geometry::space;
    return plan.settings.axisymmetric ? Geometry::axisymmetric : Geometry::plane_strain;
}

// A row among doubles: their count with this one, the body, the columns.
constexpr std::size_t before_columns = 2;

int packed_size(std::size_t columns) { return static_cast<int>(before_columns + columns); }

int pack(const PointRow& row, double* to) {
    to[0] = packed_size(row.columns.size());
    to[1] = static_cast<double>(row.body);
    std::copy(row.columns.begin(), row.columns.end(), to + before_columns);
    return packed_size(row.columns.size());
}

PointRow unpack(const double* from) {
    return {static_cast<std::size_t>(from[1]),
            {from + before_columns, from + static_cast<std::ptrdiff_t>(from[0])}};
}

double pressure_of_table(const mpm::Case& plan, std::size_t body, double z) {
    const mpm::BodyPlan& of = plan.bodies[body];
    refuse("the table of water " + of.name, mpm::objection_to_water_table(of, z), no_name);
    return mpm::pore_pressure_at(*of.water, plan.gravity, z);
}

static_assert(sizeof(double) == sizeof(std::uint64_t));

}  // namespace

// What is wrong with a command is wrong on all processes; what fails in a step may fail on one.
template <class Work> void FixGritMpm::guarded(const Work& work) {
    try {
        work();
    } catch (const std::invalid_argument& wrong) {
        error->all(FLERR, std::string("Illegal fix grit/mpm command: ") + wrong.what());
    } catch (const std::exception& failure) {
        fail(failure.what());
    }
}

template <class Work> void FixGritMpm::guarded_here(const Work& work) {
    try {
        work();
    } catch (const std::exception& failure) {
        fail(failure.what());
    }
}

FixGritMpm::FixGritMpm(LAMMPS* host, int count, char** words) : Fix(host, count, words) {
    if (count < 4) error->all(FLERR, std::string("Illegal fix grit/mpm command: no geometry"));
    dimensions = is_in_space(words[3]) ? 3 : 2;
    check_host();
    box = box_now();
    guarded([&] {
        FixCase plan = read_fix({words + 3, words + count}, box);
        read_surfaces(plan, [this](const std::string& file) { return bytes_of(file); });
        run =
            std::make_unique<LocalRun>(std::move(plan), [this](const std::string& name, double t) {
                return variable_at(name, t);
            });
        for (std::size_t b = 0; b < run->description().members.size(); ++b)
            most_columns = std::max(most_columns, run->column_names(b).size());
    });
    const FixCase& plan = run->description();
    for (const mpm::BodyPlan& body : plan.plan.bodies) has_water = has_water || body.water;
    shown_columns = most_columns + (has_water ? std::size(mpm::pore_fields) : 0);
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
    stores_ids = 1;
    time_depend = 1;
    vector_flag = 1;
    size_vector = static_cast<int>(mpm::history_columns(run->in_space()).size());
    global_freq = 1;
    extvector = 0;
    peratom_flag = 1;
    size_peratom_cols = static_cast<int>(shown_columns);
    peratom_freq = 1;
    nevery = 1;
    maxexchange = packed_size(most_columns);
    FixGritMpm::grow_arrays(atom->nmax);
    atom->add_callback(0);
    atom->add_callback(1);
    for (std::size_t b = 0; b < plan.points.size(); ++b)
        if (!plan.points[b].empty()) read_points(b);
}

FixGritMpm::~FixGritMpm() {
    atom->delete_callback(id, 0);
    atom->delete_callback(id, 1);
    end_timeout();
}

int FixGritMpm::setmask() {
    using namespace LAMMPS_NS::FixConst;
    return INITIAL_INTEGRATE | PRE_NEIGHBOR | POST_RUN;
}

void FixGritMpm::check_host() const {
    const auto refuse = [this](const char* why) {
        error->all(FLERR, std::string("Fix grit/mpm requires ") + why);
    };
    const bool in_space = dimensions == 3;
    if (domain->dimension != dimensions) refuse(in_space ? "dimension 3" : "dimension 2");
    if (domain->triclinic) refuse("an orthogonal box");
    for (int d = 0; d < dimensions; ++d)
        for (int side = 0; side < 2; ++side)
            if (domain->boundary[d][side] != 1)
                refuse(in_space ? "fixed boundaries along x, y and z: boundary f f f"
                                : "fixed boundaries along x and y: boundary f f p");
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

Box FixGritMpm::box_now() const {
    Box out;
    for (std::size_t d = 0; d < out.size(); ++d) out[d] = {domain->boxlo[d], domain->boxhi[d]};
    return out;
}

// The grid was made for it.
void FixGritMpm::check_box() const {
    const Box now = box_now();
    for (int d = 0; d < dimensions; ++d) {
        const auto& was = box[static_cast<std::size_t>(d)];
        const auto& is = now[static_cast<std::size_t>(d)];
        if (was != is)
            error->all(FLERR, std::string("Fix grit/mpm: the box along ") + "xyz"[d] + " is from " +
                                  mpm::exact_text(is[0]) + " to " + mpm::exact_text(is[1]) +
                                  " m, the grid of the fix from " + mpm::exact_text(was[0]) +
                                  " to " + mpm::exact_text(was[1]) +
                                  " m: change_box before the fix is made");
    }
}

// All processes see a group change, but none that it does so within a run.
void FixGritMpm::check_tractions() const {
    for (const std::string& name : run->description().traction_groups) {
        const int number = group->find(name);
        if (number >= 0 && group->dynamic[number])
            error->all(FLERR, "Fix grit/mpm: traction group " + name +
                                  " is dynamic, but loads stay on their atoms while a run lasts");
    }
}

// Atoms that have moved have more than the files of points know.
void FixGritMpm::check_beginning() const {
    if (run->has_begun() || is_restarted || update->ntimestep == 0) return;
    error->all(
        FLERR,
        "Fix grit/mpm: the atoms are at step " + std::to_string(update->ntimestep) + ", but fix " +
            id +
            " knows of no run before: it was removed, or a restart file has it under another ID; "
            "reset_timestep 0 before the fix lets its run begin with the atoms as they are");
}

// Each atom of the group is a material point, and each body has some.
void FixGritMpm::check_points() {
    std::vector<long> count(1, 0);
    for (int i = 0; i < atom->nlocal; ++i) count[0] += is_mine(i) ? 1 : 0;
    run->each_body([&](std::size_t, const mpm::ParticleColumns& of) {
        count.push_back(static_cast<long>(of.size()));
    });
    MPI_Allreduce(MPI_IN_PLACE, count.data(), static_cast<int>(count.size()), MPI_LONG, MPI_SUM,
                  world);
    long points = 0;
    for (std::size_t b = 0; b + 1 < count.size(); ++b) {
        points += count[b + 1];
        if (count[b + 1] == 0)
            error->all(FLERR, "Fix grit/mpm: body " + run->description().plan.bodies[b].name +
                                  " has no atoms");
    }
    if (count[0] != points)
        error->all(FLERR, "Fix grit/mpm: " + std::to_string(count[0]) +
                              " atoms in its group, but " + std::to_string(points) +
                              " material points");
}

// Positions are the fix's: where a command has moved an atom, it may be on another process than its point.
void FixGritMpm::check_places() {
    const double most = 1e-9 * run->slack();  // what cuts that move may round
    run->each_body([&](std::size_t, const mpm::ParticleColumns& q) {
        for (std::ptrdiff_t p = 0; p < q.size(); ++p) {
            const double* const x = atom->x[atom_of(q.ids()[p])];
            for (int d = 0; d < dimensions; ++d)
                if (!(std::fabs(x[d] - q(d, p)) <= most))
                    throw std::runtime_error(
                        "a command has moved atom " + std::to_string(q.ids()[p]) + " along " +
                        "xyz"[d] + " to " + mpm::exact_text(x[d]) +
                        " m, its material point is at " + mpm::exact_text(q(d, p)) + " m");
        }
    });
}

void FixGritMpm::fail(const std::string& why) {
    if (comm->nprocs == 1) error->all(FLERR, "Fix grit/mpm: " + why);
    error->one(FLERR, "Fix grit/mpm: " + why);
}

void FixGritMpm::init() {
    check_host();
    check_box();
    check_tractions();
    check_variables();
    if (update->whichflag == 2)
        error->all(FLERR, std::string("Fix grit/mpm cannot be used with minimize"));
    if (std::string(update->integrate_style) != "verlet")
        error->all(FLERR, std::string("Fix grit/mpm requires run_style verlet"));
    const std::string word = mpm::word_of_unused_threads(run->description().plan.settings.threads);
    if (comm->me == 0 && !word.empty()) error->warning(FLERR, "Fix grit/mpm: " + word);
    int integrators = 0;
    for (int i = 0; i < modify->nfix; ++i) integrators += modify->fix[i]->time_integrate;
    if (integrators > 1)
        error->all(FLERR, std::string("Fix grit/mpm cannot share the atoms with another fix that "
                                      "moves them"));
}

// The sub-domains, as Domain::set_local_box cuts them.
Cuts FixGritMpm::cuts() const {
    Cuts out{world, dimensions, {}, {}, {}, {}};
    const double* splits[] = {comm->xsplit, comm->ysplit, comm->zsplit};
    for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions); ++d) {
        out.here[d] = comm->myloc[d];
        for (int i = 0; i < comm->procgrid[d]; ++i)
            out.at[d].push_back(domain->boxlo[d] + domain->prd[d] * splits[d][i]);
        out.at[d].push_back(domain->boxhi[d]);
        for (int side = 0; side < 2; ++side) out.neighbour[d][side] = comm->procneigh[d][side];
    }
    for (int k = 0; k < comm->procgrid[2]; ++k)
        for (int j = 0; j < comm->procgrid[1]; ++j)
            for (int i = 0; i < comm->procgrid[0]; ++i)
                out.rank.push_back(comm->grid2proc[i][j][k]);
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
    check_beginning();
    guarded([&] {
        run->start(cuts(), checked_loads());
        const std::vector<std::vector<std::string>> due = std::move(stages_due);
        stages_due.clear();
        for (const std::vector<std::string>& words : due) begin_stage(words);
    });
    check_points();
    guarded_here([this] { check_places(); });
    if (run->run().finished())
        error->all(FLERR, std::string("Fix grit/mpm: all stages have ended"));
    way = 0.0;
    ask_variables(&LocalRun::ask_for_motion_now);
    update->atime = run->time();
    update->atimestep = update->ntimestep;
    if (run->next_step() > 0.0) update->dt = run->next_step();
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
    guarded_here([this] { run->start(cuts(), loaded_here()); });
}

void FixGritMpm::setup(int) {
    guarded_here([this] { show_columns(); });
}

// A run with "pre no" has no setup: it goes on with what the run before and commands have left.
void FixGritMpm::begin_run() {
    if (!run->started())
        error->all(FLERR, std::string("Fix grit/mpm: its first run cannot be one with pre no"));
    if (run->run().finished())
        error->all(FLERR, std::string("Fix grit/mpm: all stages have ended"));
    if (run->is_cut_anew(cuts()))
        error->all(FLERR, std::string("Fix grit/mpm: the sub-domains are other ones now, this run "
                                      "cannot be one with pre no"));
    guarded_here([this] { run->settle(loaded_here()); });
}

void FixGritMpm::initial_integrate(int) {
    if (update->ntimestep == update->firststep + 1) begin_run();
    ask_variables(&LocalRun::ask_for_step);
    guarded_here([this] {
        const int stage = run->run().state().stage;
        run->run().step();
        show_atoms();
        if (is_looked_at()) show_columns();
        if (run->run().state().stage == stage) return;
        timer->force_timeout();
        is_at_stage_end = true;
    });
    update->atime = run->time();
    update->atimestep = update->ntimestep;
    update->dt = run->next_step();
    // The driver's sort has the same measure: one more step moves less than the other half.
    run->halo().max(&way, 1);
    if (way > 0.5 * run->slack()) next_reneighbor = update->ntimestep;
}

int FixGritMpm::modify_param(int count, char** words) {
    if (std::string(words[0]) != "stage" || count < 2) return 0;
    const std::vector<std::string> all(words + 1, words + count);
    end_timeout();
    if (timer->is_timeout()) {  // LAMMPS leaves out the runs to come, and so the stage
        if (comm->me == 0)
            error->warning(FLERR, "Fix grit/mpm: stage " + all[0] +
                                      " is left out: LAMMPS was told to end, by timer timeout or "
                                      "another fix");
        return count;
    }
    guarded([&] {
        if (run->started()) begin_stage(all);
        else stages_due.push_back(all);
    });
    return count;
}

void FixGritMpm::begin_stage(const std::vector<std::string>& words) {
    mpm::Runner& runner = run->run();
    runner.begin(words[0], [&](const mpm::StagePlan& before) {
        return read_stage({words.begin() + 1, words.end()}, before, runner.description());
    });
}

// The timeout outlasts the run: a "run N every M" looks for one between its parts, which all end with the stage. Nothing tells
// when its last one is over; runs are left out until a stage is described.
void FixGritMpm::post_run() {
    if (!run->started()) return;
    if (is_at_stage_end && comm->me == 0)
        LAMMPS_NS::utils::logmesg(
            lmp, run->run().finished()
                     ? std::string("Grit: all stages have ended, further runs are left out\n")
                     : std::string("Grit: a stage has ended, runs are left out until fix_modify ") +
                           id + " stage describes the next one\n");
    guarded_here([this] {
        run->settle(loaded_here());
        show_columns();
    });
    report_traffic();
}

// The one that the fix has called for, and no other.
void FixGritMpm::end_timeout() {
    if (is_at_stage_end) timer->reset_timeout();
    is_at_stage_end = false;
}

// One process reads, so that all have the same or none.
std::string FixGritMpm::bytes_of(const std::string& file) {
    std::string bytes, wrong;
    if (comm->me == 0) {
        try {
            bytes = mpm::stl_bytes(file);
        } catch (const std::invalid_argument& refused) {
            wrong = refused.what();
        }
    }
    broadcast(wrong);
    if (!wrong.empty()) throw std::invalid_argument(wrong);
    broadcast(bytes);
    return bytes;
}

void FixGritMpm::broadcast(std::string& text) {
    auto left = static_cast<std::uint64_t>(text.size());
    MPI_Bcast(&left, 1, MPI_UINT64_T, 0, world);
    text.resize(left);
    constexpr std::uint64_t most = 1 << 30;
    for (char* at = text.data(); left > 0;) {
        const auto now = static_cast<int>(std::min(left, most));
        MPI_Bcast(at, now, MPI_CHAR, 0, world);
        at += now;
        left -= static_cast<std::uint64_t>(now);
    }
}

void FixGritMpm::read_points(std::size_t body) {
    const std::string& name = run->description().points[body];
    std::ifstream file;
    int opened = 1;
    if (comm->me == 0) {
        file.open(name);
        opened = file ? 1 : 0;
    }
    MPI_Bcast(&opened, 1, MPI_INT, 0, world);
    if (!opened) error->all(FLERR, "Fix grit/mpm: cannot open file " + name);
    std::unique_ptr<PointsFile> points;
    std::set<int> seen;
    std::int64_t rows = 0;
    for (;;) {
        std::string lines = comm->me == 0 ? next_lines(file) : std::string();
        auto size = static_cast<int>(lines.size());
        MPI_Bcast(&size, 1, MPI_INT, 0, world);
        if (size == 0) break;
        lines.resize(static_cast<std::size_t>(size));
        MPI_Bcast(lines.data(), size, MPI_CHAR, 0, world);
        std::istringstream stream(lines);
        for (std::string line; std::getline(stream, line);) {
            const std::size_t first = line.find_first_not_of(" \t\r");
            if (first == std::string::npos || line[first] == '#') continue;
            try {
                if (!points) {
                    const mpm::Case& plan = run->description().plan;
                    points = std::make_unique<PointsFile>(
                        run->column_names(body), line, geometry_of(plan),
                        std::vector<PointsFile::Otherwise>{
                            {"p_w",
                             [&plan, body](std::vector<double>& of) {
                                 const int z =
                                     plan.space ? int{mpm::space::column::z} : int{mpm::column::z};
                                 return pressure_of_table(plan, body,
                                                          of[static_cast<std::size_t>(z)]);
                             }},
                            {"m_w", [this, body](std::vector<double>& of) {
                                 return run->water(body)->mass({of.data(), 1}, 0);
                             }}});
                    continue;
                }
                const int tag = PointsFile::id_of(line.c_str());
                ++rows;
                const int i = tag >= 1 && tag <= atom->map_tag_max ? atom->map(tag) : -1;
                if (i < 0 || i >= atom->nlocal) continue;
                if (!is_mine(i) || body_of(i) != static_cast<int>(body))
                    throw std::invalid_argument("atom " + std::to_string(tag) + " is not in body " +
                                                run->description().plan.bodies[body].name);
                if (!seen.insert(tag).second)
                    throw std::invalid_argument("atom " + std::to_string(tag) + " is there twice");
                PointRow out{body, {atom->x[i], atom->x[i] + dimensions}};
                out.columns.insert(out.columns.end(), atom->v[i], atom->v[i] + dimensions);
                points->read(line.c_str(), out.columns);
                put(i, std::move(out));
            } catch (const std::exception& wrong) {
                error->one(FLERR, "Fix grit/mpm: file " + name + ": " + wrong.what());
            }
        }
    }
    if (!points) error->all(FLERR, "Fix grit/mpm: file " + name + " is empty");
    auto found = static_cast<std::int64_t>(seen.size());
    MPI_Allreduce(MPI_IN_PLACE, &found, 1, MPI_INT64_T, MPI_SUM, world);
    if (found != rows)
        error->all(FLERR, "Fix grit/mpm: file " + name + " has " + std::to_string(rows) +
                              " points, but only " + std::to_string(found) +
                              " of them have an atom");
}

// Of each traction, ascending.
LoadedIds FixGritMpm::loaded_here() const {
    LoadedIds out;
    const FixCase& plan = run->description();
    for (std::size_t k = 0; k < plan.traction_groups.size(); ++k) {
        const std::string& name = plan.traction_groups[k];
        const auto body = static_cast<int>(plan.plan.body(plan.plan.tractions[k].body));
        const int number = group->find(name);
        if (number < 0) error->all(FLERR, "Could not find fix grit/mpm traction group ID " + name);
        std::vector<int>& ids = out.emplace_back();
        for (int i = 0; i < atom->nlocal; ++i)
            if ((atom->mask[i] & group->bitmask[number]) && is_mine(i) && body_of(i) == body)
                ids.push_back(atom->tag[i]);
        std::sort(ids.begin(), ids.end());
    }
    return out;
}

// Before a run: some process has an atom of each.
LoadedIds FixGritMpm::checked_loads() const {
    LoadedIds out = loaded_here();
    for (std::size_t k = 0; k < out.size(); ++k) {
        auto count = static_cast<std::int64_t>(out[k].size());
        MPI_Allreduce(MPI_IN_PLACE, &count, 1, MPI_INT64_T, MPI_SUM, world);
        const FixCase& plan = run->description();
        if (count == 0)
            error->all(FLERR, "Fix grit/mpm: traction group " + plan.traction_groups[k] +
                                  " has no atoms of body " + plan.plan.tractions[k].body);
    }
    return out;
}

void FixGritMpm::check_variables() const {
    std::vector<std::string> names = run->description().traction_variables;
    for (const MotionVariables& motion : run->description().motion)
        for (const auto* of : {&motion.along, &motion.about})
            names.insert(names.end(), std::begin(*of), std::end(*of));
    for (const std::string& name : names) {
        if (name.empty()) continue;
        const int number = input->variable->find(name.c_str());
        if (number < 0 || !input->variable->equalstyle(number))
            error->all(FLERR, "Fix grit/mpm: there is no equal-style variable \"" + name + '"');
    }
}

// All processes ask, also those without a loaded particle: what a variable reads may need all of them.
void FixGritMpm::ask_variables(void (LocalRun::*ask)()) {
    if (!run->has_variables()) return;
    modify->clearstep_compute();
    is_asking = true;
    guarded_here([&] { (run.get()->*ask)(); });
    is_asking = false;
    modify->addstep_compute(update->ntimestep + 1);
}

double FixGritMpm::variable_at(const std::string& name, double t) {
    const int number = input->variable->find(name.c_str());
    if (number < 0) throw std::runtime_error("variable \"" + name + "\" is gone");
    const double time = update->atime;
    const LAMMPS_NS::bigint step = update->atimestep;
    update->atime = t;
    update->atimestep = update->ntimestep;
    const double value = input->variable->compute_equal(number);
    update->atime = time;
    update->atimestep = step;
    return value;
}

int FixGritMpm::pack_exchange(int i, double* to) {
    if (!is_mine(i)) {
        to[0] = 1.0;
        return 1;
    }
    int size = 0;
    guarded_here([&] {
        size = pack(run->row(atom->tag[i]), to);
        run->leave(atom->tag[i]);
    });
    return size;
}

int FixGritMpm::unpack_exchange(int i, double* from) {
    const auto size = static_cast<int>(from[0]);
    if (size > 1) put(i, unpack(from));
    else set_arrays(i);
    return size;
}

int FixGritMpm::pack_restart(int i, double* to) {
    if (!is_mine(i)) {
        to[0] = 1.0;
        return 1;
    }
    int size = 0;
    guarded_here([&] { size = pack(run->row(atom->tag[i]), to); });
    const Riders riders = riders_of(i);
    if (riders.count > 0) std::memcpy(to + size, riders.words, riders.count * sizeof(double));
    size += static_cast<int>(riders.count);
    to[0] = size;
    return size;
}

// What nodes leave for the next step goes with the atoms of a restart file, so that no process ever has all of it.
void FixGritMpm::take_nodes_along(const NodeItems& nodes) {
    std::size_t mine = 0;
    seat.clear();
    for (int i = 0; i < atom->nlocal; ++i) {
        seat.push_back(mine);
        mine += is_mine(i) ? 1 : 0;
    }
    riding = spread(nodes, mine, world);
}

FixGritMpm::Riders FixGritMpm::riders_of(int i) const {
    const NodeItems& items = riding.items;
    const std::size_t at = static_cast<std::size_t>(i) < seat.size()
                               ? seat[static_cast<std::size_t>(i)] * riding.for_each_place
                               : items.size();
    if (at >= items.size()) return {};
    return {items.words.data() + at * items.each(),
            std::min(riding.for_each_place, items.size() - at) * items.each()};
}

int FixGritMpm::size_restart(int i) {
    int size = 1;
    if (is_mine(i))
        guarded_here([&] {
            size = packed_size(run->row(atom->tag[i]).columns.size() + riders_of(i).count);
        });
    return size;
}

// Asked for after the fix has written what is not of atoms.
int FixGritMpm::maxsize_restart() {
    return packed_size(most_columns + riding.for_each_place * riding.items.each());
}

// The rows of fixes follow one another, each with its size in front.
void FixGritMpm::unpack_restart(int i, int which) {
    const double* from = atom->extra[i];
    for (int k = 0; k < which; ++k) from += static_cast<int>(*from);
    if (from[0] <= 1.0) return;
    PointRow of_atom = unpack(from);
    const std::size_t bodies = run->description().plan.bodies.size();
    const std::size_t columns = of_atom.body < bodies ? run->column_names(of_atom.body).size() : 0;
    const bool is_known = columns > 0 && of_atom.columns.size() >= columns;
    if (!is_known || (of_atom.columns.size() - columns) % run->words_of_a_node() != 0)
        error->one(FLERR, "Fix grit/mpm: atom " + std::to_string(atom->tag[i]) +
                              " of the restart file is of another material");
    std::vector<std::uint64_t> riders(of_atom.columns.size() - columns);
    if (!riders.empty())
        std::memcpy(riders.data(), of_atom.columns.data() + columns,
                    riders.size() * sizeof(double));
    run->take_nodes(riders);
    of_atom.columns.resize(columns);
    put(i, std::move(of_atom));
}

void FixGritMpm::write_restart(FILE* file) {
    std::string bytes;
    const std::uint64_t fingerprint = run->description().fingerprint;
    riding = {};
    guarded([&] {
        if (!run->has_begun()) return void(bytes = to_bytes(nullptr, fingerprint));
        const StoredRun stored = run->store();
        take_nodes_along(stored.nodes);
        bytes = to_bytes(&stored, fingerprint);
    });
    if (comm->me != 0) return;
    const auto size = static_cast<int>(bytes.size());
    std::fwrite(&size, sizeof size, 1, file);
    std::fwrite(bytes.data(), 1, bytes.size(), file);
}

void FixGritMpm::restart(char* bytes) {
    is_restarted = true;
    guarded([&] {
        const auto stored = from_bytes(bytes, run->description().fingerprint);
        if (stored) run->go_on_from(std::move(*stored));
    });
}

int FixGritMpm::atom_of(int point) const {
    const int i = atom->map(point);
    if (i < 0 || i >= atom->nlocal)
        throw std::runtime_error("LAMMPS has lost atom " + std::to_string(point));
    return i;
}

// Positions and velocities for all that looks at atoms.
void FixGritMpm::show_atoms() {
    double farthest2 = 0.0;
    run->each_body([&](std::size_t, const mpm::ParticleColumns& q) {
        for (std::ptrdiff_t p = 0; p < q.size(); ++p) {
            const int i = atom_of(q.ids()[p]);
            double way2 = 0.0;
            for (int d = 0; d < dimensions; ++d) {
                const double x = q(d, p), moved = x - atom->x[i][d];
                way2 += moved * moved;
                atom->x[i][d] = x;
                atom->v[i][d] = q(dimensions + d, p);
            }
            farthest2 = std::max(farthest2, way2);
        }
    });
    way += std::sqrt(farthest2);
}

// Columns are shown when others may look: at output, and when another fix may do something.
bool FixGritMpm::is_looked_at() const {
    using namespace LAMMPS_NS::FixConst;
    const LAMMPS_NS::bigint step = update->ntimestep;
    if (step == output->next) return true;
    for (int k = 0; k < modify->nfix; ++k) {
        const LAMMPS_NS::Fix* other = modify->fix[k];
        if (other == this) continue;
        const bool is_seldom = (modify->fmask[k] & ~(END_OF_STEP | PRE_EXCHANGE | POST_RUN)) == 0;
        if (!is_seldom || (other->nevery > 0 && step % other->nevery == 0)) return true;
    }
    return false;
}

void FixGritMpm::show_columns() {
    run->each_body([&](std::size_t b, const mpm::ParticleColumns& q) {
        for (std::ptrdiff_t p = 0; p < q.size(); ++p) {
            double* to = shown_rows[static_cast<std::size_t>(atom_of(q.ids()[p]))];
            for (int c = 0; c < q.column_count(); ++c) to[c] = q(c, p);
            if (!has_water) continue;
            const auto value = [&](int c) { return q(c, p); };
            show_pores(run->water(b), run->first_stress(), value, to + most_columns);
        }
    });
}

void FixGritMpm::show(int i, PointRow& given) {
    set_arrays(i);
    double* to = shown_rows[static_cast<std::size_t>(i)];
    std::copy(given.columns.begin(), given.columns.end(), to);
    if (!has_water) return;
    const auto value = [&](int c) { return given.columns[static_cast<std::size_t>(c)]; };
    show_pores(run->water(given.body), run->first_stress(), value, to + most_columns);
}

// Atoms keep their rows where LAMMPS sorts or sends them between two steps.
void FixGritMpm::put(int i, PointRow given) {
    show(i, given);
    run->put(atom->tag[i], std::move(given));
}

void FixGritMpm::grow_arrays(int most_atoms) {
    const auto atoms = static_cast<std::size_t>(std::max(most_atoms, 1));
    shown.resize(atoms * shown_columns, 0.0);
    shown_rows.resize(atoms);
    for (std::size_t i = 0; i < atoms; ++i) shown_rows[i] = shown.data() + i * shown_columns;
    array_atom = shown_rows.data();
}

void FixGritMpm::copy_arrays(int from, int to, int) {
    std::copy_n(shown_rows[static_cast<std::size_t>(from)], shown_columns,
                shown_rows[static_cast<std::size_t>(to)]);
}

void FixGritMpm::set_arrays(int i) {
    std::fill_n(shown_rows[static_cast<std::size_t>(i)], shown_columns, 0.0);
}

// What a variable of this fix asks for must not end the means of forces.
double FixGritMpm::compute_vector(int i) {
    if (!run->started()) return 0.0;
    const long now = run->steps();
    if (row_step != now || !(row_is_taken || is_asking)) {
        guarded_here([&] {
            const mpm::HistoryRow found = is_asking ? run->run().row_so_far() : run->run().row();
            row.clear();
            for (const mpm::HistoryColumn& column : mpm::history_columns(run->in_space()))
                row.push_back(column.value(found));
        });
        row_step = now;
        row_is_taken = !is_asking;
    }
    return row[static_cast<std::size_t>(i)];
}

double FixGritMpm::memory_usage() {
    return 2.0 * static_cast<double>(run->particles()) * static_cast<double>(shown_columns) *
           sizeof(double);
}

void FixGritMpm::report_traffic() {
    const Halo::Traffic& now = run->halo().traffic();
    const double steps = std::max(1.0, static_cast<double>(update->ntimestep - first_step));
    double mine[] = {static_cast<double>(now.messages - traffic_before.messages) / steps,
                     static_cast<double>(now.bytes - traffic_before.bytes) / steps,
                     static_cast<double>(now.reductions - traffic_before.reductions) / steps,
                     static_cast<double>(now.gathers - traffic_before.gathers) / steps,
                     static_cast<double>(now.gathered_bytes - traffic_before.gathered_bytes) /
                         steps,
                     now.seconds - traffic_before.seconds,
                     MPI_Wtime() - run_began};
    constexpr int count = sizeof mine / sizeof *mine;
    double most[count];
    MPI_Reduce(mine, most, count, MPI_DOUBLE, MPI_MAX, 0, world);
    if (comm->me != 0) return;
    char line[256];
    std::snprintf(
        line, sizeof line,
        "Grit: halo exchange %.3g s of %.3g s (%.1f %%); a step has up to %.4g messages of "
        "%.6g bytes together, %.4g reductions and %.4g gathers of %.6g bytes together per "
        "process\n",
        most[5], most[6], 100.0 * most[5] / std::max(most[6], 1e-30), most[0], most[1], most[2],
        most[3], most[4]);
    LAMMPS_NS::utils::logmesg(lmp, std::string(line));
}

}  // namespace grit::lammps
