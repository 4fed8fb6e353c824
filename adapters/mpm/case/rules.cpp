// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/case/rules.hpp"

#include <algorithm>

#include "adapters/mpm/case/case_words.hpp"
#include "adapters/mpm/case/spellings.hpp"
#include "adapters/mpm/step/text.hpp"

namespace grit::mpm {
namespace {

// Letters of ASCII: names are the same everywhere.
bool may_be_in_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
}

template <class Plans>
Objections objection_to_another(const Plans& plans, const std::string& name, const char* kind) {
    if (auto objection = objection_to_name(name)) return objection;
    for (const auto& other : plans)
        if (other.name == name)
            return Objection{"name",
                             std::string(": there is a ") + kind + " \"" + name + "\" already"};
    return {};
}

bool is_implicit(const BodyPlan& body) { return body.water && body.water->implicit; }

}  // namespace

Objections objection_to_name(const std::string& name) {
    if (name.empty()) return Objection{"name", " is empty"};
    if (!std::all_of(name.begin(), name.end(), may_be_in_name))
        return Objection{"name", " may have letters, digits, _ and - only, got \"" + name + '"'};
    return {};
}

Objections objection_to_name_of_body(const Case& plan, const std::string& name) {
    return objection_to_another(plan.bodies, name, "body");
}

Objections objection_to_name_of_stage(const Case& plan, const std::string& name) {
    return objection_to_another(plan.stages, name, "stage");
}

Objections objection_to(const Case& plan, Side side) {
    if (side == Side::left && plan.settings.axisymmetric && plan.r.from == 0.0 &&
        plan.boundary[static_cast<int>(side)] != Boundary::roller)
        return Objection{"left", " is the axis r = 0: roller"};
    const std::string_view key = word_of(words::sides, side);
    if (plan.boundary[static_cast<int>(side)] != Boundary::platen) return {};
    if (plan.settings.axisymmetric && (side == Side::left || side == Side::right))
        return Objection{key, ": a platen around an axis does not move as one"};
    if (plan.settings.scheme != Scheme::usl)
        return Objection{key, ": a platen needs the scheme usl"};
    const bool along_z = side == Side::bottom || side == Side::top;
    for (const Side beside :
         {along_z ? Side::left : Side::bottom, along_z ? Side::right : Side::top})
        if (plan.boundary[static_cast<int>(beside)] == Boundary::fixed)
            return Objection{key, " is a platen, which the fixed " +
                                      std::string(word_of(words::sides, beside)) +
                                      " side would hold at its end: roller"};
    if (plan.drained[static_cast<int>(side)])
        return Objection{key, " is a platen, which no water passes, and drained"};
    return {};
}

Objections objection_to(const TimeTable& table) {
    for (std::size_t i = 1; i < table.time.size(); ++i)
        if (!(table.time[i] > table.time[i - 1]))
            return Objection{"time_s", " must ascend: " + text(table.time[i]) + " after " +
                                           text(table.time[i - 1])};
    return {};
}

Objections objection_to(const PulseTrain& pulses, const KeyName& name) {
    const auto beside = [&](const std::string& must, std::string_view key) {
        return must + name(key) + ", " + text(pulses.duration) + ", got ";
    };
    if (pulses.form == PulseForm::half_sine && pulses.peak_time != 0.5 * pulses.duration)
        return Objection{"peak_time_s", ": a half sine has its peak at " +
                                            text(0.5 * pulses.duration) + " s, got " +
                                            text(pulses.peak_time)};
    if (!(pulses.peak_time < pulses.duration))
        return Objection{"peak_time_s",
                         beside(" must be below ", "duration_s") + text(pulses.peak_time)};
    if (!(pulses.interval >= pulses.duration))
        return Objection{"interval_s",
                         beside(" must be no shorter than ", "duration_s") + text(pulses.interval)};
    return {};
}

Objections objection_to(const Case& plan, const TractionPlan& traction) {
    if (plan.bodies[plan.body(traction.body)].prescribed())
        return Objection{"body", ": \"" + traction.body + "\" is rigid, no load moves it"};
    if (traction.on_mixture && !plan.bodies[plan.body(traction.body)].water)
        return Objection{"acts_on", ": \"" + traction.body + "\" has no pore water"};
    return {};
}

