// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/space_fields.hpp"

#include <stdexcept>

#include <adapters/mpm/space/kernel/sand.hpp>
#include <fmt/format.h>

#include "cli/mpm/field_rules.hpp"
#include "cli/sand/parameter_units.hpp"

namespace cli {
namespace {

namespace space = grit::mpm::space;
namespace sc = grit::mpm::space::column;

// A particle in space, and what its columns do not know.
struct SpaceParticle {
    space::Body& body;
    std::ptrdiff_t p;
    std::size_t number;  // of the body
    int id;
    grit::Vector3 start;              // [m]
    grit_sand_invariants invariants;  // of bodies with stress

    space::ParticleView view() const { return body.particles.view(); }
    double operator()(int column) const { return view()[column][p]; }
    double mass() const { return (*this)(sc::mass); }
    double volume() const { return view().volume(p); }
    double of_state(int k) const { return (*this)(space::Sand::state + k); }
};

using Rule = FieldRule<SpaceParticle>;

const space::Sand* sand_in_space(const space::Body& body) {
    return dynamic_cast<const space::Sand*>(body.material.get());
}

const std::vector<Rule>& rules_in_space() {
    using P = const SpaceParticle&;
    static const std::vector<Rule> all = joined<SpaceParticle>({
        rules_of_numbers<SpaceParticle>(),
        {{{"velocity", "m/s", "", 3, ShownOf::every_body},
          [](P x, int k) { return x(sc::v_x + k); }},
         {{"displacement", "m", "since the start", 3, ShownOf::every_body},
          [](P x, int k) { return x(sc::x + k) - x.start[k]; }},
         {{"mass", "kg", "", 1, ShownOf::every_body}, [](P x, int) { return x(sc::mass); }}},
        rules_of_volume<SpaceParticle>(),
        {{{"F_xx", "-", "deformation gradient", 1, ShownOf::every_body},
          [](P x, int) { return x(sc::F_xx); }},
         {{"F_xy", "-", "", 1, ShownOf::every_body}, [](P x, int) { return x(sc::F_xy); }},
         {{"F_xz", "-", "", 1, ShownOf::every_body}, [](P x, int) { return x(sc::F_xz); }},
         {{"F_yx", "-", "", 1, ShownOf::every_body}, [](P x, int) { return x(sc::F_yx); }},
         {{"F_yy", "-", "", 1, ShownOf::every_body}, [](P x, int) { return x(sc::F_yy); }},
         {{"F_yz", "-", "", 1, ShownOf::every_body}, [](P x, int) { return x(sc::F_yz); }},
         {{"F_zx", "-", "", 1, ShownOf::every_body}, [](P x, int) { return x(sc::F_zx); }},
         {{"F_zy", "-", "", 1, ShownOf::every_body}, [](P x, int) { return x(sc::F_zy); }},
         {{"F_zz", "-", "", 1, ShownOf::every_body}, [](P x, int) { return x(sc::F_zz); }},
         {{"stress_xx", "kPa", "Cauchy stress, tension positive; with water effective", 1,
           ShownOf::stressed},
          [](P x, int) { return kilo * x(sc::S_xx); }},
         {{"stress_yy", "kPa", "", 1, ShownOf::stressed},
          [](P x, int) { return kilo * x(sc::S_yy); }},
         {{"stress_zz", "kPa", "", 1, ShownOf::stressed},
          [](P x, int) { return kilo * x(sc::S_zz); }},
         {{"stress_xy", "kPa", "", 1, ShownOf::stressed},
          [](P x, int) { return kilo * x(sc::S_xy); }},
         {{"stress_xz", "kPa", "", 1, ShownOf::stressed},
          [](P x, int) { return kilo * x(sc::S_xz); }},
         {{"stress_yz", "kPa", "", 1, ShownOf::stressed},
          [](P x, int) { return kilo * x(sc::S_yz); }}},
        rules_of_invariants<SpaceParticle>(),
        {{{"h_xx", "-", "intergranular strain, extension positive", 1, ShownOf::sand},
          [](P x, int) { return x.of_state(0); }},
         {{"h_yy", "-", "", 1, ShownOf::sand}, [](P x, int) { return x.of_state(1); }},
         {{"h_zz", "-", "", 1, ShownOf::sand}, [](P x, int) { return x.of_state(2); }},
         {{"h_xy", "-", "engineering shear", 1, ShownOf::sand},
          [](P x, int) { return x.of_state(3); }},
         {{"h_xz", "-", "", 1, ShownOf::sand}, [](P x, int) { return x.of_state(4); }},
         {{"h_yz", "-", "", 1, ShownOf::sand}, [](P x, int) { return x.of_state(5); }}},
        rules_of_state<SpaceParticle>(),
        rules_of_pore_pressure<SpaceParticle>(),
        {{{"total_xx", "kPa", "total stress, effective - pore pressure; shear has none", 1,
           ShownOf::water},
          [](P x, int) { return total_stress(x, sc::S_xx); }},
         {{"total_yy", "kPa", "", 1, ShownOf::water},
          [](P x, int) { return total_stress(x, sc::S_yy); }},
         {{"total_zz", "kPa", "", 1, ShownOf::water},
          [](P x, int) { return total_stress(x, sc::S_zz); }}},
        rules_of_porosity<SpaceParticle>(),
    });
    return all;
}

grit_sand_invariants invariants_in_space(const space::Body& body, const space::ParticleView& q,
                                         std::ptrdiff_t p) {
    const space::Sand* sand = sand_in_space(body);
    double stress[6], state[GRIT_SAND_STATE_SIZE];
    for (int k = 0; k < 6; ++k) stress[k] = q[sc::S_xx + k][p];
    for (int k = 0; k < GRIT_SAND_STATE_SIZE && sand; ++k) state[k] = q[space::Sand::state + k][p];
    return invariants_of(sand ? &sand->prepared() : nullptr, stress, state);
}

}  // namespace

const std::vector<MpmField>& space_fields() {
    static const std::vector<MpmField> fields = [] {
        std::vector<MpmField> out;
        for (const Rule& rule : rules_in_space()) out.push_back(rule.field);
        return out;
    }();
    return fields;
}

std::string space_field_table() { return table_of_fields(space_fields()); }

SpaceFields::SpaceFields(space::Simulation& simulation) : shown(simulation) {
    for (std::size_t b = 0; b < shown.bodies(); ++b) {
        space::Particles& particles = shown.body(b).particles;
        std::vector<grit::Vector3> positions(static_cast<std::size_t>(particles.size()));
        for (std::ptrdiff_t p = 0; p < particles.size(); ++p)
            positions[static_cast<std::size_t>(particles.ids()[p])] = particles.view().position(p);
        start.push_back(std::move(positions));
    }
}

bool SpaceFields::has(std::size_t body, const MpmField& field) const {
    const space::Body& of = shown.body(body);
    switch (field.of) {
        case ShownOf::every_body: return true;
        case ShownOf::stressed: return !of.rigid();
        case ShownOf::sand: return !of.rigid() && sand_in_space(of);
        case ShownOf::water: return of.water.has_value();
        default: return false;
    }
}

std::vector<double> SpaceFields::values(std::size_t body, const MpmField& field) const {
    space::Body& of = shown.body(body);
    const Rule* rule = nullptr;
    for (const Rule& each : rules_in_space())
        if (std::string(each.field.name) == field.name) rule = &each;
    if (!rule || !has(body, field))
        throw std::invalid_argument(fmt::format("body {} has no {}", of.name, field.name));
    const auto width = static_cast<std::size_t>(field.components);
    std::vector<double> out(start[body].size() * width);
    for (std::ptrdiff_t p = 0; p < of.particles.size(); ++p) {
        const int id = of.particles.ids()[p];
        const auto at = static_cast<std::size_t>(id);
        const SpaceParticle x{of,
                              p,
                              body,
                              id,
                              start[body][at],
                              field.of == ShownOf::every_body
                                  ? grit_sand_invariants{}
                                  : invariants_in_space(of, of.particles.view(), p)};
        for (std::size_t k = 0; k < width; ++k)
            out[at * width + k] = rule->value(x, static_cast<int>(k));
    }
    return out;
}

std::vector<double> SpaceFields::corners(std::size_t body) const {
    constexpr double xi[] = {-1, 1, 1, -1}, eta[] = {-1, -1, 1, 1};
    space::Particles& particles = shown.body(body).particles;
    const space::ParticleView q = particles.view();
    std::vector<double> out(24 * start[body].size());
    for (std::ptrdiff_t p = 0; p < particles.size(); ++p)
        for (std::size_t k = 0; k < 8; ++k) {
            const double e[] = {xi[k % 4], eta[k % 4], k < 4 ? -1.0 : 1.0};
            double* corner = &out[24 * static_cast<std::size_t>(particles.ids()[p]) + 3 * k];
            for (int i = 0; i < 3; ++i) {
                corner[i] = q[sc::x + i][p];
                for (int j = 0; j < 3; ++j) corner[i] += q.F(i, j, p) * e[j] * q[sc::l_x + j][p];
            }
        }
    return out;
}

}  // namespace cli
