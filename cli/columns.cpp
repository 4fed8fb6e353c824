// SPDX-License-Identifier: BSD-3-Clause
#include "cli/columns.hpp"

#include <cmath>
#include <limits>

#include "cli/parameter_units.hpp"

namespace cli {
namespace {

using element::Record;
using element::Vector6;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// What a column may need, computed once for each row.
struct Derived {
    const StagedRecord& staged;
    grit_sand_invariants invariants{};
    double density_factor = unknown;      // f_d [-]
    double small_strain_shear = unknown;  // G_0 [kPa]
    double shear_stress = 0.0;            // tau [kPa]
    double shear_strain = 0.0;            // gamma [-]
    double secant = unknown;              // G since the last reversal [kPa]
};

// sigma_11 - (sigma_22 + sigma_33)/2, and the same of strain.
double axial_difference(const Vector6& v) { return v[0] - 0.5 * (v[1] + v[2]); }

// Of any law: what follows from the stress alone.
grit_sand_invariants invariants_of(const Vector6& stress) {
    grit_sand_invariants out{};
    const element::Matrix3 T = element::stress_tensor(stress);
    const Eigen::Vector3d s = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(T).eigenvalues();
    const element::Matrix3 deviator = T - T.trace() / 3.0 * element::Matrix3::Identity();
    out.p = -T.trace() / 3.0;
    out.q = std::sqrt(1.5) * deviator.norm();
    out.mobilised_friction_angle = out.p > 0.0 ? std::asin((s[2] - s[0]) / -(s[2] + s[0])) : 0.0;
    const double cube = 13.5 * -deviator.determinant();
    out.lode_angle =
        out.q > 0.0 ? std::acos(std::clamp(cube / (out.q * out.q * out.q), -1.0, 1.0)) / 3.0 : 0.0;
    out.tan_psi = out.rho = out.relative_density = unknown;
    return out;
}

// Shear modulus of M at the reversal of a strain that had swept the memory: m_R L_1212.
double shear_modulus_after_reversal(const element::GritLaw& sand, const Record& record) {
    grit_sand_parameters parameters;
    grit_sand_parameters_init(&parameters, sizeof parameters);
    grit_sand_parameters_of(&sand.sand(), &parameters);
    double L[36];
    grit_sand_stiffness(&sand.sand(), record.effective_stress.data(), record.void_ratio, L,
                        nullptr);
    const double m_R = parameters.reversal_stiffness;
    return (std::isnan(m_R) ? 1.0 : m_R) * L[21];
}

Derived derive(const StagedRecord& staged, const element::GritLaw* sand) {
    Derived out{staged};
    const Record& record = staged.record;
    if (sand) {
        out.invariants = sand->invariants({record.stress, record.state});
        grit_sand_scalar_factors factors{};
        factors.struct_size = sizeof factors;
        grit_sand_factors(&sand->sand(), record.effective_stress.data(), record.void_ratio,
                          &factors);
        out.density_factor = factors.f_d;
        out.small_strain_shear = shear_modulus_after_reversal(*sand, record);
    } else {
        out.invariants = invariants_of(record.effective_stress);
    }
    out.shear_stress =
        staged.shear ? record.total_stress[3] : 0.5 * axial_difference(record.total_stress);
    out.shear_strain = staged.shear ? record.strain[3] : axial_difference(record.strain);
    return out;
}

// G = (tau - tau_r)/(gamma - gamma_r), r: the last reversal of gamma, or the start of the stage.
void add_secants(std::vector<Derived>& rows) {
    std::size_t reversal = 0;
    double direction = 0.0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const double step = rows[i].shear_strain - rows[i - 1].shear_strain;
        if (rows[i].staged.stage != rows[i - 1].staged.stage || step * direction < 0.0)
            reversal = i - 1;
        if (step != 0.0) direction = step;
        const double gamma = rows[i].shear_strain - rows[reversal].shear_strain;
        if (std::abs(gamma) > 1e-12)
            rows[i].secant = (rows[i].shear_stress - rows[reversal].shear_stress) / gamma;
    }
}

struct Definition {
    const char* name;
    const char* unit;
    double (*of)(const Derived&);
};

const Record& r(const Derived& d) { return d.staged.record; }

constexpr Definition definitions[] = {
    {"stage", "", [](const Derived& d) -> double { return d.staged.stage; }},
    {"step", "", [](const Derived& d) -> double { return r(d).step; }},
    {"increment", "", [](const Derived& d) -> double { return r(d).increment; }},
    {"time", "s", [](const Derived& d) { return r(d).time; }},
    {"axial_strain", "-", [](const Derived& d) { return r(d).strain[0]; }},
    {"volumetric_strain", "-", [](const Derived& d) { return r(d).strain.head<3>().sum(); }},
    {"shear_strain", "-", [](const Derived& d) { return d.shear_strain; }},
    {"p", "kPa", [](const Derived& d) { return d.invariants.p; }},
    {"q", "kPa", [](const Derived& d) { return d.invariants.q; }},
    {"axial_deviator", "kPa",
     [](const Derived& d) { return -axial_difference(r(d).total_stress); }},
    {"shear_stress", "kPa", [](const Derived& d) { return d.shear_stress; }},
    {"void_ratio", "-", [](const Derived& d) { return r(d).void_ratio; }},
    {"relative_density", "-", [](const Derived& d) { return d.invariants.relative_density; }},
    {"mobilised_friction", "deg",
     [](const Derived& d) { return d.invariants.mobilised_friction_angle / degree; }},
    {"lode_angle", "deg", [](const Derived& d) { return d.invariants.lode_angle / degree; }},
    {"rho", "-", [](const Derived& d) { return d.invariants.rho; }},
    {"f_d", "-", [](const Derived& d) { return d.density_factor; }},
    {"pore_pressure", "kPa", [](const Derived& d) { return r(d).pore_pressure; }},
    {"p_total", "kPa", [](const Derived& d) { return -r(d).total_stress.head<3>().sum() / 3.0; }},
    {"secant_G", "kPa", [](const Derived& d) { return d.secant; }},
    {"G_0", "kPa", [](const Derived& d) { return d.small_strain_shear; }},
    {"stress_11", "kPa", [](const Derived& d) { return r(d).effective_stress[0]; }},
    {"stress_22", "kPa", [](const Derived& d) { return r(d).effective_stress[1]; }},
    {"stress_33", "kPa", [](const Derived& d) { return r(d).effective_stress[2]; }},
    {"stress_12", "kPa", [](const Derived& d) { return r(d).effective_stress[3]; }},
    {"stress_13", "kPa", [](const Derived& d) { return r(d).effective_stress[4]; }},
    {"stress_23", "kPa", [](const Derived& d) { return r(d).effective_stress[5]; }},
    {"strain_11", "-", [](const Derived& d) { return r(d).strain[0]; }},
    {"strain_22", "-", [](const Derived& d) { return r(d).strain[1]; }},
    {"strain_33", "-", [](const Derived& d) { return r(d).strain[2]; }},
    {"gamma_12", "-", [](const Derived& d) { return r(d).strain[3]; }},
    {"gamma_13", "-", [](const Derived& d) { return r(d).strain[4]; }},
    {"gamma_23", "-", [](const Derived& d) { return r(d).strain[5]; }},
    {"newton_iterations", "", [](const Derived& d) -> double { return r(d).iterations; }},
    {"rate_evaluations", "", [](const Derived& d) -> double { return r(d).evaluations; }},
    {"halvings", "", [](const Derived& d) -> double { return r(d).cut_backs; }},
};

}  // namespace

const std::vector<std::string>& standard_column_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> out;
        for (const Definition& definition : definitions) out.emplace_back(definition.name);
        return out;
    }();
    return names;
}

Table tabulate(const std::vector<StagedRecord>& records, const element::GritLaw* sand,
               const std::vector<std::string>& state_names) {
    std::vector<Derived> rows;
    for (const StagedRecord& record : records) rows.push_back(derive(record, sand));
    add_secants(rows);
    Table out;
    for (const Definition& definition : definitions) {
        Column column{definition.name, definition.unit, {}};
        for (const Derived& row : rows) column.values.push_back(definition.of(row));
        out.columns.push_back(std::move(column));
    }
    for (std::size_t i = 0; i < state_names.size(); ++i) {
        if (out.find(state_names[i])) continue;
        Column column{state_names[i], "", {}};
        for (const Derived& row : rows) column.values.push_back(r(row).state[i]);
        out.columns.push_back(std::move(column));
    }
    return out;
}

}  // namespace cli
