// SPDX-License-Identifier: BSD-3-Clause
#include "robustness/contact_trials.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <grit/grit.h>

#include "robustness/contact_many_trials.hpp"
#include "robustness/contact_node.hpp"
#include "robustness/layout.hpp"
#include "robustness/program_text.hpp"
#include "robustness/vec.hpp"

namespace robustness {
namespace contact {
namespace {

const Vocabulary words = {
    {"nodes corrected alone", "with one body", "open", "sticking", "slipping",
     "pressed by a spring", "refused", "in another state with a common velocity",
     "in another state when turned", "nodes of more bodies", "of these, refused",
     "of these, squeezed", "of these, pressed and settled",
     "of these, settled without the friction asked for", "of these, in rings with springs",
     "squeezed in other words only", "at another end of sweeps in other words"},
    {"momentum error over momentum",
     "energy gained over that of the relative motion",
     "friction above Coulomb's, over m_r |w|",
     "approach left beside (1 - f_p) of it, over |w|",
     "energy gained with that of a spring, over both",
     "impulse of a spring beside (C9), over its terms",
     "difference with bodies exchanged, over (1 + mu) velocities",
     "difference with a common velocity, over (1 + mu) velocities",
     "difference when turned, over (1 + mu) velocities",
     "momentum error of more bodies",
     "energy gained by more bodies, over that of relative motion",
     "work of impulses beside rigid bodies given, over its terms",
     "velocity that impulses of more bodies do not explain, over all on its way",
     "friction of more bodies above Coulomb's, over m_r times velocities",
     "approach left by more bodies beyond a tenth of the largest, over velocities",
     "normal impulse of more bodies beside (C7) and tolerance, over velocities",
     "friction of more bodies beside (C7) and tolerance, over velocities",
     "more bodies exchanged: difference over tolerance",
     "more bodies with a common velocity: difference over tolerance",
     "more bodies turned: difference over tolerance"},
    {"results are finite",
     "a refused node keeps its bits",
     "an open node keeps its bits",
     "a batch gives the bits of single calls, whatever its strides",
     "a status is one of a node's",
     "momentum is kept to 1e-15",
     "energy does not grow by more than 1e-14",
     "friction stays within Coulomb's limit to 1e-13 (1 + mu / 100)",
     "the normal impulse presses",
     "f_p of the approach is taken to 1e-14",
     "energy with that of a spring does not grow by more than 1e-14",
     "the impulse of a spring is that of (C9) to 1e-14",
     "bodies exchanged give the same to 1e-14 (1 + mu)",
     "a common velocity is not seen, to 1e-14 (1 + mu)",
     "turned nodes give turned velocities to 1e-13 (1 + mu)",
     "momentum of more bodies is kept to 1e-14",
     "energy of more bodies does not grow by 1e-12",
     "a rigid body keeps its bits among many",
     "impulses beside rigid bodies give no more work than 1e-12 of its terms",
     "reported impulses of more bodies explain their velocities to 1e-12",
     "a pair of more bodies that is apart has no impulse",
     "normal impulses of more bodies press",
     "friction of more bodies stays within Coulomb's limit to 1e-13 (1 + mu / 100)",
     "more bodies leave no more than a tenth of the largest approach",
     "settled normal impulses are those of pairs that the others leave, (C7)",
     "settled friction is that of pairs that the others leave, (C7)",
     "bodies are squeezed by two rigid ones only that move differently",
     "bodies may have any numbers, to the bit",
     "more bodies exchanged, without friction in any order, give the same",
     "a common velocity of more bodies is not seen",
     "more bodies turn along",
     "two bodies among many are a pair, to the bit",
     "a batch of more bodies gives the bits of single calls, whatever its strides",
     "nothing is written between the velocities of more bodies",
     "an error of more bodies names the first bad node",
     "sums of more bodies are those of single calls to the bit, and of reports"}};

constexpr int longest_batch = 31;

Call random_call(Random& random) {
    Call call;
    grit_contact_options& o = call.options;
    grit_contact_options_init(&o, sizeof o);
    o.components = 2 + random.below(2);
    o.law = random.below(2) ? GRIT_CONTACT_GEO : GRIT_CONTACT_FRICTIONAL;
    o.penalty_power = random.below(2) ? 6.0 : random.log_uniform(1e-6, 1e6);
    o.friction_coefficient = random.below(3) ? random.log_uniform(1e-6, 1e3) : 0.0;
    o.time_step = random.log_uniform(1e-12, 1e3);
    call.area = random.below(3) == 0;
    if (call.area) o.adhesion = random.below(2) ? random.log_uniform(1e-10, 1e10) : 0.0;
    o.mass_tolerance = random.below(2) ? 1e-10 : random.uniform(0.0, 0.499);
    o.rigid = random.below(4) ? GRIT_CONTACT_NONE_RIGID : 1 + random.below(2);
    o.instruction_set = 1 + random.below(grit_instruction_set());
    call.gap = random.below(3) == 0;
    if (call.gap) o.gap_tolerance = random.below(2) ? 0.0 : random.log_uniform(1e-12, 1.0);
    call.pore = random.below(4) == 0;
    if (o.law == GRIT_CONTACT_GEO && random.below(3) == 0)
        o.relaxation_time = random.log_uniform(1e-12, 1e3);
    if (o.law == GRIT_CONTACT_GEO && random.below(4) == 0) {
        call.gap = call.area = true;
        o.contact_stiffness = random.log_uniform(1e-15, 1e15);
    }
    return call;
}

}  // namespace

Node random_node(Random& random, const Call& call) {
    Node x;
    const int components = call.options.components;
    x.m_a = random.below(40) ? random.log_uniform(1e-30, 1e30) : 0.0;
    x.m_b = random.below(10) ? x.m_a * random.log_uniform(1e-12, 1e12)
                             : random.log_uniform(1e-250, 1e100);
    // Calls with a large tolerance would mostly find one body.
    const double least = call.options.mass_tolerance;
    if (least > 1e-6 && random.below(10))
        x.m_b = x.m_a * (1.0 / random.uniform(least, 1.0 - least) - 1.0);
    if (random.below(40) == 0) x.m_b = 0.0;
    x.normal = random_normal(random, components);
    x.cell = random.log_uniform(1e-6, 1e6);
    switch (random.below(6)) {
        case 0: x.distance = 0.0; break;
        case 1: x.distance = x.cell; break;
        case 2: x.distance = INFINITY; break;
        case 3: x.distance = -x.cell * random.log_uniform(1e-12, 1e3); break;
        default: x.distance = x.cell * random.uniform(0.0, 1.2);
    }
    x.gap = random.below(4) ? x.cell * random.uniform(-1.0, 1.0) : 0.0;
    x.area = random.log_uniform(1e-12, 1e6);
    const double speed = random.log_uniform(1e-12, 1e6);
    for (Vec* v : {&x.v_a, &x.v_b}) {
        *v = random_vector(random, components);
        for (double& each : *v) each *= speed;
    }
    const double away = std::pow(10.0, random.uniform(-14.0, 0.0));
    switch (random.below(8)) {
        case 0:  // nearly together
            x.v_b = plus(x.v_a, away * speed, random_vector(random, components));
            break;
        case 1:  // along the normal
            x.v_b = plus(x.v_a, -speed * away, x.normal);
            break;
        case 2: x.v_b = x.v_a; break;
        case 3: x.v_a = x.v_b = {}; break;
        default: break;
    }
    if (random.below(2) && dot(x.w(), x.normal) < 0.0) std::swap(x.v_a, x.v_b);  // they approach
    x.pore = (random.below(2) ? 1.0 : -1.0) * x.m_r() * speed * random.log_uniform(1e-6, 10.0);
    if (!std::isfinite(x.pore)) x.pore = 0.0;
    if (random.below(100) == 0) {
        const double bad[] = {NAN, INFINITY, -INFINITY, 1e308, -1e308, 4.9e-324, -1.0};
        double* const member[] = {&x.m_a,  &x.m_b,       &x.distance, &x.cell,  &x.gap,
                                  &x.area, &x.normal[0], &x.v_a[1],   &x.v_b[0]};
        *member[random.below(9)] = bad[random.below(7)];
    }
    return x;
}

namespace {

grit_contact_nodes views_of(const Call& call, Node& x) {
    grit_contact_nodes q{};
    q.struct_size = sizeof q;
    q.mass_a = grit_view_of(&x.m_a, 1, 1);
    q.mass_b = grit_view_of(&x.m_b, 1, 1);
    q.normal = grit_view_of(x.normal.data(), 3, 1);
    q.distance = grit_view_of(&x.distance, 1, 1);
    q.cell_size = grit_view_of(&x.cell, 1, 1);
    if (call.gap) q.gap = grit_view_of(&x.gap, 1, 1);
    if (call.area) q.contact_area = grit_view_of(&x.area, 1, 1);
    if (call.pore) q.pore_impulse = grit_view_of(&x.pore, 1, 1);
    q.velocity_a = grit_mutable_view_of(x.v_a.data(), 3, 1);
    q.velocity_b = grit_mutable_view_of(x.v_b.data(), 3, 1);
    return q;
}

}  // namespace

void correct(const Call& call, Node& x) {
    const grit_contact_nodes q = views_of(call, x);
    grit_contact_correct(&call.options, 1, &q, &x.report, nullptr, nullptr);
}

namespace {

void correct_together(Random& random, const Call& call, std::vector<Node>& all) {
    const auto n = static_cast<std::ptrdiff_t>(all.size());
    const std::ptrdiff_t places = n + random.below(3);
    const std::vector<std::ptrdiff_t> index = shuffled(random, places);
    const int c = call.options.components;
    bool common = true;  // normals and cells
    for (const Node& x : all)
        common = common && same(x.normal, all[0].normal) && x.cell == all[0].cell;
    Layout m_a(random, places, 1), m_b(random, places, 1), normal(random, places, c),
        distance(random, places, 1), cell(random, places, 1), gap(random, places, 1),
        area(random, places, 1), pore(random, places, 1), v_a(random, places, c),
        v_b(random, places, c);
    for (std::ptrdiff_t i = 0; i < n; ++i) {
        const Node& x = all[static_cast<std::size_t>(i)];
        const std::ptrdiff_t at = index[static_cast<std::size_t>(i)];
        m_a.put(at, &x.m_a);
        m_b.put(at, &x.m_b);
        normal.put(at, x.normal.data());
        distance.put(at, &x.distance);
        cell.put(at, &x.cell);
        gap.put(at, &x.gap);
        area.put(at, &x.area);
        pore.put(at, &x.pore);
        v_a.put(at, x.v_a.data());
        v_b.put(at, x.v_b.data());
    }
    grit_contact_nodes q{};
    q.struct_size = sizeof q;
    q.index = index.data();
    q.mass_a = m_a.in();
    q.mass_b = m_b.in();
    q.normal = normal.in();
    q.distance = distance.in();
    q.cell_size = cell.in();
    if (common) {
        q.normal = grit_view_of(all[0].normal.data(), 0, 1);
        q.cell_size = grit_view_of(&all[0].cell, 0, 1);
    }
    if (call.gap) q.gap = gap.in();
    if (call.area) q.contact_area = area.in();
    if (call.pore) q.pore_impulse = pore.in();
    q.velocity_a = v_a.out();
    q.velocity_b = v_b.out();
    std::vector<grit_contact_report> reports(all.size());
    grit_contact_correct(&call.options, n, &q, reports.data(), nullptr, nullptr);
    for (std::ptrdiff_t i = 0; i < n; ++i) {
        Node& x = all[static_cast<std::size_t>(i)];
        const std::ptrdiff_t at = index[static_cast<std::size_t>(i)];
        v_a.get(at, x.v_a.data());
        v_b.get(at, x.v_b.data());
        x.report = reports[static_cast<std::size_t>(i)];
    }
}

bool same_motion(const Node& a, const Node& b) { return same(a.v_a, b.v_a) && same(a.v_b, b.v_b); }

}  // namespace

std::string program_of(const Call& call, const Node& x) {
    const grit_contact_options& o = call.options;
    const double scalars[] = {x.m_a, x.m_b, x.distance, x.cell, x.gap, x.area, x.pore};
    const double options[] = {o.penalty_power,   o.friction_coefficient, o.adhesion,
                              o.time_step,       o.mass_tolerance,       o.gap_tolerance,
                              o.relaxation_time, o.contact_stiffness};
    return "#include <grit/grit.h>\n#include <stdio.h>\nint main(void) {\n    double s[] = " +
           numbers(scalars, 7) + ";\n    double n[] = " + numbers(x.normal.data(), 3) +
           ", a[] = " + numbers(x.v_a.data(), 3) + ", b[] = " + numbers(x.v_b.data(), 3) +
           ";\n    double p[] = " + numbers(options, 8) +
           ";\n    grit_contact_options o; grit_contact_options_init(&o, sizeof o);\n    "
           "o.components = " +
           std::to_string(o.components) + "; o.law = " + std::to_string(o.law) +
           "; o.rigid = " + std::to_string(o.rigid) +
           "; o.instruction_set = " + std::to_string(o.instruction_set) +
           ";\n    o.penalty_power = p[0]; o.friction_coefficient = p[1]; o.adhesion = p[2]; "
           "o.time_step = p[3];\n"
           "    o.mass_tolerance = p[4]; o.gap_tolerance = p[5]; o.relaxation_time = p[6];\n"
           "    o.contact_stiffness = p[7];\n"
           "    grit_contact_nodes q = {sizeof q};\n"
           "    q.mass_a = grit_view_of(s, 1, 1); q.mass_b = grit_view_of(s + 1, 1, 1); q.normal = "
           "grit_view_of(n, 3, 1);\n"
           "    q.distance = grit_view_of(s + 2, 1, 1); q.cell_size = grit_view_of(s + 3, 1, "
           "1);\n" +
           (call.gap ? "    q.gap = grit_view_of(s + 4, 1, 1);\n" : "") +
           (call.area ? "    q.contact_area = grit_view_of(s + 5, 1, 1);\n" : "") +
           (call.pore ? "    q.pore_impulse = grit_view_of(s + 6, 1, 1);\n" : "") +
           "    q.velocity_a = grit_mutable_view_of(a, 3, 1); q.velocity_b = "
           "grit_mutable_view_of(b, 3, 1);\n"
           "    grit_contact_report r; grit_error e = {0}; grit_contact_correct(&o, 1, &q, &r, 0, "
           "&e);\n"
           "    printf(\"status %d state %d f_p %.17g J %.17g %.17g %.17g %s\\n\", r.status, "
           "r.state, r.penalty_factor,\n"
           "           r.impulse[0], r.impulse[1], r.impulse[2], e.message);\n"
           "    for (int c = 0; c < 3; ++c) printf(\"%.17g %.17g\\n\", a[c], b[c]);\n}\n";
}

namespace {}  // namespace

Vec impulse_of(const grit_contact_report& r) { return {r.impulse[0], r.impulse[1], r.impulse[2]}; }

double reduced_mass(const Call& call, const Node& x) {
    switch (call.options.rigid) {
        case GRIT_CONTACT_A_RIGID: return x.m_b;
        case GRIT_CONTACT_B_RIGID: return x.m_a;
        default: return x.m_r();
    }
}

double coulomb_limit(const Call& call, const Node& x, const grit_contact_report& r, double J_n,
                     double size) {
    const grit_contact_options& o = call.options;
    const double rubs = std::max(0.0, J_n - (call.pore ? x.pore / size : 0.0));
    const double sticks =
        o.adhesion > 0.0 ? r.penalty_factor * o.adhesion * x.area * o.time_step / size : 0.0;
    return o.friction_coefficient * rubs + sticks;
}

double friction_excess_of(const Call& call, const Node& x, const grit_contact_report& r,
                          double size) {
    const Vec J = impulse_of(r), share = {J[0] / size, J[1] / size, J[2] / size};
    const double J_n = dot(share, x.normal), J_t = norm(plus(share, -J_n, x.normal));
    const double limit = coulomb_limit(call, x, r, J_n, size);
    return (J_t - limit) / (1.0 + limit);
}

double stiffness_of(const Call& call, const Node& x, double m_r) {
    const double dt = call.options.time_step;
    return call.options.contact_stiffness * x.area * dt / m_r * dt;
}

// (C9): both sides times 1 - f_p: spring and dashpot, implicit.
Answer answer_of(const Call& call, const Node& x, double f, double m_r) {
    const grit_contact_options& o = call.options;
    if (o.contact_stiffness == 0.0) return {f, 0.0};
    const double dt = o.time_step, part = o.relaxation_time > 0.0 ? dt / o.relaxation_time : 1.0,
                 stiff = stiffness_of(call, x, m_r), overlap = std::max(-x.gap, 0.0);
    const double whole = 1.0 - f + f * part + (1.0 - f) * stiff;
    return {(f * part + (1.0 - f) * stiff) / whole, (1.0 - f) * stiff * (overlap / dt) / whole};
}

namespace {

void judge_spring(const Call& call, const Node& x, const Node& y, double m_r, double J_n,
                  Findings& out) {
    const double stiff = stiffness_of(call, x, m_r), dt = call.options.time_step,
                 overlap = std::max(-x.gap, 0.0);
    if (!measurable(stiff)) return;
    const auto program = [&] { return program_of(call, x); };
    out.count(sprung);
    const Answer answer = answer_of(call, x, y.report.penalty_factor, m_r);
    const double pushed = answer.pushed, taken = answer.share * dot(x.w(), x.normal);
    const double speeds = norm(x.v_a) + norm(x.v_b);
    // Hosts may give |n|^2 within 1e-6 of 1.
    const double off_unit = std::fabs(dot(x.normal, x.normal) - 1.0);
    const double error =
        std::fabs(J_n / m_r - taken - pushed) / (pushed + std::fabs(taken) + speeds) - off_unit;
    out.measure(spring_error, error);
    out.demand(spring_as_told, error <= 1e-14, program);
    // Velocities as lengths of a step, so that no square is too large.
    const auto energy = [&](const Vec& w, double depth) {
        return std::hypot(norm(w), std::sqrt(stiff) * (depth / dt));
    };
    const double now = dot(y.w(), x.normal);
    const double before = energy(x.w(), overlap), after = energy(y.w(), overlap + now * dt);
    // What w and the depth have lost to roundoff.
    const double lost =
        (1e-15 + off_unit) * (speeds + norm(y.v_a) + norm(y.v_b)) * (1.0 + std::sqrt(stiff)) +
        4e-16 * std::sqrt(stiff) * (overlap / dt);
    const double gain = (after - before - lost) / (before + lost);
    out.measure(spring_energy_gain, gain);
    out.demand(spring_gains_no_energy, gain <= 1e-14, program);
}

void judge(const Call& call, const Node& x, const Node& y, Findings& out) {
    const auto program = [&] { return program_of(call, x); };
    const grit_contact_report& r = y.report;
    out.count(nodes);
    if (r.status != GRIT_OK) {
        out.count(refused);
        out.demand(known_status, r.status == GRIT_BAD_STATE, program);
        out.demand(untouched, same_motion(x, y), program);
        return;
    }
    out.demand(known_status, r.state >= GRIT_CONTACT_INACTIVE && r.state <= GRIT_CONTACT_SLIP,
               program);
    out.count(inactive + r.state);
    if (r.state <= GRIT_CONTACT_OPEN) {
        out.demand(open_untouched, same_motion(x, y), program);
        return;
    }
    const Vec J = impulse_of(r);
    out.demand(finite, all_finite(y.v_a) && all_finite(y.v_b) && all_finite(J), program);
    const bool springs = call.options.contact_stiffness > 0.0;
    const double speeds = norm(x.v_a) + norm(x.v_b);
    if (speeds < smallest_number) return;
    const double m_r = reduced_mass(call, x);
    // A spring pushes bodies apart that had no relative velocity, and by less than their velocities show.
    const double before = springs ? norm(x.w()) + norm(y.w()) + norm(J) / m_r : norm(x.w());
    if (call.options.rigid == GRIT_CONTACT_NONE_RIGID) {
        double error = 0.0, size = 0.0;
        for (std::size_t c = 0; c < 3; ++c) {
            error += std::fabs(x.m_a * (y.v_a[c] - x.v_a[c]) + x.m_b * (y.v_b[c] - x.v_b[c]));
            size += x.m_a * (std::fabs(x.v_a[c]) + std::fabs(y.v_a[c])) +
                    x.m_b * (std::fabs(x.v_b[c]) + std::fabs(y.v_b[c]));
        }
        out.measure(momentum_error, error / size);
        out.demand(keeps_momentum, error <= 1e-15 * size, program);
    }
    const double roundoff = 4e-16 * speeds / before;  // of w itself
    if (springs) {
        judge_spring(call, x, y, m_r, dot(J, x.normal), out);
    } else {
        const double gain = norm(y.w()) / before - 1.0;
        out.measure(energy_gain, gain - roundoff);
        out.demand(gains_no_energy, gain <= 1e-14 + roundoff, program);
    }
    // Impulses over m_r |w|, whose squares may be too small for numbers.
    const double size = m_r * before, w_n = dot(x.w(), x.normal);
    if (!(size > smallest_number)) return;
    out.demand(pushes_only, dot(J, x.normal) >= -1e-14 * size, program);
    const double excess = friction_excess_of(call, x, r, size);
    // A normal is as long as it is told to be, and the limit takes the roundoff of J_n times mu.
    const double stretched = std::fabs(dot(x.normal, x.normal) - 1.0),
                 rough = 1.0 + 0.01 * call.options.friction_coefficient;
    out.measure(friction_excess, excess / rough - roundoff - stretched);
    out.demand(obeys_coulomb, excess <= (1e-13 + stretched) * rough + 4.0 * roundoff, program);
    if (call.options.relaxation_time == 0.0 && !springs) {
        const double left =
            std::fabs(dot(y.w(), x.normal) - (1.0 - r.penalty_factor) * w_n) / before;
        out.measure(approach_left, left - roundoff - stretched);
        out.demand(closes_as_told, left <= 1e-14 + 4.0 * roundoff + stretched, program);
    }
}

double apart(const Node& a, const Vec& v_a, const Vec& v_b) {
    return norm(plus(a.v_a, -1.0, v_a)) + norm(plus(a.v_b, -1.0, v_b));
}

// What a node must give in other words: with the bodies exchanged, in another frame, turned.
void judge_in_other_words(const Call& call, const Node& x, const Node& y, Random& random,
                          Findings& out) {
    if (y.report.status != GRIT_OK || y.report.state <= GRIT_CONTACT_OPEN) return;
    const auto program = [&] { return program_of(call, x); };
    // A spring gives what was not there.
    const double speeds = std::max(norm(x.v_a) + norm(x.v_b), norm(y.v_a) + norm(y.v_b));
    if (norm(x.v_a) + norm(x.v_b) < smallest_number) return;

    Node exchanged = x;
    std::swap(exchanged.m_a, exchanged.m_b);
    std::swap(exchanged.v_a, exchanged.v_b);
    for (double& each : exchanged.normal) each = -each;
    Call other = call;
    if (call.options.rigid != GRIT_CONTACT_NONE_RIGID) other.options.rigid = 3 - call.options.rigid;
    correct(other, exchanged);
    const double swapped = apart(y, exchanged.v_b, exchanged.v_a) / speeds;
    const double rough = 1.0 + call.options.friction_coefficient;
    out.measure(swap_error, swapped / rough);
    out.demand(does_not_see_names,
               exchanged.report.state == y.report.state && swapped <= 1e-14 * rough, program);

    // Roundoff may decide between what is close: opening, sticking, slipping. Velocities do not jump there, but
    // where adhesion or suction begins: next to nothing presses then.
    const double J_n = dot(impulse_of(y.report), x.normal) / reduced_mass(call, x);
    const auto stays = [&](const Node& z, Count edge, double difference, double least) {
        if (z.report.state != y.report.state) out.count(edge);
        const bool rubs_unpressed = call.options.adhesion > 0.0 || (call.pore && x.pore < 0.0);
        const bool jumps = rubs_unpressed && z.report.state <= GRIT_CONTACT_OPEN;
        return jumps ? J_n <= least * (speeds + norm(z.v_a)) : difference <= least * rough;
    };
    Node moving = x;
    const double speed = std::min(speeds, 10.0 * norm(x.w()));
    Vec common = random_vector(random, call.options.components);
    for (double& each : common) each *= speed;
    moving.v_a = plus(moving.v_a, 1.0, common);
    moving.v_b = plus(moving.v_b, 1.0, common);
    correct(call, moving);
    const double seen = apart(y, plus(moving.v_a, -1.0, common), plus(moving.v_b, -1.0, common)) /
                        (speeds + norm(common));
    out.measure(galilei_error, seen / rough);
    out.demand(does_not_see_common_velocity, stays(moving, moved_to_edge, seen, 1e-14), program);

    const double angle = random.uniform(0.0, 6.283185307179586);
    Node aside = x;
    for (Vec* each : {&aside.normal, &aside.v_a, &aside.v_b}) *each = turned(*each, angle);
    correct(call, aside);
    const double off = apart(aside, turned(y.v_a, angle), turned(y.v_b, angle)) / speeds;
    out.measure(turn_error, off / rough);
    out.demand(turns_along, stays(aside, turned_to_edge, off, 1e-13), program);
}

void run_contact(Random& random, long cases, Findings& out) {
    for (long tried = 0; tried < cases;) {
        const Call call = random_call(random);
        const auto n = static_cast<std::size_t>(
            std::min<long>(1 + random.below(longest_batch), cases - tried));
        std::vector<Node> before, alone, together;
        for (std::size_t i = 0; i < n; ++i) before.push_back(random_node(random, call));
        // A plane through all nodes: one normal and one cell for all, by strides of 0.
        if (random.below(4) == 0)
            for (Node& x : before) {
                x.distance = std::min(x.distance, 2.0 * before[0].cell);
                x.normal = before[0].normal;
                x.cell = before[0].cell;
            }
        alone = together = before;
        for (Node& x : alone) correct(call, x);
        correct_together(random, call, together);
        for (std::size_t i = 0; i < n; ++i) {
            judge(call, before[i], alone[i], out);
            out.demand(same_bits,
                       same_motion(alone[i], together[i]) &&
                           alone[i].report.status == together[i].report.status &&
                           alone[i].report.state == together[i].report.state,
                       [&] { return program_of(call, before[i]); });
            if (random.below(8) == 0) judge_in_other_words(call, before[i], alone[i], random, out);
        }
        if (random.below(4) == 0) try_many(call, random, out);
        tried += static_cast<long>(n);
    }
}

}  // namespace
}  // namespace contact

Kind contact_trials() { return {"contact", contact::words, 1000000, contact::run_contact}; }

}  // namespace robustness
