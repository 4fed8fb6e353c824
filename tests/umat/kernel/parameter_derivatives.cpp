// SPDX-License-Identifier: BSD-3-Clause
// Derivatives by parameters against a complex step in long double through the very same steps: every decision is that
// of the plain number, which is carried beside it.
#define GRIT_TARGET kernel_test
#include <gtest/gtest.h>

#include <algorithm>
#include <complex>

#include "umat/batch/differentiated_points.hpp"

#include "tests/umat/support/random_sand.hpp"
#include "tests/umat/support/states.hpp"

namespace grit::kernel_test {
namespace {

// When the shadow returns to its plain number, so that it is the derivative of the same points: where a step has ended, or
// with every operation. No parameter of a template: the kernels take a minute to compile for each.
enum class Settles { by_step, by_operation };
Settles settles = Settles::by_step;

struct Shadowed {
    using Shadow = std::complex<long double>;
    double v = 0.0;
    Shadow x = 0.0L;

    Shadowed() = default;
    Shadowed(double plain) : v(plain), x(plain) {}
    Shadowed(double plain, const Shadow& shadow) : v(plain), x(shadow) {
        if (settles == Settles::by_operation) settle(*this);
    }

    friend void settle(Shadowed& a) { a.x.real(a.v); }
    friend Shadowed operator+(const Shadowed& a, const Shadowed& b) {
        return {a.v + b.v, a.x + b.x};
    }
    friend Shadowed operator-(const Shadowed& a, const Shadowed& b) {
        return {a.v - b.v, a.x - b.x};
    }
    friend Shadowed operator*(const Shadowed& a, const Shadowed& b) {
        return {a.v * b.v, a.x * b.x};
    }
    friend Shadowed operator/(const Shadowed& a, const Shadowed& b) {
        return {a.v / b.v, a.x / b.x};
    }
    friend Shadowed operator-(const Shadowed& a) { return {-a.v, -a.x}; }
    friend bool operator<(const Shadowed& a, const Shadowed& b) { return a.v < b.v; }
    friend bool operator>(const Shadowed& a, const Shadowed& b) { return a.v > b.v; }
    friend bool operator>=(const Shadowed& a, const Shadowed& b) { return a.v >= b.v; }
    friend double value(const Shadowed& a) { return a.v; }
    friend Shadowed select(bool mask, const Shadowed& yes, const Shadowed& no) {
        return mask ? yes : no;
    }
    friend Shadowed fma(const Shadowed& a, const Shadowed& b, const Shadowed& c) {
        return {kernel_test::fma(a.v, b.v, c.v), a.x * b.x + c.x};
    }
    friend Shadowed sqrt(const Shadowed& a) { return {kernel_test::sqrt(a.v), std::sqrt(a.x)}; }
    friend Shadowed fabs(const Shadowed& a) { return a.v < 0.0 ? -a : a; }
    friend Shadowed exp(const Shadowed& a) { return {kernel_test::exp(a.v), std::exp(a.x)}; }
    friend Shadowed log(const Shadowed& a) { return {kernel_test::log(a.v), std::log(a.x)}; }
};

template <> constexpr bool is_sensitive<Shadowed> = true;

Shadowed power(const SensitiveExponent<Shadowed>& q, const Shadowed& x) {
    return {power(Exponent{q.value.v, q.quarters}, x.v), std::exp(q.value.x * std::log(x.x))};
}

void settle(Tensor<Shadowed>& A) {
    for (auto& component : A.c) settle(component);
}
void settle(Marched<Shadowed>& y) {
    settle(y.T);
    settle(y.compression.x);
    settle(y.compression.expansion);
}
void settle(Mobilisation<Shadowed>& h) {
    for (auto* x : {&h.rho, &h.c, &h.across, &h.J, &h.J_growth, &h.rho_beta}) settle(*x);
}
void settle(Waypoint<Shadowed>& w) {
    for (auto* x : {&w.ds, &w.e, &w.along, &w.across, &w.flow}) settle(*x);
}
void settle(StateOf<Shadowed>& x) {
    settle(x.T);
    settle(x.h);
    settle(x.e);
    settle(x.w);
}

// The kernels call it where they take over what a step has made.
template <template <class> class Of>
void assign(bool where, Of<Shadowed>& to, const Of<Shadowed>& x) {
    if (!where) return;
    to = x;
    settle(to);
}

}  // namespace
}  // namespace grit::kernel_test

