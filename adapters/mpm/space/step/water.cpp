// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/space/step/water.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "adapters/mpm/step/text.hpp"

namespace grit::mpm::space {

void Water::add_body() {
    const std::size_t i = bodies.size();
    OfBody& body = bodies.emplace_back();
    if (!has(i)) return;
    body.cells.resize(model.cells());
    body.pencils.resize(static_cast<std::size_t>(model.pencils()));
    particles_changed(i);
}

void Water::particles_changed(std::size_t body) {
    if (has(body))
        bodies[body].places.resize(
            static_cast<std::size_t>(model.parts[body].body.particles.size()));
}

bool Water::is_anywhere() const {
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (has(i)) return true;
    return false;
}

// value: volume [m3], what is averaged, as a share of less than eight, and the cell.
template <class Value> void Water::find_means(const Value& value) {
    for (OfBody& body : bodies) std::fill(body.cells.begin(), body.cells.end(), CellIntegers{});
    model.for_pencils_apart([this, &value](std::size_t i, int pencil) {
        if (!has(i)) return;
        const Part& part = model.parts[i];
        const double per_volume = 1.0 / part.largest_volume;
        for (std::ptrdiff_t p = part.pencils.begin(pencil); p < part.pencils.begin(pencil + 1);
             ++p) {
            const auto [V, x, cell] = value(i, p);
            add_share(bodies[i].cells[static_cast<std::size_t>(cell)], V * per_volume, x);
        }
    });
    for (OfBody& body : bodies)
        if (!body.cells.empty())
            model.exchange.sum_cells(body.cells.data(),
                                     static_cast<std::ptrdiff_t>(body.cells.size()));
}

namespace {

struct Averaged {
    double V, x;
    std::ptrdiff_t cell;
};

}  // namespace

void Water::find_pressures() {
    if (!is_anywhere()) return;
    const GridView grid = model.grid();
    find_means([&](std::size_t i, std::ptrdiff_t p) {
        Part& part = model.parts[i];
        const ParticleView q = part.body.particles.view();
        const PoreWater& water = *part.body.water;
        return Averaged{q.volume(p), water.pressure(q, p) / water.bulk_modulus,
                        grid.cell_of(q.position(p))};
    });
}

PoreStrains Water::strains(std::size_t i) {
    if (!has(i)) return {};
    return {&*model.parts[i].body.water, bodies[i].places.data()};
}

void Water::update() {
    if (!is_anywhere()) return;
    find_means([this](std::size_t i, std::ptrdiff_t p) {
        const PorePlace& place = bodies[i].places[static_cast<std::size_t>(p)];
        return Averaged{place.V, place.strain, place.cell};
    });
    model.for_pencils([this](std::size_t i, int pencil) {
        if (has(i)) update(i, pencil);
    });
}

void Water::update(std::size_t i, int pencil) {
    Part& part = model.parts[i];
    const ParticleView q = part.body.particles.view();
    const PoreWater& water = *part.body.water;
    const bool fixed_point = model.settings.fixed_point;
    OfPencil sums;
    for (std::ptrdiff_t p = part.pencils.begin(pencil); p < part.pencils.begin(pencil + 1); ++p) {
        const auto [V, e, own, cell] = bodies[i].places[static_cast<std::size_t>(p)];
        const CellIntegers& mean = bodies[i].cells[static_cast<std::size_t>(cell)];
        const double strain = mean.volume > 0 ? mean.mean() : own;
        const double e_middle = water.middle_of(e, strain);
        if (!(e_middle > 0.0))
            throw std::runtime_error("body " + part.body.name + ": particle " +
                                     std::to_string(part.body.particles.ids()[p]) +
                                     " has no pores left, its void ratio is " + text(e_middle) +
                                     " at t = " + text(model.t) + " s");
        const double before = water.pressure(q, p);
        q[water.first][p] = water.strained(q[water.first][p], e, e_middle, strain);
        const double now = water.pressure(q, p);
        sums.work.add(-0.5 * (before + now) * strain * V, fixed_point);
        sums.half.add(-0.5 * now * strain * V, fixed_point);
        sums.speed2 = std::max(sums.speed2, water.speed2(e, q[column::mass][p] / V));
    }
    bodies[i].pencils[static_cast<std::size_t>(pencil)] = sums;
}

void Water::measure() {
    model.for_pencils([this](std::size_t i, int pencil) {
        if (!has(i)) return;
        Part& part = model.parts[i];
        const ParticleView q = part.body.particles.view();
        const PoreWater& water = *part.body.water;
        OfPencil sums;
        for (std::ptrdiff_t p = part.pencils.begin(pencil); p < part.pencils.begin(pencil + 1); ++p)
            sums.speed2 = std::max(sums.speed2, water.speed2(water.void_ratio(q, p),
                                                             q[column::mass][p] / q.volume(p)));
        bodies[i].pencils[static_cast<std::size_t>(pencil)] = sums;
    });
}

double Water::speed2(std::size_t body) const {
    double out = 0.0;
    for (const OfPencil& pencil : bodies[body].pencils) out = std::max(out, pencil.speed2);
    return out;
}

}  // namespace grit::mpm::space
