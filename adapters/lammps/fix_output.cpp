// SPDX-License-Identifier: GPL-2.0-only
// fix grit/mpm: what the rest of LAMMPS may look at.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "adapters/lammps/guarded.hpp"
#include "adapters/mpm/run/history.hpp"

namespace grit::lammps {

int FixGritMpm::atom_of(int point) const {
    const int i = atom->map(point);
    if (i < 0 || i >= atom->nlocal)
        throw std::runtime_error("LAMMPS has lost atom " + std::to_string(point));
    return i;
}

// Positions and velocities for all that looks at atoms.
void FixGritMpm::show_atoms() {
    double farthest2 = 0.0;
    for (std::size_t b = 0; b < run->simulation().bodies(); ++b) {
        mpm::Particles& particles = run->simulation().body(b).particles;
        const mpm::ParticleView q = particles.view();
        const double *r = q[mpm::column::r], *z = q[mpm::column::z];
        const double *v_r = q[mpm::column::v_r], *v_z = q[mpm::column::v_z];
        for (std::ptrdiff_t p = 0; p < particles.size(); ++p) {
            const int i = atom_of(particles.ids()[p]);
            double* x = atom->x[i];
            const double d_r = r[p] - x[0], d_z = z[p] - x[1];
            farthest2 = std::max(farthest2, d_r * d_r + d_z * d_z);
            x[0] = r[p];
            x[1] = z[p];
            atom->v[i][0] = v_r[p];
            atom->v[i][1] = v_z[p];
        }
    }
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
    for (std::size_t b = 0; b < run->simulation().bodies(); ++b) {
        const mpm::Particles& particles = run->simulation().body(b).particles;
        for (std::ptrdiff_t p = 0; p < particles.size(); ++p) {
            double* to = shown_rows[static_cast<std::size_t>(atom_of(particles.ids()[p]))];
            for (int c = 0; c < particles.column_count(); ++c) to[c] = particles(c, p);
        }
    }
}

void FixGritMpm::show(int i, const std::vector<double>& columns) {
    set_arrays(i);
    std::copy(columns.begin(), columns.end(), shown_rows[static_cast<std::size_t>(i)]);
}

// Atoms keep their rows where LAMMPS sorts or sends them between two steps.
void FixGritMpm::put(int i, PointRow given) {
    show(i, given.columns);
    run->put(atom->tag[i], std::move(given));
}

void FixGritMpm::grow_arrays(int most_atoms) {
    const auto atoms = static_cast<std::size_t>(std::max(most_atoms, 1));
    shown.resize(atoms * most_columns, 0.0);
    shown_rows.resize(atoms);
    for (std::size_t i = 0; i < atoms; ++i) shown_rows[i] = shown.data() + i * most_columns;
    array_atom = shown_rows.data();
}

void FixGritMpm::copy_arrays(int from, int to, int) {
    std::copy_n(shown_rows[static_cast<std::size_t>(from)], most_columns,
                shown_rows[static_cast<std::size_t>(to)]);
}

void FixGritMpm::set_arrays(int i) {
    std::fill_n(shown_rows[static_cast<std::size_t>(i)], most_columns, 0.0);
}

// What a variable of this fix asks for must not end the means of forces.
double FixGritMpm::compute_vector(int i) {
    if (!run->started()) return 0.0;
    const long now = run->simulation().steps();
    if (row_step != now || !(row_is_taken || is_asking)) {
        guarded_here([&] {
            const mpm::HistoryRow found = is_asking ? run->run().row_so_far() : run->run().row();
            row.clear();
            for (const mpm::HistoryColumn& column : mpm::history_columns())
                row.push_back(column.value(found));
        });
        row_step = now;
        row_is_taken = !is_asking;
    }
    return row[static_cast<std::size_t>(i)];
}

double FixGritMpm::memory_usage() {
    return 2.0 * static_cast<double>(run->particles()) * static_cast<double>(most_columns) *
           sizeof(double);
}

}  // namespace grit::lammps
