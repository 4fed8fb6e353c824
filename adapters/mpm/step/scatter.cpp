// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/scatter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "adapters/mpm/step/column_names.hpp"
#include "adapters/mpm/step/text.hpp"

namespace grit::mpm {
namespace {

constexpr int aim = 48;                // bits of the largest contribution after a change of scale
constexpr double least_size = 0x1p42;  // ... and what it may shrink to
// At the coarsest scale every finite contribution is within the limit. The finest one has a reciprocal.
constexpr int coarsest = -975, finest = 1000;
static_assert(std::numeric_limits<double>::max() * 0x1p-975 < FixedPoint::limit);

constexpr double infinite = std::numeric_limits<double>::infinity();

// The scale for contributions of which the largest is so large at this one; the same: they fit. After
// at most three changes they do.
double scale_for(double largest, double scale) {
    if (largest == 0.0)
        return std::max(scale, 1.0);  // at a coarse scale it may be too small to see
    if (!(largest < infinite)) return std::ldexp(1.0, coarsest);
    if (largest >= least_size && largest < FixedPoint::limit) return scale;
    const int exponent = std::ilogb(scale) + aim - std::ilogb(largest);
    return std::ldexp(1.0, std::clamp(exponent, coarsest, finest));
}

unsigned part_of(std::size_t component) {
    switch (component) {
        case record::m: return part::mass;
        case record::p_r:
        case record::p_z: return part::momentum;
        case record::f_r:
        case record::f_z: return part::force;
        default: return part::gradient;
    }
}

const char* name_of(unsigned of_part) {
    switch (of_part) {
        case part::mass: return "mass";
        case part::momentum: return "momentum";
        case part::force: return "force";
        default: return "gradient of its mass";
    }
}

// The first number of a body that is none; another process may have it.
std::string place_of_failure(Body& body) {
    const std::vector<std::string> names =
        column_names(body.material.get(), body.water ? &*body.water : nullptr);
    const ParticleView q = body.particles.view();
    for (std::ptrdiff_t p = 0; p < body.particles.size(); ++p)
        for (int c = 0; c < body.particles.column_count(); ++c)
            if (!std::isfinite(q[c][p]))
                return ": particle " + std::to_string(body.particles.ids()[p]) + " has " +
                       names[static_cast<std::size_t>(c)] + " = " + text(q[c][p]);
    return {};
}

}  // namespace

void Scatter::add_body() {
    OfBody& body = bodies.emplace_back();
    if (!model.settings.fixed_point) return;
    body.integers.resize(model.fixed_nodes.size());
    body.strips.resize(static_cast<std::size_t>(model.strips()));
    body.scale.fill(1.0);
}

void Scatter::clear() {
    model.for_strips([this](std::size_t body, int strip) {
        const Model::Rows rows = model.nodes_of(strip);
        const auto begin = model.parts[body].records.begin();
        std::fill(begin + rows.begin, begin + rows.end, NodeRecord{});
    });
}

void Scatter::operator()(unsigned parts) {
    if (means.wanted() && (parts & part::force)) means.find_stresses();
    if (model.settings.fixed_point) return add_fixed(parts, nullptr);
    add(parts, nullptr);
    for (Part& part : model.parts)
        model.exchange.sum_nodes(part.records.data(),
                                 static_cast<std::ptrdiff_t>(part.records.size()));
}

void Scatter::into(std::vector<ScatterTarget>& targets, unsigned parts) {
    model.settings.fixed_point ? add_fixed(parts, &targets) : add(parts, &targets);
}

std::vector<NodeRecord>& Scatter::nodes(std::size_t body,
                                        std::vector<ScatterTarget>* targets) const {
    return targets ? (*targets)[body].records : model.parts[body].records;
}

void Scatter::add(unsigned parts, std::vector<ScatterTarget>* targets) {
    const bool with_means = means.wanted() && (parts & part::force);
    model.for_strips_apart([&, this](std::size_t body, int strip) {
        const auto s = static_cast<std::size_t>(strip);
        // In fixed point the scale is the one that all strips want.
        if (targets && ((*targets)[body].records.empty() ||
                        !((*targets)[body].strips[s] || model.settings.fixed_point)))
            return;
        Part& part = model.parts[body];
        const ScatterCall call{model.grid(),
                               part.body.particles.view(),
                               part.strips.begin(strip),
                               part.strips.begin(strip + 1),
                               nodes(body, targets).data(),
                               parts,
                               model.settings.fixed_point ? &bodies[body].strips[s] : nullptr,
                               with_means ? means.of(body) : CellMean{},
                               part.separation};
        if (body_force && (parts & part::force))
            body_force(call.particles, call.begin, call.end, model.t);
        kernels().scatter(model.settings.shape, model.settings.axisymmetric, call);
    });
}

// The scales that the contributions want; true if the sums must be done again. Throws where one is infinite
// or no number.
bool Scatter::rescale(unsigned parts, const std::vector<ScatterTarget>* targets) {
    bool again = false;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (targets && (*targets)[i].records.empty()) continue;
        OfBody& body = bodies[i];
        std::array<double, record::size> largest{};
        for (const FixedPoint& strip : body.strips)
            for (std::size_t c = 0; c < largest.size(); ++c)
                // A maximum over processes need not know what is no number.
                largest[c] = strip.largest[c] <= infinite ? std::max(largest[c], strip.largest[c])
                                                          : infinite;
        model.exchange.max(largest.data(), record::size);
        for (std::size_t c = 0; c < largest.size(); ++c) {
            if (!(parts & part_of(c))) continue;
            const double scale = scale_for(largest[c], body.scale[c]);
            Body& failed = model.parts[i].body;
            if (scale != body.scale[c]) again = true;
            else if (!(largest[c] < infinite))
                throw std::runtime_error(
                    "body " + failed.name + ": a particle's share of the " + name_of(part_of(c)) +
                    " of nodes is infinite or no number at t = " + text(model.t) + " s" +
                    place_of_failure(failed));
            body.scale[c] = scale;
        }
    }
    return again;
}

void Scatter::add_fixed(unsigned parts, std::vector<ScatterTarget>* targets) {
    do {
        for (OfBody& body : bodies) {
            std::fill(body.integers.begin(), body.integers.end(), NodeIntegers{});
            for (FixedPoint& strip : body.strips) {
                strip = {};
                strip.nodes = body.integers.data();
                std::copy(body.scale.begin(), body.scale.end(), strip.scale);
            }
        }
        add(parts, targets);
    } while (rescale(parts, targets));
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        OfBody& body = bodies[i];
        std::vector<NodeRecord>& records = nodes(i, targets);
        if (records.empty()) continue;
        model.exchange.sum_nodes(body.integers.data(),
                                 static_cast<std::ptrdiff_t>(body.integers.size()));
        for (std::size_t node = 0; node < records.size(); ++node)
            for (int c = 0; c < record::size; ++c)
                records[node][c] += static_cast<double>(body.integers[node].value[c]) /
                                    body.scale[static_cast<std::size_t>(c)];
    }
}

}  // namespace grit::mpm
