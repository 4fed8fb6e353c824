// SPDX-License-Identifier: BSD-3-Clause
#include "element/calibration/estimates.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "element/text.hpp"

namespace calibration {
namespace {

using element::text;

constexpr double degree = std::numbers::pi / 180.0;

enum Index {
    phi_c = GRIT_SAND_CRITICAL_FRICTION_ANGLE,
    h_s = GRIT_SAND_GRANULATE_HARDNESS,
    n = GRIT_SAND_STIFFNESS_EXPONENT,
    e_d0 = GRIT_SAND_DENSEST_VOID_RATIO,
    e_c0 = GRIT_SAND_CRITICAL_VOID_RATIO,
    e_i0 = GRIT_SAND_LOOSEST_VOID_RATIO,
    alpha = GRIT_SAND_PYKNOTROPY_EXPONENT,
    beta = GRIT_SAND_STIFFNESS_VOID_EXPONENT,
    p_t = GRIT_SAND_PRESSURE_SHIFT,
    m_R = GRIT_SAND_REVERSAL_STIFFNESS,
    m_T = GRIT_SAND_TRANSVERSE_STIFFNESS,
    R = GRIT_SAND_ELASTIC_STRAIN_RADIUS,
    beta_r = GRIT_SAND_EVOLUTION_EXPONENT,
    chi = GRIT_SAND_STIFFNESS_INTERPOLATION_EXPONENT,
};

// Values of a channel of a test by row; empty if it was not read.
std::vector<std::pair<int, double>> channel(const Experiment& test, const char* name) {
    std::vector<std::pair<int, double>> out;
    for (const Reading& each : test.readings)
        if (test.channels[static_cast<std::size_t>(each.channel)].name == name)
            out.emplace_back(each.row, each.value);
    return out;
}

// Void ratio by row, read or from a strain (H9).
std::vector<std::pair<int, double>> void_ratios(const Experiment& test) {
    std::vector<std::pair<int, double>> out = channel(test, "void_ratio");
    if (!out.empty()) return out;
    const bool oedometric = test.kind == "oedometer" || test.kind == "k0_consolidation";
    out = channel(test, "volumetric_strain");
    if (out.empty() && oedometric) out = channel(test, "axial_strain");
    for (auto& [row, value] : out) value = (1.0 + test.start.void_ratio) * std::exp(value) - 1.0;
    return out;
}

bool is_compression(const Experiment& test) {
    return test.kind == "oedometer" || test.kind == "k0_consolidation" || test.kind == "isotropic";
}

// Pressure and void ratio of the first loading.
struct Curve {
    std::vector<double> pressure, void_ratio;
};

Curve compression_of(const Experiment& test, double K_0) {
    Curve out;
    const bool isotropic = test.kind == "isotropic";
    const auto stresses = channel(test, isotropic ? "p" : "stress_11");
    const bool by_stress = test.driver == "stress_11" || test.driver == "p";
    for (const auto& [row, e] : void_ratios(test)) {
        double stress = NAN;
        if (by_stress) stress = std::abs(test.driven[static_cast<std::size_t>(row)]);
        for (const auto& [at, value] : stresses)
            if (at == row) stress = std::abs(value);
        const double p = isotropic ? stress : stress * (1.0 + 2.0 * K_0) / 3.0;
        if (std::isnan(p)) continue;
        if (!out.pressure.empty() && !(p > out.pressure.back())) break;
        out.pressure.push_back(p);
        out.void_ratio.push_back(e);
    }
    return out;
}

// Stress ratio sigma_1/sigma_3 and void ratio where the deviator of a drained test is largest, or at its end.
struct Strength {
    double ratio = 0.0, void_ratio = 0.0, pressure = 0.0;
};

std::optional<Strength> strength_of(const Experiment& test, bool at_end) {
    if (test.kind != "triaxial_drained") return std::nullopt;
    const auto q = channel(test, "axial_deviator");
    const auto e = void_ratios(test);
    if (q.empty()) return std::nullopt;
    const auto at = at_end ? q.end() - 1
                           : std::max_element(q.begin(), q.end(), [](const auto& a, const auto& b) {
                                 return a.second < b.second;
                             });
    const double lateral = -test.start.stress[1];
    Strength out{(lateral + at->second) / lateral, test.start.void_ratio,
                 lateral + at->second / 3.0};
    for (const auto& [row, value] : e)
        if (row == at->first) out.void_ratio = value;
    if (!(out.ratio > 1.0)) return std::nullopt;
    return out;
}

template <class Better>
const Experiment* best_of(const std::vector<Experiment>& tests, const Better& better) {
    const Experiment* best = nullptr;
    for (const Experiment& each : tests)
        if (each.fitted && (!best || better(each, *best))) best = &each;
    return best;
}

class Estimates {
  public:
    Estimates(const std::vector<Experiment>& experiments, const IndexTests& measured,
              const grit_sand_parameters& known)
        : tests(experiments), index(measured), given(known) {
        for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i) {
            out.push_back({get(given, i), "given"});
            if (i >= m_R && std::isnan(out.back().value)) out.back().origin = "not given";
        }
    }

