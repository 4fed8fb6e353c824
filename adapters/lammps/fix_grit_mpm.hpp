// SPDX-License-Identifier: GPL-2.0-only
// fix grit/mpm: the atoms of a group are the material points of a run of Grit. See docs/lammps.md.
#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "adapters/lammps/local_run.hpp"
#include "adapters/lammps/shim/host.hpp"

namespace grit::lammps {

class FixGritMpm : public LAMMPS_NS::Fix {
  public:
    FixGritMpm(LAMMPS_NS::LAMMPS* host, int count, char** words);
    ~FixGritMpm() override;

    int setmask() override;
    void init() override;
    void setup_pre_neighbor() override;
    void initial_integrate(int) override;
    void pre_neighbor() override;
    void setup(int) override;
    void post_run() override;
    int modify_param(int count, char** words) override;

    double compute_vector(int i) override;
    double memory_usage() override;

    void grow_arrays(int most_atoms) override;
    void copy_arrays(int from, int to, int) override;
    void set_arrays(int i) override;
    int pack_exchange(int i, double* to) override;
    int unpack_exchange(int i, double* from) override;
    int pack_restart(int i, double* to) override;
    void unpack_restart(int i, int which) override;
    int size_restart(int i) override;
    int maxsize_restart() override;
    void write_restart(FILE* file) override;
    void restart(char* bytes) override;

  private:
    // Of a call into Grit: what it throws becomes an error of LAMMPS.
    template <class Work> void guarded(const Work& work);
    template <class Work> void guarded_here(const Work& work);
    [[noreturn]] void fail(const std::string& why);
    void check_variables() const;
    void check_host() const;
    void check_bricks() const;
    void check_box() const;
    void check_tractions() const;
    void check_beginning() const;
    void check_points();
    void check_places();
    Box box_now() const;
    void end_timeout();
    std::string bytes_of(const std::string& file);
    void broadcast(std::string& text);
    void read_points(std::size_t body);
    LoadedIds loaded_here() const;
    LoadedIds checked_loads() const;
    Cuts cuts() const;
    int body_of(int atom) const;
    void begin_stage(const std::vector<std::string>& words);
    void ask_variables(void (LocalRun::*ask)());
    double variable_at(const std::string& name, double t);
    void follow_cuts();
    void begin_run();
    void put(int atom, PointRow given);
    bool is_looked_at() const;
    int atom_of(int point) const;
    void show(int atom, PointRow& given);
    void show_atoms();
    void show_columns();
    void report_traffic();
    bool is_mine(int atom) const;
    void take_nodes_along(const NodeItems& nodes);
    // Words of the nodes that ride on an atom.
    struct Riders {
        const std::uint64_t* words = nullptr;
        std::size_t count = 0;
    };
    Riders riders_of(int atom) const;

    int dimensions = 2;
    Box box{};                  // that the grid was made for
    bool is_restarted = false;  // what a restart file says is there
    bool is_at_stage_end =
        false;  // LAMMPS is told of the end of a stage as of a timeout, until the next one is
    std::unique_ptr<LocalRun> run;
    std::vector<int> member_bits;                      // of bodies by group, 0: by type
    std::vector<std::vector<std::string>> stages_due;  // of fix_modify before the run is built
    std::vector<double> row;                           // of the history ...
    long row_step = -1;                                // ... after this step of the run
    bool row_is_taken = false;                         // it was row(), not row_so_far()
    bool is_asking = false;                            // for variables of loads and motions
    std::vector<double> shown;                        // columns of as many atoms as may be here ...
    std::vector<double*> shown_rows;                  // ... and where each begins
    double way = 0.0;                                 // since the last migration, at most [m]
    std::size_t most_columns = 0, shown_columns = 0;  // of a particle; with those of pores
    bool has_water = false;                           // any body
    SpreadItems riding;                               // of a restart file that is being written ...
    std::vector<std::size_t> seat;                    // ... and the place of each atom among ours
    Halo::Traffic traffic_before;
    double run_began = 0.0;
    LAMMPS_NS::bigint first_step = 0;
};

}  // namespace grit::lammps
