// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/io/checkpoint_state.hpp"

#include <algorithm>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <type_traits>

#include "adapters/mpm/io/checksum.hpp"

namespace grit::mpm {

// The one list of all that a step leaves for the next one, or for those who look on. Left out is what
// every step makes anew: integers, sums of strips, increments, active nodes; and what follows
// from the rest: the place of each id.
struct CheckpointMembers {
    // take(begin, count) for every piece of memory. First by what others are found.
    template <class AnySimulation, class Take>
    static void visit_order(AnySimulation& s, const Take& take) {
        for (auto& part : s.parts) {
            take(part.body.particles.id.data(), part.body.particles.id.size());
            take(part.strips.start.data(), part.strips.start.size());
        }
    }
    template <class AnySimulation, class Take>
    static void visit(AnySimulation& s, const Take& take) {
        take(&s.t, 1);
        take(&s.dt, 1);
        take(&s.dt_before, 1);
        take(&s.drift, 1);
        take(&s.largest_speed, 1);
        take(&s.step_count, 1);
        take(&s.started, 1);
        take(&s.sums, 1);
        for (auto* of_stage :
             {&s.settings.cfl, &s.settings.largest_step, &s.settings.pic_rate,
              &s.settings.local_damping, &s.settings.gravity_r, &s.settings.gravity_z})
            take(of_stage, 1);
        for (auto& part : s.parts) {
            visit_columns(part.body.particles, take);
            take(part.scale.data(), part.scale.size());
            take(part.records.data(), part.records.size());
            take(part.motions.data(), part.motions.size());
            take(part.internal.data(), part.internal.size());
        }
        take(s.edge_loads.data(), s.edge_loads.size());
        for (auto& body : s.absorbing_sides.bodies) {
            take(body.forces.data(), body.forces.size());
            take(&body.balanced, 1);
        }
        for (auto& contact : s.contacts) {
            take(&contact.step_totals, 1);
            take(&contact.step_faces, 1);
            take(contact.touched.data(), contact.touched.size());
        }
        for (auto& pair : s.penalties) {
            take(&pair.step_totals, 1);
            take(&pair.next_totals, 1);
            take(&pair.step_faces[0], 2);
            take(&pair.step, 1);
            take(&pair.taken, 1);
            take(&pair.dt_before, 1);
            for (auto& line : pair.lines)
                for (auto* of_vertices :
                     {&line.position, &line.velocity, &line.history, &line.force, &line.stiffness})
                    take(of_vertices->data(), of_vertices->size());
        }
    }
    static constexpr std::size_t bytes_per_vertex = 9 * sizeof(double);
    // Before all else: how long the lines of penalty contacts have become.
    static std::vector<std::uint64_t> line_counts(const Simulation& s) {
        std::vector<std::uint64_t> counts;
        for (const auto& pair : s.penalties)
            for (const auto& line : pair.lines) counts.push_back(line.position.size() / 2);
        return counts;
    }
    static void resize_lines(Simulation& s, const std::vector<std::uint64_t>& counts) {
        auto count = counts.begin();
        for (auto& pair : s.penalties)
            for (auto& line : pair.lines) {
                for (auto* of_vertices :
                     {&line.position, &line.velocity, &line.history, &line.force})
                    of_vertices->resize(2 * *count);
                line.stiffness.resize(*count);
                ++count;
            }
    }
    template <class AnyParticles, class Take>
    static void visit_columns(AnyParticles& particles, const Take& take) {
        for (int c = 0; c < particles.columns; ++c)
            take(particles.data.data() + c * particles.stride,
                 static_cast<std::size_t>(particles.count));
    }

