// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/scatter.hpp"

#include <algorithm>

namespace grit::mpm {
namespace {

unsigned part_of(int component) {
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

}  // namespace

void Scatter::add_body() {
    IntegerRecords& body = integers.emplace_back();
    if (model.settings.fixed_point) body.resize(model.fixed_nodes.size(), model.strips());
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
    const bool with_water = parts == part::all;
    if (with_water) water.find_pressures();
    if (model.settings.fixed_point) {
        add_fixed(parts, nullptr);
    } else {
        if (with_water) water.begin_sums();
        add(parts, nullptr);
        for (Part& part : model.parts)
            model.exchange.sum_nodes(part.records.data(),
                                     static_cast<std::ptrdiff_t>(part.records.size()));
    }
    if (with_water) water.finish_sums();
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
        const bool has_water = !targets && parts == part::all && water.has(body);
        const WaterScatter of_water = has_water ? water.scattered(body, strip) : WaterScatter{};
        const ScatterCall call{model.grid(),
                               part.body.particles.view(),
                               part.strips.begin(strip),
                               part.strips.begin(strip + 1),
                               nodes(body, targets).data(),
                               parts,
                               model.settings.fixed_point ? integers[body].part(strip) : nullptr,
                               with_means ? means.of(body) : CellMean{},
                               part.separation,
                               has_water ? &of_water : nullptr};
        if (body_force && (parts & part::force))
            body_force(call.particles, call.begin, call.end, model.t);
        kernels().scatter(model.settings.shape, model.settings.axisymmetric, call);
    });
}

// True if the sums must be done again. Throws where a contribution is infinite or no number.
bool Scatter::check(unsigned parts, const std::vector<ScatterTarget>* targets) {
    unsigned components = 0;
    for (int c = 0; c < record::size; ++c)
        if (parts & part_of(c)) components |= 1u << c;
    bool again = false;
    for (std::size_t i = 0; i < integers.size(); ++i) {
        if (targets && (*targets)[i].records.empty()) continue;
        const IntegerRecords::Check found = integers[i].check(components, model.exchange);
        if (found.failed >= 0)
            fail_share(model.parts[i].body, name_of(part_of(found.failed)), model.t);
        again = again || found.again;
    }
    // Processes ask each other: no short cut.
    if (!targets && parts == part::all && water.check_sums()) again = true;
    return again;
}

void Scatter::add_fixed(unsigned parts, std::vector<ScatterTarget>* targets) {
    do {
        for (IntegerRecords& body : integers) body.begin();
        if (!targets && parts == part::all) water.begin_sums();
        add(parts, targets);
    } while (check(parts, targets));
    for (std::size_t i = 0; i < integers.size(); ++i) {
        std::vector<NodeRecord>& records = nodes(i, targets);
        if (!records.empty()) integers[i].add_to(records, model.exchange);
    }
}

}  // namespace grit::mpm
