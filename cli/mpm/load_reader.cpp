// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/load_reader.hpp"

#include <cmath>

#include <fmt/format.h>
#include <grit/contact.h>

#include "cli/mpm/body_reader.hpp"
#include "cli/mpm/space_reader.hpp"
#include "cli/mpm/words.hpp"

namespace cli {
namespace {

using namespace grit::mpm;

template <class Plans> std::vector<std::string> names_of(const Plans& plans) {
    std::vector<std::string> out;
    for (const auto& plan : plans) out.push_back(plan.name);
    return out;
}

void read_range(TomlTable& table, const std::string& key, double (&range)[2]) {
    const auto given = table.numbers_if(key, 2);
    if (!given) return;
    if (!((*given)[0] < (*given)[1]))
        table.fail(key, fmt::format("{} must ascend, got [{:g}, {:g}]", table.full(key),
                                    (*given)[0], (*given)[1]));
    range[0] = (*given)[0];
    range[1] = (*given)[1];
}

PulseTrain read_pulses(TomlTable table) {
    PulseTrain out;
    out.peak = number(table, case_word("traction.pulses", "peak_kPa"));
    if (const auto form = choice_if(table, case_word("traction.pulses", "form")))
        out.form = static_cast<PulseForm>(*form);
    out.duration = number(table, case_word("traction.pulses", "duration_s"));
    out.peak_time =
        number_if(table, case_word("traction.pulses", "peak_time_s")).value_or(0.5 * out.duration);
    out.interval =
        number_if(table, case_word("traction.pulses", "interval_s")).value_or(out.duration);
    refuse(table, objection_to(out, same_name));
    out.count = integer_or_default(table, case_word("traction.pulses", "count"));
    out.start = number_or_default(table, case_word("traction.pulses", "start_s"));
    table.finish();
    return out;
}

grit::Vector2 direction_of(TomlTable& table, Edge edge) {
    const auto given = table.numbers_if("direction", 2);
    if (!given) {
        if (edge == Edge::top) return {0.0, -1.0};
        if (edge == Edge::bottom) return {0.0, 1.0};
        return {edge == Edge::right ? -1.0 : 1.0, 0.0};
    }
    const double length = std::hypot((*given)[0], (*given)[1]);
    if (!(length > 0.0)) table.fail("direction", table.full("direction") + " must not be 0");
    return {(*given)[0] / length, (*given)[1] / length};
}

// A line in the grid; closed if its last point is its first.
BoundaryLine read_line(TomlTable table, const Case& plan) {
    const std::vector<double> r = table.numbers("r_m"), z = table.numbers("z_m", r.size());
    std::vector<grit::Vector2> points;
    for (std::size_t i = 0; i < r.size(); ++i) points.push_back({r[i], z[i]});
    BoundaryLine out = line_through(std::move(points));
    if (const auto objection = objection_to(plan, out))
        table.fail("r_m", table.full("") + objection->what);
    table.finish();
    return out;
}

PenaltyPlan read_penalty(TomlTable& table, const Case& plan) {
    PenaltyPlan out{};
    out.modulus = number(table, case_word("contact", "modulus_kPa"));
    out.stiffness_multiple = number_or_default(table, case_word("contact", "stiffness_multiple"));
    out.stiff_line = read_line(table.table("stiff_line"), plan);
    out.soft_line = read_line(table.table("soft_line"), plan);
    return out;
}

}  // namespace

std::string body_name(TomlTable& table, const std::string& key, const Case& plan) {
    return table.choice(key, names_of(plan.bodies));
}

std::string stage_name(TomlTable& table, const std::string& key, const Case& plan) {
    return table.choice(key, names_of(plan.stages));
}

TractionPlan read_traction(TomlTable table, Case& plan) {
    TractionPlan out;
    out.body = body_name(table, "body", plan);
    if (const auto on = choice_if(table, case_word("traction", "acts_on")))
        out.on_mixture = *on != 0;
    refuse(table, objection_to(plan, out));
    if (plan.space) {
        plan.space->faces.push_back(read_face(table));
    } else {
        out.edge = static_cast<Edge>(choice(table, case_word("traction", "edge")));
        read_range(table, "r_m", out.r);
        read_range(table, "z_m", out.z);
        out.direction = direction_of(table, out.edge);
    }
    if (table.one_of({"stress_kPa", "pulses"}) == "pulses") {
        out.stress = read_pulses(table.table("pulses"));
        if (table.has("time_s"))
            table.fail("time_s", table.full("time_s") + " belongs to stress_kPa, not to pulses");
    } else {
        out.stress = read_time_table(table, "stress_kPa", words::kilopascal.si);
    }
    if (table.has("from_stage")) out.from_stage = stage_name(table, "from_stage", plan);
    table.finish();
    return out;
}

InflowPlan read_inflow(TomlTable table, const Case& plan) {
    InflowPlan out;
    out.side = static_cast<Side>(choice(table, case_word("inflow", "side")));
    refuse(table, objection_to(plan, out));
    out.speed = read_time_table(table, "speed_m_per_s", 1.0);
    if (table.has("from_stage")) out.from_stage = stage_name(table, "from_stage", plan);
    table.finish();
    return out;
}

ContactPlan read_contact(TomlTable table, const Case& plan) {
    ContactPlan out;
    out.stiff = body_name(table, "stiff", plan);
    out.soft = body_name(table, "soft", plan);
    const int law = choice(table, case_word("contact", "law"));
    if (plan.space && law == words::penalty_law_word)
        table.fail("law", fmt::format("{}: {} is not there in space", table.full("law"),
                                      word_of(words::contact_laws, law)));
    if (law == words::penalty_law_word) {
        out.law = GRIT_CONTACT_FRICTIONAL;
        out.friction_coefficient = number_if(table, case_word("contact", "friction_coefficient"))
                                       .value_or(out.friction_coefficient);
        out.penalty = read_penalty(table, plan);
        table.finish();
        return out;
    }
    words::set_law(out, law);
    if (plan.space)
        for (const char* key : {"stiff_line", "after_damping"})
            if (table.has(key)) refuse_in_space(table, key);
    if (plan.space && out.at_surfaces && table.has("stiff_surface")) {
        TomlTable of = table.table("stiff_surface");
        out.surface_mesh = read_closed_surface(of, case_word("contact.stiff_surface", "unit_m"));
        of.finish();
    }
    if (out.at_surfaces && table.has("stiff_line"))
        out.surface_line = read_line(table.table("stiff_line"), plan);
    read_members(table, "contact", contact_members(), out);
    refuse(table, objection_to(
                      out, [&table](std::string_view key) { return table.has(std::string(key)); }));
    table.finish();
    return out;
}

}  // namespace cli