    static void grid_words(const Simulation& s, std::ostream& out);
    static void body_words(const Simulation& s, std::ostream& out);
    static void contact_words(const Simulation& s, std::ostream& out);
    static std::uint64_t rates_checksum(const Simulation& s);
    static std::vector<double> masses_by_id(const Particles& particles);
    static void check(const Simulation& s, const std::string& bytes);
    static void find_places(Simulation& s) {
        for (auto& part : s.parts) s.find_places(part);
    }
};

namespace {

std::string of(const Axis& axis) {
    std::vector<double> nodes;
    for (int i = 0; i < axis.nodes(); ++i) nodes.push_back(axis[i]);
    std::ostringstream out;
    out << axis.nodes() << " nodes from " << nodes.front() << " to " << nodes.back()
        << " m, checksum " << checksum(nodes.data(), nodes.size() * sizeof(double));
    return out.str();
}

const char* name_of(Scheme scheme) {
    return scheme == Scheme::usl ? "usl" : scheme == Scheme::musl ? "musl" : "usf";
}

const char* name_of(Shape shape) {
    switch (shape) {
        case Shape::cpdi: return "cpdi";
        case Shape::cpdi_published: return "cpdi, as published";
        case Shape::ugimp: return "ugimp";
        default: return "point";
    }
}

}  // namespace

void CheckpointMembers::grid_words(const Simulation& s, std::ostream& out) {
    out << "geometry: " << (s.settings.axisymmetric ? "axisymmetric" : "plane strain") << '\n'
        << "grid along r: " << of(s.r_axis) << '\n'
        << "grid along z: " << of(s.z_axis) << '\n'
        << "fixed nodes: "
        << std::count_if(s.fixed_nodes.begin(), s.fixed_nodes.end(),
                         [](int bits) { return bits != fixed::none; })
        << ", checksum " << checksum(s.fixed_nodes.data(), s.fixed_nodes.size()) << '\n'
        << "absorbing nodes: " << s.absorbing_sides.nodes.size() << ", checksum "
        << rates_checksum(s) << '\n'
        << "shape functions: " << name_of(s.settings.shape) << '\n'
        << "scheme: " << name_of(s.settings.scheme) << '\n'
        << "bulk viscosity: linear " << s.settings.linear_viscosity << ", quadratic "
        << s.settings.quadratic_viscosity << '\n'
        << "volumetric strain: " << (s.settings.cell_mean ? "mean of the cell" : "own") << '\n'
        << "sums: " << (s.settings.fixed_point ? "fixed point" : "floating point") << '\n';
}

std::uint64_t CheckpointMembers::rates_checksum(const Simulation& s) {
    std::vector<double> numbers;
    for (const auto& node : s.absorbing_sides.nodes)
        numbers.insert(numbers.end(), {static_cast<double>(node.node), node.rate[0], node.rate[1]});
    return checksum(numbers.data(), numbers.size() * sizeof(double));
}

std::vector<double> CheckpointMembers::masses_by_id(const Particles& particles) {
    std::vector<double> mass(static_cast<std::size_t>(particles.count));
    for (std::ptrdiff_t p = 0; p < particles.count; ++p)
        mass[static_cast<std::size_t>(particles.ids()[p])] = particles(column::mass, p);
    return mass;
}

void CheckpointMembers::body_words(const Simulation& s, std::ostream& out) {
    out << "bodies: " << s.parts.size() << '\n';
    for (std::size_t i = 0; i < s.parts.size(); ++i) {
        const Body& body = s.parts[i].body;
        const std::vector<double> mass = masses_by_id(body.particles);
        out << "body " << i << ": " << (body.name.empty() ? "without name" : "\"" + body.name + '"')
            << (body.rigid() ? ", rigid" : "") << ", " << body.particles.count << " particles of "
            << body.particles.columns << " columns, checksum of their masses "
            << checksum(mass.data(), mass.size() * sizeof(double)) << '\n';
        if (!body.material) continue;
        for (const std::string& word : body.material->words())
            out << "body " << i << ": " << word << '\n';
    }
    out << "tractions: " << s.tractions.size() << '\n';
}

void CheckpointMembers::contact_words(const Simulation& s, std::ostream& out) {
    out << "contacts: " << s.contacts.size() << '\n';
    for (std::size_t i = 0; i < s.contacts.size(); ++i) {
        const ContactLaw& law = s.contacts[i].law();
        const grit_contact_options& o = law.options;
        out << "contact " << i << ": bodies " << law.a << " and " << law.b << ", law " << o.law
            << ", friction coefficient " << o.friction_coefficient << ", penalty power "
            << o.penalty_power << ", normal " << law.normal << ", measure " << law.measure
            << (law.gated ? ", gated" : "") << '\n';
    }
    out << "penalty contacts: " << s.penalties.size() << '\n';
    for (std::size_t i = 0; i < s.penalties.size(); ++i) {
        const PenaltyLaw& law = s.penalties[i].law();
        const grit_penalty_options& o = law.options;
        out << "penalty contact " << i << ": bodies " << law.a << " and " << law.b
            << ", friction coefficient " << o.friction_coefficient << ", stiffness "
            << o.normal_stiffness << " and " << o.tangential_stiffness << " Pa/m, depth up to "
            << o.depth_max << " m, segments of " << law.shortest << " to " << law.longest << " m\n";
    }
}

std::string CheckpointState::words(const Simulation& simulation) {
    std::ostringstream out;
    out.precision(17);
    CheckpointMembers::grid_words(simulation, out);
    CheckpointMembers::body_words(simulation, out);
    CheckpointMembers::contact_words(simulation, out);
    return out.str();
}

std::string CheckpointState::bytes(const Simulation& simulation) {
    std::string out;
    const auto append = [&](const auto* data, std::size_t count) {
        static_assert(std::is_trivially_copyable_v<std::remove_pointer_t<decltype(data)>>);
        out.append(reinterpret_cast<const char*>(data), count * sizeof *data);
    };
    const std::vector<std::uint64_t> counts = CheckpointMembers::line_counts(simulation);
    append(counts.data(), counts.size());
    CheckpointMembers::visit_order(simulation, append);
    CheckpointMembers::visit(simulation, append);
    return out;
}

namespace {

template <class Number>
std::vector<Number> read(const std::string& bytes, std::size_t& at, std::size_t count) {
    std::vector<Number> out(count);
    if (count > 0) std::memcpy(out.data(), bytes.data() + at, count * sizeof(Number));
    at += count * sizeof(Number);
    return out;
}

// Ids are a permutation, and starts of strips ascend.
void check_order(const std::vector<int>& ids, const std::vector<std::ptrdiff_t>& starts) {
    const auto count = static_cast<std::ptrdiff_t>(ids.size());
    std::vector<bool> seen(ids.size(), false);
    for (const int id : ids) {
        if (id < 0 || id >= count || seen[static_cast<std::size_t>(id)])
            throw std::runtime_error("its particles are not numbered as those of the simulation");
        seen[static_cast<std::size_t>(id)] = true;
    }
    if (!std::is_sorted(starts.begin(), starts.end()) || starts.front() < 0 ||
        starts.back() > count)
        throw std::runtime_error("its strips do not hold the particles of the simulation");
}

}  // namespace

void CheckpointMembers::check(const Simulation& s, const std::string& bytes) {
    const std::vector<std::uint64_t> ours = line_counts(s);
    std::size_t wanted = 0, at = 0;
    if (bytes.size() >= ours.size() * sizeof(std::uint64_t)) {
        for (const std::uint64_t count : read<std::uint64_t>(bytes, at, ours.size()))
            wanted += std::min<std::uint64_t>(count, bytes.size()) * bytes_per_vertex;
        for (const std::uint64_t count : ours) wanted -= count * bytes_per_vertex;
    }
    wanted += ours.size() * sizeof(std::uint64_t);
    const auto add = [&](const auto* data, std::size_t count) { wanted += count * sizeof *data; };
    visit_order(s, add);
    visit(s, add);
    if (bytes.size() != wanted)
        throw std::runtime_error("its state has " + std::to_string(bytes.size()) +
                                 " bytes, that of the simulation " + std::to_string(wanted));
    for (const auto& part : s.parts) {
        const auto ids = read<int>(bytes, at, part.body.particles.id.size());
        check_order(ids, read<std::ptrdiff_t>(bytes, at, part.strips.start.size()));
    }
}

void CheckpointState::take(Simulation& simulation, const std::string& bytes) {
    CheckpointMembers::check(simulation, bytes);
    std::size_t start = 0;
    CheckpointMembers::resize_lines(
        simulation,
        read<std::uint64_t>(bytes, start, CheckpointMembers::line_counts(simulation).size()));
    const char* at = bytes.data() + start;
    const auto copy = [&](auto* data, std::size_t count) {
        if (count > 0) std::memcpy(static_cast<void*>(data), at, count * sizeof *data);
        at += count * sizeof *data;
    };
    CheckpointMembers::visit_order(simulation, copy);
    CheckpointMembers::visit(simulation, copy);
    CheckpointMembers::find_places(simulation);
}

}  // namespace grit::mpm
