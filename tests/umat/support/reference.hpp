// SPDX-License-Identifier: BSD-3-Clause
// Referee of the integrator: grit_sand_rate integrated for T, h and e by Boost.odeint
// (Runge-Kutta-Fehlberg 7(8), 1e-13), cut where the intergranular strain turns to loading.
#pragma once

#include <boost/numeric/odeint.hpp>

#include "support/states.hpp"

namespace tests {

struct Reference {
    State end;
    bool in_domain = true;  // over the whole path
};

class Referee {
  public:
    Referee(const Sand& s, const State& start, const Vec& dE, Intergranular intergranular)
        : sand(s), igs(intergranular), D(dE.normalized()), scale(start.T.norm()) {
        for (int i = 0; i < 6; ++i) {
            y[i] = start.T[i] / scale;
            y[6 + i] = start.h[i] / sand.p.elastic_strain_radius;
        }
        y[12] = start.e;
        const double length = dE.norm();
        const double turn = igs == Intergranular::on ? -start.h.dot(D) : 0.0;
        if (turn > 0.0 && turn < length) {
            march(0.0, turn);
            march(turn, length);
        } else {
            march(0.0, length);
        }
    }
    Reference result() const { return {state(y), in_domain}; }

  private:
    using Y = std::vector<double>;

    State state(const Y& v) const {
        State x;
        for (int i = 0; i < 6; ++i) {
            x.T[i] = v[i] * scale;
            x.h[i] = v[6 + i] * sand.p.elastic_strain_radius;
        }
        x.e = v[12];
        return x;
    }

    void march(double from, double to) {
        using namespace boost::numeric::odeint;
        const auto rates = [this](const Y& v, Y& dv, double) {
            const Rate r = rate(sand, state(v), D, igs);
            for (int i = 0; i < 6; ++i) {
                dv[i] = r.T[i] / scale;
                dv[6 + i] = r.h[i] / sand.p.elastic_strain_radius;
            }
            dv[12] = r.e;
        };
        const auto watch = [this](const Y& v, double) {
            const State x = state(v);
            const double p = -trace(x.T) / 3.0;
            const VoidRatios limits = void_ratios(sand, std::fmax(p, 0.0));
            if (!(p > 0.05 * scale / std::sqrt(3.0)) || deviator(x.T).norm() > 0.75 * 3.0 * p ||
                x.e < limits.e_d || x.e > limits.e_i)
                in_domain = false;
        };
        // Short steps, for paths that pass the hydrostatic axis, where F has the tip of a cone.
        const double longest = (to - from) / 200.0;
        integrate_adaptive(make_controlled(1e-13, 1e-13, longest, runge_kutta_fehlberg78<Y>()),
                           rates, y, from, to, 0.1 * longest, watch);
    }

    const Sand& sand;
    Intergranular igs;
    Vec D;
    double scale;
    Y y = Y(13);
    bool in_domain = true;
};

inline Reference referee(const Sand& sand, const State& x, const Vec& dE,
                         Intergranular igs = Intergranular::on) {
    return Referee(sand, x, dE, igs).result();
}

}  // namespace tests
