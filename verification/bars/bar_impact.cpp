// SPDX-License-Identifier: BSD-3-Clause
// bar_impact FOLDER: the impact of two bars with every contact that Grit has, at ten places of the bars
// against the grid, as a table; the data of two pictures into FOLDER (docs/contact.md).
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <string>

#include "bars/impact.hpp"
#include "element/atomic_file.hpp"

namespace {

using namespace bars;

constexpr double powers[] = {1.0, 2.0, 4.0, 6.0, 10.0};

template <class Write> void write_file(const std::filesystem::path& path, const Write& write) {
    std::ostringstream text;
    write(text);
    element::AtomicFile file(path);
    file.write(text.str());
    file.complete();
}

struct Range {
    double lowest = 1e300, largest = -1e300;
    void add(double x) {
        lowest = std::min(lowest, x);
        largest = std::max(largest, x);
    }
};

void print_row(const std::string& name, const char* gate, const Contact& contact) {
    std::array<Range, 5> columns;
    double most_energy = 0.0;
    for (int i = 0; i < 10; ++i) {
        const Impact r = impact(contact, 0.1 * i);
        const double values[] = {r.start_gap, r.force, r.duration, r.impulse, r.energy};
        for (std::size_t k = 0; k < columns.size(); ++k) columns[k].add(values[k]);
        most_energy = std::max(most_energy, r.most_energy);
    }
    std::printf("| %-22s | %-4s |", name.c_str(), gate);
    const auto shown = [](double x) { return std::round(100.0 * x) / 100.0 + 0.0; };  // no -0.00
    for (const Range& range : columns)
        std::printf(" %.2f … %.2f |", shown(range.lowest), shown(range.largest));
    std::printf(" %.3f |\n", most_energy);
}

void print_table() {
    std::puts("| contact                | gate | start gap [cell] | force [rho c v] | "
              "duration [2L/c] | impulse [2 rho v L] | energy kept | most energy |");
    std::puts("|---|---|---|---|---|---|---|---|");
    for (const bool gated : {true, false}) {
        const char* gate = gated ? "on" : "off";
        for (const double k : powers)
            print_row("GCA k " + std::to_string(static_cast<int>(k)), gate, geo_contact(k, gated));
        print_row("FCA", gate, frictional_contact(gated));
        Contact literal = geo_contact(6.0, gated);
        literal.measure = GRIT_CONTACT_NEAREST_CENTRE;
        print_row("GCA k 6, s to a centre", gate, literal);
    }
    const auto print_stiff_rows = [](const char* law, const auto& contact_of) {
        for (const double multiple : {0.1, 1.0, 10.0}) {
            char name[40];
            std::snprintf(name, sizeof name, "%s %g E/cell", law, multiple);
            print_row(name, "-", contact_of(impact_stiffness(multiple)));
        }
    };
    print_stiff_rows("PCA", penalty_contact);
    print_row("surface", "-", surface_contact(0.0));
    print_stiff_rows("surface", [](double stiffness) { return surface_contact(0.0, stiffness); });
}

void write_histories(std::ostream& out) {
    Contact literal = geo_contact(6.0, false);
    literal.measure = GRIT_CONTACT_NEAREST_CENTRE;
    const Impact runs[] = {impact(geo_contact(6.0, true), 0.3),
                           impact(geo_contact(6.0, false), 0.3),
                           impact(literal, 0.3),
                           impact(frictional_contact(true), 0.3),
                           impact(frictional_contact(false), 0.3),
                           impact(penalty_contact(impact_stiffness(1.0)), 0.3),
                           impact(surface_contact(0.0), 0.3)};
    out << "time,gca_gated,gca_ungated,gca_literal,fca_gated,fca_ungated,pca,surface\n";
    for (std::size_t i = 0; i < runs[0].history.size(); ++i) {
        out << runs[0].history[i].time;
        for (const Impact& run : runs) out << ',' << run.history[i].force;
        out << '\n';
    }
}

void write_penalty_factors(std::ostream& out) {
    out << "s_over_d,k1,k2,k4,k6,k10\n";
    for (int i = -20; i <= 120; ++i) {
        const double s = 0.01 * i;
        out << s;
        for (const double k : powers) {
            double f_p = 0.0;
            grit_contact_penalty_factor(s, 1.0, k, &f_p);
            out << ',' << f_p;
        }
        out << '\n';
    }
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) {
        std::fputs("usage: bar_impact FOLDER\n", stderr);
        return 2;
    }
    try {
        const std::filesystem::path folder = arguments[1];
        std::filesystem::create_directories(folder);
        print_table();
        write_file(folder / "bar_impact.csv", write_histories);
        write_file(folder / "penalty_factor.csv", write_penalty_factors);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bar_impact: %s\n", error.what());
        return 1;
    }
    return 0;
}
