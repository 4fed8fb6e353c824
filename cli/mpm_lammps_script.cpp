// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm_lammps_script.hpp"

#include <cmath>
#include <iterator>

#include <adapters/mpm/run/history.hpp>
#include <fmt/format.h>
#include <grit/contact.h>
#include <grit/contact_distance.h>
#include <grit/contact_normals.h>

#include "cli/exit_code.hpp"
#include "cli/version.hpp"

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
    return fmt::format("pulses {} {} {} {} {} {} {}",
                       p.form == PulseForm::half_sine ? "half_sine" : "triangle", exact(p.peak),
                       exact(p.duration), exact(p.peak_time), exact(p.interval), exact(p.start),
                       p.count);
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

void add_grid(const Case& plan, FixWords& fix) {
    for (const char direction : {'r', 'z'})
        for (const AxisSegment& segment : (direction == 'r' ? plan.r : plan.z).segments)
            fix.add("grid {} {} {} {}", direction, exact(segment.to), segment.cells,
                    exact(segment.growth));
    constexpr const char* sides[] = {"left", "right", "bottom", "top"};
    constexpr const char* kinds[] = {"free", "roller", "fixed"};
    for (int side = 0; side < 4; ++side) {
        const Boundary kind = plan.boundary[side];
        if (kind == Boundary::absorbing)
            throw BadInput("fix grit/mpm of LAMMPS has no absorbing sides");
        if (kind != Boundary::free)
            fix.add("boundary {} {}", sides[side], kinds[static_cast<int>(kind)]);
    }
}

void add_numerics(const Case& plan, FixWords& fix) {
    constexpr const char* shapes[] = {"cpdi", "cpdi_published", "ugimp", "linear"};
    constexpr const char* schemes[] = {"usl", "musl", "usf"};
    const Settings& s = plan.settings;
    fix.add("shape_function {} scheme {}", shapes[static_cast<int>(s.shape)],
            schemes[static_cast<int>(s.scheme)]);
    fix.add("cfl {} pic_rate {} local_damping {}", exact(s.cfl), exact(s.pic_rate),
            exact(s.local_damping));
    if (std::isfinite(s.largest_step)) fix.add("largest_step {}", exact(s.largest_step));
    fix.add("bulk_viscosity {} {}", exact(s.linear_viscosity), exact(s.quadratic_viscosity));
    fix.add("cell_mean {} fixed_point {}", word(s.cell_mean), word(s.fixed_point));
    fix.add("gravity {} energy_residual_limit {}", exact(plan.gravity), exact(plan.residual_limit));
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
                             plan.options.intergranular_off ? "off" : "on");
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
        if (const auto* rigid = std::get_if<RigidPlan>(&body.material))
            fix.add("motion {} {} {}{}", body.name, of_table(rigid->velocity_r),
                    of_table(rigid->velocity_z), from(rigid->from_stage));
        fix.add("points {} {}_{}.points", body.name, stem, body.name);
    }
}

void add_contacts(const Case& plan, FixWords& fix) {
    for (const ContactPlan& contact : plan.contacts) {
        if (contact.penalty) throw BadInput("fix grit/mpm of LAMMPS has no penalty contact");
        const char* normal = contact.normal == GRIT_CONTACT_NORMAL_OF_A   ? "stiff"
                             : contact.normal == GRIT_CONTACT_NORMAL_OF_B ? "soft"
                                                                          : "average";
        const char* distance = contact.measure == GRIT_CONTACT_SUPPORT ? "support"
                               : contact.measure == GRIT_CONTACT_EDGE  ? "edge"
                                                                       : "nearest_centre";
        const bool geo = contact.law == GRIT_CONTACT_GEO;
        fix.add("contact {} {} {} {}{} normal {}{} gated {}", contact.stiff, contact.soft,
                geo ? "geo" : "frictional", exact(contact.friction_coefficient),
                geo ? " power " + exact(contact.penalty_power) : "", normal,
                geo || contact.gated ? std::string(" distance ") + distance : "",
                word(contact.gated));
    }
}

