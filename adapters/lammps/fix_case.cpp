// SPDX-License-Identifier: GPL-2.0-only
#include "adapters/lammps/fix_case.hpp"

#include <cmath>
#include <functional>
#include <memory>
#include <set>
#include <span>
#include <stdexcept>
#include <utility>

#include "adapters/lammps/read_body.hpp"
#include "adapters/lammps/read_function.hpp"
#include "adapters/lammps/words.hpp"
#include "adapters/mpm/case/case_words.hpp"
#include "adapters/mpm/case/closed_surface.hpp"
#include "adapters/mpm/io/checksum.hpp"
#include "adapters/mpm/space/step/settings.hpp"
#include "adapters/mpm/step/contact_pair.hpp"
#include "adapters/mpm/step/text.hpp"

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

std::string called(const mpm::ContactPlan& contact) {
    return "contact " + contact.stiff + ' ' + contact.soft;
}

std::string name_of_body(std::string_view key) {
    if (key.empty()) return {};
    if (key == "stiff") return "the stiffer one";
    return key == "soft" ? ": the softer body" : ": " + std::string(key);
}

constexpr mpm::Spelling axes[] = {mpm::spelling("r", 0, ""), mpm::spelling("z", 1, "")};
constexpr mpm::Spelling axes_in_space[] = {mpm::spelling("x", 0, ""), mpm::spelling("y", 1, ""),
                                           mpm::spelling("z", 2, "")};

mpm::Spellings axes_of(const Case& plan) {
    return plan.space ? mpm::Spellings(axes_in_space) : mpm::Spellings(axes);
}

mpm::AxisPlan& axis_of(Case& plan, int direction) {
    if (plan.space) return plan.space->axis[direction];
    return direction == 0 ? plan.r : plan.z;
}

void refuse_in_space(const Case& plan, const char* what) {
    if (plan.space) throw std::invalid_argument(std::string(what) + " is not there in space");
}

void read_segment(Words& words, Case& plan) {
    mpm::AxisPlan& axis =
        axis_of(plan, words.choice("the direction of a grid segment", axes_of(plan)));
    mpm::AxisSegment segment{};
    segment.to = words.number("the end of a grid segment");
    segment.cells = words.integer("the number of its cells", case_word("grid.r", "cells").range);
    segment.growth = words.number("their growth", case_word("grid.r", "growth"));
    const double before = axis.segments.empty() ? axis.from : axis.to();
    if (!(segment.to > before))
        throw std::invalid_argument("the segments of a grid must ascend, got " +
                                    mpm::exact_text(segment.to) + " m behind " +
                                    mpm::exact_text(before) + " m");
    axis.segments.push_back(segment);
}

void read_boundary(Words& words, Case& plan) {
    if (plan.space) {
        const int of_six = words.choice("a side of the grid", mpm::words::sides_in_space);
        plan.space->boundary[of_six] = static_cast<mpm::Boundary>(
            words.choice("the boundary of a side", mpm::words::boundaries));
        return;
    }
    const int side = words.choice("a side of the grid", mpm::words::sides);
    plan.boundary[side] =
        static_cast<mpm::Boundary>(words.choice("the boundary of a side", mpm::words::boundaries));
    refuse("boundary ", mpm::objection_to(plan, static_cast<mpm::Side>(side)), as_in_files);
}

void read_traction(Words& words, FixCase& out) {
    mpm::TractionPlan traction;
    traction.body = words.word("the body of a traction");
    out.traction_groups.push_back(words.word("the group of a traction"));
    const bool in_space = out.plan.space.has_value();
    const int edge =
        words.choice("the edge of a traction", in_space ? mpm::Spellings(mpm::words::sides_in_space)
                                                        : mpm::Spellings(mpm::words::edges));
    double direction[3] = {};
    bool is_none = true;
    for (int k = 0; k < out.dimensions(); ++k) {
        direction[k] =
            words.number("the direction of a traction along " +
                         std::string(axes_of(out.plan)[static_cast<std::size_t>(k)].word));
        is_none = is_none && direction[k] == 0.0;
    }
    if (is_none) throw std::invalid_argument("the direction of a traction must not be 0");
    if (in_space) {
        mpm::FacePlan face;
        face.across = edge / 2;
        face.upper = edge % 2 == 1;
        face.direction = {direction[0], direction[1], direction[2]};
        out.plan.space->faces.push_back(face);
    } else {
        traction.edge = static_cast<mpm::Edge>(edge);
        traction.direction = {direction[0], direction[1]};
    }
    Function function = read_function(words, "the stress of a traction");
    traction.stress = std::move(function.time);
    out.traction_variables.push_back(std::move(function.variable));
    traction.on_mixture = words.take("mixture");
    if (words.take("from")) traction.from_stage = words.word("the stage of a traction");
    out.plan.tractions.push_back(std::move(traction));
}

// The surface of the stiffer body, where that is told. False: the next word is another one.
bool read_stiff(Words& words, const Case& plan, mpm::ContactPlan& contact, std::string& file) {
    const bool is_line = words.peek() == "stiff_line";
    if (!is_line && words.peek() != "stiff_surface") return false;
    const std::string key = words.word("a surface");
    if (is_line) refuse_in_space(plan, key.c_str());
    else if (!plan.space) throw std::invalid_argument(key + " is there in space alone");
    if (!contact.at_surfaces)
        throw std::invalid_argument(
            key + " belongs to the law surface, not to " +
            std::string(word_of(mpm::words::contact_laws, mpm::words::law_of(contact))));
    if (!is_line) {
        file = words.word("the file of " + key);
        return true;
    }
    std::vector<Vector2> points;
    for (int n = words.integer("the number of points of " + key, mpm::words::many); n > 0; --n) {
        const double r = words.number("r of " + key);
        points.push_back({r, words.number("z of " + key)});
    }
    contact.surface_line = mpm::line_through(std::move(points));
    return true;
}

