// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/case/case_words.hpp"

#include <cstdlib>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "adapters/mpm/step/text.hpp"

namespace grit::mpm {
namespace {

template <class Plan, auto... Path>
constexpr Member<Plan> member(const CaseWord& word, std::string_view fix = {}) {
    using Value = std::remove_cvref_t<decltype((std::declval<Plan&>().*....*Path))>;
    return {&word, fix, [](const Plan& plan) { return static_cast<double>((plan.*....*Path)); },
            [](Plan& plan, double value) { (plan.*....*Path) = static_cast<Value>(value); }};
}

// In the order in which scripts for LAMMPS have them: restart files know their words.
constexpr Member<Case> of_numerics[] = {
    member<Case, &Case::settings, &Settings::shape>(case_word("numerics", "shape_function"),
                                                    "shape_function"),
    member<Case, &Case::settings, &Settings::scheme>(case_word("numerics", "scheme"), "scheme"),
    member<Case, &Case::settings, &Settings::cfl>(case_word("numerics", "cfl"), "cfl"),
    member<Case, &Case::settings, &Settings::pic_rate>(case_word("numerics", "pic_rate_per_s"),
                                                       "pic_rate"),
    member<Case, &Case::settings, &Settings::local_damping>(case_word("numerics", "local_damping"),
                                                            "local_damping"),
    member<Case, &Case::settings, &Settings::largest_step>(case_word("numerics", "largest_step_s"),
                                                           "largest_step"),
    member<Case, &Case::settings, &Settings::linear_viscosity>(
        case_word("numerics", "bulk_viscosity_linear"), "bulk_viscosity"),
    member<Case, &Case::settings, &Settings::quadratic_viscosity>(
        case_word("numerics", "bulk_viscosity_quadratic"), "bulk_viscosity"),
    member<Case, &Case::settings, &Settings::cell_mean>(
        case_word("numerics", "cell_averaged_volume"), "cell_mean"),
    member<Case, &Case::settings, &Settings::reduced_domains>(
        case_word("numerics", "reduced_domains"), "reduced_domains"),
    member<Case, &Case::settings, &Settings::fixed_point>(case_word("numerics", "fixed_point"),
                                                          "fixed_point"),
    member<Case, &Case::gravity>(case_word("", "gravity_m_per_s2"), "gravity"),
    member<Case, &Case::residual_limit>(case_word("numerics", "energy_residual_limit"),
                                        "energy_residual_limit"),
    member<Case, &Case::settings, &Settings::threads>(case_word("numerics", "threads"), "threads")};

constexpr Member<ContactPlan> of_contact[] = {
    member<ContactPlan, &ContactPlan::friction_coefficient>(
        case_word("contact", "friction_coefficient")),
    member<ContactPlan, &ContactPlan::penalty_power>(case_word("contact", "penalty_power"),
                                                     "power"),
    member<ContactPlan, &ContactPlan::normal>(case_word("contact", "normal"), "normal"),
    member<ContactPlan, &ContactPlan::measure>(case_word("contact", "distance"), "distance"),
    member<ContactPlan, &ContactPlan::gated>(case_word("contact", "gated"), "gated"),
    member<ContactPlan, &ContactPlan::relaxation_time>(case_word("contact", "relaxation_time_s"),
                                                       "relaxation_time"),
    member<ContactPlan, &ContactPlan::contact_stiffness_multiple>(
        case_word("contact", "contact_stiffness_multiple"), "stiffness_multiple"),
    member<ContactPlan, &ContactPlan::pressure_spacing>(
        case_word("contact", "pressure_spacing_cells"), "pressure_spacing"),
    member<ContactPlan, &ContactPlan::sweep_tolerance>(case_word("contact", "sweep_tolerance"),
                                                       "sweep_tolerance"),
    member<ContactPlan, &ContactPlan::after_damping>(case_word("contact", "after_damping"),
                                                     "after_damping"),
    member<ContactPlan, &ContactPlan::modulus>(case_word("contact", "modulus_kPa"), "modulus")};

constexpr struct {
    std::string_view key, laws;
} laws_of_keys[] = {{"penalty_power", "geo"},
                    {"normal", "geo and frictional"},
                    {"distance", "geo and frictional"},
                    {"gated", "geo and frictional"},
                    {"relaxation_time_s", "geo and surface"},
                    {"contact_stiffness_multiple", "geo and surface"},
                    {"pressure_spacing_cells", "surface"},
                    {"sweep_tolerance", "surface"},
                    {"after_damping", "surface"}};

constexpr Member<WaterPlan> of_water[] = {
    member<WaterPlan, &WaterPlan::implicit>(case_word("body.water", "pressure"), "pressure"),
    member<WaterPlan, &WaterPlan::porosity>(case_word("body.water", "porosity"), "porosity"),
    member<WaterPlan, &WaterPlan::bulk_modulus>(case_word("body.water", "bulk_modulus_kPa"),
                                                "bulk_modulus"),
    member<WaterPlan, &WaterPlan::density>(case_word("body.water", "density_kg_per_m3"), "density"),
    member<WaterPlan, &WaterPlan::largest_tension>(case_word("body.water", "cavitation_kPa"),
                                                   "cavitation"),
    member<WaterPlan, &WaterPlan::conductivity>(case_word("body.water", "conductivity_m_per_s"),
                                                "conductivity")};

constexpr Member<StagePlan> of_stage[] = {
    member<StagePlan, &StagePlan::gravity>(case_word("stage", "gravity"), "gravity"),
    member<StagePlan, &StagePlan::local_damping>(case_word("stage", "local_damping"),
                                                 "local_damping"),
    member<StagePlan, &StagePlan::pic_rate>(case_word("stage", "pic_rate_per_s"), "pic_rate"),
    member<StagePlan, &StagePlan::cfl>(case_word("stage", "cfl"), "cfl")};

constexpr Member<StageEnd> of_end[] = {
    member<StageEnd, &StageEnd::time>(case_word("stage.until", "time_s"), "until_time"),
    member<StageEnd, &StageEnd::depth>(case_word("stage.until", "depth_m"), "until_depth"),
    member<StageEnd, &StageEnd::blows>(case_word("stage.until", "blows"), "until_blows"),
    member<StageEnd, &StageEnd::unbalanced_share>(case_word("stage.until", "unbalanced_share"),
                                                  "until_unbalanced"),
    member<StageEnd, &StageEnd::kinetic_share>(case_word("stage.until", "kinetic_share"),
                                               "until_kinetic")};

constexpr FixKeyword keywords[] = {
    {"grid", "`r`|`z` TO CELLS GROWTH, in space `x`|`y`|`z`",
     "the next segment of an axis up to TO [m]; a cell is GROWTH times as long as the one before"},
    {"boundary", "{side} {boundary.left}",
     "of a side of the grid, in space `front` and `back` too; default `free`, the axis is a "
     "roller"},
    {"body", "NAME `type` N|`group` G MATERIAL",
     "NAME: letters, digits, _ and -; MATERIAL: `rigid`; `elastic` E NU; `neo_hooke` E NU; `sand` "
     "NAME|`custom` (PARAMETER "
     "VALUE)... with the "
     "parameters of `grit/sand.h`, Pa and rad, and `tolerance`, `evaluation_limit`, `intergranular "
     "on`|`off`"},
    {"water",
     "NAME {body.water.drainage} [`pressure` {body.water.pressure}] [`porosity` N] [`bulk_modulus` "
     "K_W] [`density` RHO] [`cavitation` "
     "P] "
     "[`table` Z] [`conductivity` K [`kozeny_carman` E]]",
     "of a body of sand, or elastic with porosity N; as in `body.water`: Pa, kg/m³, m, m/s; E: the "
     "void ratio that the conductivity is of; Z, where the points file has no `p_w`"},
    {"drained", "{side}", "a side that pore water leaves freely"},
    {"motion",
     "NAME V_R V_Z [`from` STAGE], in space NAME V_X V_Y V_Z [`spin` W_X W_Y W_Z] [`centre` X Y Z] "
     "[`free` N DEGREE...] [`start` V_X V_Y V_Z] [`from` STAGE]",
     "velocities of a rigid body [m/s], each a FUNCTION, no pulses; W: about the centre [rad/s], "
     "which is that of mass; DEGREE: `x`, `y`, `z`, `about_x`, `about_y` or `about_z`, moved by "
     "weight, loads and contact, from V [m/s] on"},
    {"points", "NAME FILE", "of a body, see below"},
    {"traction",
     "NAME GROUP {traction.edge} D_R D_Z FUNCTION [`mixture`] [`from` STAGE], in space D_X D_Y D_Z",
     "stress [Pa] times direction on that edge of each atom of the group, in space a face, `front` "
     "and `back` too; `mixture`: on grains and water by their shares"},
    {"contact",
     "STIFF SOFT {contact.law} MU [`power` K] [`normal` {contact.normal}] [`distance` "
     "{contact.distance}] [`gated` `yes`|`no`] [`relaxation_time` TAU] [`stiffness_multiple` X "
     "`modulus` M] [`pressure_spacing` CELLS] [`sweep_tolerance` "
     "SHARE] [`after_damping` `yes`|`no`] [`stiff_line` N R Z...|`stiff_surface` FILE]",
     "geo and frictional have `normal`, `distance` and `gated`, geo `power` besides, surface "
     "`pressure_spacing`, `sweep_tolerance`, `after_damping` and the surface of STIFF at the "
     "begin: `stiff_line` through N points [m], STIFF on its left, closed if the last is the "
     "first, in space `stiff_surface`, an STL file [m]; geo and surface TAU [s] and X of "
     "M [Pa] / shortest "
     "cell: of geo X with gate, of surface TAU with X, X without `after_damping`; `distance` not "
     "without gate where it is frictional"},
    {"stages", "N NAME...",
     "all stages, in order; default: one, `run`; names: letters, digits, _ and -"},
    {"driven", "NAME {history.depth_of}", "the body of the history; default: the first"}};

std::string joined(Spellings words, bool of_fix_alone) {
    std::string out;
    for (const Spelling& spelling : words)
        if (spelling.in_fix || !of_fix_alone)
            out += (out.empty() ? "`" : "|`") + std::string(spelling.word) + '`';
    return out;
}

// {section.key} and {side} become the words of a choice.
std::string filled_in(std::string_view pattern) {
    std::string out;
    while (!pattern.empty()) {
        const std::size_t open = pattern.find('{');
        out += pattern.substr(0, open);
        if (open == std::string_view::npos) break;
        const std::size_t close = pattern.find('}', open);
        const std::string_view name = pattern.substr(open + 1, close - open - 1);
        const std::size_t dot = name.rfind('.');
        Spellings found = words::sides;
        for (const CaseWord& word : words::all)
            if (dot != std::string_view::npos && word.section == name.substr(0, dot) &&
                word.key == name.substr(dot + 1))
                found = word.words;
        out += joined(found, true);
        pattern.remove_prefix(close + 1);
    }
    return out;
}

// Of a table in Markdown.
std::string row(std::initializer_list<std::string> cells) {
    std::string out = "|";
    for (const std::string& cell : cells) {
        out += ' ';
        for (const char c : cell) out += c == '|' ? std::string("\\|") : std::string(1, c);
        out += " |";
    }
    return out + '\n';
}

std::string with_unit(const CaseWord& word) {
    return *word.unit ? std::string(" [") + word.unit + ']' : std::string();
}

enum class Told { with_texts, words_alone };

std::string value_of(const CaseWord& word, bool of_fix, Told told = Told::with_texts) {
    switch (word.kind) {
        case Kind::number:
            return (word.range.is_all() ? "number" : "number " + word.range.text()) +
                   with_unit(word);
        case Kind::integer: return "integer " + word.range.text();
        case Kind::yes_or_no: return of_fix ? "`yes`|`no`" : "`true`, `false`";
        case Kind::numbers: return "numbers" + with_unit(word);
        case Kind::text: return "text";
        case Kind::texts: return "texts";
        case Kind::table: return "table";
        case Kind::choice: break;
    }
    if (of_fix) return joined(word.words, true);
    std::string out;
    for (const Spelling& spelling : word.words) {
        out += (out.empty() ? "`" : "; `") + std::string(spelling.word) + '`';
        if (*spelling.text && told == Told::with_texts) out += std::string(": ") + spelling.text;
    }
    return out;
}

// Of a plan that says nothing.
template <class Plan> std::string plain_value(const Member<Plan>& member, bool of_fix) {
    const CaseWord& word = *member.word;
    if (*word.otherwise) return word.otherwise;
    const double value = member.get(Plan());
    if (word.kind == Kind::yes_or_no)
        return of_fix ? (value != 0.0 ? "`yes`" : "`no`") : (value != 0.0 ? "`true`" : "`false`");
    if (word.kind == Kind::choice)
        return '`' + std::string(word_of(word.words, static_cast<int>(value))) + '`';
    return text(value / word.si);
}

template <class Plan>
const Member<Plan>* member_of(std::span<const Member<Plan>> members, const CaseWord& word) {
    for (const Member<Plan>& member : members)
        if (member.word == &word) return &member;
    return nullptr;
}

std::string default_of(const CaseWord& word) {
    if (const auto* member = member_of<Case>(of_numerics, word)) return plain_value(*member, false);
    if (const auto* member = member_of<ContactPlan>(of_contact, word))
        return plain_value(*member, false);
    if (const auto* member = member_of<StagePlan>(of_stage, word))
        return plain_value(*member, false);
    return *word.otherwise ? word.otherwise : "needed";
}

std::string heading(std::string_view section) {
    const std::string name(section);
    if (section == "grid.r") return "`[[grid.r]]`, `[[grid.z]]`, in space x, y and z";
    if (section == "body.box") return "`[[body.box]]`, `[[body.polygon]]`";
    if (section == "body.elastic") return "`[body.elastic]`, `[body.neo_hooke]`";
    if (section == "contact.stiff_line") return "`[contact.stiff_line]`, `[contact.soft_line]`";
    for (const char* list : {"body", "body.cylinder", "body.cone", "body.sphere", "body.surface",
                             "traction", "inflow", "contact", "stage"})
        if (section == list) return "`[[" + name + "]]`";
    return name.empty() ? "top of the file" : "`[" + name + "]`";
}

template <class Plan> std::string rows_of(std::span<const Member<Plan>> members, bool stage) {
    std::string out;
    for (std::size_t i = 0; i < members.size(); ++i) {
        const Member<Plan>& member = members[i];
        if (member.fix.empty() || (i > 0 && members[i - 1].fix == member.fix)) continue;
        std::string values = value_of(*member.word, true), otherwise = plain_value(member, true);
        if (i + 1 < members.size() && members[i + 1].fix == member.fix) {
            values = "linear and quadratic, each a " + values;
            otherwise += ' ' + plain_value(members[i + 1], true);
        }
        std::string what = member.word->text;
        if (!stage) what += (what.empty() ? "default " : "; default ") + otherwise;
        out += row({'`' + std::string(member.fix) + '`', values, what});
    }
    return out;
}

}  // namespace

std::string Interval::text() const {
    if (open && high == infinite) return "> " + mpm::text(low);
    return (open ? "in (" : "in [") + mpm::text(low) + ", " + mpm::text(high) + (open ? ')' : ']');
}

double CaseWord::otherwise_number() const {
    char* end = nullptr;
    const double value = std::strtod(otherwise, &end);
    if (end == otherwise || *end != '\0')
        throw std::logic_error(std::string(key) + " is no number where it is not given");
    return si * value;
}

std::span<const Member<Case>> numerics_members() { return of_numerics; }
std::span<const Member<ContactPlan>> contact_members() { return of_contact; }
std::string_view laws_with(std::string_view key) {
    for (const auto& of : laws_of_keys)
        if (of.key == key) return of.laws;
    return {};
}
bool has_key(std::string_view law, std::string_view key) {
    const std::string_view laws = laws_with(key);
    return laws.empty() || laws.find(law) != laws.npos;
}
std::span<const Member<WaterPlan>> water_members() { return of_water; }
std::span<const Member<StagePlan>> stage_members() { return of_stage; }
std::span<const Member<StageEnd>> end_members() { return of_end; }
std::span<const FixKeyword> fix_keywords() { return keywords; }

std::string keys_of_cases() {
    std::string out = "| table | key | value | default | what |\n|---|---|---|---|---|\n";
    std::string_view section = "-";
    const Spelling* told = nullptr;  // words that the row above explains
    for (const CaseWord& word : words::all) {
        const Told texts = told && word.words.data() == told ? Told::words_alone : Told::with_texts;
        told = word.words.data();
        out += row({word.section == section ? "" : heading(word.section),
                    '`' + std::string(word.key) + '`', value_of(word, false, texts),
                    default_of(word), word.text});
        section = word.section;
    }
    return out;
}

std::string keys_of_fix() {
    std::string out = "| keyword | values | what |\n|---|---|---|\n";
    for (const FixKeyword& keyword : keywords)
        out +=
            row({'`' + std::string(keyword.word) + '`', filled_in(keyword.values), keyword.text});
    return out + rows_of<Case>(of_numerics, false) +
           "\n| word of a stage | values | what |\n|---|---|---|\n" +
           rows_of<StagePlan>(of_stage, true) + rows_of<StageEnd>(of_end, true);
}

}  // namespace grit::mpm
