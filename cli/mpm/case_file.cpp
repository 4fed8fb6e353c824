// SPDX-License-Identifier: BSD-3-Clause
#include "cli/mpm/case_file.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "cli/mpm/body_reader.hpp"
#include "cli/mpm/grid_reader.hpp"
#include "cli/mpm/load_reader.hpp"
#include "cli/mpm/space_fields.hpp"
#include "cli/mpm/space_reader.hpp"
#include "cli/mpm/words.hpp"
#include "cli/process/exit_code.hpp"

namespace cli {
namespace {

using namespace grit::mpm;

StageEnd read_until(TomlTable table, const Case& plan) {
    StageEnd out;
    read_members(table, "stage.until", end_members(), out);
    if (table.given().empty())
        table.fail("", fmt::format("{} must say what ends the stage", table.full("")));
    refuse(table, objection_to(plan, out, same_name));
    if (!(out.time < unlimited) && !(out.depth < unlimited) && out.blows == 0 &&
        out.unbalanced_share == 0.0)
        table.fail("unbalanced_share",
                   fmt::format("{} of 0 never ends a stage", table.full("unbalanced_share")));
    table.finish();
    return out;
}

// Names alone: loads and motions refer to them.
void read_stage_names(TomlTable& root, Case& plan) {
    for (TomlTable& table : root.tables_if("stage")) {
        StagePlan stage;
        stage.name = table.string("name");
        refuse(table, objection_to_name_of_stage(plan, stage.name));
        plan.stages.push_back(stage);
    }
    if (plan.stages.empty()) root.fail("stage", "stage is missing: a case needs a [[stage]]");
}

void read_stages(TomlTable& root, Case& plan) {
    std::size_t i = 0;
    for (TomlTable& table : root.tables_if("stage")) {
        StagePlan& stage = plan.stages[i++];
        table.has("name");
        stage = plan.plain_stage(stage.name);
        read_members(table, "stage", stage_members(), stage);
        stage.end = read_until(table.table("until"), plan);
        table.finish();
    }
}

void read_bodies(TomlTable& root, Case& plan, const std::filesystem::path& sand) {
    for (TomlTable& table : root.tables_if("body")) {
        BodyPlan body = read_body(table, plan, sand);
        refuse(table, objection_to_name_of_body(plan, body.name));
        if (auto* rigid = std::get_if<RigidPlan>(&body.material);
            rigid && !rigid->from_stage.empty()) {
            TomlTable inner = table.table("rigid");
            stage_name(inner, "from_stage", plan);
        }
        plan.bodies.push_back(std::move(body));
    }
    if (plan.bodies.empty()) root.fail("body", "body is missing: a case needs a [[body]]");
}

void read_contacts(TomlTable& root, Case& plan) {
    for (TomlTable& table : root.tables_if("contact")) {
        plan.contacts.push_back(read_contact(table, plan));
        refuse(table, objection_to_contact(plan, plan.contacts.size() - 1, same_name));
    }
}

// A thousandth of the first stage that says how long it is; 0: none does.
double kind_interval(const Case& plan) {
    for (const StagePlan& stage : plan.stages)
        if (stage.end.time < unlimited) return 1e-3 * stage.end.time;
    return 0.0;
}

void read_profile(TomlTable& table, Case& plan) {
    const auto z = table.numbers_if("profile_z_m", 2);
    if (!z && table.has("profile_parts"))
        table.fail("profile_parts", fmt::format("{} needs {}", table.full("profile_parts"),
                                                table.full("profile_z_m")));
    if (!z) return;
    if (!plan.space)
        table.fail("profile_z_m",
                   fmt::format("{} is there in space alone", table.full("profile_z_m")));
    if (!((*z)[0] < (*z)[1]))
        table.fail("profile_z_m", fmt::format("{} must ascend, got {} and {} m",
                                              table.full("profile_z_m"), (*z)[0], (*z)[1]));
    ProfilePlan& profile = plan.history.profile;
    profile.from = (*z)[0];
    profile.to = (*z)[1];
    profile.parts = integer_or_default(table, case_word("history", "profile_parts"));
}

void read_history(TomlTable table, Case& plan) {
    if (table.has("body")) plan.history.body = body_name(table, "body", plan);
    if (const auto depth = choice_if(table, case_word("history", "depth_of")))
        plan.history.depth_of = static_cast<DepthOf>(*depth);
    plan.history.interval =
        number_if(table, case_word("history", "interval_s")).value_or(kind_interval(plan));
    if (!table.has("interval_s") && plan.history.interval == 0.0)
        table.fail("", fmt::format("{} is missing: no stage has a time_s to take a thousandth of; "
                                   "0 is a row after every step",
                                   table.full("interval_s")));
    read_profile(table, plan);
    table.finish();
}

FieldsPlan read_fields(TomlTable table, const std::vector<MpmField>& known) {
    FieldsPlan out;
    out.interval = number_or_default(table, case_word("fields", "interval_s"));
    std::vector<std::string> names = table.strings_or_none("variables");
    if (!table.has("variables")) names = names_of_fields(known);
    for (const std::string& name : names) {
        try {
            out.variables.push_back(field_of(known, name));
        } catch (const std::invalid_argument& error) {
            table.fail("variables", fmt::format("{}: {}", table.full("variables"), error.what()));
        }
    }
    table.finish();
    return out;
}

}  // namespace

MpmCaseFile read_mpm_case(const std::filesystem::path& path, const std::filesystem::path& sand,
                          const std::vector<CaseSetting>& settings) {
    MpmCaseFile out;
    TomlTable root = TomlTable::of_file(path, &out.inputs, settings);
    name_axes(root);
    if (!sand.empty()) out.inputs.push_back(sand);
    root.refuse_case_of("grit element");
    Case& plan = out.plan;
    plan.name = root.string_if("name").value_or(path.stem().string());
    refuse(root, objection_to_name(plan.name));
    plan.title = root.string_if("title").value_or(plan.name);
    read_members(root, "", numerics_members(), plan);
    read_grid(root.table("grid"), plan);
    if (auto numerics = root.table_if("numerics")) read_mpm_numerics(std::move(*numerics), plan);
    if (auto boundary = root.table_if("boundary")) read_boundary(std::move(*boundary), plan);
    read_stage_names(root, plan);
    read_bodies(root, plan, sand);
    for (TomlTable& table : root.tables_if("traction"))
        plan.tractions.push_back(read_traction(std::move(table), plan));
    if (plan.space && root.has("inflow")) refuse_in_space(root, "inflow");
    for (TomlTable& table : root.tables_if("inflow"))
        plan.inflows.push_back(read_inflow(std::move(table), plan));
    read_contacts(root, plan);
    read_stages(root, plan);
    plan.history.body = plan.bodies.front().name;
    plan.history.interval = kind_interval(plan);
    if (auto history = root.table_if("history")) read_history(std::move(*history), plan);
    else if (plan.history.interval == 0.0)
        root.fail("history", "history.interval_s is missing: no stage has a time_s to take a "
                             "thousandth of; 0 is a row after every step");
    if (auto fields = root.table_if("fields"))
        out.fields =
            read_fields(std::move(*fields),
                        plan.space ? space_fields() : mpm_fields(plan.settings.axisymmetric));
    root.finish();
    for (const auto& [key, value] : root.values()) out.given.push_back(key + " = " + value);
    return out;
}

}  // namespace cli
