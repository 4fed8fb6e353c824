// SPDX-License-Identifier: BSD-3-Clause
#include "robustness/penalty_trials.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include <grit/contact_penalty.h>

#include "robustness/layout.hpp"
#include "robustness/program_text.hpp"

namespace robustness {
namespace {

enum Count { calls, refused, without_contact, vertices_in_contact, slipping };
enum Largest { reaction_error, friction_excess, swap_difference, shift_difference };
enum Rule {
    finite,
    untouched,
    known_status,
    same_again,
    same_in_any_memory,
    action_is_reaction,
    obeys_coulomb,
    presses_only,
    energies_are_not_negative,
    opens_clean,
    validates_alike
};

const Vocabulary words = {
    {"calls", "refused", "without contact", "vertices in contact", "of these, slipping"},
    {"action and reaction, over the sum of forces", "friction above Coulomb's, over mu t_n",
     "difference with bodies exchanged, over the largest force",
     "difference with all shifted by a length, over the largest force"},
    {"results are finite", "a refused call writes nothing", "a status is one of a call",
     "the same call gives the same bits, whatever is in its workspace",
     "any strides give the same bits", "action is reaction to 1e-12",
     "friction stays within Coulomb's limit to 1e-12", "the normal traction presses",
     "stored energies and dissipation are not negative", "an open vertex has no history",
     "what is validated is what is computed"}};

using Pair = std::array<double, 2>;

struct Line {
    std::vector<Pair> x, v, history, force;
    std::vector<double> stiffness;
    std::vector<grit_penalty_report> reports;
    bool closed = true;

    void size_up() {
        v.resize(x.size());
        history.resize(x.size());
        force.assign(x.size(), {});
        stiffness.assign(x.size(), 0.0);
        reports.assign(x.size(), {});
    }
    grit_penalty_surface view() {
        grit_penalty_surface s{};
        s.struct_size = sizeof s;
        s.closed = closed;
        s.count = static_cast<std::ptrdiff_t>(x.size());
        s.position = grit_view_of(x[0].data(), 2, 1);
        s.velocity = grit_view_of(v[0].data(), 2, 1);
        s.history = grit_mutable_view_of(history[0].data(), 2, 1);
        s.force = grit_mutable_view_of(force[0].data(), 2, 1);
        s.stiffness = grit_mutable_view_of(stiffness.data(), 1, 1);
        s.reports = reports.data();
        return s;
    }
    bool same(const Line& other) const {
        const std::size_t bytes = x.size() * sizeof(Pair);
        return std::memcmp(history.data(), other.history.data(), bytes) == 0 &&
               std::memcmp(force.data(), other.force.data(), bytes) == 0 &&
               std::memcmp(stiffness.data(), other.stiffness.data(), bytes / 2) == 0;
    }
};

struct Call {
    grit_penalty_options options;
    Line a, b;
    grit_penalty_totals totals{};
    grit_status status = GRIT_OK;

