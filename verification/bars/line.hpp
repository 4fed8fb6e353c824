// SPDX-License-Identifier: BSD-3-Clause
// The smallest material-point code that contact can live in: a one-dimensional grid, two bars, explicit
// steps with the stress last, CPDI (uGIMP) weights, FLIP. It calls the contact as any host would.
#pragma once

#include <array>
#include <vector>

#include <grit/contact.h>
#include <grit/contact_distance.h>
#include <grit/contact_penalty.h>
#include <grit/contact_surface.h>

#include "bars/bar.hpp"

namespace bars {

enum class Method { nodal, penalty, surface };

struct Contact {
    Method method = Method::nodal;
    grit_contact_options options{};  // nodal: law, k, friction, rigid bodies
    bool gated = true;               // nodal: by the gap
    int measure = GRIT_CONTACT_SUPPORT;
    double stiffness = 0.0;  // penalty, surface: eps [Pa/m]; a surface may have none
    double friction = 0.0;   // surface: mu [-]
};

Contact geo_contact(double k, bool gated);
Contact frictional_contact(bool gated);
Contact penalty_contact(double stiffness);
Contact surface_contact(double friction, double stiffness = 0.0);

// What contact did in a step.
struct StepReport {
    double force = 0.0;              // on B along the line, per cross-section [Pa]
    double slip_force = 0.0;         // on B across it [Pa]
    double dissipation = 0.0;        // leapfrog value [J/m2]
    double transfer = 0.0;           // lost between nodes and particles [J/m2]
    int slipping = 0, sticking = 0;  // nodes
};

class Line {
  public:
    // Nodes at from, from + cell, ... [m]. Bar a lies left of b.
    Line(double from, double cell, int nodes);
    StepReport step(Bar& a, Bar& b, const Contact& contact, double dt);
    double cell() const { return h; }

  private:
    struct Nodes {
        std::vector<double> mass, momentum, slip_momentum, force, slip_force;
        std::vector<std::array<double, 2>> v, old_v;
    };
    struct Weights {
        std::ptrdiff_t first;      // of four nodes
        std::array<double, 4> N;   // S of the particle's length [-]
        std::array<double, 4> dN;  // G [1/m]
    };
    Weights weights(double x, double length) const;
    void gather(const Bar& bar, Nodes& nodes) const;
    void advance(const Bar& bar, Nodes& nodes, double dt) const;
    void measure(const Bar& a, const Bar& b);
    StepReport correct(const Bar& a, const Bar& b, const Contact& contact, double dt);
    StepReport push(const Bar& a, const Bar& b, const Contact& contact, double dt);
    StepReport meet(const Bar& a, const Bar& b, const Contact& contact, double dt);
    double scatter(Bar& bar, const Nodes& nodes, double dt) const;

    double x0, h;
    std::size_t count;
    Nodes nodes_a, nodes_b;
    std::vector<std::array<double, 2>> position, surface, centre;
    std::vector<double> distance, gap;
};

}  // namespace bars
