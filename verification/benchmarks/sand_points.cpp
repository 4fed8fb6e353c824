// SPDX-License-Identifier: BSD-3-Clause
#include "sand_points.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace benchmarks {

SandPoints::SandPoints(const std::vector<Call>& calls, std::size_t count, bool with_tangent)
    : tangent(with_tangent ? 36 * count : 0), reports(count) {
    for (std::size_t i = 0; i < count; ++i) {
        const Call& c = calls[i % calls.size()];
        strain.insert(strain.end(), c.strain, c.strain + 6);
        stress.insert(stress.end(), c.stress, c.stress + 6);
        state.insert(state.end(), c.state, c.state + GRIT_SAND_STATE_SIZE);
    }
}

grit_sand_points SandPoints::views(std::size_t first) {
    grit_sand_points q{};
    q.struct_size = sizeof q;
    q.strain_increment = grit_view_of(&strain[6 * first], 6, 1);
    q.stress = grit_mutable_view_of(&stress[6 * first], 6, 1);
    q.state = grit_mutable_view_of(&state[GRIT_SAND_STATE_SIZE * first], GRIT_SAND_STATE_SIZE, 1);
    if (!tangent.empty()) q.tangent = grit_mutable_matrix_view_of(&tangent[36 * first], 36, 6, 1);
    return q;
}

grit_sand_options SandRequest::options() const {
    grit_sand_options out;
    grit_sand_options_init(&out, sizeof out);
    if (tolerance > 0.0) out.tolerance = tolerance;
    out.tangent = tangent;
    out.instruction_set = instruction_set;
    return out;
}

std::string SandRequest::words() const {
    std::ostringstream out;
    out << "/increment:" << increment << "/tolerance:";
    if (tolerance > 0.0) out << tolerance;
    else out << "default";
    out << "/tangent:" << tangent << "/isa:" << instruction_set;
    return out.str();
}

void SandRequest::tell(benchmark::State& state) const {
    state.counters["increment"] = increment;
    state.counters["tolerance"] = options().tolerance;
    state.counters["default_tolerance"] = tolerance > 0.0 ? 0.0 : 1.0;
    state.counters["tangent"] = tangent;
    state.counters["instruction_set"] = instruction_set;
}

void update(const grit_sand& sand, const grit_sand_options& options, SandPoints& points,
            std::size_t first, std::size_t last, std::size_t per_call) {
    for (; first < last; first += per_call) {
        const grit_sand_points views = points.views(first);
        const std::size_t n = std::min(per_call, last - first);
        grit_sand_update(&sand, &options, static_cast<std::ptrdiff_t>(n), &views,
                         &points.reports[first], nullptr);
    }
}

void tell(benchmark::State& state, const std::vector<Outcome>& outcomes) {
    std::vector<double> errors, evaluations;
    for (const Outcome& o : outcomes) {
        if (o.failed) continue;
        errors.push_back(o.error);
        if (!std::isnan(o.evaluations)) evaluations.push_back(o.evaluations);
    }
    state.counters["failures"] =
        static_cast<double>(outcomes.size() - errors.size()) / static_cast<double>(outcomes.size());
    const auto add = [&state](const std::string& what, const std::vector<double>& x) {
        if (x.empty()) return;  // JSON has no NaN
        state.counters[what + "_p50"] = percentile(x, 0.5);
        state.counters[what + "_p90"] = percentile(x, 0.9);
        state.counters[what + "_max"] = percentile(x, 1.0);
    };
    add("error", errors);
    add("evaluations", evaluations);
}

}  // namespace benchmarks