namespace {

namespace kernel = grit::kernel_test;
using namespace tests;
using kernel::Sensitive;
using kernel::Settles;
using kernel::Shadowed;
using Shadow = std::complex<long double>;

constexpr int of_e = GRIT_SAND_PARAMETER_COUNT;  // the initial void ratio
constexpr int directions = of_e + 1;

// So small that no derivative of a path makes it a large one: some grow by 1e70.
constexpr long double step = 1e-1000L;

// The constants of a material as grit_sand_prepare has them, in long double: (H4), (H8).
kernel::SensitiveMaterial<Shadowed> shadowed(const grit::Material& m, int direction) {
    using kernel::SensitiveExponent;
    const auto variable = [&](double x, int own) {
        return Shadowed(x, Shadow(x, own == direction ? step : 0.0L));
    };
    const Shadow phi_c = variable(m.phi_c, 0).x, h_s = variable(m.h_s, 1).x,
                 alpha = variable(m.alpha, 6).x, beta = variable(m.beta, 7).x;
    kernel::SensitiveMaterial<Shadowed> r;
    r.at = &m;
    r.n = variable(m.n, 2);
    r.e_d0 = variable(m.e_d0, 3);
    r.e_c0 = variable(m.e_c0, 4);
    r.e_i0 = variable(m.e_i0, 5);
    r.p_t = variable(m.p_t, 8);
    r.m_R = variable(m.m_R, 9);
    r.m_T = variable(m.m_T, 10);
    r.R = variable(m.R, 11);
    r.beta_r = variable(m.beta_r, 12);
    r.chi = variable(m.chi, 13);
    const Shadow sine = std::sin(phi_c);
    const long double root_2 = std::sqrt(2.0L), root_3 = std::sqrt(3.0L);
    const Shadow a = root_3 * (3.0L - sine) / (2.0L * root_2 * sine);
    const Shadow range = r.e_c0.x - r.e_d0.x;
    const Shadow bracket =
        3.0L + a * a - root_3 * a * std::pow((r.e_i0.x - r.e_d0.x) / range, alpha);
    r.a = {m.a, a};
    r.stiffness = {m.stiffness, h_s / r.n.x * std::pow(r.e_i0.x / r.e_c0.x, beta) / bracket};
    r.three_over_hs = {m.three_over_hs, 3.0L / h_s};
    r.inverse_e_range = {m.inverse_e_range, 1.0L / range};
    r.inverse_e_i0 = {m.inverse_e_i0, 1.0L / r.e_i0.x};
    r.inverse_R = {m.inverse_R, 1.0L / r.R.x};
    r.p_floor = {m.p_floor, static_cast<long double>(grit::floor_per_hardness) * h_s};
    const auto exponent = [](const grit::Exponent& plain, const Shadow& x) {
        return SensitiveExponent<Shadowed>{{plain.value, x}, plain.quarters};
    };
    r.alpha_power = exponent(m.alpha_power, alpha);
    r.beta_power = exponent(m.beta_power, beta);
    r.chi_power = exponent(m.chi_power, r.chi.x);
    r.beta_r_power = exponent(m.beta_r_power, r.beta_r.x);
    r.inverse_beta_r_power = exponent(m.inverse_beta_r_power, 1.0L / r.beta_r.x);
    return r;
}

// By an increment; false where it failed.
template <class Real, class Material>
bool advance(const Material& m, const kernel::Control& control, const Vec& dE,
             kernel::StateOf<Real>& x) {
    kernel::PointOf<Real> p{};
    p.T = x.T;
    p.h = x.h;
    p.e = x.e;
    p.w = x.w;
    for (int c = 0; c < 6; ++c) p.strain_increment[c] = Real(dE[c]);
    kernel::enter_domain(m, true, p);
    if (p.stress_free) {
        x = kernel::separated(true, p);
        return true;
    }
    const auto to = kernel::advance<Real>(m, control, true, p);
    if (to.end.failed || !(kernel::norm(to.end.y.T) < 1e3 * kernel::plain(m).h_s)) return false;
    x = to.state;
    return true;
}

struct Path {
    Sand sand;
    State start;
    std::vector<Vec> increments;
    double tolerance;

    const grit::Material& material() const { return grit::material_of(sand.prepared); }
    kernel::Control control() const { return {tolerance, 20000}; }
};

Path random_path(Random& random) {
    Path path{random_sand(random), {}, {}, random.log_uniform(1e-9, 1e-2)};
    const double p = random.log_uniform(1.0, 1e3);
    const Vec n = deviator(random.direction()).normalized();
    path.start.T = stress_with(p, random.uniform(0.0, 0.5), n);
    path.start.e = void_ratio_at(path.sand, p, random.uniform(0.05, 1.2));
    path.start.h = random_memory(path.sand, random);
    for (int i = static_cast<int>(random.uniform(1.0, 6.0)); i > 0; --i) {
        const Vec direction = random.direction();  // the same order for every compiler
        path.increments.push_back(random.log_uniform(1e-7, 1e-2) * direction);
    }
    return path;
}

template <class Real> kernel::StateOf<Real> start_of(const Path& path) {
    kernel::StateOf<Real> x{};
    for (int c = 0; c < 6; ++c) x.T[c] = Real(path.start.T[c]);
    for (int c = 0; c < 6; ++c) x.h[c] = Real(path.start.h[c]);
    x.e = Real(path.start.e);
    x.w = Real(0.0);
    return x;
}

// A state after each increment.
template <class Real> using Course = std::vector<kernel::StateOf<Real>>;

bool is_finite(const kernel::StateOf<Sensitive>& x) {
    double sum = 0.0;
    const auto add = [&](const Sensitive& of) {
        for (int k = 0; k < directions; ++k) sum += 0.0 * of.d[k];
    };
    for (int c = 0; c < 6; ++c) add(x.T[c]);
    for (int c = 0; c < 6; ++c) add(x.h[c]);
    add(x.e);
    return sum == 0.0;
}

// Empty where an update fails.
Course<Sensitive> differentiated(const Path& path) {
    const auto m = kernel::differentiated<Sensitive>(
        path.material(), [](int lane) { return lane < of_e ? lane : GRIT_SAND_NO_PARAMETER; });
    kernel::StateOf<Sensitive> x = start_of<Sensitive>(path);
    x.e = Sensitive::variable(path.start.e, of_e);
    Course<Sensitive> course;
    for (const Vec& dE : path.increments) {
        if (!advance(m, path.control(), dE, x) || !is_finite(x)) return {};
        course.push_back(x);
    }
    return course;
}

Course<Shadowed> shadowed(const Path& path, int direction) {
    const auto m = shadowed(path.material(), direction);
    auto y = start_of<Shadowed>(path);
    if (direction == of_e) y.e.x.imag(step);
    Course<Shadowed> course;
    for (const Vec& dE : path.increments) {
        if (!advance(m, path.control(), dE, y)) return {};
        course.push_back(y);
        settle(y);
    }
    return course;
}

// Of derivatives per relative change of the parameter: their error over the larger of them and a hundredth of what is
// differentiated.
struct Error {
    long double square = 0.0L, size = 0.0L;

