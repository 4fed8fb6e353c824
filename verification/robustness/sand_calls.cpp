// SPDX-License-Identifier: BSD-3-Clause
#include "robustness/sand_calls.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>

#include "robustness/program_text.hpp"

namespace robustness {
namespace {

constexpr double untouched_tangent = 7.0;

double norm(const double* a, double shear) {
    double sum = 0.0;
    for (int c = 0; c < 6; ++c) sum += (c < 3 ? 1.0 : shear) * a[c] * a[c];
    return std::sqrt(sum);
}

// Mostly the published ones, or everything that grit_sand_prepare takes.
void random_sand(Random& random, Call& call) {
    grit_sand_parameters& p = call.parameters;
    for (;;) {
        grit_sand_parameters_init(&p, sizeof p);
        call.of_catalogue = random.below(3) == 0;
        if (call.of_catalogue) {
            grit_sand_record_parameters(random.below(grit_sand_record_count()), 1.0, &p);
        } else {
            for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i) {
                const grit_sand_parameter_info& info = *grit_sand_parameter_describe(i);
                const double low = std::max(info.lowest, 1e-3 * info.highest);
                grit_sand_parameter_set(&p, i,
                                        random.below(2) ? random.uniform(info.lowest, info.highest)
                                                        : random.log_uniform(low, info.highest));
            }
            p.granulate_hardness =
                random.below(8) ? random.log_uniform(1e4, 1e11) : random.log_uniform(1e-30, 1e30);
            p.densest_void_ratio = random.log_uniform(0.01, 5.0);
            p.critical_void_ratio = random.log_uniform(p.densest_void_ratio, 5.0);
            p.loosest_void_ratio = random.log_uniform(p.critical_void_ratio, 5.0);
            p.pressure_shift =
                random.below(3) ? 0.0 : p.granulate_hardness * random.log_uniform(1e-14, 1.0);
            p.transverse_stiffness = random.log_uniform(1.0, p.reversal_stiffness);
            p.elastic_strain_radius = random.log_uniform(1e-6, 1e-2);
            p.evolution_exponent = random.log_uniform(0.01, 2.0);
            if (random.below(6) == 0)
                p.reversal_stiffness = p.transverse_stiffness = p.elastic_strain_radius =
                    p.evolution_exponent = p.stiffness_interpolation_exponent = NAN;
        }
        if (grit_sand_prepare(&p, &call.sand, nullptr) == GRIT_OK) return;
    }
}

// About a random axis, in the plane about the third one.
void random_rotation(Random& random, int components, double Q[9]) {
    double q[4] = {random.normal(), random.normal(), random.normal(), random.normal()};
    if (components == 4) q[1] = q[2] = 0.0;
    if (random.below(2)) q[0] += random.log_uniform(1.0, 1e6);
    double size = 0.0;
    for (const double each : q) size += each * each;
    for (double& each : q) each /= std::sqrt(size);
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    const double made[9] = {
        1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),
        2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
        2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y)};
    std::copy(made, made + 9, Q);
}

// Of n points in as many places or some more; listed: unless they are in a row, all of them.
std::vector<std::ptrdiff_t> any_order(Random& random, std::ptrdiff_t n, bool& listed) {
    const std::ptrdiff_t places = n + random.below(3);
    listed = places > n || random.below(2);
    if (listed) return shuffled(random, places);
    std::vector<std::ptrdiff_t> index(static_cast<std::size_t>(places));
    std::iota(index.begin(), index.end(), 0);
    return index;
}

}  // namespace

bool with_memory(const Call& call) {
    return !std::isnan(call.parameters.elastic_strain_radius) && !call.options.intergranular_off;
}

double norm_of_stress(const double* T) { return norm(T, 2.0); }
double norm_of_strain(const double* E) { return norm(E, 0.5); }

