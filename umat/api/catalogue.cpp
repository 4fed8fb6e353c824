// SPDX-License-Identifier: BSD-3-Clause
// Published parameter sets. Status A: two independent readable sources agree; B: one source, or a
// conflict between sources that is named in the note.
#include <grit/sand_catalogue.h>

#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double degree = 3.14159265358979323846 / 180.0;

struct Record {
    grit_sand_record text;
    // phi_c [deg], h_s [kPa], n, e_d0, e_c0, e_i0, alpha, beta, m_R, m_T, R, beta_r, chi
    double values[13];
};

constexpr Record records[] = {
    {{"lausitz", "Lausitz sand", "A",
      "Gowda, Moormann & Stolle, Application of Geo-contact to pile installation using the CPDI "
      "variant of MPM, Table 1",
      "the table prints m_T as m_r"},
     {33, 1.6e6, 0.19, 0.44, 0.85, 1.00, 0.25, 1.0, 5, 2, 1e-4, 0.5, 6}},
    {{"hochstetten", "Hochstetten sand (von Wolffersdorff 1996)", "A",
      "von Wolffersdorff 1996, Mech. Cohesive-frictional Mater. 1:251; intergranular strain: "
      "Niemunis & Herle 1997",
      ""},
     {33, 1.0e6, 0.25, 0.55, 0.95, 1.05, 0.25, 1.5, 5, 2, 1e-4, 0.5, 6}},
    {{"hochstetten-hg99", "Hochstetten sand (Herle & Gudehus 1999)", "B",
      "Herle & Gudehus 1999, Mech. Cohesive-frictional Mater. 4:461",
      "one source; no intergranular strain published with it"},
     {33, 1.5e6, 0.28, 0.55, 0.95, 1.05, 0.25, 1.0, none, none, none, none, none}},
    {{"karlsruhe-fine", "Karlsruhe fine sand", "A",
      "Wichtmann & Triantafyllidis 2016, Acta Geotechnica 11:739, doi 10.1007/s11440-015-0402-z "
      "(laboratory data); published parameter set",
      "another set for it has m_R 2.4, m_T 1.2, chi 6"},
     {33.1, 4.0e6, 0.27, 0.677, 1.054, 1.212, 0.14, 2.5, 2.2, 1.1, 1e-4, 0.1, 5.5}},
    {{"hostun", "Hostun sand", "B", "Herle & Gudehus 1999 (after a secondary source)",
      "another set has 33 deg, e_d0 0.63, e_c0 1.00, e_i0 1.15"},
     {34, 1.0e6, 0.29, 0.61, 0.96, 1.09, 0.13, 2.0, 5, 2, 1e-4, 0.5, 6}},
    {{"karlsruhe-medium", "Karlsruhe medium sand", "B", "documentation of a finite-element code",
      "sources disagree on phi_c (30 or 31 deg) and chi: given without intergranular strain"},
     {30, 5.8e6, 0.28, 0.53, 0.84, 1.00, 0.13, 1.05, none, none, none, none, none}},
    {{"hamburg-01", "Hamburg sand 01", "B", "parameter collection of a material library",
      "one source"},
     {32, 2.0e6, 0.30, 0.50, 0.80, 0.95, 0.10, 1.0, 5, 2, 1e-4, 0.5, 6}},
};

}  // namespace

extern "C" {

int grit_sand_record_count(void) { return static_cast<int>(std::size(records)); }

const grit_sand_record* grit_sand_record_at(int index) {
    return index >= 0 && index < grit_sand_record_count() ? &records[index].text : nullptr;
}

int grit_sand_record_find(const char* name) {
    for (int i = 0; name && i < grit_sand_record_count(); ++i)
        if (std::strcmp(records[i].text.name, name) == 0) return i;
    return -1;
}

grit_status grit_sand_record_parameters(int index, double stress_scale,
                                        grit_sand_parameters* parameters) {
    if (!grit_sand_record_at(index) || !parameters || !(stress_scale > 0.0) ||
        !std::isfinite(stress_scale))
        return GRIT_BAD_CALL;
    const double* v = records[index].values;
    for (int at = 0; at < GRIT_SAND_PARAMETER_COUNT; ++at) {
        const grit_sand_parameter_info& info = *grit_sand_parameter_describe(at);
        if (info.optional == 1) continue;  // not part of a record
        double value = *v++;
        if (std::strcmp(info.unit, "rad") == 0) value *= degree;
        if (std::strcmp(info.unit, "stress") == 0) value *= stress_scale;
        if (const grit_status s = grit_sand_parameter_set(parameters, at, value)) return s;
    }
    return GRIT_OK;
}
}