void read_contact(Words& words, FixCase& out) {
    Case& plan = out.plan;
    mpm::ContactPlan contact;
    contact.stiff = words.word("the stiffer body of a contact");
    contact.soft = words.word("the softer body of a contact");
    mpm::words::set_law(contact, words.choice("the law of a contact", mpm::words::contact_laws));
    contact.friction_coefficient =
        words.number("a friction coefficient", case_word("contact", "friction_coefficient"));
    std::set<std::string> given;
    std::string file;
    for (;;) {
        if (read_stiff(words, plan, contact, file)) continue;
        const auto* member = member_called(mpm::contact_members(), words.peek());
        if (!member) break;
        words.read(*given.insert(words.word("a keyword")).first, *member, contact);
    }
    if (contact.after_damping) refuse_in_space(plan, "contact after damping");
    const KeyName name = fix_words(mpm::contact_members());
    refuse(
        "",
        mpm::objection_to(contact, [&](std::string_view key) { return given.contains(name(key)); }),
        name);
    plan.contacts.push_back(contact);
    out.surfaces.push_back(file);
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
             refuse_in_space(c.plan, "a drained side");
             c.plan.drained[w.choice("a drained side of the grid", mpm::words::sides)] = true;
         }},
        {"motion", read_motion},
        {"points", read_points},
        {"traction", read_traction},
        {"contact", read_contact},
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

void check_grid(const mpm::AxisPlan& axis, double end, std::string_view name) {
    const std::string grid = "grid " + std::string(name);
    if (axis.segments.empty()) throw std::invalid_argument(grid + " is missing");
    if (axis.to() != end)
        throw std::invalid_argument(grid + " ends at " + mpm::exact_text(axis.to()) +
                                    " m, the box at " + mpm::exact_text(end) + " m");
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
        const std::string which = called(contact);
        refuse(which, mpm::objection_to_contact(plan, i, name_of_body), name_of_body);
        if (!contact.surface_line.points.empty())
            refuse(which + ": stiff_line", mpm::objection_to(plan, contact.surface_line), no_name);
        for (const std::string& body : {contact.stiff, contact.soft}) {
            const auto& water = plan.bodies[plan.body(body)].water;
            if (water && water->implicit && contact.at_surfaces)
                throw std::invalid_argument(which + ": implicit pore pressure, in \"" + body +
                                            "\", knows no surface contact across processes");
        }
    }
    plan.body(plan.history.body);
}

// Names of files do not matter, what is in them does.
std::string without_file(std::string words, const std::string& keyword, const FixCase& plan) {
    if (keyword != "contact" || plan.surfaces.back().empty()) return words;
    const std::string name = "\n" + plan.surfaces.back() + "\n";
    return words.replace(words.rfind(name), name.size(), "\n");
}

}  // namespace

bool is_in_space(const std::string& geometry) {
    return geometry == mpm::word_of(mpm::words::geometries, mpm::words::Geometry::space);
}

FixCase read_fix(const std::vector<std::string>& given, const Box& box) {
    FixCase out;
    Words words(given);
    Case& plan = out.plan;
    if (is_in_space(words.peek())) plan.space.emplace();
    plan.settings.axisymmetric = words.choice("the geometry", mpm::words::geometries) ==
                                 static_cast<int>(mpm::words::Geometry::axisymmetric);
    for (int d = 0; d < out.dimensions(); ++d)
        axis_of(plan, d).from = box[static_cast<std::size_t>(d)][0];
    std::string matters = words.taken_since(0);
    for (int d = 0; d < out.dimensions(); ++d)
        matters += mpm::exact_text(axis_of(plan, d).from) + '\n';
    while (!words.done()) {
        const std::size_t first = words.taken();
        const std::string keyword = words.word("a keyword");
        if (const auto reader = readers().find(keyword); reader != readers().end())
            reader->second(words, out);
        else if (!read_numerics(keyword, words, plan))
            throw std::invalid_argument("unknown keyword \"" + keyword + '"');
        if (keyword != "points" && keyword != "threads")
            matters += without_file(words.taken_since(first), keyword, out);
    }
    out.fingerprint = mpm::checksum(matters.data(), matters.size());
    for (const mpm::Spelling& axis : axes_of(plan))
        check_grid(axis_of(plan, axis.value), box[static_cast<std::size_t>(axis.value)][1],
                   axis.word);
    if (plan.space) mpm::space::check_there(plan.settings);
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

void read_surfaces(FixCase& plan, const std::function<std::string(const std::string&)>& bytes_of) {
    for (std::size_t i = 0; i < plan.surfaces.size(); ++i) {
        const std::string& file = plan.surfaces[i];
        if (file.empty()) continue;
        const std::string bytes = bytes_of(file);
        plan.plan.contacts[i].surface_mesh =
            std::make_shared<mpm::ClosedSurface>(mpm::surface_of_stl(bytes, file, 1.0, {}));
        refuse(called(plan.plan.contacts[i]), mpm::objection_to_contact(plan.plan, i, name_of_body),
               name_of_body);
        plan.fingerprint ^= (i + 1) * mpm::checksum(bytes.data(), bytes.size());
    }
}

}  // namespace grit::lammps