Objections objection_to(const Case& plan, const InflowPlan& inflow) {
    const std::string side(word_of(words::sides, inflow.side));
    const auto i = static_cast<std::size_t>(inflow.side);
    if (plan.boundary[i] != Boundary::roller && plan.boundary[i] != Boundary::fixed)
        return Objection{"side", ": the " + side + " one is neither a roller nor fixed"};
    if (plan.drained[i]) return Objection{"side", ": the " + side + " one is drained"};
    if (inflow.side == Side::left && plan.settings.axisymmetric && plan.r.from == 0.0)
        return Objection{"side", ": the left one is the axis r = 0"};
    for (const BodyPlan& body : plan.bodies)
        if (body.water && body.water->drainage == Drainage::flow) return {};
    return Objection{"", ": no body has water that flows"};
}

Objections objection_to(const Case& plan, const BoundaryLine& line) {
    const std::size_t n = line.points.size(), segments = line.closed ? n : n - 1;
    const auto at = [](const Vector2& x) { return " at " + place_text(x[0], x[1]); };
    for (const Vector2& x : line.points)
        if (!(x[0] >= plan.r.from && x[0] <= plan.r.to() && x[1] >= plan.z.from &&
              x[1] <= plan.z.to()))
            return Objection{"", " leaves the grid" + at(x)};
    if (n < 2) return Objection{"", " needs two points at least, got " + std::to_string(n)};
    const auto length = [&](std::size_t i) {
        return norm(line.points[(i + 1) % n] - line.points[i]);
    };
    double whole = 0.0;
    for (std::size_t i = 0; i < segments; ++i) whole += length(i);
    for (std::size_t i = 0; i < segments; ++i)
        if (!(length(i) > 1e-9 * whole))
            return Objection{"", " has no length from point " + std::to_string(i + 1) +
                                     " to the next," + at(line.points[i])};
    return {};
}

Objections objection_to(const Case& plan, const MaterialPlan& material, const WaterPlan& water,
                        const IsGiven& given) {
    if (std::holds_alternative<RigidPlan>(material))
        return Objection{"", ": a rigid body has no pores"};
    if (plan.settings.scheme != Scheme::usl)
        return Objection{"", ": pore water needs the scheme usl"};
    if (plan.space && water.drainage == Drainage::flow)
        return Objection{"drainage", ": water that flows is not there in space"};
    if (plan.space && water.implicit)
        return Objection{"pressure", ": an implicit one is not there in space"};
    const bool is_sand = std::holds_alternative<SandPlan>(material);
    if (is_sand && given("porosity"))
        return Objection{"porosity", ": sand has a void ratio instead"};
    if (!is_sand && !given("porosity")) return Objection{"porosity", " is missing"};
    const bool absorbs = plan.has_side(Boundary::absorbing);
    // The body itself is not among them yet: processes that share a grid know no platens.
    if (water.implicit && plan.has_side(Boundary::platen) &&
        std::any_of(plan.bodies.begin(), plan.bodies.end(), is_implicit))
        return Objection{"pressure", ": beside a platen one body alone may have an implicit one"};
    if (water.implicit && absorbs)
        return Objection{"pressure", ": absorbing sides know no implicit one yet"};
    if (water.drainage == Drainage::undrained) {
        for (const char* key : {"conductivity_m_per_s", "conductivity_law"})
            if (given(key)) return Objection{key, " belongs to drainage = \"flow\""};
        return {};
    }
    if (!given("conductivity_m_per_s")) return Objection{"conductivity_m_per_s", " is missing"};
    if (absorbs) return Objection{"drainage", ": absorbing sides know no water that flows yet"};
    return {};
}

Objections objection_to_water_table(const BodyPlan& body, double reached) {
    if (!body.water || body.water->drainage != Drainage::flow || !body.water->table) return {};
    const double table = *body.water->table;
    if (!(reached > table + 1e-9 * (1.0 + std::abs(table)))) return {};
    return Objection{"water_table_m",
                     " must not lie below the body where water flows, as its surfaces stand in "
                     "water: got " +
                         text(table) + ", the body reaches " + text(reached)};
}