void random_tensor(Random& random, double length, double shear_factor, int components,
                   double out[6]) {
    for (int c = 0; c < 6; ++c) out[c] = c < components ? random.normal() : 0.0;
    const double size = norm_of_stress(out);
    for (int c = 0; c < 6; ++c) out[c] *= length / size * (c < 3 ? 1.0 : shear_factor);
}

Call random_call(Random& random) {
    Call call;
    random_sand(random, call);
    grit_sand_options_init(&call.options, sizeof call.options);
    call.options.tolerance =
        random.below(16) ? random.log_uniform(1e-6, 0.1) : random.log_uniform(1e-12, 0.1);
    if (random.below(4) == 0) call.options.tolerance = GRIT_SAND_DEFAULT_TOLERANCE;
    call.options.evaluation_limit = random.below(4)   ? 2000
                                    : random.below(4) ? 2 + random.below(50)
                                                      : 20000;
    call.options.intergranular_off = random.below(8) == 0;
    call.options.tangent = random.below(8) == 0 ? 1 + random.below(2) : GRIT_TANGENT_NONE;
    call.options.instruction_set = 1 + random.below(grit_instruction_set());
    call.components = random.below(4) ? 6 : 4;
    call.rotated = random.below(6) == 0;
    call.options.stress_is_rotated = call.rotated && random.below(2);
    call.advised = random.below(3) == 0;
    return call;
}

Point random_point(Random& random, const Call& call) {
    Point x;
    const grit_sand_parameters& s = call.parameters;
    const double p =
        s.granulate_hardness *
        std::pow(10.0, random.below(2) ? random.uniform(-12.0, 1.0) : random.uniform(-8.0, -2.0));
    random_tensor(random, 1.0, 1.0, call.components, x.stress);
    const double mean = (x.stress[0] + x.stress[1] + x.stress[2]) / 3.0;
    for (int c = 0; c < 3; ++c) x.stress[c] -= mean;
    const int where = random.below(20);
    const double tan_psi = where == 0   ? random.uniform(1.4, 10.0)
                           : where == 1 ? std::sqrt(2.0) * (1.0 + 1e-15 * random.below(3))
                           : where == 2 ? 0.0
                           : where == 3 ? random.log_uniform(1e-16, 1e-3)
                                        : random.uniform(0.0, 1.2);
    const double size = std::max(norm_of_stress(x.stress), 1e-300);
    for (int c = 0; c < 6; ++c)
        x.stress[c] = x.stress[c] * tan_psi * std::sqrt(3.0) * p / size - (c < 3 ? p : 0.0);
    if (where == 4)
        for (double& each : x.stress) each = random.below(2) ? -each : 0.0;
    if (where == 5)
        for (double& each : x.stress) each = 0.0;

    double limits[3];
    grit_sand_void_ratios(&call.sand, p, limits);
    const double place =
        random.below(10) == 0 ? random.uniform(-3.0, 5.0) : random.uniform(0.0, 1.2);
    double e = limits[2] + place * (limits[1] - limits[2]);
    if (random.below(50) == 0) e = limits[random.below(3)];
    x.state[GRIT_SAND_VOID_RATIO] = e;
    if (where == 5 && random.below(2))
        x.state[GRIT_SAND_SEPARATION] = random.log_uniform(1e-16, 1.0);

    const double strain =
        random.below(3) ? random.log_uniform(1e-8, 1e-1) : random.log_uniform(1e-15, 1.0);
    random_tensor(random, strain, 2.0, call.components, x.strain);
    const int way = random.below(30);
    if (way == 0) std::fill(x.strain, x.strain + 6, 0.0);
    if (way == 1 || way == 2)  // of volume alone
        for (int c = 0; c < 6; ++c)
            x.strain[c] = c < 3 ? (way == 1 ? -1 : 1) * strain / std::sqrt(3.0) : 0.0;

    const double R = std::isnan(s.elastic_strain_radius) ? 1e-4 : s.elastic_strain_radius;
    random_tensor(random, R, 2.0, call.components, x.state);
    const double along = norm_of_strain(x.strain) > 0.0 ? R / norm_of_strain(x.strain) : 0.0;
    double rho = 1.0;
    switch (random.below(12)) {
        case 0: rho = 0.0; break;
        case 1: rho = random.log_uniform(1e-16, 1.0); break;
        case 2: rho = random.uniform(1.0, 1.02); break;
        case 3: rho = 1.0; break;
        case 4: rho = random.uniform(1.0, 3.0); break;
        case 5:  // exactly at a reversal, or mobilised
        case 6: {
            const double sign = random.below(2) ? 1.0 : -1.0;
            for (int c = 0; c < 6; ++c) x.state[c] = sign * along * x.strain[c];
            break;
        }
        default: rho = random.uniform();
    }
    for (int c = 0; c < 6; ++c) x.state[c] *= rho;
    if (call.rotated) random_rotation(random, call.components, x.rotation);
    if (call.advised) x.substep = random.below(3) ? random.log_uniform(1e-12, 1.0) : 0.0;
    if (random.below(200) == 0) {
        const double bad[] = {NAN, INFINITY, -INFINITY, 1e308, -1e308, 4.9e-324};
        double* const member[] = {x.strain, x.stress, x.state, x.rotation};
        member[random.below(4)][random.below(4)] = bad[random.below(6)];
    }
    std::fill(x.tangent, x.tangent + 36, untouched_tangent);
    return x;
}

