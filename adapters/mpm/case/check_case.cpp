// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/case/check_case.hpp"

#include <algorithm>
#include <set>

#include <grit/contact.h>

#include "adapters/mpm/step/text.hpp"

namespace grit::mpm {
namespace {

std::string quoted(const std::string& name) { return '"' + name + '"'; }

// As std::isalnum in the C locale: names are the same everywhere.
bool may_be_in_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
}

// section: also what the plans are called.
template <class Plans> Refused check_names(const Plans& plans, std::string_view section) {
    std::set<std::string> before;
    for (std::size_t i = 0; i < plans.size(); ++i) {
        const std::string& name = plans[i].name;
        if (auto refused = check_name(section, i, name)) return refused;
        if (!before.insert(name).second)
            return Refusal{section, i, "name",
                           ": there is a " + std::string(section) + ' ' + quoted(name) +
                               " already"};
    }
    return {};
}

// The axis needs no word; what is said of it must be true.
Refused check_sides(const Case& plan, const Said& said) {
    if (plan.settings.axisymmetric && plan.r.from == 0.0 && said.left &&
        plan.boundary[static_cast<int>(Side::left)] != Boundary::roller)
        return Refusal{"boundary", 0, "left", " is the axis r = 0: roller"};
    return {};
}

Refused check_times(std::string_view section, std::size_t number, const TimeTable& table) {
    for (std::size_t i = 1; i < table.time.size(); ++i)
        if (!(table.time[i] > table.time[i - 1]))
            return Refusal{section, number, "time_s",
                           " must ascend: " + text(table.time[i]) + " after " +
                               text(table.time[i - 1])};
    return {};
}

Refused check_motion(std::size_t number, const BodyPlan& body) {
    const auto* rigid = std::get_if<RigidPlan>(&body.material);
    if (!rigid) return {};
    if (auto refused = check_times("body.rigid", number, rigid->velocity_r)) return refused;
    return check_times("body.rigid", number, rigid->velocity_z);
}

Refused check_pulses(std::size_t number, const PulseTrain& pulses) {
    const auto refuse = [number](std::string_view key, std::string words) {
        return Refusal{"traction.pulses", number, key, std::move(words)};
    };
    const double middle = 0.5 * pulses.duration;
    if (pulses.form == PulseForm::half_sine && pulses.peak_time != middle)
        return refuse("peak_time_s", ": a half sine has its peak at " + text(middle) + " s, got " +
                                         text(pulses.peak_time));
    if (!(pulses.peak_time < pulses.duration))
        return refuse("peak_time_s", " must be below the duration of a pulse, " +
                                         text(pulses.duration) + " s, got " +
                                         text(pulses.peak_time));
    if (!(pulses.interval >= pulses.duration))
        return refuse("interval_s", " must be no shorter than a pulse, " + text(pulses.duration) +
                                        " s, got " + text(pulses.interval));
    return {};
}

Refused check_traction(const Case& plan, std::size_t number) {
    const TractionPlan& traction = plan.tractions[number];
    if (plan.bodies[plan.body(traction.body)].rigid())
        return Refusal{"traction", number, "body",
                       ": " + quoted(traction.body) + " is rigid, no load moves it"};
    if (const auto* pulses = std::get_if<PulseTrain>(&traction.stress))
        return check_pulses(number, *pulses);
    return check_times("traction", number, std::get<TimeTable>(traction.stress));
}

Refused check_contact(const Case& plan, const Said& said, std::size_t number) {
    const ContactPlan& contact = plan.contacts[number];
    const auto refuse = [number](std::string_view key, std::string words) {
        return Refusal{"contact", number, key, std::move(words)};
    };
    const std::size_t stiff = plan.body(contact.stiff), soft = plan.body(contact.soft);
    if (stiff == soft)
        return Refusal{"contact", number,
                       "soft",    " must be another body than ",
                       "stiff",   ", got " + quoted(contact.soft)};
    if (plan.bodies[stiff].rigid() && plan.bodies[soft].rigid())
        return refuse("soft", ": both bodies are rigid, " + quoted(contact.stiff) + " and " +
                                  quoted(contact.soft));
    if (!contact.penalty && contact.law == GRIT_CONTACT_FRICTIONAL) {
        if (said.contacts[number].power)
            return refuse("penalty_power", " belongs to the geo law, not to the frictional one");
        if (said.contacts[number].distance && !contact.gated)
            return refuse("distance", ": the frictional law measures none unless it is gated");
    }
    for (std::size_t i = 0; i < number; ++i) {
        const ContactPlan& other = plan.contacts[i];
        if ((other.stiff == contact.stiff && other.soft == contact.soft) ||
            (other.stiff == contact.soft && other.soft == contact.stiff))
            return refuse("", ": " + quoted(contact.stiff) + " and " + quoted(contact.soft) +
                                  " have a contact already");
    }
    return {};
}

}  // namespace

Refused check_name(std::string_view section, std::size_t number, const std::string& name) {
    if (name.empty()) return Refusal{section, number, "name", " is empty"};
    if (!std::all_of(name.begin(), name.end(), may_be_in_name))
        return Refusal{section, number, "name",
                       " may have letters, digits, _ and - only, got " + quoted(name)};
    return {};
}

Refused check_end(const Case& plan, std::size_t number, const StageEnd& end) {
    if (end.kinetic_share > 0.0 && end.unbalanced_share == 0.0)
        return Refusal{"stage.until",      number,
                       "kinetic_share",    " needs ",
                       "unbalanced_share", ": a body that turns back has no kinetic energy either"};
    if (end.unbalanced_share > 0.0 && plan.settings.scheme == Scheme::musl)
        return Refusal{"stage.until", number, "unbalanced_share",
                       " is not measured with the scheme musl"};
    const auto has_pulses = [](const TractionPlan& traction) {
        return std::holds_alternative<PulseTrain>(traction.stress);
    };
    if (end.blows > 0 && std::none_of(plan.tractions.begin(), plan.tractions.end(), has_pulses))
        return Refusal{"stage.until", number, "blows", " needs a traction with pulses"};
    return {};
}

Refused check_case(const Case& plan, const Said& said) {
    if (auto refused = check_sides(plan, said)) return refused;
    if (auto refused = check_names(plan.stages, "stage")) return refused;
    if (auto refused = check_names(plan.bodies, "body")) return refused;
    for (std::size_t i = 0; i < plan.bodies.size(); ++i)
        if (auto refused = check_motion(i, plan.bodies[i])) return refused;
    for (std::size_t i = 0; i < plan.tractions.size(); ++i)
        if (auto refused = check_traction(plan, i)) return refused;
    for (std::size_t i = 0; i < plan.contacts.size(); ++i)
        if (auto refused = check_contact(plan, said, i)) return refused;
    for (std::size_t i = 0; i < plan.stages.size(); ++i)
        if (auto refused = check_end(plan, i, plan.stages[i].end)) return refused;
    return {};
}

}  // namespace grit::mpm
