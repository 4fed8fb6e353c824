// SPDX-License-Identifier: BSD-3-Clause
#include "robustness/surface_trials.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include <grit/contact_surface.h>

#include "robustness/layout.hpp"
#include "robustness/program_text.hpp"
#include "robustness/vec.hpp"

namespace robustness {
namespace {

enum Count { calls, refused, without_contact, points_in_contact, not_settled, in_parts };
enum Largest {
    momentum_error,
    energy_gain,
    residual_left,
    friction_excess,
    galilei_error,
    turn_error,
    rubbing_turn_error,
    parts_momentum,
    parts_energy
};
enum Rule {
    finite,
    untouched,
    known_status,
    same_again,
    same_in_any_memory,
    pair_alone_is_pair,
    keeps_momentum,
    gains_no_energy,
    presses_only,
    obeys_coulomb,
    does_not_see_common_velocity,
    turns_along,
    parts_keep_momentum,
    parts_gain_no_energy,
    holds_what_is_held,
    asks_for_memory_once,
    sweeps_bounded
};

const Vocabulary words = {
    {"calls", "refused", "without contact", "points in contact", "that the limit of sweeps ended",
     "also as two pairs that share both bodies"},
    {"momentum error over momentum", "energy gained, over that of the motion",
     "change of velocity in the last sweep, over the largest approach",
     "friction above Coulomb's, over mu times the normal impulse",
     "difference with a common velocity, over velocities",
     "difference when turned, over velocities", "the same with friction in space",
     "momentum error of two pairs", "energy gained by two pairs"},
    {"results are finite", "a refused call writes nothing", "a status is one of a call",
     "the same call gives the same bits, whatever is in its workspace",
     "any strides give the same bits",
     "a pair that hangs together with none has the bits of its own call",
     "momentum is kept to 1e-12", "energy does not grow by more than 1e-12 and what surfaces held",
     "no facet pulls", "friction stays within Coulomb's limit to 1e-12",
     "a common velocity is not seen, to 1e-9",
     "turned surfaces give turned velocities to 1e-9 (in space without friction)",
     "momentum of two pairs is kept to 1e-12",
     "energy of two pairs does not grow by more than 1e-12 and what surfaces held",
     "a node that is held keeps its velocity in that direction",
     "a call that lacks memory says how much, at most three times",
     "sweeps stay within their limit"}};

// Nodes of a grid, and a part of its surface.
struct Body {
    int components = 2, size = 6;
    bool rigid = false;
    std::vector<double> position, mass, v, weight, vertex_velocity;
    std::vector<std::ptrdiff_t> facet, node;
    std::vector<int> fixed;
    double cell = 1.0;

    int corners() const { return 1 << components; }
    std::ptrdiff_t vertices() const {
        return static_cast<std::ptrdiff_t>(position.size()) / components;
    }
    void add_vertex(const std::array<double, 3>& x) {
        for (int corner = 0; corner < corners(); ++corner) {
            std::ptrdiff_t id = 0, stride = 1;
            double N = 1.0;
            for (int c = 0; c < components; ++c, stride *= size) {
                const double at = x[static_cast<std::size_t>(c)];
                const int low = std::clamp(static_cast<int>(std::floor(at)), 0, size - 2);
                const bool upper = corner >> c & 1;
                id += stride * (low + upper);
                N *= upper ? at - low : 1.0 - (at - low);
            }
            node.push_back(id);
            weight.push_back(N);
        }
        for (int c = 0; c < components; ++c)
            position.push_back(cell * x[static_cast<std::size_t>(c)]);
    }
    grit_surface view() {
        grit_surface s{};
        s.struct_size = sizeof s;
        s.rigid = rigid;
        s.nodes_each = corners();
        s.vertices = vertices();
        s.facets = static_cast<std::ptrdiff_t>(facet.size()) / components;
        s.position = grit_view_of(position.data(), components, 1);
        s.facet = facet.data();
        s.node = node.data();
        s.weight = weight.data();
        s.nodes = static_cast<std::ptrdiff_t>(mass.size());
        s.mass = grit_view_of(mass.data(), 1, 1);
        s.fixed = fixed.data();
        s.velocity = grit_mutable_view_of(v.data(), components, 1);
        s.vertex_velocity = grit_view_of(vertex_velocity.data(), components, 1);
        return s;
    }
    bool same(const Body& other) const {
        return std::memcmp(v.data(), other.v.data(), v.size() * sizeof(double)) == 0;
    }
};

struct Call {
    grit_surface_options options{};
    Body a, b;
    grit_surface_totals totals{};
    std::vector<grit_surface_report> reports;
    grit_status status = GRIT_OK;
    int tries = 0;
    double friction_excess = 0.0;  // over mu times the normal impulse, largest of all points

