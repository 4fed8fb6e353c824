// SPDX-License-Identifier: GPL-2.0-only
#include "adapters/lammps/fix_case.hpp"

#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>
#include <utility>

#include "adapters/lammps/read_body.hpp"
#include "adapters/lammps/read_function.hpp"
#include "adapters/lammps/words.hpp"
#include "adapters/mpm/io/checksum.hpp"
#include "adapters/mpm/step/contact_pair.hpp"

namespace grit::lammps {
namespace {

using mpm::Case;

void read_segment(Words& words, Case& plan) {
    const int direction = words.choice("the direction of a grid segment", {"r", "z"});
    mpm::AxisPlan& axis = direction == 0 ? plan.r : plan.z;
    mpm::AxisSegment segment{};
    segment.to = words.number("the end of a grid segment");
    segment.cells = words.integer("the number of its cells", mpm::limits::cells);
    segment.growth = words.number("their growth", mpm::limits::growth);
    const double before = axis.segments.empty() ? axis.from : axis.to();
    if (!(segment.to > before)) throw std::invalid_argument("the segments of a grid must ascend");
    axis.segments.push_back(segment);
}

void read_boundary(Words& words, Case& plan) {
    const int side = words.choice("a side of the grid", {"left", "right", "bottom", "top"});
    constexpr mpm::Boundary kinds[] = {mpm::Boundary::free, mpm::Boundary::roller,
                                       mpm::Boundary::fixed};
    plan.boundary[side] =
        kinds[words.choice("the boundary of a side", {"free", "roller", "fixed"})];
}

void read_traction(Words& words, FixCase& out) {
    mpm::TractionPlan traction;
    traction.body = words.word("the body of a traction");
    out.traction_groups.push_back(words.word("the group of a traction"));
    constexpr mpm::Edge edges[] = {mpm::Edge::bottom, mpm::Edge::right, mpm::Edge::top,
                                   mpm::Edge::left};
    traction.edge =
        edges[words.choice("the edge of a traction", {"bottom", "right", "top", "left"})];
    traction.direction.r = words.number("the direction of a traction along r");
    traction.direction.z = words.number("... and along z");
    if (traction.direction.r == 0.0 && traction.direction.z == 0.0)
        throw std::invalid_argument("the direction of a traction must not be 0");
    Function function = read_function(words, "the stress of a traction");
    traction.stress = std::move(function.time);
    out.traction_variables.push_back(std::move(function.variable));
    if (words.take("from")) traction.from_stage = words.word("the stage of a traction");
    out.plan.tractions.push_back(std::move(traction));
}

void read_contact(Words& words, Case& plan) {
    mpm::ContactPlan contact;
    contact.stiff = words.word("the stiffer body of a contact");
    contact.soft = words.word("the softer body of a contact");
    contact.law = words.choice("the law of a contact", {"geo", "frictional"}) == 0
                      ? GRIT_CONTACT_GEO
                      : GRIT_CONTACT_FRICTIONAL;
    contact.friction_coefficient =
        words.number("a friction coefficient", mpm::limits::friction_coefficient);
    contact.normal = GRIT_CONTACT_NORMAL_OF_A;
    contact.measure = GRIT_CONTACT_SUPPORT;
    constexpr int normals[] = {GRIT_CONTACT_NORMAL_OF_A, GRIT_CONTACT_NORMAL_OF_B,
                               GRIT_CONTACT_NORMAL_AVERAGE};
    constexpr int measures[] = {GRIT_CONTACT_SUPPORT, GRIT_CONTACT_EDGE,
                                GRIT_CONTACT_NEAREST_CENTRE};
    const bool frictional = contact.law == GRIT_CONTACT_FRICTIONAL;
    bool has_power = false, has_distance = false;
    for (;;) {
        if (words.take("power")) {
            has_power = true;
            contact.penalty_power = words.number("the penalty power", mpm::limits::penalty_power);
        } else if (words.take("normal")) {
            contact.normal = normals[words.choice("the normal", {"stiff", "soft", "average"})];
        } else if (words.take("distance")) {
            has_distance = true;
            contact.measure =
                measures[words.choice("the distance", {"support", "edge", "nearest_centre"})];
        } else if (words.take("gated")) {
            contact.gated = words.yes_or_no("gated");
        } else {
            break;
        }
    }
    if (frictional && has_power)
        throw std::invalid_argument("power belongs to the geo law, not to the frictional one");
    if (frictional && has_distance && !contact.gated)
        throw std::invalid_argument(
            "distance: the frictional law measures none unless it is gated");
    plan.contacts.push_back(contact);
}

void add_stage(const std::string& name, Case& plan) {
    for (const mpm::StagePlan& other : plan.stages)
        if (other.name == name)
            throw std::invalid_argument("two stages are called \"" + name + '"');
    plan.stages.emplace_back().name = name;
}

mpm::StagePlan first_stage(const Case& plan, const std::string& name) {
    mpm::StagePlan out;
    out.name = name;
    out.local_damping = plan.settings.local_damping;
    out.pic_rate = plan.settings.pic_rate;
    out.cfl = plan.settings.cfl;
    return out;
}

using Reader = std::function<void(Words&, FixCase&)>;

const std::map<std::string, Reader>& readers() {
    static const std::map<std::string, Reader> all{
        {"grid", [](Words& w, FixCase& c) { read_segment(w, c.plan); }},
        {"boundary", [](Words& w, FixCase& c) { read_boundary(w, c.plan); }},
        {"body", read_body},
        {"motion", read_motion},
        {"points", read_points},
        {"traction", read_traction},
        {"contact", [](Words& w, FixCase& c) { read_contact(w, c.plan); }},
        {"stages",
         [](Words& w, FixCase& c) {
             for (int n = w.integer("the number of stages", {1, 1000000}); n > 0; --n)
                 add_stage(w.word("the name of a stage"), c.plan);
         }},
        {"driven",
         [](Words& w, FixCase& c) {
             c.plan.history.body = w.word("the driven body");
             c.plan.history.depth_of =
                 w.choice("its depth", {"lowest_point", "centre_of_mass"}) == 0
                     ? mpm::DepthOf::lowest_point
                     : mpm::DepthOf::centre_of_mass;
         }},
        {"shape_function",
         [](Words& w, FixCase& c) {
             constexpr mpm::Shape shapes[] = {mpm::Shape::cpdi, mpm::Shape::cpdi_published,
                                              mpm::Shape::ugimp, mpm::Shape::point};
             c.plan.settings.shape = shapes[w.choice(
                 "the shape function", {"cpdi", "cpdi_published", "ugimp", "linear"})];
         }},
        {"scheme",
         [](Words& w, FixCase& c) {
             constexpr mpm::Scheme schemes[] = {mpm::Scheme::usl, mpm::Scheme::musl,
                                                mpm::Scheme::usf};
             c.plan.settings.scheme = schemes[w.choice("the scheme", {"usl", "musl", "usf"})];
         }},
        {"gravity",
         [](Words& w, FixCase& c) { c.plan.gravity = w.number("gravity", mpm::limits::gravity); }},
        {"cfl",
         [](Words& w, FixCase& c) { c.plan.settings.cfl = w.number("cfl", mpm::limits::cfl); }},
        {"largest_step",
         [](Words& w, FixCase& c) { c.plan.settings.largest_step = w.positive("largest_step"); }},
        {"pic_rate",
         [](Words& w, FixCase& c) {
             c.plan.settings.pic_rate = w.number("pic_rate", mpm::limits::pic_rate);
         }},
        {"local_damping",
         [](Words& w, FixCase& c) {
             c.plan.settings.local_damping = w.number("local_damping", mpm::limits::local_damping);
         }},
        {"bulk_viscosity",
         [](Words& w, FixCase& c) {
             c.plan.settings.linear_viscosity =
                 w.number("the linear bulk viscosity", mpm::limits::bulk_viscosity);
             c.plan.settings.quadratic_viscosity =
                 w.number("the quadratic bulk viscosity", mpm::limits::bulk_viscosity);
         }},
        {"cell_mean",
         [](Words& w, FixCase& c) { c.plan.settings.cell_mean = w.yes_or_no("cell_mean"); }},
        {"fixed_point",
         [](Words& w, FixCase& c) { c.plan.settings.fixed_point = w.yes_or_no("fixed_point"); }},
        {"threads",
         [](Words& w, FixCase& c) {
             c.plan.settings.threads = w.integer("threads", mpm::limits::threads);
         }},
        {"energy_residual_limit",
         [](Words& w, FixCase& c) {
             c.plan.residual_limit =
                 w.number("energy_residual_limit", mpm::limits::energy_residual_limit);
         }},
    };
    return all;
}

void check_grid(const mpm::AxisPlan& axis, double end, const char* name) {
    if (axis.segments.empty())
        throw std::invalid_argument(std::string("grid ") + name + " is missing");
    if (axis.to() != end)
        throw std::invalid_argument(std::string("grid ") + name + " ends at " +
                                    std::to_string(axis.to()) + " m, the box at " +
                                    std::to_string(end) + " m");
}

void check_names(const Case& plan) {
    if (plan.bodies.empty()) throw std::invalid_argument("there is no body");
    for (const mpm::TractionPlan& traction : plan.tractions) {
        if (plan.bodies[plan.body(traction.body)].rigid())
            throw std::invalid_argument("a traction on body " + traction.body +
                                        ": it is rigid, no load moves it");
        if (!traction.from_stage.empty()) plan.stage(traction.from_stage);
    }
    for (const mpm::BodyPlan& body : plan.bodies)
        if (const auto* rigid = std::get_if<mpm::RigidPlan>(&body.material))
            if (!rigid->from_stage.empty()) plan.stage(rigid->from_stage);
    if (plan.settings.axisymmetric && plan.r.from == 0.0 &&
        plan.boundary[static_cast<int>(mpm::Side::left)] == mpm::Boundary::fixed)
        throw std::invalid_argument("boundary left is the axis r = 0: roller");
    std::set<std::set<std::string>> pairs;
    for (const mpm::ContactPlan& contact : plan.contacts) {
        if (!pairs.insert({contact.stiff, contact.soft}).second)
            throw std::invalid_argument(contact.stiff + " and " + contact.soft +
                                        " have a contact already");
        const std::size_t stiff = plan.body(contact.stiff), soft = plan.body(contact.soft);
        if (stiff == soft)
            throw std::invalid_argument("a contact of body " + contact.stiff + " with itself");
        if (plan.bodies[stiff].rigid() && plan.bodies[soft].rigid())
            throw std::invalid_argument("a contact of " + contact.stiff + " with " + contact.soft +
                                        ": both bodies are rigid");
    }
    plan.body(plan.history.body);
}

}  // namespace

FixCase read_fix(const std::vector<std::string>& given, const double (&box)[2][2]) {
    FixCase out;
    Words words(given);
    Case& plan = out.plan;
    plan.settings.axisymmetric =
        words.choice("the geometry", {"axisymmetric", "plane_strain"}) == 0;
    plan.r.from = box[0][0];
    plan.z.from = box[1][0];
    std::string matters = words.taken_since(0);
    while (!words.done()) {
        const std::size_t first = words.taken();
        const std::string keyword = words.word("a keyword");
        const auto reader = readers().find(keyword);
        if (reader == readers().end())
            throw std::invalid_argument("unknown keyword \"" + keyword + '"');
        reader->second(words, out);
        if (keyword != "points" && keyword != "threads") matters += words.taken_since(first);
    }
    out.fingerprint = mpm::checksum(matters.data(), matters.size());
    check_grid(plan.r, box[0][1], "r");
    check_grid(plan.z, box[1][1], "z");
    if (plan.history.body.empty() && !plan.bodies.empty()) plan.history.body = plan.bodies[0].name;
    if (plan.stages.empty()) plan.stages.emplace_back().name = "run";
    for (mpm::StagePlan& stage : plan.stages) stage = first_stage(plan, stage.name);
    check_names(plan);
    return out;
}

mpm::StagePlan read_stage(const std::vector<std::string>& given, const mpm::StagePlan& before,
                          mpm::Scheme scheme) {
    Words words(given);
    mpm::StagePlan out = before;
    out.end = {};
    while (!words.done()) {
        const std::string key = words.word("a keyword");
        if (key == "gravity") out.gravity = words.yes_or_no("gravity");
        else if (key == "local_damping")
            out.local_damping = words.number(key, mpm::limits::local_damping);
        else if (key == "pic_rate") out.pic_rate = words.number(key, mpm::limits::pic_rate);
        else if (key == "cfl") out.cfl = words.number(key, mpm::limits::cfl);
        else if (key == "until_time") out.end.time = words.positive(key);
        else if (key == "until_depth") out.end.depth = words.positive(key);
        else if (key == "until_blows") out.end.blows = words.integer(key, mpm::limits::blows);
        else if (key == "until_unbalanced")
            out.end.unbalanced_share = words.number(key, mpm::limits::share);
        else if (key == "until_kinetic")
            out.end.kinetic_share = words.number(key, mpm::limits::share);
        else throw std::invalid_argument("unknown keyword \"" + key + "\" of a stage");
    }
    if (out.end.kinetic_share > 0.0 && out.end.unbalanced_share == 0.0)
        throw std::invalid_argument("until_kinetic needs until_unbalanced: a body that turns back "
                                    "has no kinetic energy either");
    if (out.end.unbalanced_share > 0.0 && scheme == mpm::Scheme::musl)
        throw std::invalid_argument("until_unbalanced is not measured with the scheme musl");
    return out;
}

}  // namespace grit::lammps
