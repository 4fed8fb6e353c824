// SPDX-License-Identifier: BSD-3-Clause
// OpenSees' nDMaterial UMAT, replayed as its published source calls (docs/start/opensees.md): every trial starts from the
// committed stress and STATEV with the strain since then, arguments it has nothing for are zeros and identities, the
// order 11 22 33 12 23 31 is turned into Abaqus' and back, and PNEWDT < 1 is a trial that failed.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "support/library.hpp"
#include "support/umat_call.hpp"

namespace opensees_replay {

using Six = std::array<double, 6>;

constexpr std::size_t abaqus_of[6] = {0, 1, 2, 3, 5, 4};  // and back: 13 and 23 change places

class UmatMaterial {
  public:
    // nDMaterial UMAT tag -symbol symbol -props ... -statev ... -initial_stress ... -library library
    UmatMaterial(int tag, const std::string& symbol, std::vector<double> props,
                 std::vector<double> statev, const Six& initial_stress)
        : tag_(tag), symbol_(symbol), props_(std::move(props)), initial_statev_(std::move(statev)),
          initial_stress_(initial_stress), committed_statev_(initial_statev_),
          trial_statev_(initial_statev_), committed_stress_(initial_stress),
          trial_stress_(initial_stress),
          umat_(reinterpret_cast<UmatFunction>(symbol_of(GRIT_UMAT_LIBRARY, symbol.c_str()))) {}

    // In the order of OpenSees; false is its -1.
    bool set_trial_strain(const Six& strain) {
        for (std::size_t c = 0; c < 6; ++c) trial_strain_[abaqus_of[c]] = strain[c];
        tangent_is_of_trial_ = call(trial_strain_, trial_stress_, trial_statev_, trial_tangent_);
        if (!tangent_is_of_trial_) {
            trial_stress_ = committed_stress_;
            trial_statev_ = committed_statev_;
        }
        return tangent_is_of_trial_;
    }
    double stress(std::size_t c) const { return trial_stress_[abaqus_of[c]]; }
    const std::vector<double>& statev() const { return trial_statev_; }
    double pnewdt() const { return pnewdt_; }
    // Before any trial, and after a failed one: that of the initial state, without a strain.
    double tangent(std::size_t i, std::size_t j) {
        if (tangent_is_of_trial_) return trial_tangent_[6 * i + j];
        if (initial_tangent_.empty()) initial_tangent_ = tangent_of_initial_state();
        return initial_tangent_[6 * i + j];
    }
    void commit() {
        committed_stress_ = trial_stress_;
        committed_statev_ = trial_statev_;
        committed_strain_ = trial_strain_;
        committed_time_ += 1.0;
        ++kinc_;
    }

  private:
    std::vector<double> tangent_of_initial_state() {
        Six stress = initial_stress_;
        std::vector<double> statev = initial_statev_, tangent(36);
        UmatMaterial fresh(tag_, symbol_, props_, initial_statev_, initial_stress_);
        EXPECT_TRUE(fresh.call({}, stress, statev, tangent));
        EXPECT_EQ(stress, initial_stress_) << "no strain, no change";
        return tangent;
    }

    bool call(const Six& strain, Six& stress, std::vector<double>& statev,
              std::vector<double>& tangent) {
        stress = committed_stress_;
        statev = committed_statev_;
        Six dstran;
        for (std::size_t c = 0; c < 6; ++c) dstran[c] = strain[c] - committed_strain_[c];
        double ddsdde[36] = {}, sse = 0.0, spd = 0.0, scd = 0.0, rpl = 0.0, drpldt = 0.0;
        double ddsddt[6] = {}, drplde[6] = {};
        const double time[2] = {committed_time_, committed_time_}, dtime = 1.0, none = 0.0;
        const double coords[3] = {}, celent = 1.0;
        char cmname[80];
        std::memset(cmname, ' ', sizeof cmname);
        std::memcpy(cmname, symbol_.data(), symbol_.size());
        const int ndi = 3, nshr = 3, ntens = 6, nstatv = static_cast<int>(statev.size()),
                  nprops = static_cast<int>(props_.size()), npt = 1, zero = 0;
        const int kstep[4] = {1, 0, 0, 0};
        pnewdt_ = 1.0;
        umat_(stress.data(), statev.data(), ddsdde, &sse, &spd, &scd, &rpl, ddsddt, drplde, &drpldt,
              committed_strain_.data(), dstran.data(), time, &dtime, &none, &none, &none, &none,
              cmname, &ndi, &nshr, &ntens, &nstatv, props_.data(), &nprops, coords, identity,
              &pnewdt_, &celent, identity, identity, &tag_, &npt, &zero, &zero, kstep, &kinc_,
              sizeof cmname);
        tangent.resize(36);
        bool finite = true;
        for (std::size_t i = 0; i < 6; ++i)
            for (std::size_t j = 0; j < 6; ++j) {
                tangent[6 * i + j] = ddsdde[abaqus_of[i] + 6 * abaqus_of[j]];
                finite = finite && std::isfinite(tangent[6 * i + j]);
            }
        for (const double s : stress) finite = finite && std::isfinite(s);
        return finite && std::isfinite(pnewdt_) && pnewdt_ >= 1.0;
    }

