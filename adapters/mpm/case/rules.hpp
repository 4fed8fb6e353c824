// SPDX-License-Identifier: BSD-3-Clause
// What the parts of a case must satisfy together, whoever has read them: case files, fix grit/mpm. Ranges of single
// keys: case_words.hpp.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "adapters/mpm/case/case.hpp"

namespace grit::mpm {

// A sentence about a key of case files: the name that the reader has for it, then what.
struct Objection {
    std::string_view key;  // empty: the whole part
    std::string what;      // " must be below duration_s, 0.01, got 0.02"
};
using Objections = std::optional<Objection>;
// What the reader calls another key of the same part.
using KeyName = std::function<std::string(std::string_view key)>;
// Does the part say something of a key?
using IsGiven = std::function<bool(std::string_view key)>;

// Names become parts of file names, of keys in [override] and of commands.
Objections objection_to_name(const std::string& name);
// ... of a body or a stage besides those that the case has.
Objections objection_to_name_of_body(const Case& plan, const std::string& name);
Objections objection_to_name_of_stage(const Case& plan, const std::string& name);
// A side that is given a boundary.
Objections objection_to(const Case& plan, Side side);
Objections objection_to(const TimeTable& table);
Objections objection_to(const PulseTrain& pulses, const KeyName& name);
Objections objection_to(const Case& plan, const TractionPlan& traction);
Objections objection_to(const Case& plan, const InflowPlan& inflow);
Objections objection_to(const Case& plan, const BoundaryLine& line);
// Of pore water, as a body of this material has it.
Objections objection_to(const Case& plan, const MaterialPlan& material, const WaterPlan& water,
                        const IsGiven& given);
// Of the level of no pore pressure: water that flows is let in by every surface that suction is behind.
// reached: by the body.
Objections objection_to_water_table(const BodyPlan& body, double reached);
// Of the contact and of those before it, and of the bodies that it knows.
Objections objection_to_contact(const Case& plan, std::size_t contact, const KeyName& name);
// Of the law and of what is given for it.
Objections objection_to(const ContactPlan& contact, const IsGiven& given);
Objections objection_to(const Case& plan, const StageEnd& end, const KeyName& name);

}  // namespace grit::mpm
