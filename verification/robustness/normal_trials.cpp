// SPDX-License-Identifier: BSD-3-Clause
#include "robustness/normal_trials.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <grit/contact_normals.h>
#include <grit/version.h>

#include "robustness/layout.hpp"
#include "robustness/program_text.hpp"
#include "robustness/vec.hpp"

namespace robustness {
namespace {

enum Count { of_gradients, undefined, of_clouds, one_body, alike, not_converged, refused };
enum Largest { gradient_error, regression_error, turn_error, order_error };
enum Rule {
    known_status,
    unit_or_zero,
    untouched,
    held_is_zero,
    same_bits,
    does_not_see_names,
    does_not_see_units,
    is_along_gradients,
    is_undefined_as_told,
    turns_along,
    does_not_see_order,
    minimises_the_loss
};

const Vocabulary words = {
    {"normals of gradients", "undefined", "normals by regression", "of one body alone",
     "of clouds that do not differ", "not converged", "refused"},
    {"error of a normal of gradients, over what was lost in the difference",
     "error of a normal by regression, radians over 1 + condition / 10",
     "difference when turned, over the same", "difference in another order, over the same"},
    {"a status is one of a node's", "a normal has length 1 to 4e-16, or is zero",
     "a refused node keeps its bits", "held components are zero",
     "a batch gives the bits of single calls, whatever its strides",
     "bodies exchanged give the opposite normal, to the bit",
     "gradients times a power of two give the same bits",
     "a normal is along the gradients to 4e-15 of them",
     "a normal is undefined where less than the threshold is left",
     "turned clouds give turned normals to 1e-13 (1 + condition / 10)",
     "particles in another order give it to 1e-13 (1 + condition / 10)",
     "a normal is the minimum's in long double to 1e-13 (1 + condition / 10)"}};

const double bad_numbers[] = {NAN, INFINITY, -INFINITY};

bool is_unit_or_zero(const Vec& n) {
    return same(n, Vec{}) ||
           std::fabs(static_cast<double>(std::sqrt(static_cast<long double>(n[0]) * n[0] +
                                                   static_cast<long double>(n[1]) * n[1] +
                                                   static_cast<long double>(n[2]) * n[2]) -
                                         1.0L)) <= 4e-16;
}

bool holds(const Vec& n, int fixed) {
    for (std::size_t c = 0; c < 3; ++c)
        if ((fixed >> c & 1) && n[c] != 0.0) return false;
    return true;
}

Vec opposite(const Vec& n) { return {0.0 - n[0], 0.0 - n[1], 0.0 - n[2]}; }

// A host with two components has no third one, which stays as it was.
Vec as_written(const Vec& n, int components) { return {n[0], n[1], components == 3 ? n[2] : 0.0}; }

// ---- gradients ---------------------------------------------------------------------------------

struct Gradient {
    Vec a{}, b{}, given{};
    double scale = 0.0;
    int fixed = 0;
    Vec normal = {7.0, 7.0, 7.0};
    grit_status status = GRIT_OK;
};

struct GradientCall {
    int components = 2, source = 0;
    double threshold = 0.0;
    bool scaled = false;
};

GradientCall random_gradient_call(Random& random) {
    GradientCall call;
    call.components = 2 + random.below(2);
    call.source = random.below(4);
    if (random.below(2)) call.threshold = random.log_uniform(1e-16, 0.99);
    call.scaled = random.below(2);
    return call;
}

Gradient random_gradient(Random& random, const GradientCall& call) {
    Gradient x;
    const double size = random.log_uniform(1e-300, 1e300);
    const auto draw = [&](Vec& v) {
        v = random_vector(random, call.components);
        for (double& each : v) each *= size;
        if (random.below(20) == 0) v[static_cast<std::size_t>(random.below(2))] = 0.0;
        if (random.below(40) == 0) v = {};
    };
    draw(x.a);
    draw(x.b);
    draw(x.given);
    switch (random.below(4)) {
        case 0: x.b = opposite(x.a); break;
        case 1:  // alike: little is left of the difference
            x.b = plus(x.a, size * random.log_uniform(1e-18, 1.0),
                       random_vector(random, call.components));
            break;
        case 2: {
            const double less = random.log_uniform(1e-30, 1.0);
            for (double& each : x.b) each *= less;
            break;
        }
        default: break;
    }
    x.scale = norm(x.a) * random.log_uniform(1e-3, 1e12);
    if (random.below(3) == 0) x.fixed = random.below(1 << call.components);
    if (random.below(60) == 0) x.fixed = random.below(2) ? -1 : 1 << call.components;
    if (random.below(60) == 0) {
        Vec* const any[] = {&x.a, &x.b, &x.given};
        (*any[random.below(3)])[static_cast<std::size_t>(random.below(2))] =
            bad_numbers[random.below(3)];
    }
    if (random.below(100) == 0) x.scale = random.below(2) ? -1.0 : NAN;
    return x;
}

grit_contact_gradients options_of(const GradientCall& call) {
    grit_contact_gradients q{};
    q.struct_size = sizeof q;
    q.components = call.components;
    q.source = call.source;
    q.threshold = call.threshold;
    return q;
}

void find(const GradientCall& call, Gradient& x) {
    grit_contact_gradients q = options_of(call);
    q.gradient_a = grit_view_of(x.a.data(), 3, 1);
    q.gradient_b = grit_view_of(x.b.data(), 3, 1);
    q.given = grit_view_of(x.given.data(), 3, 1);
    if (call.scaled) q.scale = grit_view_of(&x.scale, 1, 1);
    q.fixed = &x.fixed;
    q.status = &x.status;
    q.normal = grit_mutable_view_of(x.normal.data(), 3, 1);
    grit_contact_normals_from_gradients(1, &q, nullptr, nullptr);
}

void find_together(Random& random, const GradientCall& call, std::vector<Gradient>& all) {
    const auto n = static_cast<std::ptrdiff_t>(all.size()), places = n + random.below(3);
    const std::vector<std::ptrdiff_t> index = shuffled(random, places);
    const int c = call.components, stride = 1 + random.below(3);
    Layout a(random, places, c), b(random, places, c), given(random, places, c),
        scale(random, places, 1), normal(random, places, c);
    std::vector<int> fixed(static_cast<std::size_t>(places * stride));
    std::vector<grit_status> status(all.size());
    for (std::ptrdiff_t i = 0; i < n; ++i) {
        const Gradient& x = all[static_cast<std::size_t>(i)];
        const std::ptrdiff_t at = index[static_cast<std::size_t>(i)];
        a.put(at, x.a.data());
        b.put(at, x.b.data());
        given.put(at, x.given.data());
        scale.put(at, &x.scale);
        normal.put(at, x.normal.data());
        fixed[static_cast<std::size_t>(at * stride)] = x.fixed;
    }
    grit_contact_gradients q = options_of(call);
    q.index = index.data();
    q.gradient_a = a.in();
    q.gradient_b = b.in();
    q.given = given.in();
    if (call.scaled) q.scale = scale.in();
    q.fixed = fixed.data();
    q.fixed_stride = stride;
    q.status = status.data();
    q.normal = normal.out();
    grit_contact_normals_from_gradients(n, &q, nullptr, nullptr);
    for (std::ptrdiff_t i = 0; i < n; ++i) {
        Gradient& x = all[static_cast<std::size_t>(i)];
        normal.get(index[static_cast<std::size_t>(i)], x.normal.data());
        x.status = status[static_cast<std::size_t>(i)];
    }
}

std::string program_of(const GradientCall& call, const Gradient& x) {
    return "#include <grit/grit.h>\n#include <stdio.h>\nint main(void) {\n    double a[] = " +
           numbers(x.a.data(), 3) + ", b[] = " + numbers(x.b.data(), 3) +
           ", g[] = " + numbers(x.given.data(), 3) + ", s = " + number_text(x.scale) +
           ", n[] = {7, 7, 7};\n    int fixed = " + std::to_string(x.fixed) +
           ";\n    grit_contact_gradients q = {sizeof q, " + std::to_string(call.components) +
           ", " + std::to_string(call.source) +
           "};\n    q.threshold = " + number_text(call.threshold) +
           "; q.fixed = &fixed; q.normal = grit_mutable_view_of(n, 3, 1);\n"
           "    q.gradient_a = grit_view_of(a, 3, 1); q.gradient_b = grit_view_of(b, 3, 1);\n"
           "    q.given = grit_view_of(g, 3, 1);" +
           (call.scaled ? " q.scale = grit_view_of(&s, 1, 1);" : "") +
           "\n    grit_error e = {0}; int status = grit_contact_normals_from_gradients(1, &q, 0, "
           "&e);\n    printf(\"%d %s %.17g %.17g %.17g\\n\", status, e.message, n[0], n[1], "
           "n[2]);\n}\n";
}

// (C2) in long double, whose exponents have room for the squares.
void judge_direction(const GradientCall& call, const Gradient& x, const Vec& n, Findings& out) {
    using Real = long double;
    const auto program = [&] { return program_of(call, x); };
    std::array<Real, 3> v{};
    Real left = 0.0L, a = 0.0L, b = 0.0L;
    for (std::size_t c = 0; c < 3; ++c) {
        const Real of_a = call.source == GRIT_CONTACT_NORMAL_GIVEN  ? x.given[c]
                          : call.source == GRIT_CONTACT_NORMAL_OF_B ? 0.0
                                                                    : x.a[c];
        const Real of_b =
            call.source == GRIT_CONTACT_NORMAL_OF_B || call.source == GRIT_CONTACT_NORMAL_AVERAGE
                ? x.b[c]
                : 0.0;
        a += of_a * of_a;
        b += of_b * of_b;
        if (!(x.fixed >> c & 1)) v[c] = of_a - of_b;
        left += v[c] * v[c];
    }
    left = std::sqrt(left);
    const Real terms = std::sqrt(a) + std::sqrt(b),
               threshold = call.threshold > 0.0 ? call.threshold : 1e-8,
               size = std::max(terms, call.scaled ? static_cast<Real>(x.scale) : 0.0L);
    const bool defined = !same(n, Vec{});
    if (!defined) out.count(undefined);
    // Beside the threshold either is right.
    const Real noise = 1e-14L * terms;
    if (left > threshold * size * (1.0L + 1e-14L) + noise)
        out.demand(is_undefined_as_told, defined, program);
    if (left < threshold * size * (1.0L - 1e-14L) - noise || left == 0.0L)
        out.demand(is_undefined_as_told, !defined, program);
    if (!defined || !(left > 0.0L)) return;
    Real apart = 0.0L;
    for (std::size_t c = 0; c < 3; ++c) apart += std::fabs(n[c] - v[c] / left);
    const double error = static_cast<double>(
        apart * left / (call.source == GRIT_CONTACT_NORMAL_AVERAGE ? terms : left));
    out.measure(gradient_error, error);
    out.demand(is_along_gradients, error <= 4e-15, program);
}

void judge(const GradientCall& call, const Gradient& x, const Gradient& y, Random& random,
           Findings& out) {
    const auto program = [&] { return program_of(call, x); };
    out.count(of_gradients);
    if (y.status != GRIT_OK) {
        out.count(refused);
        out.demand(known_status, y.status == GRIT_BAD_STATE || y.status == GRIT_BAD_CALL, program);
        out.demand(untouched, same(x.normal, y.normal), program);
        return;
    }
    const Vec n = as_written(y.normal, call.components);
    out.demand(unit_or_zero, is_unit_or_zero(n), program);
    out.demand(held_is_zero, holds(n, x.fixed), program);
    judge_direction(call, x, n, out);

    Gradient exchanged = x;
    std::swap(exchanged.a, exchanged.b);
    for (double& each : exchanged.given) each = -each;
    GradientCall other = call;
    if (call.source < GRIT_CONTACT_NORMAL_AVERAGE) other.source = 1 - call.source;
    find(other, exchanged);
    out.demand(does_not_see_names, same(opposite(as_written(exchanged.normal, call.components)), n),
               program);

    // Numbers at the ends of their range have other digits.
    for (const Vec* each : {&x.a, &x.b, &x.given})
        for (const double part : *each)
            if (part != 0.0 && !(std::fabs(part) > 1e-270 && std::fabs(part) < 1e270)) return;
    Gradient longer = x;
    const int digits = random.below(100) - 50;
    for (Vec* each : {&longer.a, &longer.b, &longer.given})
        for (double& part : *each) part = std::ldexp(part, digits);
    longer.scale = std::ldexp(x.scale, digits);
    find(call, longer);
    out.demand(does_not_see_units, longer.status == GRIT_OK && same(longer.normal, y.normal),
               program);
}

void try_gradients(Random& random, std::size_t n, Findings& out) {
    const GradientCall call = random_gradient_call(random);
    std::vector<Gradient> before, alone, together;
    for (std::size_t i = 0; i < n; ++i) before.push_back(random_gradient(random, call));
    alone = together = before;
    for (Gradient& x : alone) find(call, x);
    find_together(random, call, together);
    for (std::size_t i = 0; i < n; ++i) {
        out.demand(same_bits,
                   same(alone[i].normal, together[i].normal) &&
                       alone[i].status == together[i].status,
                   [&] { return program_of(call, before[i]); });
        judge(call, before[i], alone[i], random, out);
    }
}

// ---- regression --------------------------------------------------------------------------------

struct Cloud {
    std::vector<Vec> x;
    std::vector<int> body;
    std::vector<double> weight;
    int fixed = 0;
    Vec normal = {7.0, 7.0, 7.0};
    grit_status status = GRIT_OK;