grit_sand_points views_of(const Call& call, Point& x) {
    grit_sand_points q{};
    q.struct_size = sizeof q;
    q.components = call.components;
    q.strain_increment = grit_view_of(x.strain, 6, 1);
    if (call.rotated) q.rotation_increment = grit_view_of(x.rotation, 9, 1);
    q.stress = grit_mutable_view_of(x.stress, 6, 1);
    q.state = grit_mutable_view_of(x.state, GRIT_SAND_STATE_SIZE, 1);
    q.tangent = grit_mutable_matrix_view_of(x.tangent, 36, call.components, 1);
    if (call.advised) q.substep = grit_mutable_view_of(&x.substep, 1, 1);
    return q;
}

bool same(const Point& a, const Point& b) {
    return std::memcmp(a.stress, b.stress, sizeof a.stress) == 0 &&
           std::memcmp(a.state, b.state, sizeof a.state) == 0 &&
           std::memcmp(a.tangent, b.tangent, sizeof a.tangent) == 0 &&
           std::memcmp(&a.substep, &b.substep, sizeof a.substep) == 0;
}

bool same_report(const Point& a, const Point& b) {
    return std::memcmp(&a.report, &b.report, sizeof a.report) == 0;
}

bool is_rotation(const double* Q) {
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) {
            double product = r == c ? -1.0 : 0.0;
            for (int k = 0; k < 3; ++k) product += Q[3 * r + k] * Q[3 * c + k];
            if (!(std::fabs(product) < 1e-9)) return false;
        }
    return true;
}

bool near_axis(const double* T) {
    double deviator[6];
    const double mean = (T[0] + T[1] + T[2]) / 3.0;
    for (int c = 0; c < 6; ++c) deviator[c] = T[c] - (c < 3 ? mean : 0.0);
    return norm_of_stress(deviator) < 0.02 * std::fabs(mean);
}

bool all_finite(const double* x, int n) {
    return std::all_of(x, x + n, [](double each) { return std::isfinite(each); });
}

Scattered::Scattered(Random& random, const Call& call, std::ptrdiff_t n)
    : components(call.components), rotated(call.rotated), advised(call.advised),
      index(any_order(random, n, listed)), strain(random, places(), components),
      rotation(random, places(), 9), stress(random, places(), components),
      state(random, places(), GRIT_SAND_STATE_SIZE),
      tangent(random, places(), components * components), substep(random, places(), 1) {}

void Scattered::put(const std::vector<Point>& points) {
    std::ptrdiff_t i = 0;
    for (const Point& x : points) {
        const std::ptrdiff_t at = place(i++);
        strain.put(at, x.strain);
        rotation.put(at, x.rotation);
        stress.put(at, x.stress);
        state.put(at, x.state);
        tangent.put(at, x.tangent);
        substep.put(at, &x.substep);
    }
}

