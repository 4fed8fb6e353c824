// SPDX-License-Identifier: BSD-3-Clause
// The contacts by name, for problems that all of them solve.
#pragma once

#include <adapters/mpm/step/simulation.hpp>

namespace mpm_test {

using namespace grit::mpm;

enum class ContactKind {
    geo,
    geo_ungated,
    geo_spring,
    geo_spring_10,
    frictional,
    frictional_ungated,
    penalty,
    surface,
    surface_1,   // pressures a cell apart
    surface_10,  // with a stiffness of that multiple of M/h, and 1 ms
    surface_20,
    surface_1_10,  // pressures a cell apart, 10 M/h, 0.1 ms
};

inline const char* name_of(ContactKind kind) {
    switch (kind) {
        case ContactKind::geo: return "GCA gated";
        case ContactKind::geo_ungated: return "GCA";
        case ContactKind::geo_spring: return "GCA gated, spring M/h";
        case ContactKind::geo_spring_10: return "GCA gated, spring 10 M/h";
        case ContactKind::frictional: return "FCA gated";
        case ContactKind::frictional_ungated: return "FCA";
        case ContactKind::penalty: return "PCA";
        case ContactKind::surface_1: return "surface, 1 cell";
        case ContactKind::surface_10: return "surface, 10 M/h";
        case ContactKind::surface_20: return "surface, 20 M/h";
        case ContactKind::surface_1_10: return "surface, 1 cell, 10 M/h";
        default: return "surface";
    }
}

inline double p_wave_modulus(double E, double nu) {
    return E * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));
}

// What penalty contact and springs need besides; the others find their surfaces.
struct PenaltyNeeds {
    double modulus, cell;  // [Pa], [m]
    BoundaryLine line_a, line_b;
};

inline bool is_at_surfaces(ContactKind kind) {
    return kind == ContactKind::surface || kind == ContactKind::surface_1 ||
           kind == ContactKind::surface_10 || kind == ContactKind::surface_20 ||
           kind == ContactKind::surface_1_10;
}

// Between bodies 0 and 1; 0 is the stiffer one. power: k of the Geo-contact; 0: its default.
inline void add_contact(Simulation& simulation, ContactKind kind, double mu,
                        const PenaltyNeeds& needs, double power = 0.0) {
    if (is_at_surfaces(kind)) {
        SurfaceLaw law = surface_law(mu);
        const bool close = kind == ContactKind::surface_1 || kind == ContactKind::surface_1_10;
        if (close) law.spacing = 1.0;
        if (kind != ContactKind::surface && kind != ContactKind::surface_1) {
            const double multiple = kind == ContactKind::surface_20 ? 20.0 : 10.0;
            law.options.contact_stiffness = contact_stiffness(multiple, needs.modulus, needs.cell);
            law.options.relaxation_time = close ? 1e-4 : 1e-3;
        }
        simulation.add_contact(law);
    } else if (kind == ContactKind::penalty) {
        PenaltyLaw law = penalty_law(mu, 1.0, needs.modulus, needs.cell);
        law.line_a = needs.line_a;
        law.line_b = needs.line_b;
        simulation.add_contact(law);
    } else {
        const bool geo = kind != ContactKind::frictional && kind != ContactKind::frictional_ungated;
        ContactLaw law = contact_law(geo ? GRIT_CONTACT_GEO : GRIT_CONTACT_FRICTIONAL, mu);
        if (power > 0.0) law.options.penalty_power = power;
        law.gated = kind != ContactKind::geo_ungated && kind != ContactKind::frictional_ungated;
        if (kind == ContactKind::geo_spring || kind == ContactKind::geo_spring_10)
            law.options.contact_stiffness = contact_stiffness(
                kind == ContactKind::geo_spring ? 1.0 : 10.0, needs.modulus, needs.cell);
        simulation.add_contact(law);
    }
}

// On body 1 in the last step [N].
inline grit::Vector2 contact_force(const Simulation& simulation, ContactKind kind, double dt) {
    if (is_at_surfaces(kind)) {
        const double* J = simulation.surface_contact(0).totals().impulse_on_b;
        return {J[0] / dt, J[1] / dt};
    }
    const double* F = kind == ContactKind::penalty
                          ? simulation.penalty_contact(0).totals().force_on_b
                          : simulation.contact(0).totals().force_on_b;
    return {F[0], F[1]};
}

}  // namespace mpm_test
