// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/lammps_script.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include <adapters/mpm/case/case_words.hpp>
#include <adapters/mpm/case/initial_state.hpp>
#include <adapters/mpm/run/history.hpp>
#include <adapters/mpm/space/case/build.hpp>
#include <adapters/mpm/step/column_names.hpp>
#include <fmt/format.h>
#include <grit/contact.h>

#include "cli/process/exit_code.hpp"
#include "cli/process/version.hpp"

namespace cli {
namespace {

using namespace grit::mpm;

// Every bit.
std::string exact(double x) { return fmt::format("{:.17g}", x); }
const char* word(bool yes) { return yes ? "yes" : "no"; }

std::string of_table(const TimeTable& table) {
    if (table.time.size() == 1) return exact(table.value[0]);
    std::string out = fmt::format("table {}", table.time.size());
    for (std::size_t i = 0; i < table.time.size(); ++i)
        out += fmt::format(" {} {}", exact(table.time[i]), exact(table.value[i]));
    return out;
}

std::string of_pulses(const PulseTrain& p) {
    return fmt::format("pulses {} {} {} {} {} {} {}", word_of(words::pulse_forms, p.form),
                       exact(p.peak), exact(p.duration), exact(p.peak_time), exact(p.interval),
                       exact(p.start), p.count);
}

std::string of_function(const TimeFunction& function) {
    if (const auto* pulses = std::get_if<PulseTrain>(&function)) return of_pulses(*pulses);
    return of_table(std::get<TimeTable>(function));
}

std::string from(const std::string& stage) {
    return stage.empty() ? std::string() : fmt::format(" from {}", stage);
}

class FixWords {
  public:
    template <class... Args> void add(fmt::format_string<Args...> text, Args&&... args) {
        out += " &\n    ";
        out += fmt::format(text, std::forward<Args>(args)...);
    }
    std::string out;
};

void add_segments(char direction, const AxisPlan& axis, FixWords& fix) {
    for (const AxisSegment& segment : axis.segments)
        fix.add("grid {} {} {} {}", direction, exact(segment.to), segment.cells,
                exact(segment.growth));
}

void refuse_kind(Boundary kind) {
    for (const Spelling& word : words::boundaries)
        if (word.value == static_cast<int>(kind) && !word.in_fix)
            throw BadInput(fmt::format("fix grit/mpm of LAMMPS has no {} sides", word.word));
}

void add_grid_in_space(const SpacePlan& space, FixWords& fix) {
    for (const std::size_t d : {0, 1, 2}) add_segments("xyz"[d], space.axis[d], fix);
    for (const Spelling& side : words::sides_in_space) {
        const Boundary kind = space.boundary[side.value];
        refuse_kind(kind);
        if (kind != Boundary::free)
            fix.add("boundary {} {}", side.word, word_of(words::boundaries, kind));
    }
}

void add_grid(const Case& plan, FixWords& fix) {
    if (plan.space) return add_grid_in_space(*plan.space, fix);
    add_segments('r', plan.r, fix);
    add_segments('z', plan.z, fix);
    if (!plan.inflows.empty()) throw BadInput("fix grit/mpm of LAMMPS has no inflow across sides");
    for (const Spelling& side : words::sides) {
        const Boundary kind = plan.boundary[side.value];
        refuse_kind(kind);
        if (kind != Boundary::free)
            fix.add("boundary {} {}", side.word, word_of(words::boundaries, kind));
        if (plan.drained[side.value]) fix.add("drained {}", side.word);
    }
}

// As the fix reads it; empty: nothing that it could read.
template <class Plan> std::string value_of(const Member<Plan>& member, const Plan& plan) {
    const double value = member.get(plan);
    switch (member.word->kind) {
        case Kind::yes_or_no: return word(value != 0.0);
        case Kind::choice: return std::string(word_of(member.word->words, static_cast<int>(value)));
        default: return std::isfinite(value) ? exact(value) : std::string();
    }
}

// The number of threads is the host's.
void add_numerics(const Case& plan, FixWords& fix) {
    std::string_view before;
    for (const Member<Case>& member : numerics_members()) {
        const std::string value = value_of(member, plan);
        if (value.empty() || member.fix == "threads") continue;
        if (member.fix == before) fix.out += ' ' + value;
        else fix.add("{} {}", member.fix, value);
        before = member.fix;
    }
}

std::string of_sand(const SandPlan& plan) {
    std::string out = "sand custom";
    for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i) {
        double value = NAN;
        grit_sand_parameter_get(&plan.parameters, i, &value);
        if (!std::isnan(value))
            out += fmt::format(" &\n        {} {}", grit_sand_parameter_describe(i)->name,
                               exact(value));
    }
    return out + fmt::format(" &\n        tolerance {} evaluation_limit {} intergranular {}",
                             exact(plan.options.tolerance), plan.options.evaluation_limit,
                             word_of(words::on_off, plan.options.intergranular_off));
}

// Pore pressures are among the points.
void add_water(const BodyPlan& body, FixWords& fix) {
    const WaterPlan& water = *body.water;
    fix.add("water {} {}", body.name, word_of(words::drainages, water.drainage));
    for (const Member<WaterPlan>& member : water_members())
        if (member.word->kind != Kind::number || member.word->si_range().has(member.get(water)))
            fix.out += fmt::format(" {} {}", member.fix, value_of(member, water));
    if (water.kozeny_carman)
        fix.out += fmt::format(" kozeny_carman {}", exact(conductivity_at(body)));
}

std::string of_vector(const grit::Vector3& x) {
    return fmt::format("{} {} {}", exact(x[0]), exact(x[1]), exact(x[2]));
}

std::string of_motion(const Case& plan, std::size_t body) {
    const auto& rigid = std::get<RigidPlan>(plan.bodies[body].material);
    std::string out = of_table(rigid.velocity_r);
    if (!plan.space)
        return fmt::format("{} {}{}", out, of_table(rigid.velocity_z), from(rigid.from_stage));
    out += fmt::format(" {} {}", of_table(rigid.velocity_y), of_table(rigid.velocity_z));
    out += fmt::format(" spin {} {} {}", of_table(rigid.spin[0]), of_table(rigid.spin[1]),
                       of_table(rigid.spin[2]));
    if (rigid.centre) out += fmt::format(" centre {}", of_vector(*rigid.centre));
    if (rigid.any_free()) {
        out += fmt::format(" free {}", std::count(rigid.free.begin(), rigid.free.end(), true));
        for (const Spelling& degree : words::degrees_of_freedom)
            if (rigid.free[static_cast<std::size_t>(degree.value)])
                out += fmt::format(" {}", degree.word);
        out += fmt::format(" start {}", of_vector(plan.space->bodies[body].velocity));
    }
    return out + from(rigid.from_stage);
}

void add_bodies(const Case& plan, const std::string& stem, FixWords& fix) {
    for (std::size_t i = 0; i < plan.bodies.size(); ++i) {
        const BodyPlan& body = plan.bodies[i];
        std::string material = "rigid";
        if (const auto* elastic = std::get_if<ElasticPlan>(&body.material))
            material = fmt::format("{} {} {}", elastic->neo_hooke ? "neo_hooke" : "elastic",
                                   exact(elastic->youngs_modulus), exact(elastic->poissons_ratio));
        if (const auto* sand = std::get_if<SandPlan>(&body.material)) material = of_sand(*sand);
        fix.add("body {} type {} {}", body.name, i + 1, material);
        if (body.rigid()) fix.add("motion {} {}", body.name, of_motion(plan, i));
        if (body.water) add_water(body, fix);
        fix.add("points {} {}_{}.points", body.name, stem, body.name);
    }
}

std::string of_line(const BoundaryLine& line) {
    std::vector<grit::Vector2> points = line.points;
    if (line.closed) points.push_back(points.front());
    std::string out = fmt::format(" stiff_line {}", points.size());
    for (const grit::Vector2& x : points) out += fmt::format(" {} {}", exact(x[0]), exact(x[1]));
    return out;
}

void add_contacts(const Case& plan, const std::string& stem, FixWords& fix) {
    for (const ContactPlan& contact : plan.contacts) {
        if (contact.penalty) throw BadInput("fix grit/mpm of LAMMPS has no penalty contact");
        const int law = words::law_of(contact);
        const std::string_view word = word_of(words::contact_laws, law);
        std::string more;
        for (const Member<ContactPlan>& member : contact_members()) {
            const std::string_view key = member.word->key;
            const double value = member.get(contact);
            const bool is_none =
                member.word->kind == Kind::number && (value == 0.0 || !std::isfinite(value));
            if (member.fix.empty() || is_none || !has_key(word, key) ||
                (laws_with(key) == "surface" && value == member.get(ContactPlan{})) ||
                (member.fix == "modulus" && contact.contact_stiffness_multiple == 0.0) ||
                (member.fix == "distance" && law == GRIT_CONTACT_FRICTIONAL && !contact.gated))
                continue;
            more += fmt::format(" {} {}", member.fix, value_of(member, contact));
        }
        if (!contact.surface_line.points.empty()) more += of_line(contact.surface_line);
        if (contact.surface_mesh) more += " stiff_surface " + lammps_stl(stem, contact);
        fix.add("contact {} {} {} {}{}", contact.stiff, contact.soft, word,
                exact(contact.friction_coefficient), more);
    }
}

void add_tractions(const Case& plan, FixWords& fix) {
    for (std::size_t i = 0; i < plan.tractions.size(); ++i) {
        const TractionPlan& t = plan.tractions[i];
        const FacePlan* face = plan.space ? &plan.space->faces[i] : nullptr;
        const std::string_view edge =
            face ? word_of(words::sides_in_space, 2 * face->across + (face->upper ? 1 : 0))
                 : word_of(words::edges, t.edge);
        const std::string direction =
            face ? of_vector(face->direction)
                 : fmt::format("{} {}", exact(t.direction[0]), exact(t.direction[1]));
        fix.add("traction {} traction_{} {} {} {}{}{}", t.body, i + 1, edge, direction,
                of_function(t.stress), t.on_mixture ? " mixture" : "", from(t.from_stage));
    }
}

std::string of_stage(const StagePlan& stage) {
    std::string out = fmt::format("fix_modify mpm stage {}", stage.name);
    for (const Member<StagePlan>& member : stage_members())
        out += fmt::format(" {} {}", member.fix, value_of(member, stage));
    for (const Member<StageEnd>& member : end_members())
        if (member.get(stage.end) != member.get(StageEnd()))
            out += fmt::format(" {} {}", member.fix, value_of(member, stage.end));
    out += fmt::format("\nrun ${{most_steps}}\n"
                       "print \"stage {}: depth $(f_mpm[5]) m at $(f_mpm[3]) s\"\n",
                       stage.name);
    return out;
}

// Numbers one after the other as ranges.
std::string id_list(const std::vector<int>& ids) {
    std::string out;
    for (std::size_t i = 0; i < ids.size();) {
        std::size_t end = i + 1;
        while (end < ids.size() && ids[end] == ids[end - 1] + 1) ++end;
        out += end - i == 1 ? fmt::format(" &\n    {}", ids[i])
                            : fmt::format(" &\n    {}:{}", ids[i], ids[end - 1]);
        i = end;
    }
    return out;
}

std::string columns_comment(bool in_space) {
    std::string out = "# Columns:";
    int number = 1;
    for (const HistoryColumn& column : grit::mpm::history_columns(in_space))
        out += fmt::format("{}{} {}{}", number % 6 == 1 ? "\n#   " : ", ", number, column.name,
                           *column.unit ? fmt::format(" [{}]", column.unit) : ""),
            ++number;
    out += "\n";
    return out;
}

// Of atoms, which have the columns of files of points but id behind r z v_r v_z.
std::string pore_columns_comment(const Case& plan) {
    std::size_t longest = 0;
    bool any = false;
    const auto count = [&](const auto& names, bool is_wet) {
        longest = std::max(longest, names.size());
        any = any || is_wet;
    };
    for (const BodyPlan& body : plan.bodies) {
        if (plan.space) {
            const auto material = space::material_of(body);
            const auto water = space::water_of(body, material.get());
            count(space::column_names(material.get(), water), water.has_value());
            continue;
        }
        const auto material = make_material(body);
        const auto water =
            body.water ? std::optional(make_water(body, *material)) : std::optional<PoreWater>();
        count(column_names(material.get(), water), water.has_value());
    }
    if (!any) return {};
    std::string out = "# Of atoms:";
    for (const char* name : plan.space ? space::pore_fields : pore_fields)
        out += fmt::format(" {} {},", ++longest, name);
    out.back() = '\n';
    return out;
}

}  // namespace