    std::vector<Estimate> take() {
        friction();
        void_ratio_limits();
        compression();
        make_room();
        peak();
        stiffness();
        return std::move(out);
    }

  private:
    bool wanted(int i) const { return std::isnan(out[static_cast<std::size_t>(i)].value); }
    double value(int i) const { return out[static_cast<std::size_t>(i)].value; }
    bool is_given(int i) const { return !std::isnan(get(given, i)); }
    void put(int i, double number, std::string origin) {
        out[static_cast<std::size_t>(i)] = {number, std::move(origin)};
    }
    double K_0() const { return 1.0 - std::sin(value(phi_c)); }
    // (H6) at a mean pressure.
    double scale(double p) const {
        return p > 0.0 ? std::exp(-std::pow(3.0 * p / value(h_s), value(n))) : 1.0;
    }

    void friction() {
        if (!wanted(phi_c)) return;
        if (index.angle_of_repose) return put(phi_c, *index.angle_of_repose, "angle of repose");
        const Experiment* loosest = nullptr;
        for (const Experiment& each : tests)
            if (each.fitted && strength_of(each, true) &&
                (!loosest || each.start.void_ratio > loosest->start.void_ratio))
                loosest = &each;
        if (!loosest) return put(phi_c, 32.0 * degree, "usual for sand");
        const double ratio = strength_of(*loosest, true)->ratio;
        put(phi_c,
            std::clamp(std::asin((ratio - 1.0) / (ratio + 1.0)), 25.0 * degree, 42.0 * degree),
            "end of " + loosest->name);
    }

    void void_ratio_limits() {
        const auto [low, high] = std::minmax_element(
            tests.begin(), tests.end(), [](const Experiment& a, const Experiment& b) {
                return a.start.void_ratio < b.start.void_ratio;
            });
        const double densest = low == tests.end() ? 0.55 : low->start.void_ratio;
        const double loosest = high == tests.end() ? 0.85 : high->start.void_ratio;
        if (wanted(e_d0)) {
            if (index.least_void_ratio) put(e_d0, *index.least_void_ratio, "least void ratio");
            else put(e_d0, 0.95 * densest, "a little below the densest sample");
        }
        if (wanted(e_c0)) {
            if (index.largest_void_ratio)
                put(e_c0, *index.largest_void_ratio, "largest void ratio");
            else
                put(e_c0, std::max(1.02 * loosest, 1.3 * value(e_d0)),
                    "a little above the loosest sample");
        }
        if (wanted(e_i0)) put(e_i0, 1.15 * value(e_c0), "1.15 e_c0");
    }

    void compression() {
        if (!wanted(h_s) && !wanted(n)) return;
        // The loosest sample is compressed most nearly along (H6).
        std::vector<const Experiment*> samples;
        for (const Experiment& each : tests)
            if (each.fitted && is_compression(each)) samples.push_back(&each);
        std::sort(samples.begin(), samples.end(), [](const Experiment* a, const Experiment* b) {
            return a->start.void_ratio > b->start.void_ratio;
        });
        for (const Experiment* each : samples) {
            const Curve curve = compression_of(*each, K_0());
            const auto found = compression_curve(curve.pressure, curve.void_ratio);
            if (!found) continue;
            if (wanted(h_s)) put(h_s, found->hardness, "compression of " + each->name);
            if (wanted(n)) put(n, found->exponent, "compression of " + each->name);
            return;
        }
        if (wanted(h_s)) put(h_s, 2e6, "usual for quartz sand, in kPa");
        if (wanted(n)) put(n, 0.28, "usual for sand");
    }

