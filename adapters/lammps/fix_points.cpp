// SPDX-License-Identifier: GPL-2.0-only
// fix grit/mpm: the rows of points files, and which atoms tractions act on.
#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

#include "adapters/lammps/guarded.hpp"
#include "adapters/lammps/points_file.hpp"

namespace grit::lammps {
namespace {

constexpr std::size_t chunk = 1 << 20;  // bytes that are sent at once

// Whole lines; empty: the end.
std::string next_lines(std::ifstream& file) {
    std::string out, line;
    while (out.size() < chunk && std::getline(file, line)) out += line + '\n';
    return out;
}

}  // namespace

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
                    points =
                        std::make_unique<PointsFile>(run->column_names(body), line,
                                                     run->description().plan.settings.axisymmetric);
                    continue;
                }
                const int tag = PointsFile::id_of(line.c_str());
                const int i = tag >= 1 && tag <= atom->map_tag_max ? atom->map(tag) : -1;
                if (i < 0 || i >= atom->nlocal) continue;
                if (!is_mine(i) || body_of(i) != static_cast<int>(body))
                    throw std::invalid_argument("atom " + std::to_string(tag) + " is not in body " +
                                                run->description().plan.bodies[body].name);
                if (!seen.insert(tag).second)
                    throw std::invalid_argument("atom " + std::to_string(tag) + " is there twice");
                PointRow out{body, {atom->x[i][0], atom->x[i][1], atom->v[i][0], atom->v[i][1]}};
                points->read(line.c_str(), out.columns);
                put(i, std::move(out));
            } catch (const std::exception& wrong) {
                error->one(FLERR, "Fix grit/mpm: file " + name + ": " + wrong.what());
            }
        }
    }
    if (!points) error->all(FLERR, "Fix grit/mpm: file " + name + " is empty");
}

// On all processes, ascending: atoms of a body in a group.
std::vector<int> FixGritMpm::ids_in(int bit, std::size_t body) const {
    std::vector<int> mine;
    for (int i = 0; i < atom->nlocal; ++i)
        if ((atom->mask[i] & bit) && is_mine(i) && body_of(i) == static_cast<int>(body))
            mine.push_back(atom->tag[i]);
    auto count = static_cast<int>(mine.size());
    std::vector<int> counts(static_cast<std::size_t>(comm->nprocs)), starts(counts.size(), 0);
    MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, world);
    for (std::size_t i = 1; i < counts.size(); ++i) starts[i] = starts[i - 1] + counts[i - 1];
    std::vector<int> all(static_cast<std::size_t>(starts.back() + counts.back()));
    MPI_Allgatherv(mine.data(), count, MPI_INT, all.data(), counts.data(), starts.data(), MPI_INT,
                   world);
    std::sort(all.begin(), all.end());
    return all;
}

std::vector<std::vector<int>> FixGritMpm::traction_ids() {
    std::vector<std::vector<int>> out;
    const FixCase& plan = run->description();
    for (std::size_t k = 0; k < plan.traction_groups.size(); ++k) {
        const std::string& name = plan.traction_groups[k];
        const std::string& body = plan.plan.tractions[k].body;
        const int number = group->find(name);
        if (number < 0) error->all(FLERR, "Could not find fix grit/mpm traction group ID " + name);
        out.push_back(ids_in(group->bitmask[number], plan.plan.body(body)));
        if (out.back().empty())
            error->all(FLERR,
                       "Fix grit/mpm: traction group " + name + " has no atoms of body " + body);
    }
    return out;
}

}  // namespace grit::lammps
