// SPDX-License-Identifier: BSD-3-Clause
// One integration point of a host of MGIS, its memory between canaries.
#pragma once

#include <grit/grit.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <string>

#include "support/guarded.hpp"
#include "support/mgis_load.hpp"

namespace mgis_host {

inline constexpr double sqrt_2 = 1.4142135623730951;
inline constexpr const char* hypotheses[] = {"Tridimensional", "Axisymmetrical", "PlaneStrain",
                                             "GeneralisedPlaneStrain"};

inline Behaviour load(const std::string& hypothesis) {
    return load(GRIT_MGIS_LIBRARY, "GritSand", hypothesis);
}

// What K[0] asks for, as hosts name it.
enum Wanted : int {
    prediction_tangent = -3,
    prediction_secant = -2,
    prediction_elastic = -1,
    no_operator = 0,
    elastic = 1,
    secant = 2,
    tangent = 3,
    consistent_tangent = 4,
    and_speed_of_sound = 100
};

struct Point {
    Behaviour behaviour;
    Guarded<16> properties;
    Guarded<6> strain0, strain1, stress0, stress1{-1.0};
    Guarded<10> state0, state1{-1.0};
    Guarded<36> K{-1.0};
    Guarded<1> density0{1.6}, density1{1.6}, stored0{3.0}, stored1{-1.0}, dissipated0{5.0},
        dissipated1{-1.0}, temperature0{293.15}, temperature1{293.15};
    Guarded<1> rdt{10.0}, speed_of_sound{-1.0};
    std::array<char, 512 + 64> message{};
    BehaviourDataView view{};

    // Lausitz sand (kPa) at p = 100 kPa, e = 0.60, h = 0.
    static Point lausitz(const std::string& hypothesis) {
        Point p;
        p.behaviour = load(hypothesis);
        const double props[] = {33.0, 0.0, 1.6e6, 0.19, 0.44, 0.85, 1.0, 0.25,
                                1.0,  5.0, 2.0,   1e-4, 0.5,  6.0,  0.0, 10.6};
        for (int i = 0; i < 16; ++i) p.properties[i] = props[i];
        for (int c = 0; c < 3; ++c) p.stress0[c] = -100.0;
        p.state0[p.behaviour.place_of("VoidRatio")] = 0.6;
        p.message.fill('#');
        return p;
    }

    int components() const { return behaviour.components; }

    // Mandel's components of the strain increment.
    void set_strain(const std::array<double, 6>& increment) {
        for (int c = 0; c < components(); ++c) strain1[c] = strain0[c] + increment[c];
    }

    // Pointers may be taken away after connect() and before call().
    void connect() {
        view = {message.data(),
                1.0,
                K.data(),
                rdt.data(),
                speed_of_sound.data(),
                {strain0.data(), stress0.data(), density0.data(), properties.data(), state0.data(),
                 stored0.data(), dissipated0.data(), temperature0.data()},
                {strain1.data(), stress1.data(), density1.data(), properties.data(), state1.data(),
                 stored1.data(), dissipated1.data(), temperature1.data()}};
    }
    int call(double wanted) {
        K[0] = wanted;
        return behaviour.integrate(&view);
    }
    int run(double wanted = consistent_tangent) {
        connect();
        return call(wanted);
    }
    // The end becomes the start, as hosts do where an increment has been accepted.
    void accept() {
        strain0 = strain1;
        stress0 = stress1;
        state0 = state1;
        dissipated0 = dissipated1;
    }

    std::string said() const { return {message.data()}; }
    bool in_bounds() const {
        const int n = components(), variables = behaviour.size_of(behaviour.state_variables);
        bool intact = stress1.intact_beyond(6) && K.intact_beyond(36) && rdt.intact_beyond(1) &&
                      state1.intact_beyond(10) && speed_of_sound.intact_beyond(1);
        for (int c = n; c < 6; ++c) intact = intact && stress1[c] == -1.0;
        for (int i = n * n; i < 36; ++i) intact = intact && K[i] == -1.0;
        for (int i = variables; i < 10; ++i) intact = intact && state1[i] == -1.0;
        for (std::size_t i = 512; i < message.size(); ++i) intact = intact && message[i] == '#';
        return intact;
    }
    // No result was written.
    bool untouched() const {
        bool same = in_bounds() && speed_of_sound[0] == -1.0 && stored1[0] == -1.0 &&
                    dissipated1[0] == -1.0;
        for (int c = 0; c < 6; ++c) same = same && stress1[c] == -1.0;
        for (int i = 0; i < 10; ++i) same = same && state1[i] == -1.0;
        for (int i = 1; i < 36; ++i) same = same && K[i] == -1.0;
        return same;
    }
};

// Compression with shear in all planes; Mandel's components.
inline constexpr std::array<double, 6> general_strain = {-1e-3, 2e-4, 1e-4, 3e-4, -2e-4, 5e-4};

inline Point strained(const std::string& hypothesis) {
    Point p = Point::lausitz(hypothesis);
    p.set_strain(general_strain);
    return p;
}

// Sets a parameter of all points, and puts the default back.
class WithParameter {
  public:
    WithParameter(const Behaviour& of, std::string called, double value)
        : behaviour(of), name(std::move(called)) {
        behaviour.set_real(name.c_str(), value);
    }
    WithParameter(const WithParameter&) = delete;
    WithParameter& operator=(const WithParameter&) = delete;
    ~WithParameter() {
        for (std::size_t i = 0; i < behaviour.real_parameters.size(); ++i)
            if (behaviour.real_parameters[i] == name)
                behaviour.set_real(name.c_str(), behaviour.real_defaults[i]);
    }

  private:
    const Behaviour& behaviour;
    std::string name;
};

}  // namespace mgis_host