    std::ptrdiff_t count() const { return static_cast<std::ptrdiff_t>(x.size()); }
    bool has_both() const {
        bool has[2] = {};
        for (std::size_t k = 0; k < x.size(); ++k)
            if (weight[k] > 0.0) has[body[k] == GRIT_CONTACT_BODY_B] = true;
        return has[0] && has[1];
    }
};

struct CloudCall {
    int components = 2, instruction_set = 0, limit = 0;
    double length = 1.0, ridge = 0.0;
    bool weighed = false;
};

CloudCall random_cloud_call(Random& random) {
    CloudCall call;
    call.components = 2 + random.below(2);
    call.instruction_set = 1 + random.below(grit_instruction_set());
    call.length = random.log_uniform(1e-30, 1e30);
    if (random.below(3)) call.ridge = random.log_uniform(1e-6, 1e3);
    if (random.below(20) == 0) call.limit = 1 + random.below(10);
    call.weighed = random.below(2);
    return call;
}

Cloud random_cloud(Random& random, const CloudCall& call) {
    Cloud out;
    const int n = 2 + random.below(random.below(8) == 0 ? 120 : 16);
    const Vec plane = random_normal(random, call.components),
              origin = random_vector(random, call.components);
    const double wide = random.below(4) ? 1.0 : random.log_uniform(1e-9, 20.0),
                 apart =
                     random.below(3) ? random.uniform(-1.0, 1.0) : random.log_uniform(1e-9, 20.0);
    const int shape = random.below(12);
    for (int k = 0; k < n; ++k) {
        const int body =
            random.below(shape == 0 ? 20 : 2) ? GRIT_CONTACT_BODY_B : GRIT_CONTACT_BODY_A;
        Vec x = random_vector(random, call.components);
        for (double& each : x) each *= wide;
        if (shape == 1) x = plus({}, x[0], plane);           // on a line
        if (shape == 2) x = plus(x, -dot(x, plane), plane);  // both in a plane
        if (shape == 3 && k > 0) x = Vec{};                  // at a place
        if (shape == 4)
            for (double& each : x) each = std::round(4.0 * each) / 4.0;
        const double side = body == GRIT_CONTACT_BODY_B ? 0.5 : -0.5;
        if (shape != 2 && shape != 3) x = plus(x, side * apart, plane);
        x = plus(origin, 1.0, x);
        for (double& each : x) each *= call.length;
        out.x.push_back(x);
        out.body.push_back(body);
        out.weight.push_back(random.below(20) ? random.log_uniform(1e-3, 1e3) : 0.0);
    }
    if (random.below(20) == 0)
        for (double& each : out.weight) each *= random.log_uniform(1e-97, 1e97);
    if (random.below(4) == 0) out.fixed = random.below(1 << call.components);
    if (random.below(60) == 0) out.fixed = 1 << call.components;
    const auto any = static_cast<std::size_t>(random.below(n));
    if (random.below(60) == 0) out.x[any][0] = bad_numbers[random.below(3)];
    if (random.below(60) == 0) out.x[any][1] += 300.0 * call.length;
    if (random.below(60) == 0) out.weight[any] = random.below(2) ? -1.0 : NAN;
    if (random.below(60) == 0) out.body[any] = 2;
    if (!call.weighed) std::fill(out.weight.begin(), out.weight.end(), 1.0);
    return out;
}

grit_contact_clouds options_of(const CloudCall& call) {
    grit_contact_clouds q{};
    q.struct_size = sizeof q;
    q.components = call.components;
    q.instruction_set = call.instruction_set;
    q.length = call.length;
    q.ridge = call.ridge;
    q.iteration_limit = call.limit;
    return q;
}

void regress(const CloudCall& call, Cloud& x) {
    const std::ptrdiff_t offset[] = {0, x.count()};
    grit_contact_clouds q = options_of(call);
    q.offset = offset;
    q.particles = x.count();
    q.position = grit_view_of(x.x[0].data(), 3, 1);
    q.body = x.body.data();
    if (call.weighed) q.weight = grit_view_of(x.weight.data(), 1, 1);
    q.fixed = &x.fixed;
    q.status = &x.status;
    q.normal = grit_mutable_view_of(x.normal.data(), 3, 1);
    std::vector<double> workspace(
        grit_contact_regression_workspace_size(x.count(), call.components) / sizeof(double) + 1,
        NAN);
    grit_contact_normals_by_regression(1, &q, workspace.data(), workspace.size() * sizeof(double),
                                       nullptr, nullptr);
}

// Particles of all nodes in one order of any, as a host that lists neighbours has them.
void regress_together(Random& random, const CloudCall& call, std::vector<Cloud>& all) {
    const auto n = static_cast<std::ptrdiff_t>(all.size());
    std::vector<std::ptrdiff_t> offset = {0};
    std::ptrdiff_t most = 0;
    for (const Cloud& x : all) {
        offset.push_back(offset.back() + x.count());
        most = std::max(most, x.count());
    }
    const std::ptrdiff_t particles = offset.back();
    const std::vector<std::ptrdiff_t> particle = shuffled(random, particles);
    const int c = call.components, stride = 1 + random.below(3);
    Layout position(random, particles, c), weight(random, particles, 1), normal(random, n, c);
    std::vector<int> body(static_cast<std::size_t>(particles * stride)),
        fixed(static_cast<std::size_t>(n * stride));
    std::vector<grit_status> status(all.size());
    for (std::ptrdiff_t i = 0; i < n; ++i) {
        const Cloud& x = all[static_cast<std::size_t>(i)];
        for (std::size_t k = 0; k < x.x.size(); ++k) {
            const std::ptrdiff_t p =
                particle[static_cast<std::size_t>(offset[static_cast<std::size_t>(i)]) + k];
            position.put(p, x.x[k].data());
            weight.put(p, &x.weight[k]);
            body[static_cast<std::size_t>(p * stride)] = x.body[k];
        }
        normal.put(i, x.normal.data());
        fixed[static_cast<std::size_t>(i * stride)] = x.fixed;
    }
    grit_contact_clouds q = options_of(call);
    q.offset = offset.data();
    q.particle = particle.data();
    q.particles = particles;
    q.position = position.in();
    q.body = body.data();
    q.body_stride = stride;
    if (call.weighed) q.weight = weight.in();
    q.fixed = fixed.data();
    q.fixed_stride = stride;
    q.status = status.data();
    q.normal = normal.out();
    std::vector<double> workspace(
        grit_contact_regression_workspace_size(most, c) / sizeof(double) + 1, -1.0);
    grit_contact_normals_by_regression(n, &q, workspace.data(), workspace.size() * sizeof(double),
                                       nullptr, nullptr);
    for (std::ptrdiff_t i = 0; i < n; ++i) {
        Cloud& x = all[static_cast<std::size_t>(i)];
        normal.get(i, x.normal.data());
        x.status = status[static_cast<std::size_t>(i)];
    }
}

std::string program_of(const CloudCall& call, const Cloud& x) {
    std::string bodies;
    for (const int each : x.body) bodies += std::to_string(each) + ", ";
    return "#include <grit/grit.h>\n#include <stdio.h>\nstatic double room[4000];\nint main(void) "
           "{\n    double x[] = " +
           numbers(x.x[0].data(), 3 * x.x.size()) +
           ";\n    double m[] = " + numbers(x.weight.data(), x.weight.size()) +
           ", n[] = {7, 7, 7};\n    int body[] = {" + bodies +
           "}, fixed = " + std::to_string(x.fixed) + "; ptrdiff_t offset[] = {0, " +
           std::to_string(x.count()) + "};\n    grit_contact_clouds q = {sizeof q, " +
           std::to_string(call.components) + ", " + std::to_string(call.instruction_set) +
           "};\n    q.offset = offset; q.particles = offset[1]; q.body = body; q.fixed = &fixed; "
           "q.length = " +
           number_text(call.length) + ";\n    q.ridge = " + number_text(call.ridge) +
           "; q.iteration_limit = " + std::to_string(call.limit) +
           "; q.position = grit_view_of(x, 3, 1);\n    q.normal = grit_mutable_view_of(n, 3, 1);" +
           (call.weighed ? " q.weight = grit_view_of(m, 1, 1);" : "") +
           "\n    grit_error e = {0}; int status = grit_contact_normals_by_regression(1, &q, "
           "room, sizeof room, 0, &e);\n"
           "    printf(\"%d %s %.17g %.17g %.17g\\n\", status, e.message, n[0], n[1], n[2]);\n}\n";
}

// The minimum of the header's loss in long double: Newton steps that are halved until the loss falls.
struct Minimum {
    Vec direction{};
    double condition = 1.0;  // how many times the roundoff of positions moves the direction
    bool found = false;
};

Minimum minimum_of(const CloudCall& call, const Cloud& cloud) {
    using Real = long double;
    constexpr int most = 4;
    struct Row {
        Real x[most], y, share;
    };
    std::size_t free[most] = {};
    int D = 0;
    for (int c = 0; c < call.components; ++c)
        if (!(cloud.fixed >> c & 1)) free[D++] = static_cast<std::size_t>(c);
    const Real ridge = call.ridge > 0.0 ? call.ridge : 1e-3;
    Real total[2] = {}, mean[most] = {}, reach = 0.0L, radius = 0.0L;
    std::vector<Row> rows;
    for (std::size_t k = 0; k < cloud.x.size(); ++k) {
        if (cloud.weight[k] == 0.0) continue;
        Row row{};
        for (int r = 0; r < D; ++r) row.x[r] = static_cast<Real>(cloud.x[k][free[r]]) / call.length;
        row.x[D] = 1.0L;
        row.y = cloud.body[k] == GRIT_CONTACT_BODY_B ? 1.0L : -1.0L;
        row.share = cloud.weight[k];
        for (int r = 0; r < D; ++r) reach = std::max(reach, std::fabs(row.x[r]));
        total[cloud.body[k]] += row.share;
        rows.push_back(row);
        for (int r = 0; r < D; ++r) mean[r] += row.x[r];
    }
    for (Row& row : rows) {
        row.share *= 0.5L / total[row.y > 0.0L];
        for (int r = 0; r < D; ++r) {
            row.x[r] -= mean[r] / static_cast<Real>(rows.size());
            radius = std::max(radius, std::fabs(row.x[r]));
        }
    }
    const auto loss_at = [&](const Real* u, Real* g, Real H[][most]) {
        Real value = 0.0L;
        if (g)
            for (int r = 0; r <= D; ++r) {
                g[r] = 0.0L;
                for (int c = 0; c <= D; ++c) H[r][c] = 0.0L;
            }
        for (int r = 0; r < D; ++r) {
            value += ridge / 2.0L * u[r] * u[r];
            if (g) {
                g[r] = ridge * u[r];
                H[r][r] = ridge;
            }
        }
        for (const Row& row : rows) {
            Real m = 0.0L;
            for (int r = 0; r <= D; ++r) m += u[r] * row.x[r];
            m *= row.y;
            value +=
                row.share * (m > 0.0L ? std::log1p(std::exp(-m)) : std::log1p(std::exp(m)) - m);
            if (!g) continue;
            const Real wrong = 1.0L / (1.0L + std::exp(m)), right = 1.0L / (1.0L + std::exp(-m));
            for (int r = 0; r <= D; ++r) {
                g[r] -= row.share * wrong * row.y * row.x[r];
                for (int c = 0; c <= D; ++c)
                    H[r][c] += row.share * wrong * right * row.x[r] * row.x[c];
            }
        }
        return value;
    };
    Real u[most] = {}, g[most], H[most][most], inverse = 0.0L;
    Minimum out;
    for (int newton = 0; newton < 300 && !out.found; ++newton) {
        const Real value = loss_at(u, g, H);
        // Gaussian elimination of a positive definite matrix, with the columns of its inverse.
        constexpr int columns = 1 + most;
        Real step[most][columns];
        for (int r = 0; r <= D; ++r)
            for (int c = 0; c < columns; ++c)
                step[r][c] = c == 0 ? -g[r] : r + 1 == c ? 1.0L : 0.0L;
        for (int r = 0; r <= D; ++r)
            for (int s = r + 1; s <= D; ++s) {
                const Real part = H[s][r] / H[r][r];
                for (int c = r; c <= D; ++c) H[s][c] -= part * H[r][c];
                for (int c = 0; c < columns; ++c) step[s][c] -= part * step[r][c];
            }
        inverse = 0.0L;
        for (int r = D; r >= 0; --r)
            for (int c = 0; c < columns; ++c) {
                for (int k = r + 1; k <= D; ++k) step[r][c] -= H[r][k] * step[k][c];
                step[r][c] /= H[r][r];
                if (c > 0 && r < D) inverse = std::max(inverse, std::fabs(step[r][c]));
            }
        Real size = 0.0L, change = 0.0L;
        for (int r = 0; r <= D; ++r) size += std::fabs(u[r]), change += std::fabs(step[r][0]);
        for (Real share = 1.0L; share > 1e-9L; share /= 2.0L) {
            Real next[most];
            for (int r = 0; r <= D; ++r) next[r] = u[r] + share * step[r][0];
            if (change < 1e-9L * (1.0L + size) ||
                loss_at(next, nullptr, nullptr) <= value * (1.0L + 1e-18L)) {
                std::copy(next, next + D + 1, u);
                break;
            }
        }
        out.found = change < 1e-13L * (1.0L + size);
    }
    Real square = 0.0L;
    for (int r = 0; r < D; ++r) square += u[r] * u[r];
    out.condition =
        static_cast<double>(inverse * reach * (0.25L * radius + 1.0L / std::sqrt(square)));
    for (int r = 0; r < D; ++r)
        out.direction[free[r]] = static_cast<double>(u[r] / std::sqrt(square));
    return out;
}

double apart(const Vec& a, const Vec& b) { return norm(plus(a, -1.0, b)); }

void judge(const CloudCall& call, const Cloud& x, const Cloud& y, Random& random, Findings& out) {
    const auto program = [&] { return program_of(call, x); };
    out.count(of_clouds);
    if (y.status != GRIT_OK) {
        out.count(y.status == GRIT_NOT_CONVERGED ? not_converged : refused);
        out.demand(known_status,
                   y.status == GRIT_BAD_STATE || y.status == GRIT_BAD_CALL ||
                       (y.status == GRIT_NOT_CONVERGED && call.limit > 0),
                   program);
        out.demand(untouched, same(x.normal, y.normal), program);
        return;
    }
    const Vec n = as_written(y.normal, call.components);
    out.demand(unit_or_zero, is_unit_or_zero(n), program);
    out.demand(held_is_zero, holds(n, x.fixed), program);
    if (!x.has_both()) {
        out.count(one_body);
        out.demand(is_undefined_as_told, same(n, Vec{}), program);
        return;
    }
    if (same(n, Vec{})) out.count(alike);
    if (call.limit > 0 || random.below(4)) return;
    const Minimum exact = minimum_of(call, x);
    // Clouds that hardly differ have a normal of roundoff, or none.
    if (!exact.found || !(exact.condition < 1e8)) return;
    const double rough = 1.0 + 0.1 * exact.condition;
    const double error = apart(n, exact.direction) / rough;
    out.measure(regression_error, error);
    out.demand(minimises_the_loss, error <= 1e-13, program);

    Cloud exchanged = x;
    for (int& each : exchanged.body) each = 1 - each;
    regress(call, exchanged);
    out.demand(does_not_see_names, same(opposite(as_written(exchanged.normal, call.components)), n),
               program);

    Cloud other = x;
    const std::vector<std::ptrdiff_t> order = shuffled(random, x.count());
    for (std::size_t k = 0; k < order.size(); ++k) {
        const auto from = static_cast<std::size_t>(order[k]);
        other.x[k] = x.x[from];
        other.body[k] = x.body[from];
        other.weight[k] = x.weight[from];
    }
    regress(call, other);
    const double moved = apart(as_written(other.normal, call.components), n);
    out.measure(order_error, moved / rough);
    out.demand(does_not_see_order, moved <= 1e-13 * rough, program);

    if (x.fixed != 0) return;
    Cloud aside = x;
    const double angle = random.uniform(0.0, 6.283185307179586);
    for (Vec& each : aside.x) each = turned(each, angle);
    regress(call, aside);
    const double off = apart(as_written(aside.normal, call.components), turned(n, angle));
    out.measure(turn_error, off / rough);
    out.demand(turns_along, off <= 1e-13 * rough, program);
}

void try_clouds(Random& random, std::size_t n, Findings& out) {
    const CloudCall call = random_cloud_call(random);
    std::vector<Cloud> before, alone, together;
    for (std::size_t i = 0; i < n; ++i) before.push_back(random_cloud(random, call));
    alone = together = before;
    for (Cloud& x : alone) regress(call, x);
    regress_together(random, call, together);
    for (std::size_t i = 0; i < n; ++i) {
        out.demand(same_bits,
                   same(alone[i].normal, together[i].normal) &&
                       alone[i].status == together[i].status,
                   [&] { return program_of(call, before[i]); });
        judge(call, before[i], alone[i], random, out);
    }
}

constexpr long most_at_once = 31;

void run_normals(Random& random, long cases, Findings& out) {
    for (long tried = 0; tried < cases;) {
        const auto n =
            static_cast<std::size_t>(std::min<long>(1 + random.below(most_at_once), cases - tried));
        if (random.below(2)) try_gradients(random, n, out);
        else try_clouds(random, n, out);
        tried += static_cast<long>(n);
    }
}

}  // namespace

Kind normal_trials() { return {"normals", words, 100000, run_normals}; }

}  // namespace robustness