grit_sand_points Scattered::views() const {
    grit_sand_points q{};
    q.struct_size = sizeof q;
    q.components = static_cast<int>(components);
    if (listed) q.index = index.data();
    q.strain_increment = strain.in();
    if (rotated) q.rotation_increment = rotation.in();
    q.stress = stress.out();
    q.state = state.out();
    q.tangent = tangent.matrix(components);
    if (advised) q.substep = substep.out();
    return q;
}

void Scattered::get(std::vector<Point>& points,
                    const std::vector<grit_sand_report>& reports) const {
    std::ptrdiff_t i = 0;
    for (Point& x : points) {
        x.report = reports[static_cast<std::size_t>(i)];
        const std::ptrdiff_t at = place(i++);
        stress.get(at, x.stress);
        state.get(at, x.state);
        tangent.get(at, x.tangent);
        if (advised) substep.get(at, &x.substep);
    }
}

std::string program_of(const Call& call, const Point& x, const std::string& calls,
                       const std::string& says) {
    std::array<double, GRIT_SAND_PARAMETER_COUNT> parameters{};
    for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i)
        grit_sand_parameter_get(&call.parameters, i, &parameters[static_cast<std::size_t>(i)]);
    const grit_sand_options& o = call.options;
    return "#include <grit/grit.h>\n#include <stdio.h>\nint main(void) {\n    double v[] = " +
           numbers(parameters.data(), parameters.size()) +
           ";\n    double d[] = " + numbers(x.strain, 6) + ", T[] = " + numbers(x.stress, 6) +
           ";\n    double q[] = " + numbers(x.state, GRIT_SAND_STATE_SIZE) +
           ", M[36], s = " + numbers(&x.substep, 1, "") +
           ";\n    double Q[] = " + numbers(x.rotation, 9) +
           ";\n    grit_sand_parameters p; grit_sand_parameters_init(&p, sizeof p);\n"
           "    for (int i = 0; i < 14; ++i) grit_sand_parameter_set(&p, i, v[i]);\n"
           "    grit_sand sand; grit_sand_prepare(&p, &sand, 0);\n"
           "    grit_sand_options o; grit_sand_options_init(&o, sizeof o);\n    o.tolerance = " +
           numbers(&o.tolerance, 1, "") +
           "; o.evaluation_limit = " + std::to_string(o.evaluation_limit) +
           "; o.intergranular_off = " + std::to_string(o.intergranular_off) +
           ";\n    o.tangent = " + std::to_string(o.tangent) +
           "; o.instruction_set = " + std::to_string(o.instruction_set) +
           "; o.stress_is_rotated = " + std::to_string(o.stress_is_rotated) +
           ";\n    grit_sand_points x = {sizeof x, " + std::to_string(call.components) +
           "};\n    x.strain_increment = grit_view_of(d, 6, 1); x.stress = grit_mutable_view_of(T, "
           "6, 1);\n"
           "    x.state = grit_mutable_view_of(q, 8, 1); x.tangent = "
           "grit_mutable_matrix_view_of(M, 36, " +
           std::to_string(call.components) + ", 1);\n" +
           (call.rotated ? "    x.rotation_increment = grit_view_of(Q, 9, 1);\n"
                         : "    (void)Q;\n") +
           (call.advised ? "    x.substep = grit_mutable_view_of(&s, 1, 1);\n" : "    (void)s;\n") +
           "    grit_sand_report r;\n    " + calls +
           "\n"
           "    printf(\"status %d flags %d evaluations %d\\n\", r.status, r.flags, "
           "r.evaluations);\n"
           "    for (int c = 0; c < 6; ++c) printf(\"%.17g %.17g\\n\", T[c], q[c]);\n" +
           (says.empty() ? "" : "    " + says + "\n") + "}\n";
}

}  // namespace robustness
