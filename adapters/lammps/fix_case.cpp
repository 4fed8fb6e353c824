// SPDX-License-Identifier: GPL-2.0-only
#include "adapters/lammps/fix_case.hpp"

#include <cmath>
#include <functional>
#include <set>
#include <span>
#include <stdexcept>
#include <utility>

#include "adapters/lammps/read_body.hpp"
#include "adapters/lammps/read_function.hpp"
#include "adapters/lammps/words.hpp"
#include "adapters/mpm/case/case_words.hpp"
#include "adapters/mpm/io/checksum.hpp"
#include "adapters/mpm/step/contact_pair.hpp"

namespace grit::lammps {
namespace {

using mpm::Case;
using mpm::case_word;

using mpm::KeyName;

std::string as_in_files(std::string_view key) { return std::string(key); }

// Keys that have a word in the fix.
template <class Plan> KeyName fix_words(std::span<const mpm::Member<Plan>> members) {
    return [members](std::string_view key) {
        for (const mpm::Member<Plan>& member : members)
            if (member.word->key == key && !member.fix.empty()) return std::string(member.fix);
        return std::string(key);
    };
}

std::string name_of_body(std::string_view key) {
    if (key.empty()) return {};
    return key == "stiff" ? "the stiffer one" : ": the softer body";
}

void read_segment(Words& words, Case& plan) {
    static constexpr mpm::Spelling axes[] = {mpm::spelling("r", 0, ""), mpm::spelling("z", 1, "")};
    const int direction = words.choice("the direction of a grid segment", axes);
    mpm::AxisPlan& axis = direction == 0 ? plan.r : plan.z;
    mpm::AxisSegment segment{};
    segment.to = words.number("the end of a grid segment");
    segment.cells = words.integer("the number of its cells", case_word("grid.r", "cells").range);
    segment.growth = words.number("their growth", case_word("grid.r", "growth"));
    const double before = axis.segments.empty() ? axis.from : axis.to();
    if (!(segment.to > before)) throw std::invalid_argument("the segments of a grid must ascend");
    axis.segments.push_back(segment);
}

void read_boundary(Words& words, Case& plan) {
    const int side = words.choice("a side of the grid", mpm::words::sides);
    plan.boundary[side] =
        static_cast<mpm::Boundary>(words.choice("the boundary of a side", mpm::words::boundaries));
    refuse("boundary ", mpm::objection_to(plan, static_cast<mpm::Side>(side)), as_in_files);
}

void read_traction(Words& words, FixCase& out) {
    mpm::TractionPlan traction;
    traction.body = words.word("the body of a traction");
    out.traction_groups.push_back(words.word("the group of a traction"));
    traction.edge =
        static_cast<mpm::Edge>(words.choice("the edge of a traction", mpm::words::edges));
    traction.direction[0] = words.number("the direction of a traction along r");
    traction.direction[1] = words.number("... and along z");
    if (traction.direction[0] == 0.0 && traction.direction[1] == 0.0)
        throw std::invalid_argument("the direction of a traction must not be 0");
    Function function = read_function(words, "the stress of a traction");
    traction.stress = std::move(function.time);
    out.traction_variables.push_back(std::move(function.variable));
    traction.on_mixture = words.take("mixture");
    if (words.take("from")) traction.from_stage = words.word("the stage of a traction");
    out.plan.tractions.push_back(std::move(traction));
}

void read_contact(Words& words, Case& plan) {
    mpm::ContactPlan contact;
    contact.stiff = words.word("the stiffer body of a contact");
    contact.soft = words.word("the softer body of a contact");
    mpm::words::set_law(contact, words.choice("the law of a contact", mpm::words::contact_laws));
    contact.friction_coefficient =
        words.number("a friction coefficient", case_word("contact", "friction_coefficient"));
    std::set<std::string> given;
    while (const auto* member = member_called(mpm::contact_members(), words.peek()))
        words.read(*given.insert(words.word("a keyword")).first, *member, contact);
    const KeyName name = fix_words(mpm::contact_members());
    refuse(
        "",
        mpm::objection_to(contact, [&](std::string_view key) { return given.contains(name(key)); }),
        name);
    plan.contacts.push_back(contact);
}

void add_stage(const std::string& name, Case& plan) {
    refuse("the name of a stage", mpm::objection_to_name_of_stage(plan, name), no_name);
    plan.stages.emplace_back().name = name;
}

using Reader = std::function<void(Words&, FixCase&)>;

const std::map<std::string, Reader>& readers() {
    static const std::map<std::string, Reader> all{
        {"grid", [](Words& w, FixCase& c) { read_segment(w, c.plan); }},
        {"boundary", [](Words& w, FixCase& c) { read_boundary(w, c.plan); }},
        {"body", read_body},
        {"water", read_water},
        {"drained",
         [](Words& w, FixCase& c) {
             c.plan.drained[w.choice("a drained side of the grid", mpm::words::sides)] = true;
         }},
        {"motion", read_motion},
        {"points", read_points},
        {"traction", read_traction},
        {"contact", [](Words& w, FixCase& c) { read_contact(w, c.plan); }},
        {"stages",
         [](Words& w, FixCase& c) {
             for (int n = w.integer("the number of stages", mpm::words::many); n > 0; --n)
                 add_stage(w.word("the name of a stage"), c.plan);
         }},
        {"driven",
         [](Words& w, FixCase& c) {
             c.plan.history.body = w.word("the driven body");
             c.plan.history.depth_of =
                 static_cast<mpm::DepthOf>(w.choice("its depth", mpm::words::depths));
         }},
    };
    return all;
}

// A keyword of numerics, or false. Two members may share one, and have both their numbers behind it.
bool read_numerics(const std::string& keyword, Words& words, Case& plan) {
    int count = 0;
    for (const mpm::Member<Case>& member : mpm::numerics_members())
        count += member.fix == keyword ? 1 : 0;
    for (const mpm::Member<Case>& member : mpm::numerics_members())
        if (member.fix == keyword)
            words.read(count > 1 ? std::string(member.word->key) : keyword, member, plan);
    return count > 0;
}

void check_grid(const mpm::AxisPlan& axis, double end, const char* name) {
    if (axis.segments.empty())
        throw std::invalid_argument(std::string("grid ") + name + " is missing");
    if (axis.to() != end)
        throw std::invalid_argument(std::string("grid ") + name + " ends at " +
                                    std::to_string(axis.to()) + " m, the box at " +
                                    std::to_string(end) + " m");
}

void check_water(const Case& plan, const mpm::BodyPlan& body) {
    const mpm::WaterPlan& water = *body.water;
    const auto given = [&water](std::string_view key) {
        if (key == "porosity") return water.porosity > 0.0;
        if (key == "conductivity_m_per_s") return water.conductivity > 0.0;
        return key == "conductivity_law" && water.kozeny_carman;
    };
    const auto name = [](std::string_view key) -> std::string {
        if (key.empty()) return {};
        return ": " + (key == "conductivity_law" ? std::string("kozeny_carman")
                                                 : fix_words(mpm::water_members())(key));
    };
    refuse("water " + body.name, mpm::objection_to(plan, body.material, water, given), name);
}

void check_names(const Case& plan) {
    if (plan.bodies.empty()) throw std::invalid_argument("there is no body");
    for (const mpm::TractionPlan& traction : plan.tractions) {
        refuse("traction: ", mpm::objection_to(plan, traction), as_in_files);
        if (!traction.from_stage.empty()) plan.stage(traction.from_stage);
    }
    for (const mpm::BodyPlan& body : plan.bodies)
        if (body.water) check_water(plan, body);
    for (const mpm::BodyPlan& body : plan.bodies)
        if (const auto* rigid = std::get_if<mpm::RigidPlan>(&body.material))
            if (!rigid->from_stage.empty()) plan.stage(rigid->from_stage);
    for (std::size_t i = 0; i < plan.contacts.size(); ++i) {
        const mpm::ContactPlan& contact = plan.contacts[i];
        const std::string which = "contact " + contact.stiff + ' ' + contact.soft;
        refuse(which, mpm::objection_to_contact(plan, i, name_of_body), name_of_body);
        for (const std::string& body : {contact.stiff, contact.soft}) {
            const auto& water = plan.bodies[plan.body(body)].water;
            if (water && water->implicit && contact.at_surfaces)
                throw std::invalid_argument(which + ": implicit pore pressure, in \"" + body +
                                            "\", knows no surface contact across processes");
        }
    }
    plan.body(plan.history.body);
}

}  // namespace

FixCase read_fix(const std::vector<std::string>& given, const double (&box)[2][2]) {
    FixCase out;
    Words words(given);
    Case& plan = out.plan;
    plan.settings.axisymmetric = words.choice("the geometry", mpm::words::geometries) ==
                                 static_cast<int>(mpm::words::Geometry::axisymmetric);
    plan.r.from = box[0][0];
    plan.z.from = box[1][0];
    std::string matters = words.taken_since(0);
    while (!words.done()) {
        const std::size_t first = words.taken();
        const std::string keyword = words.word("a keyword");
        if (const auto reader = readers().find(keyword); reader != readers().end())
            reader->second(words, out);
        else if (!read_numerics(keyword, words, plan))
            throw std::invalid_argument("unknown keyword \"" + keyword + '"');
        if (keyword != "points" && keyword != "threads") matters += words.taken_since(first);
    }
    out.fingerprint = mpm::checksum(matters.data(), matters.size());
    check_grid(plan.r, box[0][1], "r");
    check_grid(plan.z, box[1][1], "z");
    if (plan.history.body.empty() && !plan.bodies.empty()) plan.history.body = plan.bodies[0].name;
    if (plan.stages.empty()) plan.stages.emplace_back().name = "run";
    for (mpm::StagePlan& stage : plan.stages) stage = plan.plain_stage(stage.name);
    check_names(plan);
    return out;
}

mpm::StagePlan read_stage(const std::vector<std::string>& given, const mpm::StagePlan& before,
                          const Case& plan) {
    Words words(given);
    mpm::StagePlan out = before;
    out.end = {};
    while (!words.done()) {
        const std::string key = words.word("a keyword");
        if (const auto* member = member_called(mpm::stage_members(), key))
            words.read(key, *member, out);
        else if (const auto* end = member_called(mpm::end_members(), key))
            words.read(key, *end, out.end);
        else throw std::invalid_argument("unknown keyword \"" + key + "\" of a stage");
    }
    const KeyName name = fix_words(mpm::end_members());
    refuse("", mpm::objection_to(plan, out.end, name), name);
    return out;
}

}  // namespace grit::lammps
