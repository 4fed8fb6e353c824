// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/case/rules.hpp"

#include "adapters/mpm/step/text.hpp"

namespace grit::mpm {

Objections objection_to(const Case& plan, Side side) {
    if (side == Side::left && plan.settings.axisymmetric && plan.r.from == 0.0 &&
        plan.boundary[static_cast<int>(side)] != Boundary::roller)
        return Objection{"left", " is the axis r = 0: roller"};
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
    if (plan.bodies[plan.body(traction.body)].rigid())
        return Objection{"body", ": \"" + traction.body + "\" is rigid, no load moves it"};
    return {};
}

Objections objection_to_contact(const Case& plan, std::size_t contact, const KeyName& name) {
    const ContactPlan& c = plan.contacts[contact];
    if (c.stiff == c.soft) return Objection{"soft", " must be another body than " + name("stiff")};
    if (plan.bodies[plan.body(c.stiff)].rigid() && plan.bodies[plan.body(c.soft)].rigid())
        return Objection{"soft", ": both bodies are rigid"};
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
    if (contact.law != GRIT_CONTACT_FRICTIONAL || contact.penalty) return {};
    if (given("penalty_power"))
        return Objection{"penalty_power", " belongs to the geo law, not to the frictional one"};
    if (given("distance") && !contact.gated)
        return Objection{"distance", ": the frictional law measures none unless it is gated"};
    return {};
}

Objections objection_to(const StageEnd& end, Scheme scheme, const KeyName& name) {
    if (end.kinetic_share > 0.0 && end.unbalanced_share == 0.0)
        return Objection{"kinetic_share",
                         " needs " + name("unbalanced_share") +
                             ": a body that turns back has no kinetic energy either"};
    if (end.unbalanced_share > 0.0 && scheme == Scheme::musl)
        return Objection{"unbalanced_share", " is not measured with the scheme musl"};
    return {};
}

}  // namespace grit::mpm
