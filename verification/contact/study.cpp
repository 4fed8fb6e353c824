// SPDX-License-Identifier: BSD-3-Clause
// Prints what the contacts do at a surface: contact_study CASE [CONTACT], see docs/contact.md. CONTACT: as the rows name it.
#include <cstdio>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include <tests/mpm/support/cavity_in_sand.hpp>
#include <tests/mpm/support/cylinders.hpp>
#include <tests/mpm/support/hertz.hpp>
#include <tests/mpm/support/pressed_blocks.hpp>
#include <tests/mpm/support/rolling_disk.hpp>
#include <tests/mpm/support/sliding_blocks.hpp>

#include "verification/contact/punch_by_elements.hpp"

namespace {

using namespace mpm_test;

constexpr ContactKind all[] = {
    ContactKind::geo,       ContactKind::frictional, ContactKind::penalty,     ContactKind::surface,
    ContactKind::surface_1, ContactKind::surface_10, ContactKind::surface_1_10};

const char* only = nullptr;  // contact
bool wanted(const char* contact) { return !only || std::strcmp(only, contact) == 0; }

void blocks() {
    std::printf(
        "Two blocks pressed by 500 kPa, after 1 s: sigma_zz of the two rows at the interface "
        "[kPa], overlap [h].\n\n| contact | offset [h] | CFL | least | most | overlap |\n"
        "|---|---|---|---|---|---|\n");
    const auto row = [](ContactKind kind, double offset, double cfl) {
        if (!wanted(name_of(kind))) return;
        PressedBlocks blocks;
        blocks.kind = kind;
        blocks.offset = offset;
        blocks.cfl = cfl;
        const PressedBlocks::Result r = blocks.run();
        std::printf("| %s | %.1f | %.1f | %.2f | %.2f | %.1e |\n", name_of(kind), offset, cfl,
                    -1e-3 * r.highest, -1e-3 * r.lowest, r.overlap);
        std::fflush(stdout);
    };
    for (const ContactKind kind :
         {ContactKind::geo, ContactKind::geo_spring, ContactKind::frictional, ContactKind::penalty})
        for (const double cfl : {0.4, 0.1}) row(kind, 0.3, cfl);
    for (const ContactKind kind : {ContactKind::surface, ContactKind::surface_1})
        for (const double cfl : {0.4, 0.1})
            for (int i = 0; i < 10; ++i) row(kind, 0.1 * i, cfl);
}

void cylinders() {
    std::printf("Two cylinders of radius R close 50 mm at 1 m/s, h 25 mm.\n\n| contact | R [m] | "
                "first force [ms] | momentum lost before [%%] |\n|---|---|---|---|\n");
    for (const ContactKind kind : all)
        for (const double radius : {0.2, 0.205, 0.2125, 0.22}) {
            if (!wanted(name_of(kind))) continue;
            Cylinders c;
            c.kind = kind;
            c.radius = radius;
            const Cylinders::Result r = c.run();
            std::printf("| %s | %.4f | %.2f | %.1f |\n", name_of(kind), radius, 1e3 * r.first,
                        100.0 * r.momentum);
            std::fflush(stdout);
        }
}

// Against finite elements with the same motion of the wall, the same sand and the same damping.
void cavity_row(const char* what, const CavityByPoints& points, const CavityCurve& exact) {
    if (!wanted(name_of(points.kind))) return;
    const CavityByPoints::Result r = points.run();
    double out = 0.0, back = 0.0;
    for (std::size_t i = 0; i < r.curve.time.size(); ++i) {
        const double t = r.curve.time[i], p = exact.pressure_at(t);
        if (t > points.turn() + points.ramp)
            back = std::max(back, std::fabs(r.curve.pressure[i] - p));
        else if (t < points.turn() && r.curve.displacement[i] > 0.005)
            out = std::max(out, std::fabs(r.curve.pressure[i] / p - 1.0));
    }
    double worst_particle = 0.0;
    std::printf("| %s | %s | a/%d | %.2f | %.2f | %.1f | %.3f |", what, name_of(points.kind),
                points.cells, points.phase, 100.0 * out, 1e-3 * back, 1e-3 * r.work);
    for (std::size_t i = 0; i < r.rows.size(); ++i) {
        const double error = r.rows[i].sigma_rr / exact.stress_at(r.rows[i].r0) - 1.0;
        if (r.rows[i].r0 < 2.0 * CavityProblem::a)
            worst_particle = std::max(worst_particle, std::fabs(error));
        if (i < 6) std::printf(" %+.1f", 100.0 * error);
    }
    std::printf(" | %.1f |\n", 100.0 * worst_particle);
    std::fflush(stdout);
}

// Innermost points of elements as long as cells, which move with them: without contact and without a grid.
void cavity_by_long_elements(const CavityByElements& problem, const CavityCurve& exact) {
    for (const int cells : {6, 12})
        for (const int points : {1, 2})
            for (const bool mean : {false, true}) {
                if (points == 1 && mean) continue;
                CavityByElements elements = problem;
                elements.per_radius = cells;
                elements.points = points;
                elements.mean = mean;
                elements.end = elements.turn() + elements.ramp;
                const CavityCurve found = elements.run();
                std::printf("| elements, %d point%s%s | | a/%d | | | | |", points,
                            points > 1 ? "s" : "", mean ? ", mean volumetric strain" : "", cells);
                double worst = 0.0;
                for (std::size_t i = 0; i < found.r0.size(); ++i) {
                    const double error = found.sigma_rr[i] / exact.stress_at(found.r0[i]) - 1.0;
                    if (found.r0[i] < 2.0 * CavityProblem::a)
                        worst = std::max(worst, std::fabs(error));
                    if (i < 6) std::printf(" %+.1f", 100.0 * error);
                }
                std::printf(" | %.1f |\n", 100.0 * worst);
                std::fflush(stdout);
            }
}

void cavity() {
    std::printf(
        "Cavity in Lausitz sand, 0.15 -> 0.225 m and back by 1.6 mm at 0.01 m/s; phase: of the "
        "wall "
        "against the grid [h]. Worst wall pressure from 5 mm on [%%] and on the way back [kPa], "
        "work of the wall [kJ/rad/m], sigma_rr of the innermost rows and the worst up to 2 a [%% "
        "off].\n\n| case | contact | h | phase | wall | back | work | rows | worst |\n"
        "|---|---|---|---|---|---|---|---|---|\n");
    for (const double e : {0.55, 0.75})
        for (const double damping : {0.0, 0.3}) {
            CavityByElements elements;
            elements.void_ratio = e;
            elements.local_damping = damping;
            const double back = 1.6e-3;
            elements.end = elements.turn() + elements.ramp + back / elements.back;
            const CavityCurve exact = elements.run();
            const auto kPa = [&](double t) { return 1e-3 * exact.pressure_at(t); };
            const double turned = elements.turn() + elements.ramp;
            std::printf(
                "| e %.2f, damping %.1f | elements: %.1f, back %.1f ... %.1f kPa | | | | | | |"
                "\n",
                e, damping, kPa(elements.turn() - 0.001), kPa(turned), kPa(elements.end));
            if (e < 0.6 && damping == 0.0) cavity_by_long_elements(elements, exact);
            struct Variant {
                const char* name;
                int per_cell;
                bool cell_mean;
            };
            for (const Variant& variant : {Variant{"two a cell", 2, false},
                                           {"two a cell, cell mean", 2, true},
                                           {"one a cell", 1, false},
                                           {"three a cell", 3, false},
                                           {"four a cell", 4, false}}) {
                if (variant.per_cell > 2 && (e > 0.6 || damping > 0.0)) continue;
                CavityByPoints points;
                static_cast<CavityProblem&>(points) = elements;
                points.per_cell = variant.per_cell;
                points.cell_mean = variant.cell_mean;
                char what[80];
                std::snprintf(what, sizeof what, "e %.2f, damping %.1f, %s", e, damping,
                              variant.name);
                for (const double phase : {0.0, 0.25, 0.5, 0.75}) {
                    points.phase = phase;
                    cavity_row(what, points, exact);
                    if (e > 0.6 || damping > 0.0) break;
                }
                if (e > 0.6 || damping > 0.0 || variant.per_cell > 2) continue;
                points.phase = 0.0;
                points.kind = ContactKind::penalty;
                cavity_row(what, points, exact);
                points.kind = ContactKind::surface;
                for (const int cells : {12, 24}) {
                    points.cells = cells;
                    cavity_row(what, points, exact);
                }
            }
        }
}

void punch() {
    std::printf(
        "Embedded rigid punch [MN/m].\n\n| | R/h | stiffness | error [%%] |\n|---|---|---|---|\n");
    double exact = 0.0;
    for (const double fine : {1.0, 2.0, 4.0})
        std::printf("| elements, %g times as fine | | %.3f | |\n", fine,
                    1e-6 * (exact = punch_by_elements(fine)));
    for (const bool holds : {true, false})
        for (const int cells : {4, 8, 16}) {
            const double found = punch_by_equal_elements(cells, holds);
            std::printf("| elements as wide as cells, corner %s | %d | %.3f | %+.1f |\n",
                        holds ? "held" : "free", cells, 1e-6 * found,
                        100.0 * (found / exact - 1.0));
        }
    struct Law {
        ContactKind kind;
        double power = 0.0;  // k; 0: its default
    };
    for (const Law& law :
         {Law{ContactKind::surface}, Law{ContactKind::surface_1}, Law{ContactKind::surface_10},
          Law{ContactKind::surface_20}, Law{ContactKind::geo}, Law{ContactKind::geo_ungated},
          Law{ContactKind::geo_spring}, Law{ContactKind::geo_spring_10},
          Law{ContactKind::geo_spring_10, 2.0}, Law{ContactKind::frictional},
          Law{ContactKind::penalty}})
        for (const double first : {4.0, 4.2, 4.4, 4.6, 4.8})
            for (const int finer : {1, 2, 4}) {
                const std::string name =
                    name_of(law.kind) + std::string(law.power > 0.0 ? ", k 2" : "");
                if (!wanted(name.c_str())) continue;
                Punch p;
                p.kind = law.kind;
                p.power = law.power;
                p.cells = first * finer;
                const double found = p.stiffness();
                std::printf("| %s | %.1f | %.3f | %+.2f |\n", name.c_str(), p.cells, 1e-6 * found,
                            100.0 * (found / exact - 1.0));
                std::fflush(stdout);
            }
}

// An elastic paraboloid on a rigid plane; the plane is on a grid line, or between two.
void hertz() {
    std::printf(
        "Hertz: errors of the contact's radius and of p0 by P [%%].\n\n| contact | cells in a | "
        "plane above a grid line [h] | radius | pressure | sum |\n|---|---|---|---|---|---|\n");
    for (const ContactKind kind : all)
        for (const double beyond : {0.0, 0.25, 0.5, 0.75})
            for (const int cells : {7, 11, 14}) {
                if (!wanted(name_of(kind))) continue;
                Hertz problem;
                problem.kind = kind;
                problem.cells = cells;
                problem.beyond = beyond;
                const Hertz::Result r = problem.run();
                std::printf("| %s | %.1f | %.2f | %+.1f | %+.1f | %+.1f |\n", name_of(kind),
                            r.radius * cells / Hertz::a, beyond, 100.0 * r.radius_error,
                            100.0 * r.pressure_error, 100.0 * r.sum_error);
                std::fflush(stdout);
            }
}

void rolling() {
    std::printf(
        "A disk of R on a slope: error of its way [%%]; friction enough to roll, and not.\n\n"
        "| contact | R/h | rolling | energy residual | sliding |\n|---|---|---|---|---|\n");
    for (const ContactKind kind : all)
        for (const int cells : {4, 8, 16}) {
            if (!wanted(name_of(kind))) continue;
            RollingDisk rolls, slides;
            rolls.kind = slides.kind = kind;
            slides.friction = 0.1;
            const RollingDisk::Result r = rolls.run(cells), s = slides.run(cells);
            std::printf("| %s | %d | %+.2f | %+.2f | %+.2f |\n", name_of(kind), cells,
                        100.0 * (r.way - 1.0), 100.0 * r.residual, 100.0 * (s.way - 1.0));
            std::fflush(stdout);
        }
}

void sliding() {
    std::printf(
        "A cube that slides: largest error of its way [%%], of its height [m]. A block that is "
        "pushed: creep before it slips at 1 s, when it does, velocity and way at 2 s [%% off].\n\n"
        "| contact | way | height | crept [m] | velocity [m/s] | slips at [s] | velocity | way "
        "|\n|---|---|---|---|---|---|---|---|\n");
    for (const ContactKind kind : all) {
        if (!wanted(name_of(kind))) continue;
        const SlidingCube::Result cube = SlidingCube{kind}.run();
        const LoadedBlock::Result block = LoadedBlock{kind}.run();
        std::printf("| %s | %.3f | %.1e | %.1e | %.1e | %.4f | %+.2f | %+.2f |\n", name_of(kind),
                    100.0 * cube.way, cube.height, block.crept, block.creep_velocity,
                    block.slips_at, 100.0 * (block.velocity - 1.0), 100.0 * (block.way - 1.0));
        std::fflush(stdout);
    }
}

struct Study {
    const char* name;
    void (*print)();
};
constexpr Study studies[] = {{"blocks", blocks},  {"cavity", cavity}, {"cylinders", cylinders},
                             {"hertz", hertz},    {"punch", punch},   {"rolling", rolling},
                             {"sliding", sliding}};

}  // namespace

int main(int count, char** words) {
    for (const Study& study : studies)
        if (count > 1 && count < 4 && std::strcmp(words[1], study.name) == 0) {
            only = count == 3 ? words[2] : nullptr;
            study.print();
            return 0;
        }
    std::fprintf(stderr, "one of:");
    for (const Study& study : studies) std::fprintf(stderr, " %s", study.name);
    std::fprintf(stderr, "\n");
    return 2;
}