    int tag_, kinc_ = 1;
    std::string symbol_;
    std::vector<double> props_, initial_statev_;
    Six initial_stress_;
    std::vector<double> committed_statev_, trial_statev_;
    Six committed_stress_, trial_stress_, committed_strain_{}, trial_strain_{};
    std::vector<double> trial_tangent_, initial_tangent_;
    bool tangent_is_of_trial_ = false;
    double committed_time_ = 0.0, pnewdt_ = 1.0;
    UmatFunction umat_;
};

// Hochstetten sand, kPa, as in OpenSees' example: the void ratio in STATEV(7), no more than 13 of them.
UmatMaterial hochstetten(const Six& initial_stress) {
    std::vector<double> statev(13, 0.0);
    statev[6] = 0.70;
    return {
        1,
        "umat",
        {33.0, 0.0, 1e6, 0.25, 0.55, 0.95, 1.05, 0.25, 1.5, 5.0, 2.0, 1e-4, 0.5, 6.0, 0.0, 0.70},
        statev,
        initial_stress};
}

// The example's element: eight equal points of a cube of 1 m that can only be pressed together along 33; its one
// displacement is the strain, its force the mean stress.
class Oedometer {
  public:
    Oedometer() : points_(8, hochstetten({-100, -100, -100, 0, 0, 0})) {}

    // One step of Newton's method until the displacement moves by less than 1e-8; the load is given.
    bool load(double force) {
        for (int iteration = 0; iteration < 50; ++iteration) {
            const double change = (force - this->force()) / stiffness();
            strain_ += change;
            if (!update()) return false;
            if (std::abs(change) < 1e-8) return commit();
        }
        return false;
    }
    // One step of the given displacement, whose load comes out: the predictor is the step, no iteration moves it.
    bool move(double step) {
        strain_ += step;
        return update() && update() && commit();
    }
    double displacement() const { return strain_; }
    double pressure() const { return -force(); }

  private:
    bool update() {
        for (UmatMaterial& point : points_)
            if (!point.set_trial_strain({0, 0, strain_, 0, 0, 0})) return false;
        return true;
    }
    bool commit() {
        for (UmatMaterial& point : points_) point.commit();
        return true;
    }
    double force() const {
        double sum = 0.0;
        for (const UmatMaterial& point : points_) sum += point.stress(2) / 8.0;
        return sum;
    }
    double stiffness() {
        double sum = 0.0;
        for (UmatMaterial& point : points_) sum += point.tangent(2, 2) / 8.0;
        return sum;
    }

