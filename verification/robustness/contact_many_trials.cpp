// SPDX-License-Identifier: BSD-3-Clause
#include "robustness/contact_many_trials.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <tuple>
#include <utility>
#include <vector>

#include "robustness/layout.hpp"
#include "robustness/program_text.hpp"

namespace robustness::contact {
namespace {

struct ManyCall {
    Call call;
    std::vector<bool> rigid;                 // of the bodies
    std::vector<std::pair<int, int>> pairs;  // bodies A and B
    double sweep_tolerance = 0.0;
    int sweep_limit = 0;

    int count() const { return static_cast<int>(rigid.size()); }
    double tolerance() const { return sweep_tolerance > 0.0 ? sweep_tolerance : 1e-3; }
    // Twice what normal impulses may leave, as a share of the largest approach.
    double left() const { return 2.0 * std::max(1e-6 * tolerance(), 1e-13); }
    bool rubs() const {
        return call.options.friction_coefficient > 0.0 || call.options.adhesion > 0.0;
    }
    std::size_t a(std::size_t k) const { return static_cast<std::size_t>(pairs[k].first); }
    std::size_t b(std::size_t k) const { return static_cast<std::size_t>(pairs[k].second); }
    Call of_pair(std::size_t k) const {
        Call one = call;
        one.options.rigid = rigid[a(k)]   ? GRIT_CONTACT_A_RIGID
                            : rigid[b(k)] ? GRIT_CONTACT_B_RIGID
                                          : GRIT_CONTACT_NONE_RIGID;
        return one;
    }
};

// A node where several bodies meet.
struct Many {
    std::vector<double> mass;
    std::vector<Vec> velocity;
    std::vector<Node> between;  // of each pair, masses and velocities not kept
    grit_status status = GRIT_OK;
    bool parallel = false;  // are there normals that are one, or nearly?
    bool alike = false;     // that are nearly one?

    // Of velocities: normals that differ by less than 1e-6, or 1e-4 where digits do not tell them apart, are one.
    double roundoff() const { return alike ? 1e-4 : 1e-13; }
    Node pair(const ManyCall& call, std::size_t k) const {
        Node x = between[k];
        x.m_a = mass[call.a(k)];
        x.m_b = mass[call.b(k)];
        x.v_a = velocity[call.a(k)];
        x.v_b = velocity[call.b(k)];
        return x;
    }
};

using Sums = std::vector<grit_contact_sums>;  // of each pair

// What a call for many nodes has given, beside velocities and reports.
struct Together {
    std::vector<std::ptrdiff_t> index;  // of the nodes
    Sums sums;
    grit_status status;
    grit_error error;
    bool kept;  // what lies between what is written
};

constexpr int most_nodes = 70;

// Two to eight bodies, up to two of them rigid.
ManyCall random_many_call(const Call& call, Random& random) {
    ManyCall many;
    many.call = call;
    many.call.options.rigid = GRIT_CONTACT_NONE_RIGID;
    if (random.below(4)) many.call.options.mass_tolerance = 0.0;
    const int count = random.below(16) ? 2 + random.below(4) : 6 + random.below(3);
    many.rigid.assign(static_cast<std::size_t>(count), false);
    const int rigid = random.below(4) ? 0 : 1 + random.below(2);
    for (int i = 0; i < rigid; ++i) many.rigid[static_cast<std::size_t>(i)] = true;
    for (int a = 0; a < count; ++a)
        for (int b = std::max(a + 1, rigid); b < count; ++b) {
            if (count > 2 && random.below(3) == 0) continue;
            many.pairs.emplace_back(a, b);
            if (random.below(2)) std::swap(many.pairs.back().first, many.pairs.back().second);
        }
    if (random.below(2)) many.sweep_tolerance = random.log_uniform(1e-10, 1.0);
    if (random.below(2)) many.sweep_limit = 1 + random.below(200);
    return many;
}

Many random_many(const ManyCall& call, Random& random) {
    Many x;
    const int c = call.call.options.components;
    const double scale = random.log_uniform(1e-20, 1e20), speed = random.log_uniform(1e-9, 1e6);
    const double spread = random.below(8) ? 1e4 : random.log_uniform(1.0, 1e10);
    for (int i = 0; i < call.count(); ++i) {
        x.mass.push_back(scale * random.log_uniform(1.0 / spread, spread));
        x.velocity.push_back(random_vector(random, c));
        for (double& each : x.velocity.back()) each *= speed;
    }
    if (random.below(20) == 0) x.mass[static_cast<std::size_t>(random.below(call.count()))] = 0.0;
    const double away = std::pow(10.0, random.uniform(-14.0, 0.0));
    const int motion = random.below(16);
    for (std::size_t i = 1; i < x.velocity.size(); ++i) {
        if (motion == 0)  // nearly together
            x.velocity[i] = plus(x.velocity[0], away * speed, random_vector(random, c));
        if (motion == 1) x.velocity[i] = {};
    }
    if (call.rigid[1] && random.below(3) == 0) x.velocity[1] = x.velocity[0];
    std::vector<Vec> directions;  // none: any
    if (random.below(4) == 0)
        for (int i = 1 + random.below(3); i > 0; --i)
            directions.push_back(unit(random_vector(random, c)));
    for (std::size_t k = 0; k < call.pairs.size(); ++k) {
        Node y;
        y.normal = unit(random_vector(random, c));
        if (!directions.empty()) {
            const auto at =
                static_cast<std::size_t>(random.below(static_cast<int>(directions.size())));
            const double angle =
                random.below(2) ? std::pow(10.0, random.uniform(-12.0, -3.0)) : 0.0;
            y.normal = turned(directions[at], angle);
            if (random.below(2))
                for (double& each : y.normal) each = -each;
        }
        if (random.below(2)) y.cell = random.log_uniform(1e-3, 1e3);
        y.distance = y.cell * random.uniform(-0.5, 1.2);
        y.gap = y.cell * random.uniform(-1.0, 0.5);
        y.area = random.log_uniform(1e-6, 1.0);
        y.pore = (random.below(2) ? 1.0 : -1.0) * scale * speed * random.log_uniform(1e-6, 10.0);
        x.between.push_back(y);
    }
    return x;
}

void compare_normals(Many& x) {
    x.alike = x.parallel = false;
    for (std::size_t k = 0; k < x.between.size(); ++k)
        for (std::size_t l = 0; l < k; ++l) {
            const Vec &n = x.between[k].normal, &m = x.between[l].normal;
            const double off = norm(plus(n, dot(n, m) < 0.0 ? 1.0 : -1.0, m));
            x.parallel = x.parallel || off < 1e-3;
            x.alike = x.alike || (off > 0.0 && off < 1e-3);
        }
}

void spoil(Many& x, Random& random) {
    const double bad[] = {NAN, INFINITY, -INFINITY, 1e308, -1e308, 4.9e-324, -1.0};
    const auto body = static_cast<std::size_t>(random.below(static_cast<int>(x.mass.size())));
    Node& y = x.between[static_cast<std::size_t>(random.below(static_cast<int>(x.between.size())))];
    double* const member[] = {&x.mass[body],
                              &x.velocity[body][0],
                              &x.velocity[body][1],
                              &y.normal[1],
                              &y.distance,
                              &y.cell,
                              &y.gap,
                              &y.area,
                              &y.pore};
    double& one = *member[random.below(9)];
    one = bad[random.below(7)];
}

// What a call takes beside the views of its bodies and pairs.
struct Arguments {
    std::vector<grit_contact_options> options;
    std::vector<grit_contact_pair> pairs;
    std::vector<grit_view> mass;
    std::vector<grit_mutable_view> velocity;
    grit_contact_bodies bodies{};

