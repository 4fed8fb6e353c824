// SPDX-License-Identifier: GPL-2.0-only
#include "adapters/lammps/read_function.hpp"

namespace grit::lammps {
namespace {

using mpm::case_word;

mpm::TimeTable read_table(Words& words, const std::string& what) {
    mpm::TimeTable out;
    for (int n = words.integer("the number of points of " + what, mpm::words::many); n > 0; --n) {
        out.time.push_back(words.number("a time of " + what));
        out.value.push_back(words.number("a value of " + what));
    }
    refuse("the times of " + what, mpm::objection_to(out), no_name);
    return out;
}

std::string name_of_pulses(std::string_view key) {
    if (key == "peak_time_s") return "the time of its peak";
    return key == "duration_s" ? "the duration of a pulse" : "the interval of pulses";
}

mpm::PulseTrain read_pulses(Words& words) {
    mpm::PulseTrain out;
    out.form =
        static_cast<mpm::PulseForm>(words.choice("the form of a pulse", mpm::words::pulse_forms));
    out.peak = words.number("the peak of a pulse");
    out.duration =
        words.number("the duration of a pulse", case_word("traction.pulses", "duration_s"));
    out.peak_time =
        words.number("the time of its peak", case_word("traction.pulses", "peak_time_s"));
    out.interval = words.number("the interval of pulses");
    refuse("", mpm::objection_to(out, name_of_pulses), name_of_pulses);
    out.start =
        words.number("the start of the first pulse", case_word("traction.pulses", "start_s"));
    out.count = words.integer("the number of pulses", case_word("traction.pulses", "count").range);
    return out;
}

}  // namespace

Function read_function(Words& words, const std::string& what) {
    Function out;
    if (words.take("table")) out.time = read_table(words, what);
    else if (words.take("pulses")) out.time = read_pulses(words);
    else if (words.peek().starts_with("v_")) out.variable = words.word(what).substr(2);
    else out.time = mpm::TimeTable{{0.0}, {words.number(what)}};
    return out;
}

}  // namespace grit::lammps
