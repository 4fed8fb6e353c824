// SPDX-License-Identifier: BSD-3-Clause
#include "cli/table/columns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

#include "cli/sand/parameter_units.hpp"
#include "element/errors.hpp"
#include "element/nearest.hpp"

namespace cli {
namespace {

using element::Record;
using element::Vector6;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// What a column may need, computed once for each row.
struct Derived {
    const Record& record;
    const Setting& setting;
    grit_sand_invariants invariants{};
    double density_factor = unknown;      // f_d [-]
    double small_strain_shear = unknown;  // G_0 [kPa]
    ShearPair shear{};
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

// Shear modulus of M at the reversal of a strain that had swept the memory: m_R L_1212. Of the basic
// model, which has no memory: L_1212.
double shear_modulus_after_reversal(const element::GritLaw& sand, const Record& record) {
    grit_sand_parameters parameters;
    grit_sand_parameters_init(&parameters, sizeof parameters);
    grit_sand_parameters_of(&sand.sand(), &parameters);
    double L[36];
    grit_sand_stiffness(&sand.sand(), record.effective_stress.data(), record.void_ratio, L,
                        nullptr);
    return (sand.intergranular_strain() ? parameters.reversal_stiffness : 1.0) * L[21];
}

Derived derive(const Record& record, const Setting& setting, const element::GritLaw* sand) {
    Derived out{record, setting};
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
    out.shear = shear_of(record, setting.shear);
    return out;
}

enum class Of {
    record,  // linear in its stresses, strains, void ratio and pore pressure
    point,
    way  // to the point
};

struct Definition {
    const char* name;
    const char* unit;
    double (*of)(const Derived&);
    Of what = Of::point;
};

const Record& r(const Derived& d) { return d.record; }
double real(long count) { return static_cast<double>(count); }

constexpr Definition definitions[] = {
    {"stage", "", [](const Derived& d) -> double { return d.setting.stage; }, Of::way},
    {"step", "", [](const Derived& d) { return real(r(d).step); }, Of::way},
    {"increment", "", [](const Derived& d) -> double { return r(d).increment; }, Of::way},
    {"time", "s", [](const Derived& d) { return r(d).time; }},
    {"axial_strain", "-", [](const Derived& d) { return r(d).strain[0]; }, Of::record},
    {"volumetric_strain", "-", [](const Derived& d) { return r(d).strain.head<3>().sum(); },
     Of::record},
    {"shear_strain", "-", [](const Derived& d) { return d.shear.strain; }, Of::record},
    {"p", "kPa", [](const Derived& d) { return -r(d).effective_stress.head<3>().sum() / 3.0; },
     Of::record},
    {"q", "kPa", [](const Derived& d) { return d.invariants.q; }},
    {"axial_deviator", "kPa", [](const Derived& d) { return -axial_difference(r(d).total_stress); },
     Of::record},
    {"shear_stress", "kPa", [](const Derived& d) { return d.shear.stress; }, Of::record},
    {"void_ratio", "-", [](const Derived& d) { return r(d).void_ratio; }, Of::record},
    {"relative_density", "-", [](const Derived& d) { return d.invariants.relative_density; }},
    {"mobilised_friction", "deg",
     [](const Derived& d) { return d.invariants.mobilised_friction_angle / degree; }},
    {"lode_angle", "deg", [](const Derived& d) { return d.invariants.lode_angle / degree; }},
    {"rho", "-", [](const Derived& d) { return d.invariants.rho; }},
    {"f_d", "-", [](const Derived& d) { return d.density_factor; }},
    {"pore_pressure", "kPa", [](const Derived& d) { return r(d).pore_pressure; }, Of::record},
    {"p_total", "kPa", [](const Derived& d) { return -r(d).total_stress.head<3>().sum() / 3.0; },
     Of::record},
    {"secant_G", "kPa", [](const Derived& d) { return d.setting.secant; }, Of::way},
    {"G_0", "kPa", [](const Derived& d) { return d.small_strain_shear; }},
    {"stress_11", "kPa", [](const Derived& d) { return r(d).effective_stress[0]; }, Of::record},
    {"stress_22", "kPa", [](const Derived& d) { return r(d).effective_stress[1]; }, Of::record},
    {"stress_33", "kPa", [](const Derived& d) { return r(d).effective_stress[2]; }, Of::record},
    {"stress_12", "kPa", [](const Derived& d) { return r(d).effective_stress[3]; }, Of::record},
    {"stress_13", "kPa", [](const Derived& d) { return r(d).effective_stress[4]; }, Of::record},
    {"stress_23", "kPa", [](const Derived& d) { return r(d).effective_stress[5]; }, Of::record},
    {"strain_11", "-", [](const Derived& d) { return r(d).strain[0]; }, Of::record},
    {"strain_22", "-", [](const Derived& d) { return r(d).strain[1]; }, Of::record},
    {"strain_33", "-", [](const Derived& d) { return r(d).strain[2]; }, Of::record},
    {"gamma_12", "-", [](const Derived& d) { return r(d).strain[3]; }, Of::record},
    {"gamma_13", "-", [](const Derived& d) { return r(d).strain[4]; }, Of::record},
    {"gamma_23", "-", [](const Derived& d) { return r(d).strain[5]; }, Of::record},
    {"newton_iterations", "", [](const Derived& d) { return real(r(d).iterations); }, Of::way},
    {"rate_evaluations", "", [](const Derived& d) { return real(r(d).evaluations); }, Of::way},
    {"halvings", "", [](const Derived& d) { return real(r(d).cut_backs); }, Of::way},
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

const char* unit_of_standard_column(const std::string& name) {
    for (const Definition& definition : definitions)
        if (name == definition.name) return definition.unit;
    return nullptr;
}

std::optional<element::LinearQuantity> linear_quantity(const std::string& name,
                                                       bool loaded_by_shear) {
    const Setting setting{0, loaded_by_shear, unknown};
    for (const Definition& definition : definitions) {
        if (definition.name != name || definition.what != Of::record) continue;
        // Its value for each component alone.
        Record record;
        const auto weight_of = [&](double& component) {
            component = 1.0;
            Derived derived{record, setting};
            derived.shear = shear_of(record, loaded_by_shear);
            const double weight = definition.of(derived);
            component = 0.0;
            return weight;
        };
        const auto weights_of = [&](Vector6& components) {
            Vector6 out;
            for (int i = 0; i < 6; ++i) out[i] = weight_of(components[i]);
            return out;
        };
        element::LinearQuantity out;
        out.strain = weights_of(record.strain);
        out.effective_stress = weights_of(record.effective_stress);
        out.total_stress = weights_of(record.total_stress);
        out.void_ratio = weight_of(record.void_ratio);
        out.pore_pressure = weight_of(record.pore_pressure);
        return out;
    }
    return std::nullopt;
}

std::vector<Column> linear_columns() {
    std::vector<Column> out;
    for (const Definition& definition : definitions)
        if (definition.what == Of::record)
            out.push_back({definition.name, definition.unit, {}, {}});
    return out;
}

ShearPair shear_of(const Record& record, bool loaded_by_shear) {
    if (loaded_by_shear) return {record.total_stress[3], record.strain[3]};
    return {0.5 * axial_difference(record.total_stress), axial_difference(record.strain)};
}

Columns::Columns(const element::GritLaw* law, const std::vector<std::string>& state_names)
    : sand(law) {
    for (const Definition& definition : definitions)
        heads.push_back({definition.name, definition.unit, {}, {}});
    for (std::size_t i = 0; i < state_names.size(); ++i) {
        const auto taken = [&](const Column& column) { return column.name == state_names[i]; };
        if (std::any_of(heads.begin(), heads.end(), taken)) continue;
        heads.push_back({state_names[i], "", {}, {}});
        states.push_back(i);
    }
}

std::vector<double> Columns::row(const Record& record, const Setting& setting) const {
    const Derived derived = derive(record, setting, sand);
    std::vector<double> out;
    for (const Definition& definition : definitions) out.push_back(definition.of(derived));
    for (const std::size_t i : states) out.push_back(record.state[i]);
    return out;
}

element::Vocabulary Columns::words(bool loaded_by_shear) const {
    return [this_ = *this, loaded_by_shear](const std::string& name) -> element::Quantity {
        std::vector<std::string> known;
        for (const Definition& definition : definitions) {
            if (definition.what == Of::way) continue;
            if (definition.name == name)
                return {[&definition, loaded_by_shear, sand = this_.sand](const Record& record) {
                    const Setting setting{0, loaded_by_shear, unknown};
                    return definition.of(derive(record, setting, sand));
                }};
            known.emplace_back(definition.name);
        }
        for (std::size_t i = 0; i < this_.states.size(); ++i) {
            known.push_back(this_.heads[std::size(definitions) + i].name);
            if (known.back() == name)
                return {[place = this_.states[i]](const Record& record) {
                    return record.state[place];
                }};
        }
        throw element::BadCase("a condition speaks of columns of the result, got \"" + name + "\"" +
                               element::suggestion(name, known));
    };
}

}  // namespace cli