    void add(const Sensitive& x, const Shadowed& y, int direction) {
        const long double exact = y.x.imag() / step, off = exact - x.d[direction];
        square += off * off;
        size += exact * exact;
    }
    double relative(double theta, double scale) const {
        const long double large =
            std::max(std::sqrt(size) * std::fabs(theta), 0.01L * static_cast<long double>(scale));
        return static_cast<double>(std::sqrt(square) * std::fabs(theta) / large);
    }
};

double error_of(const Path& path, int direction, const kernel::StateOf<Sensitive>& x,
                const kernel::StateOf<Shadowed>& y) {
    double theta = path.start.e;
    if (direction < of_e) grit_sand_parameter_get(&path.sand.p, direction, &theta);
    Error T, h, e;
    double norm_T = 0.0;
    for (int c = 0; c < 6; ++c) {
        EXPECT_EQ(x.T[c].v, y.T[c].v);
        EXPECT_EQ(x.h[c].v, y.h[c].v);
        T.add(x.T[c], y.T[c], direction);
        h.add(x.h[c], y.h[c], direction);
        norm_T = std::hypot(norm_T, x.T[c].v);
    }
    e.add(x.e, y.e, direction);
    if (norm_T == 0.0) norm_T = 1.0;
    return std::max({T.relative(theta, norm_T),
                     h.relative(theta, path.sand.p.elastic_strain_radius),
                     e.relative(theta, x.e.v)});
}

// After any increment.
double largest_error(const Path& path, int direction, const Course<Sensitive>& x, Settles when) {
    kernel::settles = when;
    const auto y = shadowed(path, direction);
    EXPECT_EQ(x.size(), y.size());
    double worst = 0.0;
    for (std::size_t i = 0; i < y.size(); ++i)
        worst = std::max(worst, error_of(path, direction, x[i], y[i]));
    return worst;
}

// Of all parameters over their whole ranges; two directions a path. What is beyond 1e-10 where the shadow settles by steps
// is the roundoff of plain numbers within steps, which the path magnifies: where it has these numbers, nothing is.
TEST(Sensitive, AreTheComplexStepInLongDoubleOfThePathsOfRandomSands) {
    constexpr int wanted = 1000;
    Random random(301);
    int failed = 0, beyond = 0;
    std::vector<double> errors;
    for (int i = 0; static_cast<int>(errors.size()) < wanted; ++i) {
        const Path path = random_path(random);
        const Course<Sensitive> x = differentiated(path);
        if (x.empty()) {
            ++failed;
            continue;
        }
        double worst = 0.0;
        for (const int k : {i % directions, (i + 8) % directions}) {
            const double error = largest_error(path, k, x, Settles::by_step);
            worst = std::max(worst, error);
            if (error <= 1e-10) continue;
            ++beyond;
            const double own = largest_error(path, k, x, Settles::by_operation);
            std::cout << "path " << i << ", direction " << k << ": " << error
                      << ", of its own numbers " << own << "\n";
            EXPECT_LE(own, 1e-10) << "path " << i << ", direction " << k;
        }
        errors.push_back(worst);
    }
    std::sort(errors.begin(), errors.end());
    std::cout << errors.size() << " paths: relative error p50 " << errors[wanted / 2] << ", p90 "
              << errors[wanted * 9 / 10] << ", p99 " << errors[wanted * 99 / 100] << ", largest "
              << errors.back() << ", above 1e-10 in " << beyond << "; " << failed
              << " others failed\n";
    EXPECT_LE(failed, 20);
    EXPECT_LE(errors.back(), 1e-7);
}

}  // namespace