    // Every sample starts between e_d and e_i, however these were estimated.
    void make_room() {
        double least = INFINITY, largest = 0.0;
        for (const Experiment& test : tests) {
            const double axial = -test.start.stress[0];
            const double p = test.at_rest ? axial * (1.0 + 2.0 * K_0()) / 3.0
                                          : -test.start.stress.head<3>().sum() / 3.0;
            const double e_0 =
                test.at_zero_pressure ? test.start.void_ratio : test.start.void_ratio / scale(p);
            least = std::min(least, e_0);
            largest = std::max(largest, e_0);
        }
        if (!is_given(e_d0) && value(e_d0) > 0.985 * least)
            put(e_d0, 0.985 * least, "a little below the densest sample");
        if (!is_given(e_c0) && value(e_c0) < 1.05 * value(e_d0))
            put(e_c0, 1.05 * value(e_d0), "a little above e_d0");
        const double e_i = std::max(1.02 * largest, 1.05 * value(e_c0));
        if (!is_given(e_i0) && value(e_i0) < e_i)
            put(e_i0, e_i, "a little above the loosest sample");
    }

    void peak() {
        if (!wanted(alpha)) return;
        const Experiment* densest = nullptr;
        for (const Experiment& each : tests)
            if (each.fitted && strength_of(each, false) &&
                (!densest || each.start.void_ratio < densest->start.void_ratio))
                densest = &each;
        if (densest) {
            const Strength top = *strength_of(*densest, false);
            const double f_d = density_factor_at_peak(value(phi_c), top.ratio);
            const double s = scale(top.pressure);
            const double density = (top.void_ratio / s - value(e_d0)) / (value(e_c0) - value(e_d0));
            const double exponent = std::log(f_d) / std::log(density);
            if (f_d < 1.0 && density > 0.0 && density < 0.9 && std::isfinite(exponent))
                return put(alpha, std::clamp(exponent, 0.03, 0.6), "peak of " + densest->name);
        }
        put(alpha, 0.2, "usual for sand");
    }

    // f_s carries (e_i/e)^beta: stiffnesses of a dense and a loose sample at one pressure, each beside that of the law.
    void stiffness() {
        if (!wanted(beta)) return;
        const auto samples = [this] {
            std::vector<const Experiment*> all;
            for (const Experiment& each : tests)
                if (each.fitted && (each.kind == "oedometer" || each.kind == "k0_consolidation"))
                    all.push_back(&each);
            return all;
        }();
        const auto [dense, loose] = std::minmax_element(
            samples.begin(), samples.end(), [](const Experiment* a, const Experiment* b) {
                return a->start.void_ratio < b->start.void_ratio;
            });
        if (samples.size() > 1 && (*loose)->start.void_ratio > 1.1 * (*dense)->start.void_ratio) {
            const auto e1 = secant(**dense), e2 = secant(**loose);
            if (e1 && e2 && e1->measured > 0.0 && e2->measured > 0.0) {
                const double found =
                    std::log(e1->measured / e1->computed / (e2->measured / e2->computed)) /
                    std::log(e2->void_ratio / e1->void_ratio);
                if (std::isfinite(found))
                    return put(beta, std::clamp(1.0 + found, 0.3, 4.0),
                               "stiffness of " + (*dense)->name + " beside " + (*loose)->name);
            }
        }
        put(beta, 1.0, "usual for sand");
    }