    explicit Arguments(const ManyCall& call) : pairs(call.pairs.size()) {
        for (std::size_t k = 0; k < pairs.size(); ++k) options.push_back(call.of_pair(k).options);
        for (std::size_t k = 0; k < pairs.size(); ++k) {
            pairs[k].struct_size = sizeof pairs[k];
            std::tie(pairs[k].a, pairs[k].b) = call.pairs[k];
            pairs[k].options = &options[k];
        }
        bodies.struct_size = sizeof bodies;
        bodies.components = call.call.options.components;
        bodies.count = call.count();
        bodies.instruction_set = call.call.options.instruction_set;
        bodies.sweep_tolerance = call.sweep_tolerance;
        bodies.sweep_limit = call.sweep_limit;
    }
    grit_status correct(std::ptrdiff_t n, grit_contact_report* reports, grit_contact_sums* sums,
                        grit_error* error) {
        bodies.mass = mass.data();
        bodies.velocity = velocity.data();
        return grit_contact_correct_many(&bodies, static_cast<int>(pairs.size()), pairs.data(), n,
                                         reports, sums, error);
    }
};

// What lies between two bodies, by number: the normal, then one number each.
constexpr int pair_numbers = 6;
const double* number_of(const Node& x, int each) {
    const double* numbers[pair_numbers] = {x.normal.data(), &x.distance, &x.cell,
                                           &x.gap,          &x.area,     &x.pore};
    return numbers[each];
}

template <class ViewOf>
void give_pair(const Call& call, grit_contact_pair& pair, const ViewOf& view_of) {
    pair.normal = view_of(0);
    pair.distance = view_of(1);
    pair.cell_size = view_of(2);
    if (call.gap) pair.gap = view_of(3);
    if (call.area) pair.contact_area = view_of(4);
    if (call.pore) pair.pore_impulse = view_of(5);
}

// sums: null or added to.
void correct(const ManyCall& call, Many& x, Sums* sums = nullptr) {
    Arguments arguments(call);
    for (std::size_t i = 0; i < x.mass.size(); ++i) {
        arguments.mass.push_back(grit_view_of(&x.mass[i], 1, 1));
        arguments.velocity.push_back(grit_mutable_view_of(x.velocity[i].data(), 3, 1));
    }
    for (std::size_t k = 0; k < x.between.size(); ++k)
        give_pair(call.call, arguments.pairs[k],
                  [&](int each) { return grit_view_of(number_of(x.between[k], each), 3, 1); });
    std::vector<grit_contact_report> reports(x.between.size());
    x.status = arguments.correct(1, reports.data(), sums ? sums->data() : nullptr, nullptr);
    for (std::size_t k = 0; k < reports.size(); ++k) x.between[k].report = reports[k];
}

bool same_report(const grit_contact_report& a, const grit_contact_report& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

bool same_reports(const Many& x, const Many& y) {
    const auto same_of = [](const Node& a, const Node& b) {
        return same_report(a.report, b.report);
    };
    return std::equal(x.between.begin(), x.between.end(), y.between.begin(), same_of);
}

bool same_states(const Many& x, const Many& y) {
    const auto count_of = [](const Many& all, int state) {
        return std::count_if(all.between.begin(), all.between.end(),
                             [&](const Node& each) { return each.report.state == state; });
    };
    for (const int state : {GRIT_CONTACT_OPEN, GRIT_CONTACT_STICK, GRIT_CONTACT_SLIP})
        if (count_of(x, state) != count_of(y, state)) return false;
    return true;
}

bool same_motion(const Many& x, const Many& y) {
    return std::equal(x.velocity.begin(), x.velocity.end(), y.velocity.begin(), same);
}

std::string program_of(const ManyCall& call, const Many& x) {
    std::string text = program_of(call.of_pair(0), x.pair(call, 0)) + "/* sweep tolerance " +
                       number_text(call.sweep_tolerance) + " limit " +
                       std::to_string(call.sweep_limit) + " bodies:";
    for (std::size_t i = 0; i < x.mass.size(); ++i)
        text += (call.rigid[i] ? " rigid m " : " m ") + number_text(x.mass[i]) + " v " +
                numbers(x.velocity[i].data(), 3);
    for (std::size_t k = 0; k < x.between.size(); ++k) {
        const Node& y = x.between[k];
        text += " pair " + std::to_string(call.pairs[k].first) + '-' +
                std::to_string(call.pairs[k].second) + " n " + numbers(y.normal.data(), 3) + " s " +
                number_text(y.distance) + " cell " + number_text(y.cell) + " gap " +
                number_text(y.gap) + " area " + number_text(y.area) + " pore " +
                number_text(y.pore);
    }
    return text + " */\n";
}

bool active(const Call& call, const Node& x) {
    const double no_mass = 1e-200;
    const double least = call.options.rigid == GRIT_CONTACT_NONE_RIGID
                             ? std::max(call.options.mass_tolerance * (x.m_a + x.m_b), no_mass)
                             : no_mass;
    return x.m_a > least && x.m_b > least;
}

// (C4)
double penalty_factor(const Call& call, const Node& x) {
    const grit_contact_options& o = call.options;
    if (o.law == GRIT_CONTACT_FRICTIONAL) return 1.0;
    const bool in_time = o.relaxation_time > 0.0 && o.contact_stiffness == 0.0;
    const double k = o.penalty_power * (in_time ? o.time_step / o.relaxation_time : 1.0);
    return 1.0 - std::pow(std::min(std::max(x.distance, 0.0), x.cell) / x.cell, k);
}

// (C3) and (C4): would they touch if they approached?
bool near(const Call& call, const Node& x) {
    const bool closed = !call.gap || x.gap <= call.options.gap_tolerance;
    return closed && (call.options.law == GRIT_CONTACT_FRICTIONAL || x.distance < x.cell);
}

double share_of(double part, double whole) {
    return whole > 0.0 ? part / whole : part > 0.0 ? INFINITY : 0.0;
}

// Beside what roundoff of its velocity is small: all that its velocity has been on the way, in a frame of that speed.
std::vector<double> sizes_of(const ManyCall& call, const Many& x, const Many& y,
                             double common = 0.0) {
    std::vector<double> sizes;
    for (std::size_t i = 0; i < x.mass.size(); ++i)
        sizes.push_back(norm(x.velocity[i]) + norm(y.velocity[i]) + common);
    for (std::size_t k = 0; k < y.between.size(); ++k)
        for (const std::size_t i : {call.a(k), call.b(k)})
            if (!call.rigid[i] && x.mass[i] > 0.0)
                sizes[i] += norm(impulse_of(y.between[k].report)) / x.mass[i];
    return sizes;
}

// A pair that is near, after all impulses.
struct Meeting {
    Call call;
    Node before;
    grit_contact_report report;
    Answer answer;
    Vec J, w;         // w: that the others leave
    double m_r, u_n;  // J_n / m_r
    double rough;     // velocity beside which roundoff is small
    double too_fast;  // approach beyond that of its J_n, (C5) or (C9)
};

std::vector<Meeting> meetings_of(const ManyCall& call, const Many& x, const Many& y) {
    const std::vector<double> sizes = sizes_of(call, x, y);
    std::vector<Meeting> meetings;
    for (std::size_t k = 0; k < x.between.size(); ++k) {
        Meeting m{};
        m.call = call.of_pair(k);
        m.before = x.pair(call, k);
        if (!active(m.call, m.before) || !near(m.call, m.before)) continue;
        m.report = y.between[k].report;
        m.m_r = reduced_mass(m.call, m.before);
        const double f_p = m.report.state > GRIT_CONTACT_OPEN ? m.report.penalty_factor
                                                              : penalty_factor(m.call, m.before);
        m.answer = answer_of(m.call, m.before, f_p, m.m_r);
        m.J = impulse_of(m.report);
        if (m.answer.share == 0.0) continue;
        m.w = plus(plus(y.velocity[call.a(k)], -1.0, y.velocity[call.b(k)]), 1.0 / m.m_r, m.J);
        m.u_n = dot(m.J, m.before.normal) / m.m_r;
        m.rough = (sizes[call.a(k)] + sizes[call.b(k)] + m.answer.pushed) / m.answer.share;
        m.too_fast = dot(m.w, m.before.normal) - (m.u_n - m.answer.pushed) / m.answer.share;
        meetings.push_back(m);
    }
    return meetings;
}

// Of those that meet; of springs what they give.
double largest_approach(const std::vector<Meeting>& meetings) {
    double largest = 0.0;
    for (const Meeting& m : meetings) {
        const double approach = dot(m.before.w(), m.before.normal);
        largest = std::max(largest, m.call.options.contact_stiffness > 0.0
                                        ? m.answer.share * approach + m.answer.pushed
                                        : approach);
    }
    return largest;
}

void judge_balance(const ManyCall& call, const Many& x, const Many& y, Findings& out) {
    const auto program = [&] { return program_of(call, x); };
    const bool any_rigid = call.rigid[0], springs = call.call.options.contact_stiffness > 0.0;
    double error = 0.0, size = 0.0, energy_before = 0.0, energy_after = 0.0, roundoff = 0.0;
    const std::vector<double> sizes = sizes_of(call, x, y);
    Vec centre{};
    double total = 0.0;
    for (std::size_t i = 0; i < x.mass.size(); ++i) {
        total += x.mass[i];
        centre = plus(centre, x.mass[i], x.velocity[i]);
    }
    for (double& each : centre) each /= total;
    for (std::size_t d = 0; d < 3; ++d) {
        double sum = 0.0;
        for (std::size_t i = 0; i < x.mass.size(); ++i) {
            sum += x.mass[i] * (y.velocity[i][d] - x.velocity[i][d]);
            size += x.mass[i] * (std::fabs(y.velocity[i][d]) + std::fabs(x.velocity[i][d]));
        }
        error += std::fabs(sum);
    }
    for (const Node& each : y.between)  // springs may press against each other
        size += norm(impulse_of(each.report));
    for (std::size_t i = 0; i < x.mass.size(); ++i) {
        const Vec old = plus(x.velocity[i], -1.0, centre), now = plus(y.velocity[i], -1.0, centre);
        energy_before += 0.5 * x.mass[i] * dot(old, old);
        energy_after += 0.5 * x.mass[i] * dot(now, now);
        const double rough = 4e-16 * sizes[i];
        roundoff += x.mass[i] * rough * (norm(old) + norm(now) + rough);
        if (call.rigid[i]) out.demand(rigid_stays, same(y.velocity[i], x.velocity[i]), program);
    }
    if (!any_rigid) {
        out.measure(many_momentum, share_of(error, size));
        out.demand(many_keeps_momentum, error <= (x.alike ? 1e-10 : 1e-14) * size, program);
    }
    if (!springs && any_rigid) {
        double given = 0.0, terms = 0.0;
        for (std::size_t k = 0; k < x.between.size(); ++k) {
            const std::size_t a = call.a(k), b = call.b(k);
            for (std::size_t d = 0; d < 3; ++d) {
                const double J = y.between[k].report.impulse[d];
                given -=
                    J * (x.velocity[a][d] - x.velocity[b][d] + y.velocity[a][d] - y.velocity[b][d]);
                terms += std::fabs(J) * (std::fabs(x.velocity[a][d]) + std::fabs(x.velocity[b][d]) +
                                         std::fabs(y.velocity[a][d]) + std::fabs(y.velocity[b][d]));
            }
        }
        if (terms > 0.0) out.measure(many_work, given / terms);
        out.demand(many_takes_work, given <= 1e-12 * terms, program);
    }
    if (!springs && !any_rigid) {
        const double gain = energy_after - energy_before - roundoff;
        out.measure(many_energy, share_of(gain, energy_before));
        out.demand(many_gains_no_energy, gain <= 1e-12 * energy_before, program);
    }
}

// Each body has what the reports say, and stays where they say nothing.
void judge_reports(const ManyCall& call, const Many& x, const Many& y, Findings& out) {
    const auto program = [&] { return program_of(call, x); };
    const std::vector<double> sizes = sizes_of(call, x, y);
    double largest = 0.0, fastest = 0.0;  // of sizes times root of mass, and of sizes
    for (std::size_t i = 0; i < x.mass.size(); ++i) {
        fastest = std::max(fastest, sizes[i]);
        if (!call.rigid[i]) largest = std::max(largest, sizes[i] * std::sqrt(x.mass[i]));
    }
    for (std::size_t i = 0; i < x.mass.size(); ++i) {
        if (call.rigid[i]) continue;
        Vec gained{};
        bool pressed = false;
        for (std::size_t k = 0; k < x.between.size(); ++k) {
            if (call.a(k) != i && call.b(k) != i) continue;
            const grit_contact_report& r = y.between[k].report;
            gained = plus(gained, call.a(k) == i ? -1.0 : 1.0, impulse_of(r));
            pressed = pressed || r.state > GRIT_CONTACT_OPEN;
        }
        if (!pressed) {
            out.demand(open_untouched, same(x.velocity[i], y.velocity[i]), program);
            continue;
        }
        const Vec change = plus(y.velocity[i], -1.0, x.velocity[i]);
        // Where normals are nearly one impulses in rings have no more digits than the largest of them.
        const double size = x.alike ? largest / std::sqrt(x.mass[i]) : sizes[i] + 1e-4 * fastest;
        const double error = norm(plus(change, -1.0 / x.mass[i], gained)) / size;
        out.measure(many_impulse_error, error);
        out.demand(many_moved_as_told, error <= 1e-12, program);
    }
    for (std::size_t k = 0; k < x.between.size(); ++k) {
        const Call pair = call.of_pair(k);
        const Node before = x.pair(call, k);
        const grit_contact_report& r = y.between[k].report;
        const Vec J = impulse_of(r);
        out.demand(known_status,
                   r.status == GRIT_OK &&
                       (r.state > GRIT_CONTACT_INACTIVE) == active(pair, before) &&
                       r.state <= GRIT_CONTACT_SLIP,
                   program);
        out.demand(finite, all_finite(J), program);
        if (r.state <= GRIT_CONTACT_OPEN || !near(pair, before)) {
            out.demand(many_apart_untouched, r.state <= GRIT_CONTACT_OPEN && same(J, {}), program);
            continue;
        }
        const double m_r = reduced_mass(pair, before),
                     size = norm(J) + m_r * (sizes[call.a(k)] + sizes[call.b(k)]);
        out.demand(many_pushes_only, dot(J, before.normal) >= -0.1 * x.roundoff() * size, program);
        const double excess = friction_excess_of(pair, before, r, size) /
                              (1.0 + (x.alike ? 1.0 : 0.01) * pair.options.friction_coefficient);
        if (!x.alike) out.measure(many_friction_excess, excess);
        out.demand(many_obeys_coulomb, excess <= x.roundoff(), program);
    }
}

// Do so many more sweeps give the same?
bool settled(const ManyCall& call, const Many& x, const Many& y, int more = 1) {
    ManyCall longer = call;
    longer.sweep_limit = more + (call.sweep_limit > 0 ? call.sweep_limit : 50);
    Many z = x;
    correct(longer, z);
    return z.status == GRIT_OK && same_motion(y, z) && same_reports(y, z);
}

// (C7): does each pair's impulse answer to the velocities that the others leave?
void judge_laws(const ManyCall& call, const Many& x, const Many& y, Findings& out) {
    // A spring that presses around a ring of one normal finds nothing that gives way: impulses of 1e20 times the velocities.
    if (x.parallel && call.call.options.contact_stiffness > 0.0) return out.count(many_in_rings);
    const auto program = [&] { return program_of(call, x); };
    const std::vector<Meeting> meetings = meetings_of(call, x, y);
    const double approach = largest_approach(meetings);
    const bool at_end = settled(call, x, y);
    const auto alone = std::count_if(y.between.begin(), y.between.end(), [](const Node& each) {
                           return each.report.state > GRIT_CONTACT_INACTIVE;
                       }) == 1;
    // Of the last sweep: a pair's velocity is changed by as many as meet its bodies. Without friction there is one.
    const double sweeps =
        call.rubs() ? 2.0 * static_cast<double>(x.between.size()) * call.tolerance() : call.left();
    const double allowed = alone ? 0.0 : sweeps * approach;
    bool pressed = false, rubbed = false;
    for (const Meeting& m : meetings) {
        const double tenth = share_of(m.too_fast - 0.1 * approach, m.rough);
        if (!x.alike) out.measure(many_approach_left, tenth);
        out.demand(many_leaves_a_tenth, tenth <= x.roundoff(), program);
        if (m.report.state <= GRIT_CONTACT_OPEN) continue;
        pressed = true;
        const double none = x.alike ? x.roundoff() : 1e-15;
        rubbed = rubbed || norm(plus(m.J, -m.u_n * m.m_r, m.before.normal)) > none * norm(m.J);
    }
    if (!at_end || !pressed) return;
    out.count(many_settled);
    // What meets alone always finds friction that fits.
    const bool frictionless = call.rubs() && !rubbed && meetings.size() > 1;
    if (frictionless) out.count(many_without_friction);
    for (const Meeting& m : meetings) {
        const bool presses = m.report.state > GRIT_CONTACT_OPEN;
        const double off =
            share_of((presses ? std::fabs(m.too_fast) : m.too_fast) - allowed, m.rough);
        if (!x.alike) out.measure(many_normal_error, off);
        out.demand(many_normal_as_told, off <= x.roundoff(), program);
        if (!presses || frictionless) continue;
        const Vec& n = m.before.normal;
        const Vec w_t = plus(m.w, -dot(m.w, n), n),
                  u_t = plus({m.J[0] / m.m_r, m.J[1] / m.m_r, m.J[2] / m.m_r}, -m.u_n, n);
        const double limit = coulomb_limit(m.call, m.before, m.report, m.u_n, m.m_r);
        const double part = std::min(1.0, limit / norm(w_t));
        const double slip = (norm(plus(u_t, -part, w_t)) - allowed) / m.rough /
                            (1.0 + m.call.options.friction_coefficient);
        if (!x.alike) out.measure(many_friction_error, slip);
        out.demand(many_friction_as_told, slip <= x.roundoff(), program);
    }
}

// What has one active pair is a pair.
void judge_pair_alone(const ManyCall& call, const Many& x, const Many& y, Findings& out) {
    std::size_t last = 0, pairs = 0;
    for (std::size_t k = 0; k < x.between.size(); ++k)
        if (active(call.of_pair(k), x.pair(call, k))) ++pairs, last = k;
    if (pairs != 1) return;
    const Call alone = call.of_pair(last);
    Node pair = x.pair(call, last);
    correct(alone, pair);
    out.demand(many_of_two_is_pair,
               same(pair.v_a, y.velocity[call.a(last)]) &&
                   same(pair.v_b, y.velocity[call.b(last)]) &&
                   same_report(pair.report, y.between[last].report),
               [&] { return program_of(call, x); });
}

// Two are rigid, can touch what is free, and move differently; or a spring presses around a ring.
bool may_be_squeezed(const ManyCall& call, const Many& x) {
    if (x.parallel && call.call.options.contact_stiffness > 0.0) return true;
    bool touches[2] = {};
    for (std::size_t k = 0; k < x.between.size(); ++k) {
        const Node pair = x.pair(call, k);
        if (!active(call.of_pair(k), pair) || !near(call.of_pair(k), pair)) continue;
        for (const std::size_t body : {call.a(k), call.b(k)})
            if (body < 2) touches[body] = true;
    }
    return call.rigid[1] && touches[0] && touches[1] && !same(x.velocity[0], x.velocity[1]);
}

void judge(const ManyCall& call, const Many& x, const Many& y, Findings& out) {
    const auto program = [&] { return program_of(call, x); };
    out.count(of_many);
    if (y.status != GRIT_OK) {
        const bool squeezed = y.status == GRIT_NOT_CONVERGED;
        out.count(squeezed ? many_not_converged : many_refused);
        bool told = squeezed || y.status == GRIT_BAD_STATE;
        for (const Node& each : y.between) told = told && each.report.status == y.status;
        out.demand(known_status, told, program);
        out.demand(untouched, same_motion(x, y), program);
        out.demand(many_squeezed_by_rigid, !squeezed || may_be_squeezed(call, x), program);
        return;
    }
    judge_balance(call, x, y, out);
    judge_reports(call, x, y, out);
    judge_laws(call, x, y, out);
    judge_pair_alone(call, x, y, out);
}

// Where nothing rubs, velocities make a convex function least, and whatever leaves each approach open by no more than e
// is as near to them as sum m |dv|^2 <= 2 e times the sum of J_n, of both. Returned: the root of what is more, and a
// velocity's roundoff, beside all velocities.
double beyond(const ManyCall& call, const Many& x, const Many& y, const Many& z, double common) {
    const std::vector<double> sizes = sizes_of(call, x, y, common);
    const std::vector<Meeting> meetings = meetings_of(call, x, y);
    double open = 0.0, J_n = 0.0, apart = 0.0, whole = 0.0;
    for (const Meeting& m : meetings)
        open =
            std::max(open, (m.rough + common) * m.answer.share + m.answer.pushed / m.answer.share);
    open = (x.alike ? x.roundoff() : 1e-14) * open + call.left() * largest_approach(meetings);
    for (std::size_t k = 0; k < x.between.size(); ++k)
        for (const Many* each : {&y, &z})
            J_n += std::fabs(dot(impulse_of(each->between[k].report), each->between[k].normal));
    for (std::size_t i = 0; i < x.mass.size(); ++i) {
        if (call.rigid[i]) continue;
        const Vec off = plus(y.velocity[i], -1.0, z.velocity[i]);
        apart += x.mass[i] * dot(off, off);
        whole += x.mass[i] * sizes[i] * sizes[i];
    }
    return apart > 0.0 ? std::sqrt(std::max(0.0, apart - 2.0 * open * J_n) / whole) : 0.0;
}

// Other numbers of the bodies give the same bits, their exchange, another order of the pairs, another frame and another
// direction the same velocities.
void judge_in_other_words(const ManyCall& call, const Many& x, const Many& y, Random& random,
                          Findings& out) {
    const auto program = [&] { return program_of(call, x); };
    const std::vector<std::ptrdiff_t> number = shuffled(random, call.count());
    ManyCall other = call;
    Many z = x;
    for (std::size_t i = 0; i < number.size(); ++i) {
        const auto at = static_cast<std::size_t>(number[i]);
        other.rigid[at] = call.rigid[i];
        z.mass[at] = x.mass[i];
        z.velocity[at] = x.velocity[i];
    }
    for (auto& [a, b] : other.pairs) {
        a = static_cast<int>(number[static_cast<std::size_t>(a)]);
        b = static_cast<int>(number[static_cast<std::size_t>(b)]);
    }
    correct(other, z);
    Many renamed = z;
    for (std::size_t i = 0; i < number.size(); ++i)
        renamed.velocity[i] = z.velocity[static_cast<std::size_t>(number[i])];
    out.demand(many_numbers_are_names, same_motion(renamed, y) && same_reports(renamed, y),
               program);

    // With friction roundoff may decide which sweep is the last one: ten times its tolerance is what trials have shown.
    // With a large coefficient there is more than one answer.
    const bool slides = !call.rubs();
    // Nor has a ring of bodies whose normals are one.
    if (!slides && x.parallel) return;
    // Sweeps that never settle may end twice where friction is left out.
    for (const int more : {1, 2, 5, 17, 100})
        if (!slides && !settled(call, x, y, more)) return;
    const double allowed = slides ? 10.0 * x.roundoff() : 1e-12 + 10.0 * call.tolerance();
    const auto judge_same = [&](const Many& seen, Largest difference, Rule rule,
                                double common = 0.0) {
        if (seen.status != GRIT_OK) {
            out.demand(many_squeezed_by_rigid, may_be_squeezed(call, x), program);
            return out.count(many_else_squeezed);
        }
        // Where adhesion and suction begin velocities jump.
        const bool jumps = call.call.options.adhesion > 0.0 || call.call.pore;
        if (jumps && !same_states(y, seen)) return out.count(many_else_ended);
        const double off = beyond(call, x, y, seen, common);
        if (off > 1e-12) out.count(many_else_ended);
        if (call.call.options.friction_coefficient > 1.0) return;
        out.measure(difference, off / allowed);
        out.demand(rule, off <= allowed, program);
    };
    other = call;
    z = x;
    for (std::size_t k = 0; k < other.pairs.size(); ++k)
        if (random.below(2)) {
            std::swap(other.pairs[k].first, other.pairs[k].second);
            for (double& each : z.between[k].normal) each = -each;
        }
    // Friction goes from pair to pair.
    for (std::size_t k = other.pairs.size(); slides && k > 1; --k) {
        const auto to = static_cast<std::size_t>(random.below(static_cast<int>(k)));
        std::swap(other.pairs[k - 1], other.pairs[to]);
        std::swap(z.between[k - 1], z.between[to]);
    }
    correct(other, z);
    judge_same(z, many_swap_error, many_does_not_see_names);

    double speed = 0.0;
    for (const Vec& each : x.velocity) speed = std::max(speed, norm(each));
    Vec common = random_vector(random, call.call.options.components);
    for (double& each : common) each *= speed;
    z = x;
    for (Vec& each : z.velocity) each = plus(each, 1.0, common);
    correct(call, z);
    for (Vec& each : z.velocity) each = plus(each, -1.0, common);
    judge_same(z, many_galilei_error, many_does_not_see_common_velocity, norm(common));

    const double angle = random.uniform(0.0, 6.283185307179586);
    z = x;
    for (Vec& each : z.velocity) each = turned(each, angle);
    for (Node& each : z.between) each.normal = turned(each.normal, angle);
    correct(call, z);
    for (Vec& each : z.velocity) each = turned(each, -angle);
    judge_same(z, many_turn_error, many_turns_along);
}

void correct_together(Random& random, const ManyCall& call, std::vector<Many>& all, Together& got) {
    const auto n = static_cast<std::ptrdiff_t>(all.size());
    const bool listed = random.below(4) != 0;
    const std::ptrdiff_t places = listed ? n + random.below(3) : n;
    got.index = shuffled(random, places);
    if (!listed) std::sort(got.index.begin(), got.index.end());
    got.index.resize(all.size());
    const int c = call.call.options.components;
    std::vector<Layout> mass, velocity, of_pair[pair_numbers];
    for (std::size_t i = 0; i < call.rigid.size(); ++i) {
        mass.emplace_back(random, places, 1);
        velocity.emplace_back(random, places, c);
    }
    for (std::size_t k = 0; k < call.pairs.size(); ++k)
        for (int each = 0; each < pair_numbers; ++each)
            of_pair[each].emplace_back(random, places, each == 0 ? c : 1);
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t body = 0; body < mass.size(); ++body) {
            mass[body].put(got.index[i], &all[i].mass[body]);
            velocity[body].put(got.index[i], all[i].velocity[body].data());
        }
        for (std::size_t k = 0; k < call.pairs.size(); ++k)
            for (int each = 0; each < pair_numbers; ++each)
                of_pair[each][k].put(got.index[i], number_of(all[i].between[k], each));
    }
    // What all nodes have in common lies at one place.
    const auto view = [&](const Layout& layout, const auto& number) {
        const bool common = std::all_of(all.begin(), all.end(), [&](const Many& x) {
            return std::equal(number(x), number(x) + layout.components(), number(all[0]));
        });
        return common ? grit_view_of(number(all[0]), 0, 1) : layout.in();
    };
    Arguments arguments(call);
    for (std::size_t body = 0; body < mass.size(); ++body) {
        arguments.mass.push_back(view(mass[body], [&](const Many& x) { return &x.mass[body]; }));
        arguments.velocity.push_back(velocity[body].out());
    }
    for (std::size_t k = 0; k < call.pairs.size(); ++k)
        give_pair(call.call, arguments.pairs[k], [&](int each) {
            return view(of_pair[each][k],
                        [&](const Many& x) { return number_of(x.between[k], each); });
        });
    if (listed) arguments.bodies.index = got.index.data();
    std::vector<grit_contact_report> reports(all.size() * call.pairs.size());
    got.sums.resize(call.pairs.size());
    got.status = arguments.correct(n, reports.data(), got.sums.data(), &got.error);
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t body = 0; body < mass.size(); ++body)
            velocity[body].get(got.index[i], all[i].velocity[body].data());
        for (std::size_t k = 0; k < call.pairs.size(); ++k)
            all[i].between[k].report = reports[i * call.pairs.size() + k];
        all[i].status = all[i].between[0].report.status;
    }
    got.kept = std::all_of(velocity.begin(), velocity.end(),
                           [&](const Layout& each) { return each.blank_but(got.index); });
}