    void run(Random& random) {
        const grit_surface on_a = a.view(), on_b = b.view();
        run(random, on_a, on_b);
    }
    void run(Random& random, const grit_surface& on_a, const grit_surface& on_b) {
        reports.assign(static_cast<std::size_t>(on_a.facets), {});
        totals = {};
        totals.struct_size = sizeof totals;
        grit_error error{};
        std::size_t needed = grit_surface_workspace_size(&on_a, &on_b);
        std::vector<double> workspace;
        for (tries = 0; tries < 4; ++tries) {
            workspace.assign(needed / sizeof(double) + 1, random.below(2) ? NAN : random.normal());
            status = grit_surface_correct(&options, &on_a, &on_b, workspace.data(),
                                          workspace.size() * sizeof(double), &needed,
                                          reports.data(), &totals, &error);
            if (needed == 0) break;
        }
        friction_excess = -1.0;
        for (std::ptrdiff_t i = 0; i < totals.rows; ++i) {
            const double* const J = totals.row[i].impulse;
            const double limit = options.friction_coefficient * J[0];
            if (limit > 0.0)
                friction_excess = std::max(friction_excess, std::hypot(J[1], J[2]) / limit - 1.0);
        }
        totals.row = nullptr;
        totals.term = nullptr;
    }
};

// The top of the lower body or the bottom of the upper one, at z = height(x, y).
template <class Height>
void add_face(Body& body, bool upper, double low, double high, int n, const Height& height) {
    const auto at = [&](int i) { return low + (high - low) * i / n; };
    if (body.components == 2) {
        for (int i = 0; i <= n; ++i) body.add_vertex({at(i), height(at(i), 0.0), 0.0});
        for (std::ptrdiff_t i = 0; i < n; ++i) {
            if (upper) body.facet.insert(body.facet.end(), {i, i + 1});
            else body.facet.insert(body.facet.end(), {i + 1, i});
        }
        return;
    }
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) body.add_vertex({at(i), at(j), height(at(i), at(j))});
    for (std::ptrdiff_t j = 0; j < n; ++j)
        for (std::ptrdiff_t i = 0; i < n; ++i) {
            const std::ptrdiff_t k = j * (n + 1) + i, r = k + 1, d = r + n + 1, u = k + n + 1;
            if (upper) body.facet.insert(body.facet.end(), {k, d, r, k, u, d});
            else body.facet.insert(body.facet.end(), {k, r, d, k, d, u});
        }
}

void fill(Random& random, Body& body, double speed) {
    std::size_t nodes = 1;
    for (int c = 0; c < body.components; ++c) nodes *= static_cast<std::size_t>(body.size);
    const double spread = random.below(3) ? random.uniform(0.0, 3.0) : random.uniform(0.0, 12.0);
    const double scale = random.log_uniform(1e-6, 1e6);
    for (std::size_t i = 0; i < nodes; ++i) {
        body.mass.push_back(scale * std::pow(10.0, random.uniform(-spread, spread)));
        body.fixed.push_back(random.below(25) == 0 ? 1 << random.below(body.components) : 0);
        // What is held and moves does work.
        for (int c = 0; c < body.components; ++c)
            body.v.push_back(body.fixed.back() >> c & 1 ? 0.0 : speed * random.normal());
    }
    for (std::size_t i = 0; i < body.position.size(); ++i) body.vertex_velocity.push_back(0.0);
}

Call random_call(Random& random) {
    Call call;
    grit_surface_options& o = call.options;
    grit_surface_options_init(&o, sizeof o);
    o.components = random.below(4) ? 2 : 3;
    o.axisymmetric = o.components == 2 && random.below(3) == 0;
    const double cell = random.log_uniform(1e-6, 1e6);
    o.time_step = random.log_uniform(1e-9, 1e3);
    o.spacing = cell * (random.below(3) ? 2.0 : random.log_uniform(0.1, 20.0));
    o.reach = cell * (random.below(3) ? 1.0 : random.log_uniform(1e-6, 3.0));
    if (random.below(3))
        o.friction_coefficient =
            random.below(4) ? random.uniform(0.0, 1.5) : random.log_uniform(1e-9, 1e6);
    o.sweep_limit = random.below(3) ? 500 : 1 + random.below(20);
    o.sweep_tolerance = random.below(3) ? 1e-6 : random.log_uniform(1e-14, 1.0);
    if (random.below(4) == 0) {
        o.contact_stiffness = random.log_uniform(1e-20, 1e20);
        if (random.below(2)) o.relaxation_time = o.time_step * random.log_uniform(1e-6, 1e6);
    }
    const double level = random.uniform(1.5, 3.5), high = random.uniform(0.0, 0.4),
                 phase = random.uniform(0.0, 6.0);
    const double gap = random.below(4) == 0 ? 0.0
                       : random.below(2)    ? random.uniform(-0.2, 0.1)
                                            : -random.log_uniform(1e-12, 0.9);
    const auto wave = [=](double x, double y) {
        return level + high * std::sin(1.3 * x + 0.7 * y + phase);
    };
    for (Body* body : {&call.a, &call.b}) {
        body->components = o.components;
        body->cell = cell;
    }
    const int most = o.components == 2 ? 24 : 5;
    add_face(call.a, false, random.uniform(0.0, 1.0), random.uniform(3.0, 4.9),
             1 + random.below(most), wave);
    add_face(call.b, true, random.uniform(0.0, 1.0), random.uniform(3.0, 4.9),
             1 + random.below(most), [&](double x, double y) { return wave(x, y) + gap; });
    // Velocities that close gaps of cells in a step, or none at all.
    const double speed = cell / o.time_step * random.log_uniform(1e-9, 10.0);
    fill(random, call.a, speed);
    fill(random, call.b, speed);
    if (random.below(8) == 0) (random.below(2) ? call.a : call.b).rigid = true;
    if (random.below(40) == 0) call.a.v[call.a.v.size() / 2] = NAN;
    if (random.below(40) == 0) call.b.facet[0] = call.b.vertices();
    return call;
}

template <class Number> std::string whole_numbers(const std::vector<Number>& x) {
    std::string out = "{";
    for (const Number each : x) out += std::to_string(each) + ", ";
    return out + "}";
}

std::string body_text(const std::string& name, const Body& body) {
    const auto array = [&](const char* what, const std::vector<double>& x) {
        return "    static double " + (what + name) + "[] = " + numbers(x.data(), x.size()) + ";\n";
    };
    const std::string n = std::to_string(body.components), s = "s" + name;
    return array("x", body.position) + array("m", body.mass) + array("v", body.v) +
           array("N", body.weight) + array("u", body.vertex_velocity) + "    static ptrdiff_t f" +
           name + "[] = " + whole_numbers(body.facet) + ", i" + name +
           "[] = " + whole_numbers(body.node) + ";\n    static int h" + name +
           "[] = " + whole_numbers(body.fixed) + ";\n    grit_surface " + s + " = {sizeof " + s +
           ", " + std::to_string(body.rigid) + ", " + std::to_string(body.corners()) + ", " +
           std::to_string(body.vertices()) + ", " +
           std::to_string(static_cast<std::ptrdiff_t>(body.facet.size()) / body.components) +
           "};\n    " + s + ".position = grit_view_of(x" + name + ", " + n + ", 1); " + s +
           ".facet = f" + name + "; " + s + ".node = i" + name + "; " + s + ".weight = N" + name +
           "; " + s + ".fixed = h" + name + ";\n    " + s +
           ".nodes = " + std::to_string(body.mass.size()) + "; " + s + ".mass = grit_view_of(m" +
           name + ", 1, 1); " + s + ".velocity = grit_mutable_view_of(v" + name + ", " + n +
           ", 1); " + s + ".vertex_velocity = grit_view_of(u" + name + ", " + n + ", 1);\n";
}

std::string program_of(const Call& call) {
    const grit_surface_options& o = call.options;
    const double p[] = {
        o.time_step,       o.spacing,           o.reach,          o.friction_coefficient,
        o.sweep_tolerance, o.contact_stiffness, o.relaxation_time};
    return "#include <grit/grit.h>\n#include <stdio.h>\nstatic double w[1 << 22];\nint main(void) "
           "{\n" +
           body_text("a", call.a) + body_text("b", call.b) + "    double p[] = " + numbers(p, 7) +
           ";\n    grit_surface_options o; grit_surface_options_init(&o, sizeof o);\n    "
           "o.components = " +
           std::to_string(o.components) + "; o.axisymmetric = " + std::to_string(o.axisymmetric) +
           "; o.sweep_limit = " + std::to_string(o.sweep_limit) +
           ";\n    o.time_step = p[0]; o.spacing = p[1]; o.reach = p[2]; o.friction_coefficient = "
           "p[3]; "
           "o.sweep_tolerance = p[4]; o.contact_stiffness = p[5]; o.relaxation_time = p[6];\n"
           "    grit_surface_totals t = {sizeof t}; grit_error e = {0}; size_t needed;\n"
           "    int status = grit_surface_correct(&o, &sa, &sb, w, sizeof w, &needed, 0, &t, &e);\n"
           "    printf(\"%d %s sweeps %td J %.17g %.17g\\n\", status, e.message, t.sweeps, "
           "t.impulse_on_a[0], "
           "t.impulse_on_a[1]);\n}\n";
}

// What a call has changed of the bodies that are not rigid.
struct Change {
    double momentum = 0.0, momentum_size = 0.0, energy = 0.0, energy_gain = 0.0;
    bool held = true, any_held = false, rigid = false;
};

Change change_between(const Call& before, const Call& after) {
    Change out;
    const auto n = static_cast<std::size_t>(after.options.components);
    std::array<double, 3> change{};
    for (const auto& [old, now] : {std::pair{&before.a, &after.a}, {&before.b, &after.b}}) {
        out.rigid = out.rigid || now->rigid;
        if (now->rigid) continue;
        for (std::size_t i = 0; i < now->v.size(); ++i) {
            const double m = now->mass[i / n], v = old->v[i], w = now->v[i];
            if (!std::isfinite(v)) continue;
            change[i % n] += m * (w - v);
            out.momentum_size += m * (std::fabs(v) + std::fabs(w));
            out.energy += 0.5 * m * v * v;
            out.energy_gain += 0.5 * m * (w - v) * (w + v);
            if (now->fixed[i / n] >> (i % n) & 1) {
                out.any_held = out.any_held || w == v;
                out.held = out.held && w == v;
            }
        }
    }
    out.momentum = std::fabs(change[0]) + std::fabs(change[1]) + std::fabs(change[2]);
    return out;
}

// Energy of overlap that a pair may give back.
double stored_by(const grit_surface_options& options, const grit_surface_totals& totals) {
    const double overlap = std::max(-totals.smallest_gap, 0.0);
    return 0.5 * options.contact_stiffness * overlap * overlap * totals.area;
}

void judge_motion(const Call& before, const Call& call, Findings& out) {
    const auto program = [&] { return program_of(before); };
    const Change change = change_between(before, call);
    out.demand(holds_what_is_held, change.held, program);
    const double stored = stored_by(call.options, call.totals);
    if (stored == 0.0) out.measure(energy_gain, change.energy_gain / change.energy);
    out.demand(gains_no_energy, change.energy_gain <= 1e-12 * change.energy + (1.0 + 1e-9) * stored,
               program);
    if (change.rigid || change.any_held) return;
    out.measure(momentum_error, change.momentum / change.momentum_size);
    out.demand(keeps_momentum, change.momentum <= 1e-12 * change.momentum_size, program);
}

// A body in memory of any strides.
class Laid {
  public:
    Laid(Random& random, const Body& body)
        : nodes(static_cast<std::ptrdiff_t>(body.mass.size())), c(body.components),
          position(random, body.vertices(), c), mass(random, nodes, 1), velocity(random, nodes, c),
          vertex_velocity(random, body.vertices(), c) {
        for (std::ptrdiff_t i = 0; i < body.vertices(); ++i) {
            position.put(i, body.position.data() + i * c);
            vertex_velocity.put(i, body.vertex_velocity.data() + i * c);
        }
        for (std::ptrdiff_t i = 0; i < nodes; ++i) {
            mass.put(i, body.mass.data() + i);
            velocity.put(i, body.v.data() + i * c);
        }
    }
    grit_surface view(Body& body) const {
        grit_surface s = body.view();
        s.position = position.in();
        s.mass = mass.in();
        s.velocity = velocity.out();
        s.vertex_velocity = vertex_velocity.in();
        return s;
    }
    void take(Body& body) const {
        for (std::ptrdiff_t i = 0; i < nodes; ++i) velocity.get(i, body.v.data() + i * c);
    }

