// SPDX-License-Identifier: GPL-2.0-only
#include "adapters/lammps/read_body.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <grit/sand_catalogue.h>

#include "adapters/lammps/read_function.hpp"

namespace grit::lammps {
namespace {

using mpm::case_word;
using mpm::spelling;

constexpr mpm::Spelling member_kinds[] = {spelling("type", 0, ""), spelling("group", 1, "")};
constexpr mpm::Spelling materials[] = {spelling("rigid", 0, ""), spelling("elastic", 1, ""),
                                       spelling("neo_hooke", 2, ""), spelling("sand", 3, "")};

mpm::ElasticPlan read_elastic(Words& words, bool neo_hooke) {
    mpm::ElasticPlan out{};
    out.neo_hooke = neo_hooke;
    out.youngs_modulus =
        words.number("Young's modulus", case_word("body.elastic", "youngs_modulus_kPa"));
    out.poissons_ratio =
        words.number("Poisson's ratio", case_word("body.elastic", "poissons_ratio"));
    return out;
}

int parameter_called(const std::string& name) {
    for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i)
        if (name == grit_sand_parameter_describe(i)->name) return i;
    return -1;
}

mpm::SandPlan read_sand(Words& words) {
    mpm::SandPlan out{};
    grit_sand_parameters_init(&out.parameters, sizeof out.parameters);
    grit_sand_options_init(&out.options, sizeof out.options);
    out.options.tolerance = case_word("body.sand", "tolerance").otherwise_number();
    const std::string name = words.word("the name of a sand");
    if (name != "custom") {
        const int record = grit_sand_record_find(name.c_str());
        if (record < 0) throw std::invalid_argument("no sand is called \"" + name + '"');
        grit_sand_record_parameters(record, 1000.0, &out.parameters);
    }
    for (;;) {
        const int index = parameter_called(words.peek());
        if (index >= 0) {
            const std::string parameter = words.word("a parameter");
            grit_sand_parameter_set(&out.parameters, index, words.number(parameter));
        } else if (words.take("tolerance")) {
            out.options.tolerance = words.number("tolerance", case_word("body.sand", "tolerance"));
        } else if (words.take("evaluation_limit")) {
            out.options.evaluation_limit =
                words.integer("evaluation_limit", {GRIT_SAND_LEAST_EVALUATION_LIMIT,
                                                   GRIT_SAND_LARGEST_EVALUATION_LIMIT});
        } else if (words.take("intergranular")) {
            out.options.intergranular_off = words.choice("intergranular", mpm::words::on_off);
        } else {
            break;
        }
    }
    grit_sand sand;
    grit_error error{};
    if (grit_sand_prepare(&out.parameters, &sand, &error) != GRIT_OK)
        throw std::invalid_argument(std::string("sand ") + name + ": " + error.message);
    return out;
}

Vector3 read_vector(Words& words, const std::string& what) {
    Vector3 out;
    for (int k = 0; k < 3; ++k) out[k] = words.number(what);
    return out;
}

}  // namespace

void read_body(Words& words, FixCase& out) {
    mpm::BodyPlan body{};
    body.name = words.word("the name of a body");
    refuse("the name of a body", mpm::objection_to_name_of_body(out.plan, body.name), no_name);
    Members members;
    if (words.choice("what a body is made of", member_kinds) == 0)
        members.type = words.integer("an atom type", mpm::words::many);
    else members.group = words.word("the group of a body");
    switch (words.choice("the material of a body", materials)) {
        case 0: body.material = mpm::RigidPlan{{{0.0}, {0.0}}, {{0.0}, {0.0}}}; break;
        case 1: body.material = read_elastic(words, false); break;
        case 2: body.material = read_elastic(words, true); break;
        default: body.material = read_sand(words);
    }
    out.plan.bodies.push_back(std::move(body));
    if (out.plan.space) out.plan.space->bodies.emplace_back();
    out.members.push_back(members);
    out.points.emplace_back();
    out.motion.emplace_back();
}

void read_motion(Words& words, FixCase& out) {
    const std::size_t body = out.plan.body(words.word("the body of a motion"));
    auto* rigid = std::get_if<mpm::RigidPlan>(&out.plan.bodies[body].material);
    if (!rigid)
        throw std::invalid_argument("body " + out.plan.bodies[body].name +
                                    " is not rigid: nothing prescribes its motion");
    const auto component = [&words](const char* what, mpm::TimeTable& table,
                                    std::string& variable) {
        Function function = read_function(words, what);
        variable = std::move(function.variable);
        auto* given = std::get_if<mpm::TimeTable>(&function.time);
        if (!given) throw std::invalid_argument(std::string(what) + " cannot be pulses");
        table = std::move(*given);
    };
    MotionVariables& variables = out.motion[body];
    const bool in_space = out.plan.space.has_value();
    component(in_space ? "the velocity along x" : "the velocity along r", rigid->velocity_r,
              variables.along[0]);
    if (in_space) component("the velocity along y", rigid->velocity_y, variables.along[1]);
    component("the velocity along z", rigid->velocity_z, variables.along[2]);
    while (in_space) {
        if (words.take("spin")) {
            for (int k = 0; k < 3; ++k)
                component("an angular velocity", rigid->spin[k], variables.about[k]);
        } else if (words.take("centre")) {
            rigid->centre = read_vector(words, "the centre of a motion");
        } else if (words.take("free")) {
            for (int n = words.integer("how many motions are free", {1, 6}); n > 0; --n)
                rigid->free[static_cast<std::size_t>(
                    words.choice("a motion that is free", mpm::words::degrees_of_freedom))] = true;
        } else if (words.take("start")) {
            out.plan.space->bodies[body].velocity =
                read_vector(words, "the velocity that a free motion starts with");
        } else {
            break;
        }
    }
    for (std::size_t k = 0; k < 6; ++k)
        if (const std::string& name = k < 3 ? variables.along[k] : variables.about[k - 3];
            rigid->free[k] && !name.empty())
            throw std::invalid_argument(
                "motion " + out.plan.bodies[body].name + ": " +
                std::string(mpm::word_of(mpm::words::degrees_of_freedom, static_cast<int>(k))) +
                " is free, and v_" + name + " tells it");
    if (words.take("from")) rigid->from_stage = words.word("the stage of a motion");
}

void read_water(Words& words, FixCase& out) {
    mpm::BodyPlan& body = out.plan.bodies[out.plan.body(words.word("the body of water"))];
    if (body.water) throw std::invalid_argument("water " + body.name + ": it has water already");
    mpm::WaterPlan& water = body.water.emplace();
    water.drainage =
        static_cast<mpm::Drainage>(words.choice("the drainage of a body", mpm::words::drainages));
    for (;;) {
        const auto* member = member_called(mpm::water_members(), words.peek());
        if (member) {
            words.read(words.word("a keyword"), *member, water);
        } else if (words.take("table")) {
            water.table = words.number("the water table");
        } else if (words.take("kozeny_carman")) {
            water.kozeny_carman = true;
            water.conductivity_at =
                words.number("the void ratio of the conductivity", mpm::words::above_zero);
        } else {
            break;
        }
    }
}

void read_points(Words& words, FixCase& out) {
    const std::size_t body = out.plan.body(words.word("the body of points"));
    out.points[body] = words.word("the file of points");
}

}  // namespace grit::lammps