// Counts are those of the reports, the other sums theirs to half a bit.
bool sum_up(const grit_contact_sums& sums, const std::vector<Many>& all, std::size_t pair) {
    grit_contact_totals totals{};
    totals.struct_size = sizeof totals;
    if (grit_contact_sums_read(&sums, &totals) != GRIT_OK) return false;
    std::ptrdiff_t states[4] = {}, failed = 0;
    long double sum[8] = {}, size[8] = {};
    for (const Many& x : all) {
        const grit_contact_report& r = x.between[pair].report;
        if (r.status != GRIT_OK) ++failed;
        else ++states[r.state];
        const double terms[] = {
            r.impulse[0], r.impulse[1], r.impulse[2],          r.force[0],
            r.force[1],   r.force[2],   r.trial_energy_normal, r.trial_energy_tangential};
        for (int t = 0; t < 8; ++t) {
            sum[t] += terms[t];
            size[t] += std::fabs(terms[t]);
        }
    }
    const double* J = totals.impulse_on_b;
    const double* F = totals.force_on_b;
    const double told[] = {J[0],
                           J[1],
                           J[2],
                           F[0],
                           F[1],
                           F[2],
                           totals.trial_energy_normal,
                           totals.trial_energy_tangential};
    bool good = totals.inactive == states[GRIT_CONTACT_INACTIVE] &&
                totals.open == states[GRIT_CONTACT_OPEN] &&
                totals.stick == states[GRIT_CONTACT_STICK] &&
                totals.slip == states[GRIT_CONTACT_SLIP] && totals.failed == failed;
    for (int t = 0; t < 8; ++t)
        good =
            good && std::fabs(told[t] - sum[t]) <= 1.2e-16L * std::fabs(sum[t]) + 1e-17L * size[t];
    for (int d = 0; d < 3; ++d)
        good = good && totals.impulse_on_a[d] == -J[d] && totals.force_on_a[d] == -F[d];
    return good;
}

