// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/io/checkpoint_state.hpp"

#include <algorithm>
#include <sstream>

#include "adapters/mpm/io/checksum.hpp"
#include "adapters/mpm/step/spellings.hpp"

namespace grit::mpm {
namespace {

void grid_words(const Simulation& s, std::ostream& out) {
    const Settings& settings = s.current_settings();
    const std::vector<std::uint8_t>& nodes = s.constraints();
    const std::vector<double> rates = s.absorbing().rates(), tied = s.platen_nodes(),
                              inflows = s.pore_water().inflow_words();
    out << "geometry: " << (settings.axisymmetric ? "axisymmetric" : "plane strain") << '\n'
        << "grid along r: " << word_of_axis(s.axis_r()) << '\n'
        << "grid along z: " << word_of_axis(s.axis_z()) << '\n'
        << "fixed nodes: "
        << std::count_if(nodes.begin(), nodes.end(), [](int bits) { return bits != fixed::none; })
        << ", checksum " << checksum(nodes.data(), nodes.size()) << '\n'
        << "drained nodes: checksum "
        << checksum(s.pore_water().drained_nodes().data(), s.pore_water().drained_nodes().size())
        << '\n'
        << "platen nodes: checksum " << checksum(tied.data(), tied.size() * sizeof(double)) << '\n'
        << "inflows: checksum " << checksum(inflows.data(), inflows.size() * sizeof(double)) << '\n'
        << "absorbing nodes: " << rates.size() / 3 << ", checksum "
        << checksum(rates.data(), rates.size() * sizeof(double)) << '\n'
        << "shape functions: " << word_of(words::shapes, settings.shape) << '\n'
        << "scheme: " << word_of(words::schemes, settings.scheme) << '\n'
        << "bulk viscosity: linear " << settings.linear_viscosity << ", quadratic "
        << settings.quadratic_viscosity << '\n'
        << "volumetric strain: " << (settings.cell_mean ? "mean of the cell" : "own") << '\n'
        << "domains of sand: " << (settings.reduced_domains ? "reduced" : "convected") << '\n'
        << "sums: " << (settings.fixed_point ? "fixed point" : "floating point") << '\n';
}

void body_words(const Simulation& s, std::ostream& out) {
    out << "bodies: " << s.bodies() << '\n';
    for (std::size_t i = 0; i < s.bodies(); ++i) {
        const Body& body = s.body(i);
        out << "body " << i << ": "
            << word_of_body(body.name, body.rigid(), body.particles, column::mass) << '\n';
        if (body.water)
            for (const std::string& word : body.water->words())
                out << "body " << i << ": " << word << '\n';
        if (!body.material) continue;
        for (const std::string& word : body.material->words())
            out << "body " << i << ": " << word << '\n';
    }
    const std::vector<double> tractions = s.traction_words();
    out << "tractions: " << s.traction_count() << ", checksum "
        << checksum(tractions.data(), tractions.size() * sizeof(double)) << '\n';
}

void contact_words(const Simulation& s, std::ostream& out) {
    out << "contacts: " << s.contact_count() << '\n';
    for (std::size_t i = 0; i < s.contact_count(); ++i) {
        const ContactLaw& law = s.contact(i).law();
        out << "contact " << i << ": " << word_of_contact(law);
        out << '\n';
    }
    out << "penalty contacts: " << s.penalty_contact_count() << '\n';
    for (std::size_t i = 0; i < s.penalty_contact_count(); ++i) {
        const PenaltyLaw& law = s.penalty_contact(i).law();
        const grit_penalty_options& o = law.options;
        out << "penalty contact " << i << ": bodies " << law.a << " and " << law.b
            << ", friction coefficient " << o.friction_coefficient << ", stiffness "
            << o.normal_stiffness << " and " << o.tangential_stiffness << " Pa/m, depth up to "
            << o.depth_max << " m, segments of " << law.shortest << " to " << law.longest << " m\n";
    }
    out << "surface contacts: " << s.surface_contact_count() << '\n';
    for (std::size_t i = 0; i < s.surface_contact_count(); ++i) {
        const SurfaceLaw& law = s.surface_contact(i).law();
        out << "surface contact " << i << ": bodies " << law.a << " and " << law.b
            << ", friction coefficient " << law.options.friction_coefficient;
        if (law.spacing != SurfaceLaw{}.spacing)
            out << ", pressures " << law.spacing << " cells apart";
        out << word_of_surface(law.options);
        if (law.after_damping) out << ", after damping too";
        if (!law.line_a.points.empty()) out << (law.line_a.closed ? ", closed line" : ", line");
        for (const Vector2& x : law.line_a.points) out << ' ' << x[0] << ' ' << x[1];
        out << '\n';
    }
}

}  // namespace

std::string word_of_axis(const Axis& axis) {
    std::vector<double> nodes;
    for (int i = 0; i < axis.nodes(); ++i) nodes.push_back(axis[i]);
    std::ostringstream out;
    out << axis.nodes() << " nodes from " << nodes.front() << " to " << nodes.back()
        << " m, checksum " << checksum(nodes.data(), nodes.size() * sizeof(double));
    return out.str();
}

std::string word_of_body(const std::string& name, bool rigid, const ParticleColumns& particles,
                         int mass_column) {
    std::vector<double> mass(static_cast<std::size_t>(particles.size()));
    for (std::ptrdiff_t p = 0; p < particles.size(); ++p)
        mass[static_cast<std::size_t>(particles.ids()[p])] = particles(mass_column, p);
    std::ostringstream out;
    out << (name.empty() ? "without name" : "\"" + name + '"') << (rigid ? ", rigid" : "") << ", "
        << particles.size() << " particles of " << particles.column_count()
        << " columns, checksum of their masses "
        << checksum(mass.data(), mass.size() * sizeof(double));
    return out.str();
}

std::string word_of_contact(const ContactLaw& law) {
    std::ostringstream out;
    out.precision(17);
    const grit_contact_options& o = law.options;
    out << "bodies " << law.a << " and " << law.b << ", law " << o.law << ", friction coefficient "
        << o.friction_coefficient << ", penalty power " << o.penalty_power << ", normal "
        << law.normal << ", measure " << law.measure << (law.gated ? ", gated" : "");
    if (o.relaxation_time > 0.0) out << ", relaxation time " << o.relaxation_time << " s";
    if (o.contact_stiffness > 0.0) out << ", stiffness " << o.contact_stiffness << " Pa/m";
    return out.str();
}

std::string word_of_surface(const grit_surface_options& options) {
    grit_surface_options usual;
    grit_surface_options_init(&usual, sizeof usual);
    std::ostringstream out;
    out.precision(17);
    if (options.contact_stiffness > 0.0)
        out << ", stiffness " << options.contact_stiffness << " Pa/m, relaxation time "
            << options.relaxation_time << " s";
    if (options.sweep_tolerance != usual.sweep_tolerance)
        out << ", sweeps to " << options.sweep_tolerance;
    return out.str();
}

std::string CheckpointState::words(const Simulation& simulation) {
    std::ostringstream out;
    out.precision(17);
    grid_words(simulation, out);
    body_words(simulation, out);
    contact_words(simulation, out);
    return out.str();
}

std::string CheckpointState::bytes(const Simulation& simulation) { return state_bytes(simulation); }

void CheckpointState::take(Simulation& simulation, const std::string& bytes) {
    take_state(simulation, bytes);
}

}  // namespace grit::mpm