    struct Secant {
        double measured = 0.0, computed = 0.0, void_ratio = 0.0;
    };
    // Oedometric stiffness over the upper half of the loading, and that of the law for beta = 1 in the middle of it.
    std::optional<Secant> secant(const Experiment& test) const {
        const Curve curve = compression_of(test, K_0());
        if (curve.pressure.size() < 4) return std::nullopt;
        const double top = curve.pressure.back();
        std::size_t half = 0;
        while (curve.pressure[half] < 0.5 * top) ++half;
        if (half + 1 >= curve.pressure.size()) return std::nullopt;
        const double axial_per_p = 3.0 / (1.0 + 2.0 * K_0());
        const double strain =
            std::log((1.0 + curve.void_ratio.back()) / (1.0 + curve.void_ratio[half]));
        Secant found;
        found.void_ratio = 0.5 * (curve.void_ratio.back() + curve.void_ratio[half]);
        found.measured = -axial_per_p * (top - curve.pressure[half]) / strain;
        grit_sand_parameters sand = given;
        for (int i = 0; i < m_R; ++i) set(sand, i, i == alpha && wanted(i) ? 0.2 : value(i));
        set(sand, beta, 1.0);
        grit_sand prepared;
        if (grit_sand_prepare(&sand, &prepared, nullptr) != GRIT_OK) return std::nullopt;
        const double p = 0.5 * (top + curve.pressure[half]);
        const double axial = -axial_per_p * p;
        const double stress[6] = {axial, K_0() * axial, K_0() * axial, 0.0, 0.0, 0.0};
        double L[36], N[6];
        if (grit_sand_stiffness(&prepared, stress, found.void_ratio, L, N) != GRIT_OK)
            return std::nullopt;
        found.computed = L[0] - N[0];  // d sigma_11/d eps_11 for a compression of unit length
        if (!(found.computed > 0.0)) return std::nullopt;
        return found;
    }

    const std::vector<Experiment>& tests;
    const IndexTests& index;
    const grit_sand_parameters& given;
    std::vector<Estimate> out;
};

}  // namespace

// (H2)-(H4) with F = 1: N = f_d N_1, and L^-1 N_1 is closed form.
double density_factor_at_peak(double critical_friction_angle, double ratio) {
    const double s = std::sin(critical_friction_angle);
    const double a = std::sqrt(3.0) * (3.0 - s) / (2.0 * std::numbers::sqrt2 * s);
    const Eigen::Vector3d T = Eigen::Vector3d(ratio, 1.0, 1.0) / (ratio + 2.0);
    const Eigen::Vector3d both = 2.0 * T - Eigen::Vector3d::Constant(1.0 / 3.0);
    const Eigen::Vector3d flow = a * (both - T * (T.dot(both) / (1.0 / (a * a) + T.dot(T))));
    return 1.0 / flow.norm();
}

// Compression indices C = -de/d ln p near both ends: e n (3p/h_s)^n. Their ratio says n, within what sands have.
std::optional<Compression> compression_curve(const std::vector<double>& p,
                                             const std::vector<double>& e) {
    const std::size_t count = p.size();
    if (count < 6) return std::nullopt;
    // Slope, pressure and void ratio of a line through some rows.
    const auto line = [&](std::size_t from, std::size_t to) {
        double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
        const auto size = static_cast<double>(to - from);
        for (std::size_t i = from; i < to; ++i) {
            x += std::log(p[i]) / size;
            y += e[i] / size;
        }
        for (std::size_t i = from; i < to; ++i) {
            xx += (std::log(p[i]) - x) * (std::log(p[i]) - x);
            xy += (std::log(p[i]) - x) * (e[i] - y);
        }
        return std::array<double, 3>{-xy / xx, std::exp(x), y};
    };
    const std::size_t third = std::max<std::size_t>(3, count / 3);
    const auto [C_1, p_1, e_1] = line(0, third);
    const auto [C_2, p_2, e_2] = line(count - third, count);
    if (!(C_1 > 0.0) || !(C_2 > 0.0) || !(p_2 > 1.5 * p_1)) return std::nullopt;
    Compression out;
    out.exponent = std::clamp(std::log(e_1 * C_2 / (e_2 * C_1)) / std::log(p_2 / p_1), 0.2, 0.4);
    out.hardness = 3.0 * p_2 * std::pow(out.exponent * e_2 / C_2, 1.0 / out.exponent);
    out.void_ratio = e_2 * std::exp(std::pow(3.0 * p_2 / out.hardness, out.exponent));
    return out;
}

std::vector<Estimate> estimate(const std::vector<Experiment>& tests, const IndexTests& index,
                               const grit_sand_parameters& given) {
    return Estimates(tests, index, given).take();
}

}  // namespace calibration