Objections objection_to_contact(const Case& plan, std::size_t contact, const KeyName& name) {
    const ContactPlan& c = plan.contacts[contact];
    if (c.stiff == c.soft) return Objection{"soft", " must be another body than " + name("stiff")};
    if (plan.bodies[plan.body(c.stiff)].rigid() && plan.bodies[plan.body(c.soft)].rigid())
        return Objection{"soft", ": both bodies are rigid"};
    if (c.surface_mesh && plan.bodies[plan.body(c.stiff)].water)
        return Objection{"stiff_surface", ": \"" + c.stiff + "\" has pore water"};
    for (const std::string& name_of : {c.stiff, c.soft}) {
        const BodyPlan& body = plan.bodies[plan.body(name_of)];
        if (c.at_surfaces && body.rigid() && !body.prescribed())
            return Objection{"law", ": the rigid body \"" + name_of +
                                        "\", which moves freely, knows contacts at nodes alone"};
    }
    if (is_implicit(plan.bodies[plan.body(c.stiff)]) && is_implicit(plan.bodies[plan.body(c.soft)]))
        return Objection{
            "", ": \"" + c.stiff + "\" and \"" + c.soft +
                    "\" both have an implicit pore pressure; one of the two must be explicit"};
    for (const std::string& body : {c.stiff, c.soft}) {
        const auto& water = plan.bodies[plan.body(body)].water;
        if (!water) continue;
        const char* what = water->drainage == Drainage::flow ? "water that flows"
                           : water->implicit                 ? "implicit pore pressure"
                                                             : nullptr;
        if (what && c.penalty)
            return Objection{"law", std::string(": ") + what + ", in \"" + body +
                                        "\", knows no penalty contact"};
        if (what && c.after_damping)
            return Objection{"after_damping", std::string(": ") + what + ", in \"" + body +
                                                  "\", knows surface contact before damping alone"};
        if (!water->implicit) continue;
        if (c.contact_stiffness_multiple > 0.0)
            return Objection{"contact_stiffness_multiple", ": implicit pore pressure, in \"" +
                                                               body +
                                                               "\", knows rigid surfaces alone"};
        if (c.at_surfaces && plan.has_side(Boundary::platen))
            return Objection{"law", ": implicit pore pressure, in \"" + body +
                                        "\", knows no surface contact beside a platen"};
        for (std::size_t i = 0; i < contact; ++i) {
            const ContactPlan& other = plan.contacts[i];
            if ((other.stiff == body || other.soft == body) && other.at_surfaces != c.at_surfaces)
                return Objection{"law", ": implicit pore pressure, in \"" + body +
                                            "\", knows contacts at nodes or at surfaces, not both"};
        }
    }
    for (std::size_t i = 0; i < contact; ++i) {
        const ContactPlan& other = plan.contacts[i];
        if ((other.stiff == c.stiff && other.soft == c.soft) ||
            (other.stiff == c.soft && other.soft == c.stiff))
            return Objection{"",
                             ": \"" + c.stiff + "\" and \"" + c.soft + "\" have a contact already"};
    }
    return {};
}

Objections objection_to(const ContactPlan& contact, const IsGiven& given) {
    const std::string law(word_of(words::contact_laws, words::law_of(contact)));
    for (const Member<ContactPlan>& member : contact_members()) {
        const std::string_view key = member.word->key, laws = laws_with(key);
        if (!given(key) || has_key(law, key)) continue;
        const bool several = laws.find(' ') != laws.npos;
        return Objection{key, (several ? " belongs to the laws " : " belongs to the law ") +
                                  std::string(laws) + ", not to " + law};
    }
    const bool is_elastic = contact.contact_stiffness_multiple > 0.0;
    if (is_elastic && !given("modulus_kPa"))
        return Objection{"contact_stiffness_multiple",
                         " needs the P-wave modulus of the softer body"};
    if (given("modulus_kPa") && !given("contact_stiffness_multiple"))
        return Objection{"modulus_kPa",
                         " belongs to a stiffness of the contact, and there is none"};
    if (contact.at_surfaces) {
        if (is_elastic && contact.after_damping)
            return Objection{"after_damping", ": a stiffness would act twice in a step"};
        if (!is_elastic && contact.relaxation_time > 0.0)
            return Objection{
                "relaxation_time_s",
                " of surfaces belongs to a stiffness of the contact, and there is none"};
        return {};
    }
    if (is_elastic && !contact.gated)
        return Objection{"contact_stiffness_multiple", " needs a gap: the contact is not gated"};
    if (contact.law == GRIT_CONTACT_FRICTIONAL && given("distance") && !contact.gated)
        return Objection{"distance", ": the frictional law measures none unless it is gated"};
    return {};
}

Objections objection_to(const Case& plan, const StageEnd& end, const KeyName& name) {
    if (end.kinetic_share > 0.0 && end.unbalanced_share == 0.0)
        return Objection{"kinetic_share",
                         " needs " + name("unbalanced_share") +
                             ": a body that turns back has no kinetic energy either"};
    if (end.unbalanced_share > 0.0 && plan.settings.scheme == Scheme::musl)
        return Objection{"unbalanced_share", " is not measured with the scheme musl"};
    const auto has_pulses = [](const TractionPlan& traction) {
        return std::holds_alternative<PulseTrain>(traction.stress);
    };
    if (end.blows > 0 && std::none_of(plan.tractions.begin(), plan.tractions.end(), has_pulses))
        return Objection{"blows", " needs a traction with pulses"};
    return {};
}

}  // namespace grit::mpm