std::string lammps_stl(const std::string& stem, const ContactPlan& contact) {
    return fmt::format("{}_{}_{}.stl", stem, contact.stiff, contact.soft);
}

std::string lammps_fix(const Case& plan, const std::string& stem) {
    FixWords fix;
    using words::Geometry;
    const Geometry in_plane =
        plan.settings.axisymmetric ? Geometry::axisymmetric : Geometry::plane_strain;
    fix.out = fmt::format("fix mpm all grit/mpm {}",
                          word_of(words::geometries, plan.space ? Geometry::space : in_plane));
    add_grid(plan, fix);
    add_numerics(plan, fix);
    std::string stages = fmt::format("stages {}", plan.stages.size());
    for (const StagePlan& stage : plan.stages) stages += fmt::format(" {}", stage.name);
    fix.add("{}", stages);
    add_bodies(plan, stem, fix);
    add_tractions(plan, fix);
    add_contacts(plan, stem, fix);
    if (plan.history.profile.parts > 0)
        throw BadInput("fix grit/mpm of LAMMPS has no columns by height (profile_z_m)");
    fix.add("driven {} {}", plan.history.body, word_of(words::depths, plan.history.depth_of));
    return fmt::format("neigh_modify once yes\n{}\n\n{}{}"
                       "thermo_style custom step f_mpm[*]\n"
                       "thermo_modify format float %.17g line one\n",
                       fix.out, columns_comment(plan.space.has_value()),
                       pore_columns_comment(plan));
}

std::string lammps_script(const Case& plan, const std::string& stem,
                          const TractionAtoms& tractions) {
    std::string out = fmt::format(
        "# {}\n# Written by Grit {}; needs fix grit/mpm, see docs/lammps.md.\n"
        "variable thermo_steps index 100\nvariable most_steps index 2000000000\n\n"
        "units si\n{}\natom_style atomic\natom_modify map yes\n"
        "read_data {}.data\n",
        plan.title, version(),
        plan.space ? "dimension 3\nboundary f f f" : "dimension 2\nboundary f f p", stem);
    for (std::size_t i = 0; i < tractions.size(); ++i)
        out += fmt::format("group traction_{} id{}\n", i + 1, id_list(tractions[i]));
    out += fmt::format("include {}.fix\nthermo ${{thermo_steps}}\n", stem);
    for (const StagePlan& stage : plan.stages) out += fmt::format("\n{}", of_stage(stage));
    return out;
}

}  // namespace cli
