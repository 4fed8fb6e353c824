// SPDX-License-Identifier: BSD-3-Clause
#include "sand_points.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace benchmarks {

SandPoints SandPoints::structures(const std::vector<Call>& calls, std::size_t count,
                                  bool with_tangent) {
    SandPoints p;
    p.tangent.resize(with_tangent ? 36 * count : 0);
    p.reports.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Call& c = calls[i % calls.size()];
        p.strain.insert(p.strain.end(), c.strain, c.strain + 6);
        p.stress.insert(p.stress.end(), c.stress, c.stress + 6);
        p.state.insert(p.state.end(), c.state, c.state + GRIT_SAND_STATE_SIZE);
    }
    return p;
}

SandPoints SandPoints::columns(const std::vector<Call>& calls, std::size_t count) {
    SandPoints p;
    p.layout = Layout::columns;
    const auto add = [&](std::vector<double>& to, int components, const auto& of) {
        for (int c = 0; c < components; ++c)
            for (std::size_t i = 0; i < count; ++i) to.push_back(of(calls[i % calls.size()])[c]);
    };
    add(p.strain, 6, [](const Call& c) { return c.strain; });
    add(p.stress, 6, [](const Call& c) { return c.stress; });
    add(p.state, GRIT_SAND_STATE_SIZE, [](const Call& c) { return c.state; });
    return p;
}

grit_sand_points SandPoints::views(std::size_t first) {
    const auto n = static_cast<std::ptrdiff_t>(size());
    const auto stride = [&](std::ptrdiff_t components) {
        return layout == Layout::columns ? std::pair<std::ptrdiff_t, std::ptrdiff_t>{1, n}
                                         : std::pair<std::ptrdiff_t, std::ptrdiff_t>{components, 1};
    };
    const auto [of_tensor, of_component] = stride(6);
    const auto [of_state, of_variable] = stride(GRIT_SAND_STATE_SIZE);
    const auto at = static_cast<std::ptrdiff_t>(first);
    grit_sand_points q{};
    q.struct_size = sizeof q;
    q.strain_increment = grit_view_of(&strain[at * of_tensor], of_tensor, of_component);
    q.stress = grit_mutable_view_of(&stress[at * of_tensor], of_tensor, of_component);
    q.state = grit_mutable_view_of(&state[at * of_state], of_state, of_variable);
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
                         points.reports.empty() ? nullptr : &points.reports[first], nullptr);
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