  private:
    std::ptrdiff_t nodes;
    int c;
    Layout position, mass, velocity, vertex_velocity;
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

// Pairs by one call.
grit_status correct(Random& random, std::vector<grit_surface_pair> pairs) {
    const auto n = static_cast<std::ptrdiff_t>(pairs.size());
    std::size_t needed = grit_surface_pairs_workspace_size(pairs.data(), n);
    grit_status status = GRIT_OK;
    for (int tries = 0; tries < 6 && needed > 0; ++tries) {
        std::vector<double> workspace(needed / sizeof(double) + 1, random.below(2) ? NAN : 1.0);
        status = grit_surface_correct_pairs(pairs.data(), n, workspace.data(),
                                            workspace.size() * sizeof(double), &needed, nullptr);
    }
    return status;
}

// Beside another pair that has nothing in common with it.
void judge_beside(Random& random, const Call& before, const Call& call, Findings& out) {
    Call beside = before, other = random_call(random);
    if (other.options.components != before.options.components) return;
    const grit_surface on_a = beside.a.view(), on_b = beside.b.view(), on_c = other.a.view(),
                       on_d = other.b.view();
    const grit_status status = correct(random, {{&other.options, &on_c, &on_d, nullptr, nullptr},
                                                {&beside.options, &on_a, &on_b, nullptr, nullptr}});
    if (status != GRIT_OK) return;  // the other one is refused
    out.demand(pair_alone_is_pair, beside.a.same(call.a) && beside.b.same(call.b),
               [&] { return program_of(before); });
}

// The facets of A in two parts, each a pair with B: both bodies are in common.
void judge_parts(Random& random, const Call& before, Findings& out) {
    Call call = before;
    const auto c = static_cast<std::size_t>(call.options.components);
    Body one = call.a, other = call.a;
    const std::size_t half = call.a.facet.size() / c / 2 * c;
    if (half == 0) return;
    one.facet.resize(half);
    other.facet.erase(other.facet.begin(), other.facet.begin() + static_cast<std::ptrdiff_t>(half));
    grit_surface on_one = one.view(), on_other = other.view(), on_b = call.b.view();
    on_one.velocity = on_other.velocity = call.a.view().velocity;
    on_one.body = on_other.body = 3;
    on_b.body = 4;
    grit_surface_totals of_one{}, of_other{};
    of_one.struct_size = of_other.struct_size = sizeof of_one;
    if (correct(random, {{&call.options, &on_one, &on_b, nullptr, &of_one},
                         {&call.options, &on_other, &on_b, nullptr, &of_other}}) != GRIT_OK)
        return;
    out.count(in_parts);
    const auto program = [&] { return program_of(before); };
    const Change change = change_between(before, call);
    const double stored = stored_by(call.options, of_one) + stored_by(call.options, of_other);
    if (stored == 0.0) out.measure(parts_energy, change.energy_gain / change.energy);
    out.demand(parts_gain_no_energy,
               change.energy_gain <= 1e-12 * change.energy + (1.0 + 1e-9) * stored, program);
    if (change.rigid) return;
    out.measure(parts_momentum, change.momentum / change.momentum_size);
    out.demand(parts_keep_momentum, change.momentum <= 1e-12 * change.momentum_size, program);
}

// By how much velocities differ from what is expected of them, over the largest, or over such that are slow.
template <class Expected>
double difference(const Body& found, const Body& expected, double slow, const Expected& told) {
    const auto n = static_cast<std::size_t>(found.components);
    double most = 0.0, size = slow;
    if (found.rigid) return 0.0;
    for (std::size_t i = 0; i < found.v.size(); i += n) {
        Vec v{}, w{};
        std::copy_n(expected.v.begin() + static_cast<std::ptrdiff_t>(i), n, v.begin());
        std::copy_n(found.v.begin() + static_cast<std::ptrdiff_t>(i), n, w.begin());
        v = told(v);
        most = std::max(most, norm(plus(w, -1.0, v)));
        size = std::max({size, norm(v), norm(w)});
    }
    return most / size;
}

template <class Told> void reword(std::vector<double>& field, int components, const Told& told) {
    const auto n = static_cast<std::size_t>(components);
    for (std::size_t i = 0; i < field.size(); i += n) {
        Vec v{};
        std::copy_n(field.begin() + static_cast<std::ptrdiff_t>(i), n, v.begin());
        v = told(v);
        std::copy_n(v.begin(), n, field.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

// In another frame, and turned: where nodes are held in no direction, and roundoff decides about no point and no sweep.
void judge_in_other_words(Random& random, const Call& before, const Call& call, Findings& out) {
    if (call.totals.points == 0 || call.totals.sweeps >= call.options.sweep_limit) return;
    const auto program = [&] { return program_of(before); };
    const bool axisymmetric = call.options.axisymmetric != 0;
    // Gaps have the roundoff of positions, a step's motion may be less.
    const double slow = 1e-4 * call.a.cell / call.options.time_step;
    double speed = 0.0;
    for (const Body* body : {&before.a, &before.b})
        for (const double v : body->v) speed = std::max(speed, std::fabs(v));
    Vec common = random_vector(random, call.options.components);
    for (double& each : common) each *= speed;
    if (axisymmetric) common[0] = 0.0;
    const auto moved = [&](const Vec& v) { return plus(v, 1.0, common); };
    Call moving = before;
    for (Body* body : {&moving.a, &moving.b}) {
        reword(body->v, body->components, moved);
        reword(body->vertex_velocity, body->components, moved);
    }
    moving.run(random);
    const auto alike = [&](const Call& other) {
        return other.status == GRIT_OK && other.totals.points == call.totals.points &&
               other.totals.sweeps == call.totals.sweeps;
    };
    if (alike(moving)) {
        const double seen = std::max(difference(moving.a, call.a, slow, moved),
                                     difference(moving.b, call.b, slow, moved));
        out.measure(galilei_error, seen);
        out.demand(does_not_see_common_velocity, seen <= 1e-9, program);
    }
    if (axisymmetric) return;
    const double angle = random.uniform(0.0, 6.283185307179586);
    const auto aside = [&](const Vec& v) { return turned(v, angle); };
    Call other = before;
    for (Body* body : {&other.a, &other.b})
        for (std::vector<double>* each : {&body->position, &body->v, &body->vertex_velocity})
            reword(*each, body->components, aside);
    other.run(random);
    if (!alike(other)) return;
    const double off = std::max(difference(other.a, call.a, slow, aside),
                                difference(other.b, call.b, slow, aside));
    // Sweeps of friction in space go along two axes, and where it is large there is more than one solution: told, not bounded.
    const bool rubs = call.options.components == 3 && call.options.friction_coefficient > 0.0;
    out.measure(rubs ? rubbing_turn_error : turn_error, off);
    out.demand(turns_along, rubs || off <= 1e-9, program);
}

void try_call(Random& random, Findings& out) {
    Call before = random_call(random);
    const bool is_free = random.below(2);
    if (is_free)
        for (Body* body : {&before.a, &before.b})
            std::fill(body->fixed.begin(), body->fixed.end(), 0);
    const auto program = [&] { return program_of(before); };
    Call call = before;
    call.run(random);
    out.count(calls);
    out.demand(asks_for_memory_once, call.tries < 3, program);
    out.demand(known_status, call.status >= GRIT_OK && call.status <= GRIT_BAD_STATE, program);
    Call again = before;
    again.run(random);
    out.demand(same_again,
               again.status == call.status && again.a.same(call.a) && again.b.same(call.b),
               program);
    if (random.below(4) == 0) judge_memory(random, before, call, out);
    if (call.status != GRIT_OK) {
        out.count(refused);
        out.demand(untouched, call.a.same(before.a) && call.b.same(before.b), program);
        return;
    }
    out.demand(sweeps_bounded,
               call.totals.sweeps >= 0 && call.totals.sweeps <= call.options.sweep_limit, program);
    if (call.totals.points == 0) out.count(without_contact);
    out.count(points_in_contact, static_cast<long>(call.totals.points));
    if (call.totals.sweeps >= call.options.sweep_limit) out.count(not_settled);
    else if (call.totals.largest_approach > 0.0)
        out.measure(residual_left, call.totals.residual / call.totals.largest_approach);
    // What is no number and not in contact stays so.
    for (const auto& [old, now] : {std::pair{&before.a, &call.a}, {&before.b, &call.b}})
        for (std::size_t i = 0; i < now->v.size(); ++i)
            out.demand(finite, std::isfinite(now->v[i]) || !std::isfinite(old->v[i]), program);
    for (const grit_surface_report& r : call.reports)
        out.demand(presses_only, r.normal_force >= 0.0, program);
    out.measure(friction_excess, call.friction_excess);
    out.demand(obeys_coulomb, call.friction_excess <= 1e-12, program);
    judge_motion(before, call, out);
    if (random.below(4) == 0) judge_beside(random, before, call, out);
    const auto finite_in = [](const Body& body) {
        return std::all_of(body.v.begin(), body.v.end(), [](double v) { return std::isfinite(v); });
    };
    if (!is_free || !finite_in(before.a) || !finite_in(before.b) || random.below(2)) return;
    judge_parts(random, before, out);
    judge_in_other_words(random, before, call, out);
}

void run_surface(Random& random, long cases, Findings& out) {
    for (long i = 0; i < cases; ++i) try_call(random, out);
}

}  // namespace

Kind surface_trials() { return {"surface", words, 5000, run_surface}; }

}  // namespace robustness