    std::vector<UmatMaterial> points_;
    double strain_ = 0.0;
};

// Published with nDMaterial UMAT: 294.3 kPa, 29080 and 316559 kPa (ratio 10.9), from another UMAT whose steps are held to
// 1e-3. verification/cases/hochstetten_oedometer.toml: 29080.15 and 316557.1 from the formulas alone.
TEST(HostCalls, OfOpenSeesReproduceItsPublishedExample) {
    Oedometer element;
    ASSERT_TRUE(element.load(-100.0));
    EXPECT_NEAR(element.displacement(), 0.0, 1e-15);
    char lines[4][100];
    const auto print = [](char* line, const char* format, auto... numbers) {
        std::snprintf(line, 100, format, numbers...);
        std::puts(line);
    };
    print(lines[0], "settlement under balancing load : %.2e m", element.displacement());
    double before = 0.0;
    for (int step = 0; step < 50; ++step) {
        before = element.pressure();
        ASSERT_TRUE(element.move(-1e-4)) << step;
    }
    const double top = element.pressure(), loading = (top - before) / 1e-4;
    print(lines[1], "axial strain  : %.2f %%", -100.0 * element.displacement());
    print(lines[2], "axial stress  : %.1f kPa (compression, started at 100)", top);
    ASSERT_TRUE(element.move(1e-4));
    const double unloading = (top - element.pressure()) / 1e-4;
    print(lines[3], "loading / unloading stiffness : %.0f / %.0f kPa (ratio %.1f)", loading,
          unloading, unloading / loading);
    std::ifstream page(GRIT_OPENSEES_PAGE);
    const std::string text{std::istreambuf_iterator<char>(page), {}};
    for (const char* line : lines) EXPECT_NE(text.find(line), std::string::npos) << line;
    EXPECT_NEAR(-element.displacement(), 0.0049, 1e-12);
    EXPECT_NEAR(top, 294.3, 0.05);
    EXPECT_NEAR(loading, 29080.0, 1e-4 * 29080.0);
    EXPECT_NEAR(unloading, 316559.0, 1e-4 * 316559.0);
}

constexpr Six k0 = {-100, -50, -50, 0, 0, 0};

TEST(HostCalls, OfOpenSeesComeToTheSameInItsOwnOrder) {
    const std::vector<Six> increments = {{-2e-4, 5e-5, 0, 1e-4, 3e-5, -7e-5},
                                         {1e-4, 0, 1e-5, -3e-5, 0, 2e-5}};
    const UmatCall expected = UmatCall::after(k0, increments);
    UmatMaterial point = hochstetten(k0);
    EXPECT_GT(point.tangent(0, 0), 0.0) << "asked for before any strain";
    Six strain{};
    for (const Six& d : increments) {
        Six end = strain, off = strain;
        const Six own = {d[0], d[1], d[2], d[3], d[5], d[4]};
        for (std::size_t c = 0; c < 6; ++c) {
            end[c] += own[c];
            off[c] += 1.3 * own[c];
        }
        ASSERT_TRUE(point.set_trial_strain(off));
        ASSERT_TRUE(point.set_trial_strain(end));
        point.commit();
        strain = end;
    }
    constexpr int place[6] = {0, 1, 2, 3, 5, 4};
    for (std::size_t c = 0; c < 6; ++c) {
        EXPECT_NEAR(point.stress(c), expected.stress[place[c]], 1e-9) << c;
        for (std::size_t r = 0; r < 6; ++r)
            EXPECT_NEAR(point.tangent(r, c), expected.tangent(place[r], place[c]), 1e-4);
    }
}

TEST(HostCalls, OfOpenSeesRecoverFromAFailureByASmallerStep) {
    UmatMaterial point = hochstetten(k0);
    const Six whole = {-0.3, 0.1, 0.1, 0, 0, 0};
    ASSERT_FALSE(point.set_trial_strain(whole));
    for (std::size_t c = 0; c < 6; ++c)
        EXPECT_EQ(point.stress(c), k0[c]) << "the failed trial has changed nothing";
    ASSERT_LT(point.pnewdt(), 1.0);
    ASSERT_GT(point.pnewdt(), 0.0) << "OpenSees calls that an invalid return";
    Six part = whole;
    for (double& x : part) x *= point.pnewdt();
    EXPECT_TRUE(point.set_trial_strain(part));
}

// With as many of STATEV as its example has.
TEST(HostCalls, OfOpenSeesWriteNoMoreThanThirteenStateVariables) {
    UmatMaterial point = hochstetten(k0);
    ASSERT_TRUE(point.set_trial_strain({0, 0, -1e-4, 0, 0, 0}));
    ASSERT_EQ(point.statev().size(), 13U);
    EXPECT_NEAR(point.statev()[6], (1.0 + 0.70) * std::exp(-1e-4) - 1.0, 1e-14);
}

}  // namespace opensees_replay
