// SPDX-License-Identifier: BSD-3-Clause
// The behaviour as a law of the element driver, so that the same program of steps runs on it.
#pragma once

#include <element/law.hpp>

#include "support/mgis_point.hpp"

namespace mgis_host {

// State: the internal state variables. What a hypothesis of four components does not have is zero, and
// its stiffness a unit one that keeps the driver's matrix regular.
class MgisLaw : public element::Law {
  public:
    MgisLaw(const Point& point) : prototype(point) {
        const int n = point.behaviour.size_of(point.behaviour.state_variables);
        for (int i = 0; i < n; ++i) names.push_back("isv" + std::to_string(i));
    }

    element::Response advance(const element::MaterialPoint& start,
                              const element::StrainIncrement& increment) const override {
        Point p = prototype;
        const int n = p.components();
        for (int c = 0; c < n; ++c) {
            const double f = factor(c);
            p.strain0[c] = increment.total_strain[c] / f;
            p.strain1[c] = (increment.total_strain[c] + increment.strain[c]) / f;
            p.stress0[c] = start.stress[c] * f;
        }
        for (std::size_t i = 0; i < names.size(); ++i)
            p.state0[static_cast<int>(i)] = start.state[i];
        element::Response out;
        if (p.run() != 1) {
            out.outcome = element::Outcome::retry_smaller;
            out.reduction = p.rdt[0];
            out.message = p.said();
            return out;
        }
        out.tangent.setIdentity();
        for (int r = 0; r < n; ++r) {
            out.end.stress[r] = p.stress1[r] / factor(r);
            for (int c = 0; c < n; ++c)
                out.tangent(r, c) = p.K[r * n + c] / (factor(r) * factor(c));
        }
        for (std::size_t i = 0; i < names.size(); ++i)
            out.end.state.push_back(p.state1[static_cast<int>(i)]);
        return out;
    }

    element::Observation observe(const element::MaterialPoint& point) const override {
        element::Observation out;
        out.void_ratio = scalar(point, "VoidRatio");
        if (prototype.properties[14] > 0.0) out.pore_pressure = scalar(point, "ExcessPorePressure");
        return out;
    }
    const std::vector<std::string>& state_names() const override { return names; }

    // stress and h in Voigt's components.
    element::MaterialPoint start(const element::Vector6& stress, const element::Vector6& h,
                                 double void_ratio) const {
        element::MaterialPoint out{stress, std::vector<double>(names.size(), 0.0)};
        for (int c = 0; c < prototype.components(); ++c)
            out.state[static_cast<std::size_t>(c)] = h[c] / factor(c);
        out.state[place("VoidRatio")] = void_ratio;
        return out;
    }

  private:
    static double factor(int c) { return c < 3 ? 1.0 : sqrt_2; }
    std::size_t place(const char* name) const {
        return static_cast<std::size_t>(prototype.behaviour.place_of(name));
    }
    double scalar(const element::MaterialPoint& point, const char* name) const {
        return point.state[place(name)];
    }

    Point prototype;
    std::vector<std::string> names;
};

}  // namespace mgis_host