void add_tractions(const Case& plan, FixWords& fix) {
    constexpr const char* edges[] = {"bottom", "right", "top", "left"};
    for (std::size_t i = 0; i < plan.tractions.size(); ++i) {
        const TractionPlan& t = plan.tractions[i];
        fix.add("traction {} traction_{} {} {} {} {}{}", t.body, i + 1,
                edges[static_cast<int>(t.edge)], exact(t.direction.r), exact(t.direction.z),
                of_function(t.stress), from(t.from_stage));
    }
}

std::string of_stage(const StagePlan& stage) {
    std::string out = fmt::format("fix_modify mpm stage {} gravity {} local_damping {} pic_rate {} "
                                  "cfl {}",
                                  stage.name, word(stage.gravity), exact(stage.local_damping),
                                  exact(stage.pic_rate), exact(stage.cfl));
    const StageEnd& end = stage.end;
    if (end.time < unlimited) out += fmt::format(" until_time {}", exact(end.time));
    if (end.depth < unlimited) out += fmt::format(" until_depth {}", exact(end.depth));
    if (end.blows > 0) out += fmt::format(" until_blows {}", end.blows);
    if (end.unbalanced_share > 0.0)
        out += fmt::format(" until_unbalanced {}", exact(end.unbalanced_share));
    if (end.kinetic_share > 0.0) out += fmt::format(" until_kinetic {}", exact(end.kinetic_share));
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

std::string columns_comment() {
    std::string out = "# Columns:";
    int number = 1;
    for (const HistoryColumn& column : history_columns())
        out += fmt::format("{}{} {}{}", number % 6 == 1 ? "\n#   " : ", ", number, column.name,
                           *column.unit ? fmt::format(" [{}]", column.unit) : ""),
            ++number;
    out += "\n";
    return out;
}

}  // namespace

std::string lammps_fix(const Case& plan, const std::string& stem) {
    FixWords fix;
    fix.out = fmt::format("fix mpm all grit/mpm {}",
                          plan.settings.axisymmetric ? "axisymmetric" : "plane_strain");
    add_grid(plan, fix);
    add_numerics(plan, fix);
    std::string stages = fmt::format("stages {}", plan.stages.size());
    for (const StagePlan& stage : plan.stages) stages += fmt::format(" {}", stage.name);
    fix.add("{}", stages);
    add_bodies(plan, stem, fix);
    add_tractions(plan, fix);
    add_contacts(plan, fix);
    fix.add("driven {} {}", plan.history.body,
            plan.history.depth_of == DepthOf::lowest_point ? "lowest_point" : "centre_of_mass");
    return fmt::format("neigh_modify once yes\n{}\n\n{}"
                       "thermo_style custom step f_mpm[*]\n"
                       "thermo_modify format float %.17g line one\n",
                       fix.out, columns_comment());
}

std::string lammps_script(const Case& plan, const std::string& stem,
                          const TractionAtoms& tractions) {
    std::string out = fmt::format(
        "# {}\n# Written by Grit {}; needs fix grit/mpm, see docs/lammps.md.\n"
        "variable thermo_steps index 100\nvariable most_steps index 2000000000\n\n"
        "units si\ndimension 2\nboundary f f p\natom_style atomic\natom_modify map yes\n"
        "read_data {}.data\n",
        plan.title, version(), stem);
    for (std::size_t i = 0; i < tractions.size(); ++i)
        out += fmt::format("group traction_{} id{}\n", i + 1, id_list(tractions[i]));
    out += fmt::format("include {}.fix\nthermo ${{thermo_steps}}\n", stem);
    for (const StagePlan& stage : plan.stages) out += fmt::format("\n{}", of_stage(stage));
    return out;
}

}  // namespace cli