void judge_together(Random& random, const ManyCall& call, const std::vector<Many>& before,
                    const std::vector<Many>& alone, const Sums& sums, Findings& out) {
    std::vector<Many> together = before;
    Together got;
    correct_together(random, call, together, got);
    for (std::size_t i = 0; i < alone.size(); ++i)
        out.demand(many_same_bits,
                   same_motion(alone[i], together[i]) && same_reports(alone[i], together[i]),
                   [&] { return program_of(call, before[i]); });
    const auto program = [&] { return program_of(call, before[0]); };
    out.demand(many_between_untouched, got.kept, program);
    std::size_t bad = 0;
    while (bad < alone.size() && alone[bad].status == GRIT_OK) ++bad;
    const bool none = bad == alone.size();
    out.demand(many_first_named,
               none ? got.status == GRIT_OK
                    : got.status == alone[bad].status && got.error.status == got.status &&
                          got.error.point == got.index[bad],
               [&] { return program_of(call, before[none ? 0 : bad]); });
    for (std::size_t k = 0; k < sums.size(); ++k)
        out.demand(many_sums,
                   std::memcmp(&sums[k], &got.sums[k], sizeof sums[k]) == 0 &&
                       sum_up(got.sums[k], alone, k),
                   program);
}

}  // namespace

