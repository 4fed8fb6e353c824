// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <stdexcept>

#include "paths/strain_path.hpp"
#include "support/trials/split_mix.hpp"

namespace paths {
namespace {

struct Test {
    const char* kind;
    bool constant_lateral_stress;  // axis 1 is driven, 22 and 33 follow
    double looseness;              // of e between e_d (0) and e_c (1)
    double pressure;               // of the start [kPa]
    double memory;                 // |h|/R at the start, along isotropic compression
    std::vector<Six> corners;
};

Six along(const Six& direction, double size) {
    Six r;
    for (std::size_t c = 0; c < 6; ++c) r[c] = size * direction[c];
    return r;
}

std::vector<Six> corners(const Six& direction, std::initializer_list<double> sizes) {
    std::vector<Six> r;
    for (const double size : sizes) r.push_back(along(direction, size));
    return r;
}

std::vector<Six> cycles(const Six& direction, double amplitude, int count) {
    std::vector<Six> r;
    for (int i = 0; i < count; ++i) {
        r.push_back(along(direction, amplitude));
        r.push_back(along(direction, -amplitude));
    }
    return r;
}

std::vector<Test> tests(int calls) {
    constexpr Six oedometric{-1, 0, 0, 0, 0, 0}, isotropic{-1, -1, -1, 0, 0, 0};
    constexpr Six undrained{-1, 0.5, 0.5, 0, 0, 0}, sheared{0, 0, 0, 1, 0, 0};
    std::vector<Test> r;
    for (const double memory : {0.0, 1.0}) {
        for (const double looseness : {0.3, 0.9}) {
            r.push_back({"oedometer", false, looseness, 10, memory,
                         corners(oedometric, {0.015, 0.013, 0.03})});
            r.push_back({"isotropic", false, looseness, 10, memory,
                         corners(isotropic, {0.005, 0.0045, 0.01})});
            r.push_back({"undrained", false, looseness, 100, memory, corners(undrained, {0.05})});
            r.push_back({"simple shear", false, looseness, 100, memory, corners(sheared, {0.1})});
            r.push_back({"drained", true, looseness, 100, memory, corners(oedometric, {0.1})});
        }
        for (const double amplitude : {1e-4, 1e-3, 1e-2}) {
            r.push_back(
                {"undrained cycles", false, 0.4, 100, memory, cycles(undrained, amplitude, 5)});
            r.push_back(
                {"simple shear cycles", false, 0.4, 100, memory, cycles(sheared, amplitude, 5)});
            r.push_back(
                {"drained cycles", true, 0.4, 100, memory, cycles(oedometric, amplitude, 5)});
        }
        // Many within R: each turns h, and errors of one sign add up.
        const int many = std::min(50, calls / 2);
        for (const double amplitude : {3e-6, 1e-5, 3e-5, 5e-5}) {
            r.push_back({"small undrained cycles", false, 0.4, 100, memory,
                         cycles(undrained, amplitude, many)});
            r.push_back({"small simple shear cycles", false, 0.4, 100, memory,
                         cycles(sheared, amplitude, many)});
            r.push_back({"small isotropic cycles", false, 0.4, 100, memory,
                         cycles(isotropic, amplitude, many)});
        }
    }
    return r;
}

void check(grit_status status, const char* what) {
    if (status != GRIT_OK) throw std::runtime_error(std::string(what) + " failed");
}

struct CatalogueSand {
    std::string name;
    grit_sand sand;
    bool has_h;
};

std::vector<CatalogueSand> catalogue() {
    std::vector<CatalogueSand> r;
    for (int i = 0; i < grit_sand_record_count(); ++i) {
        grit_sand_parameters p;
        grit_sand_parameters_init(&p, sizeof p);
        check(grit_sand_record_parameters(i, 1.0, &p), "grit_sand_record_parameters");
        grit_sand sand;
        check(grit_sand_prepare(&p, &sand, nullptr), "grit_sand_prepare");
        r.push_back({grit_sand_record_at(i)->name, sand, !std::isnan(p.elastic_strain_radius)});
    }
    return r;
}

StrainPath start_of(const Test& test, const CatalogueSand& of, bool off) {
    const grit_sand& sand = of.sand;
    StrainPath path{test.kind, of.name, sand, off, opening_pressure(sand), {}, {}, {}};
    for (std::size_t c = 0; c < 3; ++c) path.stress[c] = -test.pressure;
    double limits[3];  // e_i, e_c, e_d
    check(grit_sand_void_ratios(&sand, test.pressure, limits), "grit_sand_void_ratios");
    path.state[GRIT_SAND_VOID_RATIO] = limits[2] + test.looseness * (limits[1] - limits[2]);
    const double compression[6] = {-1, -1, -1, 0, 0, 0};
    if (test.memory > 0.0)
        check(grit_sand_mobilise(&sand, compression, test.memory, path.state.data()),
              "grit_sand_mobilise");
    return path;
}

// The lateral strain with which 22 and 33 keep their stress: Newton's method over the update itself.
class LateralControl {
  public:
    explicit LateralControl(const StrainPath& path)
        : sand(path.sand), stress(path.stress), state(path.state), lateral(path.stress[1]) {
        grit_sand_options_init(&options, sizeof options);
        options.tolerance = 1e-8;
        options.intergranular_off = path.intergranular_off;
        options.tangent = GRIT_TANGENT_CONSISTENT;
    }

