// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/fields.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "cli/mpm/field_rules.hpp"
#include "element/nearest.hpp"

namespace cli {
namespace {

namespace mpm = grit::mpm;
namespace c = grit::mpm::column;

const mpm::Sand* sand_of(const mpm::Body& body) {
    return dynamic_cast<const mpm::Sand*>(body.material.get());
}

grit_sand_invariants plane_invariants(const mpm::Body& body, const mpm::ParticleView& q,
                                      std::ptrdiff_t p) {
    const double stress[6] = {q[c::S_rr][p], q[c::S_zz][p], q[c::S_tt][p], q[c::S_rz][p], 0.0, 0.0};
    const mpm::Sand* sand = sand_of(body);
    double state[GRIT_SAND_STATE_SIZE];
    for (int k = 0; k < GRIT_SAND_STATE_SIZE && sand; ++k) state[k] = q[mpm::Sand::state + k][p];
    return invariants_of(sand ? &sand->prepared() : nullptr, stress, state);
}

const MpmFieldRule& rule_of(const MpmField& field, bool axisymmetric) {
    for (const MpmFieldRule& rule : mpm_field_rules(axisymmetric))
        if (std::string(rule.field.name) == field.name) return rule;
    throw std::invalid_argument(fmt::format("no variable {}", field.name));
}

}  // namespace

grit_sand_invariants invariants_of(const grit_sand* sand, const double* stress,
                                   const double* state) {
    grit_sand_invariants out{};
    out.struct_size = sizeof out;
    if (sand) {
        if (grit_sand_invariants_of(sand, stress, state, &out) == GRIT_OK) return out;
        out = {};
        out.p = out.q = out.lode_angle = out.mobilised_friction_angle = out.rho =
            out.relative_density = std::nan("");
        return out;
    }
    out.p = -(stress[0] + stress[1] + stress[2]) / 3.0;
    double squares = 0.0;
    for (int k = 3; k < 6; ++k) squares += 2.0 * stress[k] * stress[k];
    for (int k = 0; k < 3; ++k) squares += (stress[k] + out.p) * (stress[k] + out.p);
    out.q = std::sqrt(1.5 * squares);
    return out;
}

const std::vector<MpmField>& mpm_fields(bool axisymmetric) {
    const auto of = [](bool around) {
        std::vector<MpmField> out;
        for (const MpmFieldRule& rule : mpm_field_rules(around)) out.push_back(rule.field);
        return out;
    };
    static const std::vector<MpmField> around_an_axis = of(true), in_a_plane = of(false);
    return axisymmetric ? around_an_axis : in_a_plane;
}

std::vector<std::string> names_of_fields(const std::vector<MpmField>& fields) {
    std::vector<std::string> out;
    for (const MpmField& field : fields) out.emplace_back(field.name);
    return out;
}

std::string table_of_fields(const std::vector<MpmField>& fields) {
    std::string out = "| variable | unit | of | what |\n|---|---|---|---|\n";
    for (const MpmField& field : fields) {
        const char* const of = field.of == ShownOf::every_body ? "all"
                               : field.of == ShownOf::stressed ? "all but rigid"
                               : field.of == ShownOf::sand     ? "sand"
                                                               : "with water";
        std::string meaning;
        for (const char c : std::string_view(field.meaning))
            meaning += c == '|' ? std::string("\\|") : std::string(1, c);
        out += fmt::format("| `{}` | {} | {} | {} |\n", field.name, field.unit, of, meaning);
    }
    return out;
}

std::string mpm_field_table() { return table_of_fields(mpm_fields()); }

const MpmField& field_of(const std::vector<MpmField>& fields, const std::string& name) {
    for (const MpmField& field : fields)
        if (field.name == name) return field;
    throw std::invalid_argument(fmt::format("no variable \"{}\"{}", name,
                                            element::suggestion(name, names_of_fields(fields))));
}

const MpmField& mpm_field(const std::string& name, bool axisymmetric) {
    return field_of(mpm_fields(axisymmetric), name);
}

MpmFields::MpmFields(mpm::Simulation& simulation) : shown(simulation) {
    for (std::size_t b = 0; b < shown.bodies(); ++b) {
        const mpm::Particles& particles = shown.body(b).particles;
        std::vector<grit::Vector2> positions(static_cast<std::size_t>(particles.size()));
        for (std::ptrdiff_t p = 0; p < particles.size(); ++p)
            positions[static_cast<std::size_t>(particles.ids()[p])] = {particles(c::r, p),
                                                                       particles(c::z, p)};
        start.push_back(std::move(positions));
    }
}

bool MpmFields::has(std::size_t body, const MpmField& field) const {
    const mpm::Body& of = shown.body(body);
    switch (field.of) {
        case ShownOf::stressed: return !of.rigid();
        case ShownOf::sand: return !of.rigid() && sand_of(of);
        case ShownOf::water: return of.water.has_value();
        default: return true;
    }
}

std::vector<double> MpmFields::values(std::size_t body, const MpmField& field) const {
    const MpmFieldRule& rule = rule_of(field, shown.current_settings().axisymmetric);
    mpm::Body& of = shown.body(body);
    if (!has(body, field))
        throw std::invalid_argument(fmt::format("body {} has no {}", of.name, field.name));
    const auto width = static_cast<std::size_t>(field.components);
    std::vector<double> out(start[body].size() * width);
    for (std::ptrdiff_t p = 0; p < of.particles.size(); ++p) {
        const int id = of.particles.ids()[p];
        const auto at = static_cast<std::size_t>(id);
        const ShownParticle x{of,
                              p,
                              body,
                              id,
                              start[body][at],
                              shown.current_settings().axisymmetric,
                              field.of == ShownOf::every_body
                                  ? grit_sand_invariants{}
                                  : plane_invariants(of, of.particles.view(), p)};
        for (std::size_t k = 0; k < width; ++k)
            out[at * width + k] = rule.value(x, static_cast<int>(k));
    }
    return out;
}

std::vector<double> MpmFields::corners(std::size_t body) const {
    constexpr double xi[] = {-1, 1, 1, -1}, eta[] = {-1, -1, 1, 1};
    const mpm::Particles& q = shown.body(body).particles;
    std::vector<double> out(8 * start[body].size());
    for (std::ptrdiff_t p = 0; p < q.size(); ++p)
        for (std::size_t k = 0; k < 4; ++k) {
            const double a = xi[k] * q(c::l_r, p), b = eta[k] * q(c::l_z, p);
            double* corner = &out[8 * static_cast<std::size_t>(q.ids()[p]) + 2 * k];
            corner[0] = q(c::r, p) + q(c::F_rr, p) * a + q(c::F_rz, p) * b;
            corner[1] = q(c::z, p) + q(c::F_zr, p) * a + q(c::F_zz, p) * b;
        }
    return out;
}

}  // namespace cli