    void run(Random& random) { run(random, a.view(), b.view()); }
    void run(Random& random, const grit_penalty_surface& on_a, const grit_penalty_surface& on_b) {
        std::vector<double> workspace(grit_penalty_workspace_size(on_a.count, on_b.count) / 8);
        const double rubbish = random.below(2) ? NAN : random.normal();
        std::fill(workspace.begin(), workspace.end(), rubbish);
        totals = {};
        totals.struct_size = sizeof totals;
        grit_error error{};
        status = grit_penalty_forces(&options, &on_a, &on_b, workspace.data(), 8 * workspace.size(),
                                     &totals, &error);
    }
};

// A body with bumps and dents, or its upper or lower side alone. right: of the axis.
Line random_line(Random& random, Pair centre, double size, bool right) {
    Line out;
    const int n = 3 + random.below(random.below(4) == 0 ? 120 : 20);
    const double rough = random.below(3) ? random.uniform(0.0, 0.3) : random.log_uniform(1e-9, 0.9);
    out.closed = random.below(3) != 0;
    const double from = random.uniform(0.0, 6.28), turn = out.closed ? 6.283185307179586 : 3.0;
    for (int i = 0; i < n; ++i) {
        double share = i / static_cast<double>(out.closed ? n : n - 1);
        if (random.below(4) == 0)
            share += random.uniform(-0.4, 0.4) / n;  // short ones beside long ones
        const double radius = size * (1.0 + rough * random.uniform(-1.0, 1.0));
        Pair x = {centre[0] + radius * std::cos(from + turn * share),
                  centre[1] + radius * std::sin(from + turn * share)};
        if (right) x[0] = std::fabs(x[0]);
        out.x.push_back(x);
    }
    if (random.below(30) == 0) out.x[1] = out.x[0];  // a segment without length
    out.size_up();
    const double speed = random.log_uniform(1e-9, 1e3) * size;
    for (Pair& v : out.v) v = {speed * random.normal(), speed * random.normal()};
    if (random.below(40) == 0) out.v[0][1] = NAN;
    return out;
}

Call random_call(Random& random) {
    Call call;
    grit_penalty_options& o = call.options;
    grit_penalty_options_init(&o, sizeof o);
    o.axisymmetric = random.below(3) == 0;
    const double size = random.log_uniform(1e-6, 1e6);
    o.normal_stiffness = random.log_uniform(1e-20, 1e20);
    if (random.below(3) == 0)
        o.tangential_stiffness = o.normal_stiffness * random.log_uniform(1e-6, 1e3);
    if (random.below(3))
        o.friction_coefficient =
            random.below(4) ? random.uniform(0.0, 1.5) : random.log_uniform(1e-9, 1e6);
    o.time_step = random.log_uniform(1e-12, 1.0);
    o.depth_max =
        size * (random.below(3) ? random.uniform(0.05, 1.0) : random.log_uniform(1e-9, 100.0));
    const Pair centre = {o.axisymmetric ? size * random.uniform(0.0, 3.0) : size * random.normal(),
                         size * random.normal()};
    const double other = random.below(2) ? size : size * random.log_uniform(0.05, 20.0);
    const double depth =
        random.below(4) ? size * random.uniform(-0.1, 0.4) : size * random.log_uniform(1e-12, 1.0);
    const double angle = random.uniform(0.0, 6.28), away = size + other - depth;
    call.a = random_line(random, centre, size, o.axisymmetric);
    call.b = random_line(random,
                         {centre[0] + away * std::cos(angle), centre[1] + away * std::sin(angle)},
                         other, o.axisymmetric);
    return call;
}

std::string line_text(const char* name, const Line& line) {
    std::string out =
        std::string("    enum { n") + name + " = " + std::to_string(line.x.size()) + " };\n";
    for (const auto& [what, values] :
         {std::pair{"x", &line.x}, {"v", &line.v}, {"h", &line.history}})
        out += std::string("    static double ") + what + name +
               "[] = " + numbers((*values)[0].data(), 2 * values->size()) + ";\n";
    return out + "    static double f" + name + "[2 * n" + name + "]; grit_penalty_surface s" +
           name + " = {sizeof s" + name + ", " + std::to_string(line.closed) + ", 0, n" + name +
           "};\n    s" + name + ".position = grit_view_of(x" + name + ", 2, 1); s" + name +
           ".velocity = grit_view_of(v" + name + ", 2, 1);\n    s" + name +
           ".history = grit_mutable_view_of(h" + name + ", 2, 1); s" + name +
           ".force = grit_mutable_view_of(f" + name + ", 2, 1);\n";
}

std::string program_of(const Call& call) {
    const grit_penalty_options& o = call.options;
    const double p[] = {o.normal_stiffness, o.tangential_stiffness, o.friction_coefficient,
                        o.depth_max, o.time_step};
    return "#include <grit/grit.h>\n#include <stdio.h>\nstatic double w[1 << 20];\nint main(void) "
           "{\n" +
           line_text("a", call.a) + line_text("b", call.b) + "    double p[] = " + numbers(p, 5) +
           ";\n    grit_penalty_options o; grit_penalty_options_init(&o, sizeof o); o.axisymmetric "
           "= " +
           std::to_string(o.axisymmetric) +
           ";\n    o.normal_stiffness = p[0]; o.tangential_stiffness = p[1]; "
           "o.friction_coefficient = "
           "p[2]; o.depth_max = p[3]; o.time_step = p[4];\n"
           "    grit_penalty_totals t = {sizeof t}; grit_error e = {0};\n"
           "    int status = grit_penalty_forces(&o, &sa, &sb, w, sizeof w, &t, &e);\n"
           "    printf(\"%d %s %.17g %.17g %.17g %.17g\\n\", status, e.message, t.force_on_a[0], "
           "t.force_on_a[1], t.force_on_b[0], t.force_on_b[1]);\n}\n";
}

double largest_force(const Call& call) {
    double out = 0.0;
    for (const Line* line : {&call.a, &call.b})
        for (const Pair& f : line->force) out = std::max({out, std::fabs(f[0]), std::fabs(f[1])});
    return out;
}

double difference(const Line& one, const Line& other) {
    double out = 0.0;
    for (std::size_t i = 0; i < one.force.size(); ++i)
        for (std::size_t c = 0; c < 2; ++c)
            out = std::max(out, std::fabs(one.force[i][c] - other.force[i][c]));
    return out;
}

void judge_lines(const Call& call, Findings& out, bool& all_finite, double& sum) {
    const auto program = [&] { return program_of(call); };
    for (const Line* line : {&call.a, &call.b})
        for (std::size_t i = 0; i < line->x.size(); ++i) {
            const grit_penalty_report& r = line->reports[i];
            for (const double f : line->force[i]) {
                all_finite = all_finite && std::isfinite(f);
                sum += std::fabs(f);
            }
            if (r.state == GRIT_PENALTY_OPEN) {
                out.demand(opens_clean, line->history[i] == Pair{}, program);
                continue;
            }
            out.count(vertices_in_contact);
            if (r.state == GRIT_PENALTY_SLIP) out.count(slipping);
            out.demand(presses_only, r.normal_traction >= 0.0, program);
            const double limit = call.options.friction_coefficient * r.normal_traction;
            const double excess = std::fabs(r.tangential_traction) - limit;
            if (limit > 0.0) out.measure(friction_excess, excess / limit);
            out.demand(obeys_coulomb, excess <= 1e-12 * limit, program);
        }
}

// A line in memory of any strides.
class Laid {
  public:
    Laid(Random& random, const Line& line)
        : n(static_cast<std::ptrdiff_t>(line.x.size())), position(random, n, 2),
          velocity(random, n, 2), history(random, n, 2), force(random, n, 2),
          stiffness(random, n, 1) {
        for (std::ptrdiff_t i = 0; i < n; ++i) {
            const auto at = static_cast<std::size_t>(i);
            position.put(i, line.x[at].data());
            velocity.put(i, line.v[at].data());
            history.put(i, line.history[at].data());
            force.put(i, line.force[at].data());
            stiffness.put(i, &line.stiffness[at]);
        }
    }
    grit_penalty_surface view(Line& line) const {
        grit_penalty_surface s = line.view();
        s.position = position.in();
        s.velocity = velocity.in();
        s.history = history.out();
        s.force = force.out();
        s.stiffness = stiffness.out();
        return s;
    }
    void take(Line& line) const {
        for (std::ptrdiff_t i = 0; i < n; ++i) {
            const auto at = static_cast<std::size_t>(i);
            history.get(i, line.history[at].data());
            force.get(i, line.force[at].data());
            stiffness.get(i, &line.stiffness[at]);
        }
    }