    // Nothing where Newton's method finds no such strain, or one that no sand dilates by: it has taken the stress along
    // the limit cone then, where F = 0 and what is exact depends on the last digit (docs/adr/0002).
    std::optional<Six> follow(double axial) {
        Six d{axial, guess * axial, guess * axial, 0, 0, 0};
        for (int i = 0; i < 40; ++i) {
            Six T = stress;
            auto x = state;
            double tangent[36];
            grit_sand_points q{};
            q.struct_size = sizeof q;
            q.strain_increment = grit_view_of(d.data(), 6, 1);
            q.stress = grit_mutable_view_of(T.data(), 6, 1);
            q.state = grit_mutable_view_of(x.data(), GRIT_SAND_STATE_SIZE, 1);
            q.tangent = grit_mutable_matrix_view_of(tangent, 36, 6, 1);
            if (grit_sand_update(&sand, &options, 1, &q, nullptr, nullptr) != GRIT_OK) return {};
            const double off = T[1] - lateral;
            if (std::fabs(off) <= 1e-5 * std::fabs(lateral)) {
                stress = T;
                state = x;
                guess = d[1] / axial;
                if (std::fabs(guess) > 1.0) return {};
                return d;
            }
            d[1] = d[2] = d[1] - off / (tangent[7] + tangent[8]);
        }
        return {};
    }

  private:
    grit_sand sand;
    grit_sand_options options;
    Six stress;
    std::array<double, GRIT_SAND_STATE_SIZE> state;
    double lateral, guess = -0.3;
};

// To each corner in calls of one size a leg, as many as it is long. Says whether the lateral stress is met.
bool drive(const Test& test, int calls, StrainPath& path) {
    double whole = 0.0;
    Six from{};
    const auto length = [](const Six& A, const Six& B) {
        double sum = 0.0;
        for (std::size_t c = 0; c < 6; ++c) sum += (A[c] - B[c]) * (A[c] - B[c]);
        return std::sqrt(sum);
    };
    for (const Six& to : test.corners) {
        whole += length(from, to);
        from = to;
    }
    from = {};
    LateralControl control(path);
    for (const Six& to : test.corners) {
        const int n = std::max(1, static_cast<int>(std::lround(calls * length(from, to) / whole)));
        Six d;
        for (std::size_t c = 0; c < 6; ++c) d[c] = (to[c] - from[c]) / n;
        for (int i = 0; i < n; ++i) {
            const std::optional<Six> met = test.constant_lateral_stress ? control.follow(d[0]) : d;
            if (!met) return false;
            path.increments.push_back(*met);
        }
        from = to;
    }
    return true;
}

std::optional<StrainPath> path_of(const Test& test, int calls, const CatalogueSand& sand,
                                  bool off) {
    StrainPath path = start_of(test, sand, off);
    if (!drive(test, calls, path)) return {};
    return path;
}

}  // namespace

std::vector<StrainPath> laboratory_paths(int calls) {
    std::vector<StrainPath> r;
    for (const CatalogueSand& sand : catalogue())
        for (const Test& test : tests(calls))
            for (const bool off : {false, true}) {
                if ((!sand.has_h && !off) || (off && test.memory > 0.0)) continue;
                const std::optional<StrainPath> path = path_of(test, calls, sand, off);
                if (!path) throw std::runtime_error("the lateral stress is not met");
                r.push_back(*path);
            }
    return r;
}

std::vector<StrainPath> random_paths(int count, unsigned seed) {
    constexpr double fewest = 30.0, most = 1000.0;
    grit::SplitMix random(seed);
    const std::vector<CatalogueSand> sands = catalogue();
    std::vector<StrainPath> r;
    while (static_cast<int>(r.size()) < count) {
        const CatalogueSand& sand = sands[random.bits() % sands.size()];
        const int calls = static_cast<int>(random.log_uniform(fewest, most));
        const std::vector<Test> kinds = tests(calls);
        Test test = kinds[random.bits() % kinds.size()];
        const bool off = !sand.has_h || random.below(4) == 0;
        test.looseness = random.uniform();
        test.pressure = random.log_uniform(2.0, 1000.0);
        test.memory = off || random.below(2) == 0 ? 0.0 : random.uniform();
        // Many cycles stay within R.
        const double size = random.log_uniform(0.2, test.corners.size() > 10 ? 1.0 : 2.0);
        for (Six& corner : test.corners) corner = along(corner, size);
        if (const std::optional<StrainPath> path = path_of(test, calls, sand, off))
            r.push_back(*path);
    }
    return r;
}

}  // namespace paths
