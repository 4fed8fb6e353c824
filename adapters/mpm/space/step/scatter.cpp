// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/space/step/scatter.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace grit::mpm::space {
namespace {

const char* name_of_record(int component) {
    return component == record::m ? "mass" : component < record::f_x ? "momentum" : "force";
}

[[noreturn]] void fail(const Body& body, const char* of_what, double t) {
    fail_share(body.name, body.particles, column_names(body.material.get(), body.water), of_what,
               t);
}

}  // namespace

void Scatter::add_body() {
    integers.emplace_back();
    if (model.settings.fixed_point) integers.back().records.resize(model.nodes(), model.pencils());
}

void Scatter::add_slopes(std::size_t body) {
    const bool fixed_point = model.settings.fixed_point;
    model.parts[body].slopes.resize(model.nodes());
    if (fixed_point) integers[body].slopes.resize(model.nodes(), model.pencils());
    if (!water.has(body)) return;
    model.parts[body].pore_forces.resize(model.nodes());
    if (fixed_point) integers[body].pore_forces.resize(model.nodes(), model.pencils());
}

void Scatter::operator()() {
    if (means.wanted()) means.find_stresses();
    water.find_pressures();
    model.for_nodes([this](std::size_t body, std::size_t, std::size_t begin, std::size_t end) {
        Part& part = model.parts[body];
        std::fill(part.records.data() + begin, part.records.data() + end, NodeRecord{});
        for (std::vector<NodeSlope>* of : {&part.slopes, &part.pore_forces})
            if (!of->empty()) std::fill(of->data() + begin, of->data() + end, NodeSlope{});
    });
    if (!model.settings.fixed_point) {
        add();
        return share();
    }
    do {
        begin_fixed();
        add();
    } while (must_be_done_again());
    take_fixed();
}

void Scatter::add() {
    const bool fixed_point = model.settings.fixed_point;
    model.for_pencils_apart([this, fixed_point](std::size_t body, int pencil) {
        Part& part = model.parts[body];
        const bool with_slopes = !part.slopes.empty(), with_pores = !part.pore_forces.empty();
        const ScatterCall call{
            model.grid(),
            part.body.particles.view(),
            part.pencils.begin(pencil),
            part.pencils.begin(pencil + 1),
            part.records.data(),
            with_slopes ? part.slopes.data() : nullptr,
            means.of(body),
            part.separation,
            fixed_point ? integers[body].records.part(pencil) : nullptr,
            fixed_point && with_slopes ? integers[body].slopes.part(pencil) : nullptr,
            water.pressures(body),
            with_pores ? part.pore_forces.data() : nullptr,
            fixed_point && with_pores ? integers[body].pore_forces.part(pencil) : nullptr};
        if (body_force) body_force(call.particles, call.begin, call.end, model.t);
        kernels().scatter(model.settings.shape, call);
    });
}

// What all processes have at a node.
void Scatter::share() {
    const auto nodes = static_cast<std::ptrdiff_t>(model.nodes());
    for (Part& part : model.parts) {
        model.exchange.sum_nodes(part.records.data()->value, nodes, record::size);
        for (std::vector<NodeSlope>* of : {&part.slopes, &part.pore_forces})
            if (!of->empty()) model.exchange.sum_nodes(of->data()->value, nodes, slope::size);
    }
}

void Scatter::begin_fixed() {
    for (std::size_t i = 0; i < integers.size(); ++i) {
        integers[i].records.begin_parts();
        integers[i].slopes.begin_parts();
        integers[i].pore_forces.begin_parts();
    }
    model.for_nodes([this](std::size_t body, std::size_t, std::size_t begin, std::size_t end) {
        integers[body].records.clear(begin, end);
        if (!model.parts[body].slopes.empty()) integers[body].slopes.clear(begin, end);
        if (!model.parts[body].pore_forces.empty()) integers[body].pore_forces.clear(begin, end);
    });
}

// Throws where a contribution is infinite or no number.
bool Scatter::must_be_done_again() {
    constexpr unsigned records = (1u << (record::f_z + 1)) - 1, slopes = (1u << slope::size) - 1;
    bool again = false;
    for (std::size_t i = 0; i < integers.size(); ++i) {
        const Body& body = model.parts[i].body;
        const auto found = integers[i].records.check(records, model.exchange);
        if (found.failed >= 0) fail(body, name_of_record(found.failed), model.t);
        again = again || found.again;
        if (model.parts[i].slopes.empty()) continue;
        const auto of_slopes = integers[i].slopes.check(slopes, model.exchange);
        if (of_slopes.failed >= 0) fail(body, "gradient of its mass", model.t);
        again = again || of_slopes.again;
        if (model.parts[i].pore_forces.empty()) continue;
        const auto of_pores = integers[i].pore_forces.check(slopes, model.exchange);
        if (of_pores.failed >= 0) fail(body, "pore pressure", model.t);
        again = again || of_pores.again;
    }
    return again;
}

void Scatter::take_fixed() {
    for (std::size_t i = 0; i < integers.size(); ++i) {
        integers[i].records.share(model.exchange);
        if (!model.parts[i].slopes.empty()) integers[i].slopes.share(model.exchange);
        if (!model.parts[i].pore_forces.empty()) integers[i].pore_forces.share(model.exchange);
    }
    model.for_nodes([this](std::size_t body, std::size_t, std::size_t begin, std::size_t end) {
        Part& part = model.parts[body];
        integers[body].records.add_to(reinterpret_cast<double*>(part.records.data()), begin, end);
        if (!part.slopes.empty())
            integers[body].slopes.add_to(reinterpret_cast<double*>(part.slopes.data()), begin, end);
        if (!part.pore_forces.empty())
            integers[body].pore_forces.add_to(reinterpret_cast<double*>(part.pore_forces.data()),
                                              begin, end);
    });
}

}  // namespace grit::mpm::space
