// SPDX-License-Identifier: GPL-2.0-only
// fix grit/mpm: particles that go to other processes or into restart files, a row of numbers each.
#include <cstring>

#include "adapters/lammps/guarded.hpp"
#include "adapters/lammps/run_bytes.hpp"

namespace grit::lammps {
namespace {

// The size, the body, and the columns.
int pack(const PointRow& row, double* to) {
    const auto size = static_cast<int>(row.columns.size()) + 2;
    to[0] = size;
    to[1] = static_cast<double>(row.body);
    std::memcpy(to + 2, row.columns.data(), row.columns.size() * sizeof(double));
    return size;
}

PointRow unpack(const double* from) {
    const auto size = static_cast<std::ptrdiff_t>(from[0]);
    return {static_cast<std::size_t>(from[1]), {from + 2, from + size}};
}

}  // namespace

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
    return size;
}

int FixGritMpm::size_restart(int i) {
    int size = 1;
    if (is_mine(i))
        guarded_here([&] { size = static_cast<int>(run->row(atom->tag[i]).columns.size()) + 2; });
    return size;
}

int FixGritMpm::maxsize_restart() { return static_cast<int>(most_columns) + 2; }

// The rows of fixes follow one another, each with its size in front.
void FixGritMpm::unpack_restart(int i, int which) {
    const double* from = atom->extra[i];
    for (int k = 0; k < which; ++k) from += static_cast<int>(*from);
    if (from[0] <= 1.0) return;
    PointRow of_atom = unpack(from);
    const std::size_t bodies = run->description().plan.bodies.size();
    if (of_atom.body >= bodies || of_atom.columns.size() != run->column_names(of_atom.body).size())
        error->one(FLERR, "Fix grit/mpm: atom " + std::to_string(atom->tag[i]) +
                              " of the restart file is of another material");
    put(i, std::move(of_atom));
}

void FixGritMpm::write_restart(FILE* file) {
    std::string bytes;
    const std::uint64_t fingerprint = run->description().fingerprint;
    guarded([&] {
        if (!run->has_begun()) return void(bytes = to_bytes(nullptr, fingerprint));
        const StoredRun stored = run->store();
        bytes = to_bytes(&stored, fingerprint);
    });
    if (comm->me != 0) return;
    const auto size = static_cast<int>(bytes.size());
    std::fwrite(&size, sizeof size, 1, file);
    std::fwrite(bytes.data(), 1, bytes.size(), file);
}

void FixGritMpm::restart(char* bytes) {
    guarded([&] {
        const auto stored = from_bytes(bytes, run->description().fingerprint);
        if (stored) run->go_on_from(std::move(*stored));
    });
}

}  // namespace grit::lammps