  private:
    std::ptrdiff_t n;
    Layout position, velocity, history, force, stiffness;
};

void judge_memory(Random& random, const Call& before, const Call& call, Findings& out) {
    Call laid = before;
    const Laid a(random, laid.a), b(random, laid.b);
    laid.run(random, a.view(laid.a), b.view(laid.b));
    a.take(laid.a);
    b.take(laid.b);
    out.demand(same_in_any_memory,
               laid.status == call.status && laid.a.same(call.a) && laid.b.same(call.b),
               [&] { return program_of(before); });
}

void try_call(Random& random, Findings& out) {
    const Call before = random_call(random);
    const auto program = [&] { return program_of(before); };
    Call call = before;
    call.run(random);
    out.count(calls);
    out.demand(known_status, call.status >= GRIT_OK && call.status <= GRIT_BAD_STATE, program);
    Call again = before;
    again.run(random);
    out.demand(same_again,
               again.status == call.status && again.a.same(call.a) && again.b.same(call.b),
               program);
    if (random.below(4) == 0) judge_memory(random, before, call, out);
    Call asked = before;
    asked.options.validate_only = 1;
    asked.run(random);
    out.demand(validates_alike,
               asked.status == call.status && asked.a.same(before.a) && asked.b.same(before.b) &&
                   asked.totals.contacts_a == call.totals.contacts_a,
               program);
    if (call.status != GRIT_OK) {
        out.count(refused);
        out.demand(untouched, call.a.same(before.a) && call.b.same(before.b), program);
        return;
    }
    if (call.totals.contacts_a + call.totals.contacts_b == 0) out.count(without_contact);
    bool all_finite = true;
    double sum = 0.0;
    judge_lines(call, out, all_finite, sum);
    out.demand(finite, all_finite, program);
    const grit_penalty_totals& t = call.totals;
    out.demand(energies_are_not_negative,
               t.energy_normal >= 0.0 && t.energy_tangential >= 0.0 && t.dissipation >= 0.0,
               program);
    if (!(sum > 1e-250)) return;
    Pair left{};
    for (const Line* line : {&call.a, &call.b})
        for (const Pair& f : line->force)
            for (std::size_t c = 0; c < 2; ++c) left[c] += f[c];
    const double error = std::fabs(left[0]) + std::fabs(left[1]);
    out.measure(reaction_error, error / sum);
    out.demand(action_is_reaction, error <= 1e-12 * sum, program);

    // The nearest of two places may be the other one by roundoff: told, not bounded.
    Call swapped = before;
    std::swap(swapped.a, swapped.b);
    swapped.run(random);
    const double most = largest_force(call);
    out.measure(swap_difference,
                std::max(difference(swapped.b, call.a), difference(swapped.a, call.b)) / most);
    // A whole number of binary digits away, along the axis: positions keep theirs.
    Call shifted = before;
    for (Line* line : {&shifted.a, &shifted.b})
        for (Pair& x : line->x) x[1] += 2.0 * call.options.depth_max;
    shifted.run(random);
    out.measure(shift_difference,
                std::max(difference(shifted.a, call.a), difference(shifted.b, call.b)) / most);
}

void run_penalty(Random& random, long cases, Findings& out) {
    for (long i = 0; i < cases; ++i) try_call(random, out);
}

}  // namespace

Kind penalty_trials() { return {"penalty", words, 20000, run_penalty}; }

}  // namespace robustness