void try_many(const Call& call, Random& random, Findings& out) {
    const ManyCall many = random_many_call(call, random);
    if (many.pairs.empty()) return;
    const int n = random.below(16) ? 1 : 2 + random.below(most_nodes - 1);
    const bool plane = random.below(2), like = random.below(2);
    bool first_spoilt = false;
    std::vector<Many> before, alone;
    Sums sums(many.pairs.size());
    for (int i = 0; i < n; ++i) {
        Many x = random_many(many, random);
        // A plane through all nodes; masses that are known at one place.
        if (i > 0 && plane)
            for (std::size_t k = 0; k < x.between.size(); ++k)
                x.between[k].normal = before[0].between[k].normal;
        if (i > 0 && like) x.mass = before[0].mass;
        compare_normals(x);
        const bool spoils = random.below(50) == 0;
        if (spoils) spoil(x, random);
        if (i == 0) first_spoilt = spoils;
        const bool spoilt = spoils || (first_spoilt && (plane || like));
        Many y = x;
        correct(many, y, n > 1 ? &sums : nullptr);
        if (!spoilt || y.status != GRIT_OK) judge(many, x, y, out);
        if (!spoilt && y.status == GRIT_OK && random.below(4) == 0)
            judge_in_other_words(many, x, y, random, out);
        before.push_back(x);
        alone.push_back(y);
    }
    if (n > 1) judge_together(random, many, before, alone, sums, out);
}

}  // namespace robustness::contact
