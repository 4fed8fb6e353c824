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

struct Shadowed {
    using Shadow = std::complex<long double>;
    double v = 0.0;
    Shadow x = 0.0L;

    Shadowed() = default;
    Shadowed(double plain) : v(plain), x(plain) {}
    Shadowed(double plain, Shadow shadow) : v(plain), x(shadow) {}

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

inline Shadowed power(const SensitiveExponent<Shadowed>& q, const Shadowed& x) {
    return {power(Exponent{q.value.v, q.quarters}, x.v), std::exp(q.value.x * std::log(x.x))};
}

}  // namespace
}  // namespace grit::kernel_test

namespace {

namespace kernel = grit::kernel_test;
using namespace tests;
using kernel::Sensitive;
using kernel::Shadowed;
using Shadow = Shadowed::Shadow;

constexpr long double step = 1e-30L;
constexpr int of_e = GRIT_SAND_PARAMETER_COUNT;  // the initial void ratio
constexpr int directions = of_e + 1;

// The constants of a material as grit_sand_prepare has them, in long double: (H4), (H8).
kernel::SensitiveMaterial<Shadowed> shadowed(const grit::Material& m, int direction) {
    const auto variable = [&](double x, int own) {
        return Shadowed(x, Shadow(x, own == direction ? step : 0.0L));
    };
    using kernel::SensitiveExponent;
    const Shadowed phi_c = variable(m.phi_c, 0), h_s = variable(m.h_s, 1),
                   alpha = variable(m.alpha, 6), beta = variable(m.beta, 7);
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
    const Shadow sine = std::sin(phi_c.x), one = 1.0L;
    const long double root_2 = std::sqrt(2.0L), root_3 = std::sqrt(3.0L);
    const Shadow a = root_3 * (3.0L - sine) / (2.0L * root_2 * sine);
    const Shadow range = r.e_c0.x - r.e_d0.x;
    const Shadow bracket =
        3.0L + a * a - root_3 * a * std::pow((r.e_i0.x - r.e_d0.x) / range, alpha.x);
    r.a = {m.a, a};
    r.stiffness = {m.stiffness, h_s.x / r.n.x * std::pow(r.e_i0.x / r.e_c0.x, beta.x) / bracket};
    r.three_over_hs = {m.three_over_hs, 3.0L / h_s.x};
    r.inverse_e_range = {m.inverse_e_range, one / range};
    r.inverse_e_i0 = {m.inverse_e_i0, one / r.e_i0.x};
    r.inverse_R = {m.inverse_R, one / r.R.x};
    r.p_floor = {m.p_floor, static_cast<long double>(grit::floor_per_hardness) * h_s.x};
    const auto exponent = [](const grit::Exponent& plain, const Shadow& x) {
        return SensitiveExponent<Shadowed>{{plain.value, x}, plain.quarters};
    };
    r.alpha_power = exponent(m.alpha_power, alpha.x);
    r.beta_power = exponent(m.beta_power, beta.x);
    r.chi_power = exponent(m.chi_power, r.chi.x);
    r.beta_r_power = exponent(m.beta_r_power, r.beta_r.x);
    r.inverse_beta_r_power = exponent(m.inverse_beta_r_power, one / r.beta_r.x);
    return r;
}

// Along a path; false where an increment failed.
template <class Real, class Material>
bool follow(const Material& m, const kernel::Control& control, const std::vector<Vec>& increments,
            kernel::StateOf<Real>& x) {
    for (const Vec& dE : increments) {
        kernel::PointOf<Real> p{};
        p.T = x.T;
        p.h = x.h;
        p.e = x.e;
        p.w = x.w;
        for (int c = 0; c < 6; ++c) p.strain_increment[c] = Real(dE[c]);
        kernel::enter_domain(m, true, p);
        if (p.stress_free) {
            x = kernel::separated(true, p);
            continue;
        }
        const auto to = kernel::advance<Real>(m, control, true, p);
        if (to.end.failed || !(kernel::norm(to.end.y.T) < 1e3 * grit::kernel_test::plain(m).h_s))
            return false;
        x = to.state;
    }
    return true;
}

struct Path {
    Sand sand;
    State start;
    std::vector<Vec> increments;
    double tolerance;
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

kernel::StateOf<Shadowed> start_of(const Path& path, int direction) {
    kernel::StateOf<Shadowed> y{};
    for (int c = 0; c < 6; ++c) y.T[c] = path.start.T[c];
    for (int c = 0; c < 6; ++c) y.h[c] = path.start.h[c];
    y.e = {path.start.e, Shadow(path.start.e, direction == of_e ? step : 0.0L)};
    y.w = 0.0;
    return y;
}

kernel::StateOf<Sensitive> start_of(const Path& path) {
    kernel::StateOf<Sensitive> x{};
    for (int c = 0; c < 6; ++c) x.T[c] = Sensitive(path.start.T[c]);
    for (int c = 0; c < 6; ++c) x.h[c] = Sensitive(path.start.h[c]);
    x.e = Sensitive::variable(path.start.e, of_e);
    x.w = Sensitive(0.0);
    return x;
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

double largest_error(const Path& path, int direction, const kernel::StateOf<Sensitive>& x,
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

// Of all parameters over their whole ranges; two directions a path. Beyond are paths whose plain stress has lost digits
// too: past e_d, where a sand is as good as unstable, and from a point that has opened and closed.
TEST(Sensitive, AreTheComplexStepInLongDoubleOfThePathsOfRandomSands) {
    Random random(301);
    int failed = 0, beyond = 0;
    std::vector<double> errors;
    for (int i = 0; i < 1000; ++i) {
        const Path path = random_path(random);
        const grit::Material& m = grit::material_of(path.sand.prepared);
        const kernel::Control control{path.tolerance, 20000};
        kernel::StateOf<Sensitive> x = start_of(path);
        if (!follow(kernel::differentiated<Sensitive>(
                        m, [](int lane) { return lane < of_e ? lane : GRIT_SAND_NO_PARAMETER; }),
                    control, path.increments, x)) {
            ++failed;
            continue;
        }
        double worst = 0.0;
        for (const int k : {i % directions, (i + 8) % directions}) {
            kernel::StateOf<Shadowed> y = start_of(path, k);
            ASSERT_TRUE(follow(shadowed(m, k), control, path.increments, y));
            worst = std::max(worst, largest_error(path, k, x, y));
        }
        errors.push_back(worst);
        beyond += !(worst <= 1e-10);
    }
    std::sort(errors.begin(), errors.end());
    std::cout << errors.size() << " paths: relative error p50 " << errors[errors.size() / 2]
              << ", p90 " << errors[errors.size() * 9 / 10] << ", p99 "
              << errors[errors.size() * 99 / 100] << ", above 1e-10 in " << beyond << "; " << failed
              << " left the range of stresses\n";
    EXPECT_LE(failed, 20);
    EXPECT_LE(beyond, 5);
}

}  // namespace
