// SPDX-License-Identifier: BSD-3-Clause
// A run on a grid that is cut again, here by one process alone.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include <adapters/lammps/local_run.hpp>

namespace {

using grit::lammps::Cuts;
using grit::lammps::LocalRun;

class LammpsCuts : public ::testing::Test {
  protected:
    static void SetUpTestSuite() {
        int is_there = 0;
        MPI_Initialized(&is_there);
        if (!is_there) MPI_Init(nullptr, nullptr);
    }
    static void TearDownTestSuite() { MPI_Finalize(); }

    // A row of particles in an elastic body, that flies.
    static LocalRun flight() {
        const grit::lammps::Box box{{{0.0, 24.0}, {0.0, 24.0}}};
        LocalRun out(grit::lammps::read_fix({"plane_strain", "grid", "r",  "24",      "24",  "1",
                                             "grid",         "z",    "24", "24",      "1",   "body",
                                             "block",        "type", "1",  "elastic", "1e6", "0.3",
                                             "gravity",      "0"},
                                            box),
                     {});
        using namespace grit::mpm::column;
        for (int id = 1; id <= particles; ++id) {
            std::vector<double> row(out.column_names(0).size(), 0.0);
            row[r] = 2.25 + 0.5 * id;
            row[z] = 4.25;
            row[v_r] = 1.0;
            row[F_rr] = row[F_zz] = row[F_tt] = 1.0;
            row[l_r] = row[l_z] = 0.25;
            row[V0] = 0.25;
            row[mass] = 500.0;
            out.put(id, {0, row});
        }
        return out;
    }
    static Cuts at(std::vector<double> r) {
        Cuts out{MPI_COMM_SELF, 2, {std::move(r), {0.0, 24.0}}, {}, {}, {0}};
        for (auto& direction : out.neighbour) direction[0] = direction[1] = MPI_PROC_NULL;
        return out;
    }
    static constexpr int particles = 6;
};

TEST_F(LammpsCuts, ThatAreRefusedLeaveTheRunAsItWas) {
    LocalRun undisturbed = flight(), run = flight();
    const Cuts whole = at({0.0, 24.0}), thin = at({0.0, 10.0, 11.0, 24.0});
    undisturbed.start(whole, {});
    EXPECT_THROW(run.start(thin, {}), std::invalid_argument);
    EXPECT_FALSE(run.started());
    EXPECT_TRUE(run.is_cut_anew(thin));
    run.start(whole, {});
    for (int step = 0; step < 3; ++step) {
        run.run().step();
        undisturbed.run().step();
        EXPECT_THROW(run.start(thin, {}), std::invalid_argument);
        EXPECT_TRUE(run.is_cut_anew(thin));
        EXPECT_FALSE(run.is_cut_anew(whole));
        run.settle({});
        EXPECT_EQ(run.particles(), particles);
    }
    for (int id = 1; id <= particles; ++id)
        EXPECT_EQ(run.row(id).columns, undisturbed.row(id).columns);
}

}  // namespace
