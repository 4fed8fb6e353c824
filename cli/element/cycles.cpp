// SPDX-License-Identifier: BSD-3-Clause
#include "cli/element/cycles.hpp"

#include <cmath>
#include <iterator>
#include <numbers>

namespace cli {
namespace {

constexpr double least_swing = 1e-10;  // what Newton's method leaves over is below it
constexpr double least_part = 1e-3;
// The last stretch of a stage closes a cycle if it is so much of the one that closed the cycle before, or
// so much of the one back: a sample that creeps along goes farther one way than the other.
constexpr double share_of_closing = 0.8, share_of_way_back = 0.6;

constexpr const char* states[] = {"axial_strain", "volumetric_strain", "p", "void_ratio",
                                  "pore_pressure"};

std::size_t place(const std::vector<Column>& columns, const std::string& name) {
    std::size_t i = 0;
    while (columns[i].name != name) ++i;
    return i;
}

}  // namespace

Cycles::Cycles(const Columns& all) : columns(all) {
    table.columns = {
        {"stage", "", {}, {}},         {"cycle", "", {}, {}},  {"gamma_amplitude", "-", {}, {}},
        {"secant_G", "kPa", {}, {}},   {"G/G_0", "-", {}, {}}, {"damping", "-", {}, {}},
        {"shear_strain", "-", {}, {}}, {"u/p0", "-", {}, {}}};
    for (const char* name : states) {
        const Column& head = columns.names()[place(columns.names(), name)];
        table.columns.push_back({head.name, head.unit, {}, {}});
    }
}

void Cycles::begin_stage(int number, bool loaded_by_shear, const element::Record& start) {
    stage = number;
    by_shear = loaded_by_shear;
    cycle = closing = 0.0;
    tips.clear();
    pressure = -start.total_stress.head<3>().sum() / 3.0;
    last = farthest = {start, shear_of(start, by_shear), 0.0};
    turns.emplace(last.shear.strain, least_swing, least_part);
}

void Cycles::add(const element::Record& record) {
    const ShearPair shear = shear_of(record, by_shear);
    const double work =
        0.5 * (shear.stress + last.shear.stress) * (shear.strain - last.shear.strain);
    last = {record, shear, last.work + work};
    const Turns::Move move = turns->add(shear.strain);
    if (move == Turns::Move::turned) add_tip(farthest);
    if (move != Turns::Move::back) farthest = last;
}

void Cycles::end_stage() {
    if (tips.size() == 2) {
        const double needed = closing > 0.0 ? share_of_closing * closing
                                            : share_of_way_back * distance(tips[0], tips[1]);
        if (distance(tips[1], last) >= needed) add_tip(last);
    }
    turns.reset();
}

void Cycles::add_tip(Tip tip) {
    tips.push_back(std::move(tip));
    if (tips.size() < 3) return;
    add_cycle(tips[0], tips[1], tips[2]);
    closing = distance(tips[1], tips[2]);
    tips.erase(tips.begin(), tips.begin() + 2);
}

double Cycles::distance(const Tip& a, const Tip& b) {
    return std::abs(b.shear.strain - a.shear.strain);
}

void Cycles::add_cycle(const Tip& from, const Tip& middle, const Tip& to) {
    const std::vector<double> at_start = columns.row(from.record, {stage, by_shear, NAN});
    const std::vector<double> at_end = columns.row(to.record, {stage, by_shear, NAN});
    const double range = middle.shear.strain - from.shear.strain, amplitude = 0.5 * std::abs(range);
    const double G = (middle.shear.stress - from.shear.stress) / range;
    const double values[] = {static_cast<double>(stage),
                             ++cycle,
                             amplitude,
                             G,
                             G / at_start[place(columns.names(), "G_0")],
                             (to.work - from.work) /
                                 (2.0 * std::numbers::pi * G * amplitude * amplitude),
                             to.shear.strain,
                             to.record.pore_pressure / pressure};
    for (std::size_t i = 0; i < std::size(values); ++i)
        table.columns[i].values.push_back(values[i]);
    for (std::size_t i = 0; i < std::size(states); ++i)
        table.columns[std::size(values) + i].values.push_back(
            at_end[place(columns.names(), states[i])]);
}

const std::vector<std::string>& Cycles::comments() {
    static const std::vector<std::string> text = {
        "a cycle: from a reversal of shear_strain to the second after it, every increment counted; "
        "secant_G from tip to tip; G_0 at the first; damping = loop area/(2 pi G "
        "gamma_amplitude^2); the state at its end; u/p0: pore_pressure over the total mean "
        "pressure "
        "where the stage begins"};
    return text;
}

Table Cycles::take() { return table.rows() > 0 ? std::move(table) : Table{}; }

}  // namespace cli
