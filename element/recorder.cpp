// SPDX-License-Identifier: BSD-3-Clause
#include "element/recorder.hpp"

#include <cmath>

#include "element/text.hpp"

namespace element {

Recorder::Recorder(const Law& l, const Settings& set, const Listeners& who)
    : law(l), settings(set), listeners(who) {
    history.state_names = law.state_names();
}

Record Recorder::snapshot(const Sample& sample, Place place) const {
    Record out;
    out.step = place.step;
    out.increment = place.increment;
    out.time = sample.time;
    out.strain = sample.strain;
    out.stress = sample.point.stress;
    out.state = sample.point.state;
    const Observation seen = law.observe(sample.point);
    const double carried = std::isnan(seen.pore_pressure) ? 0.0 : seen.pore_pressure;
    out.void_ratio = seen.void_ratio;
    out.pore_pressure = carried + sample.pore_pressure;
    out.effective_stress = out.stress + carried * unit_tensor();
    out.total_stress = out.stress - sample.pore_pressure * unit_tensor();
    if (sample.slopes.wanted()) out.slopes = slopes_of(sample);
    return out;
}

RecordSlopes Recorder::slopes_of(const Sample& sample) const {
    const Slopes& s = sample.slopes;
    const ObservedSlopes seen = law.observe(sample.point, s.point);
    RecordSlopes out;
    out.strain = s.strain;
    out.stress = out.effective_stress = out.total_stress = s.point.stress;
    out.effective_stress.topRows<3>().rowwise() += seen.pore_pressure;
    out.total_stress.topRows<3>().rowwise() -= s.pore_pressure;
    out.state = s.point.state;
    out.void_ratio = seen.void_ratio;
    out.pore_pressure = seen.pore_pressure + s.pore_pressure;
    return out;
}

void Recorder::add(const Advance& more) {
    work.iterations += more.iterations;
    work.evaluations += more.evaluations;
    work.cut_backs += more.cut_backs;
    work.residuals = more.residuals;
}

void Recorder::record(const Sample& sample, Place place) {
    Record out = snapshot(sample, place);
    out.iterations = work.iterations;
    out.evaluations = work.evaluations;
    out.cut_backs = work.cut_backs;
    if (settings.keep_residuals) out.residuals = std::move(work.residuals);
    work = Advance{};
    if (listeners.record) listeners.record(out);
    else history.records.push_back(std::move(out));
}

void Recorder::exit(Place place, const Condition& condition) {
    history.exits.push_back(
        text("step %ld, increment %d: %s", place.step, place.increment, condition.text.c_str()));
}

void Recorder::fail(const Step& step, const Sample& sample, Place place, int increments,
                    const std::string& why) {
    const std::string name = step.name.empty() ? "" : " (" + step.name + ")";
    const Vector6& e = sample.strain;
    history.failure =
        Failure{place.step, place.increment,
                text("step %ld%s, increment %d of %d, at strain %.6g %.6g %.6g %.6g %.6g %.6g: %s",
                     place.step, name.c_str(), place.increment, increments, e[0], e[1], e[2], e[3],
                     e[4], e[5], why.c_str())};
}

}  // namespace element
