// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/space/run/checkpoint.hpp"

#include <sstream>

#include "adapters/mpm/io/checkpoint_state.hpp"
#include "adapters/mpm/io/checksum.hpp"
#include "adapters/mpm/step/spellings.hpp"

namespace grit::mpm::space {
namespace {

std::string words_of(const Simulation& s) {
    std::ostringstream out;
    out.precision(17);
    const Settings& settings = s.current_settings();
    out << "geometry: space\n";
    for (int d = 0; d < 3; ++d)
        out << "grid along "
            << "xyz"[d] << ": " << word_of_axis(s.axis(d)) << '\n';
    out << "fixed nodes: checksum " << checksum(s.constraints().data(), s.constraints().size())
        << '\n'
        << "shape functions: " << word_of(words::shapes, settings.shape) << '\n'
        << "bulk viscosity: linear " << settings.linear_viscosity << ", quadratic "
        << settings.quadratic_viscosity << '\n'
        << "volumetric strain: " << (settings.cell_mean ? "mean of the cell" : "own") << '\n'
        << "sums: " << (settings.fixed_point ? "fixed point" : "floating point") << '\n'
        << "bodies: " << s.bodies() << '\n';
    for (std::size_t i = 0; i < s.bodies(); ++i) {
        const Body& body = s.body(i);
        out << "body " << i << ": "
            << word_of_body(body.name, body.rigid(), body.particles, column::mass) << '\n';
        if (body.rigid()) {
            out << "body " << i << ": free";
            for (const bool is_free : body.motion->to_be_free()) out << (is_free ? " yes" : " no");
            out << '\n';
        }
        if (!body.material) continue;
        for (const std::string& word : body.material->words())
            out << "body " << i << ": " << word << '\n';
        if (!body.water) continue;
        for (const std::string& word : body.water->words())
            out << "body " << i << ": " << word << '\n';
    }
    const std::vector<double> tractions = s.traction_words();
    out << "tractions: " << s.traction_count() << ", checksum "
        << checksum(tractions.data(), tractions.size() * sizeof(double)) << '\n'
        << "contacts: " << s.contact_count() << '\n';
    for (std::size_t i = 0; i < s.contact_count(); ++i)
        out << "contact " << i << ": " << word_of_contact(s.contact(i).law()) << '\n';
    out << "surface contacts: " << s.surface_contact_count() << '\n';
    for (std::size_t i = 0; i < s.surface_contact_count(); ++i) {
        const SurfaceLaw& law = s.surface_contact(i).law();
        const std::vector<double>& mesh = law.mesh_a.position;
        out << "surface contact " << i << ": bodies " << law.a << " and " << law.b
            << ", friction coefficient " << law.options.friction_coefficient << ", pressures "
            << law.spacing << " cells apart" << word_of_surface(law.options) << ", mesh of "
            << law.mesh_a.facets() << " triangles, checksum "
            << checksum(mesh.data(), mesh.size() * sizeof(double)) << " and "
            << checksum(law.mesh_a.facet.data(), law.mesh_a.facet.size() * sizeof(std::ptrdiff_t))
            << '\n';
    }
    return out.str();
}

}  // namespace

void save(const Simulation& simulation, std::ostream& out) {
    write_state(words_of(simulation), state_bytes(simulation), out);
}

void restore(Simulation& simulation, std::istream& in, OtherBits bits) {
    read_state(in, bits, words_of(simulation),
               [&](const std::string& state) { take_state(simulation, state); });
}

}  // namespace grit::mpm::space
