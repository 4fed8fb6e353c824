// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/kernel/pore_water.hpp"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

namespace grit::mpm {
namespace {

// Lanes of WaterNodeCall::volume.
constexpr int drag_impulse = motion::other_r;

// A component of a node: of the grains, of the water, and whether they may move.
struct Component {
    int k;  // 0: r, 1: z
    bool grains_free, water_free;
};

Component component(const WaterNodeCall& call, std::ptrdiff_t i, int k) {
    const int bit = k == 0 ? fixed::r : fixed::z;
    const bool is_free = !(call.grains.fixed[i] & bit);
    return {k, is_free, !(call.closed[i] & bit) || (call.drained && (call.drained[i] & bit))};
}

bool has_water(const WaterNodeCall& call, std::ptrdiff_t i) {
    return call.grains.records[i][record::m] > call.grains.least_mass &&
           call.water->is_at(call.water_records[i]);
}

// The velocity of water that a side lets in, which stands there as the grains do [m/s].
double poured(const WaterNodeCall& call, std::ptrdiff_t i, int k) {
    return call.poured ? call.poured[i][k] / call.porosity(i) : 0.0;
}

// Half a step's work of the pressure on the volume that mapping took away, see NodeSums: what is not counted there,
// where the grains' share of its force is one of their forces.
double mapped_away(const WaterNodeCall& call, std::ptrdiff_t i, double n, const NodeMotion& water) {
    const NodeMotion &before = call.volume[i], &grains = call.grains.motions[i];
    if (before[0] == 0.0 && before[1] == 0.0) return 0.0;
    double work = 0.0;
    for (int k = 0; k < 2; ++k)
        work += call.water_records[i][water_record::f_r + k] *
                (call.grains.dt_before * (before[k] - (1.0 - n) * grains[motion::v_r + k]) -
                 call.grains.dt * n * water[motion::other_r + k]);
    return 0.5 * work;
}

}  // namespace

std::vector<std::string> PoreWater::words() const {
    char text[240];
    std::snprintf(text, sizeof text,
                  "water: bulk modulus %.17g Pa, density %.17g kg/m3, largest tension %.17g Pa, "
                  "porosity %.17g",
                  bulk_modulus, density, largest_tension, porosity);
    std::vector<std::string> out{text};
    if (implicit) out.emplace_back("water: pressure implicit");
    if (!flows) return out;
    std::snprintf(text, sizeof text, "water flows: conductivity %.17g m/s at void ratio %.17g",
                  conductivity, conductivity_at);
    out.emplace_back(text);
    return out;
}

void reflect(const PoreWater& water, const ParticleView& q, std::ptrdiff_t p) {
    if (water.flows) q[water.velocity_column()][p] = -q[water.velocity_column()][p];
}

void add_pressures(const GridView& grid, const ParticleView& q, std::ptrdiff_t begin,
                   std::ptrdiff_t end, const PoreWater& water, double per_volume,
                   WaterCell* cells) {
    for (std::ptrdiff_t p = begin; p < end; ++p) {
        add_share(cells[grid.cell_of(q[column::r][p], q[column::z][p])],
                  q[column::V0][p] * q.J(p) * per_volume,
                  water.pressure(q, p) / water.bulk_modulus);
    }
}

namespace {

[[noreturn]] void fail(const ParticleView& q, std::ptrdiff_t p, const std::string& why) {
    throw std::runtime_error("a particle at (" + std::to_string(q[column::r][p]) + ", " +
                             std::to_string(q[column::z][p]) + ") m has no " + why);
}

}  // namespace

// What has come and gone is that of the cell, as the pressure is: particle by particle a steady flow would empty some and fill
// others.
double update_pressures(const ParticleView& q, std::ptrdiff_t begin, std::ptrdiff_t end,
                        const PoreWater& water, const WaterCell* cells, const WaterPlace* places,
                        double per_volume, const ImplicitCell* implicit, bool fixed_point,
                        WaterSums& sums) {
    const double quantum = 8.0 / (CellIntegers::scale * per_volume);
    double fastest = 0.0;
    for (std::ptrdiff_t p = begin; p < end; ++p) {
        const auto [V, e, cell] = places[p];
        const WaterCell& mean = cells[cell];
        const double of_cell = mean.volume > 0 ? mean.mean() : 0.0;
        // Its volume as that of the cell has it: what particles get adds up to what the cell has [m3].
        const double part =
            water.flows ? quantum * static_cast<double>(cell_share_rounded(0.125 * V * per_volume))
                        : 0.0;
        if (water.flows && mean.volume > 0)
            q[water.content_column()][p] -=
                water.density * part *
                (static_cast<double>(mean.left) / static_cast<double>(mean.volume));
        const ImplicitCell after = implicit ? implicit[cell] : ImplicitCell{};
        const double gone = mean.volume > 0 ? after.left / mean.total(per_volume) : 0.0;
        const double strain = of_cell + gone;
        const double e_middle = water.middle_of(e, of_cell);
        if (!(e_middle > 0.0))
            fail(q, p, "pores left, its void ratio is " + std::to_string(e_middle));
        if (water.flows && !(q[water.content_column()][p] > 0.0))
            fail(q, p, "water left: more has flowed out of it than was there");
        const double before = water.pressure(q, p);
        const bool keeps_cavity = water.keeps_cavity(e, q[water.first][p]);
        q[water.first][p] = water.strained(q[water.first][p], e, e_middle, strain);
        const double now = water.pressure(q, p);
        sums.work.add(-0.5 * (before + now) * strain * V, fixed_point);
        sums.half.add(-0.5 * now * of_cell * V, fixed_point);
        fastest = std::max(fastest, water.speed2(e, q[column::mass][p] / V));
        if (water.flows)
            sums.carried.add(0.5 * (water.mass_of(e, V) - water.mass(q, p)) *
                                 water.speed_squared(q, p),
                             fixed_point);
        if (!implicit) continue;
        // What particles of a cell differ by presses nowhere, until one of them comes to the next cell. What flows from one to the
        // other adds up to nothing: the sum of V dp/(K_w/n).
        if (mean.volume > 0 && !keeps_cavity)
            q[water.first][p] +=
                after.together * (water.stiffness(e) / after.stiffness) * (after.pressure - before);
        if (gone == 0.0) continue;
        sums.between.add(0.5 * (before + now) * gone * V, fixed_point);
        if (water.flows) q[water.content_column()][p] -= water.density * gone * part;
    }
    return fastest;
}

void push_water(const WaterNodeCall& call, WaterSums& sums) {
    for (std::ptrdiff_t i = call.grains.begin; i < call.grains.end; ++i) {
        const NodeRecord& w = call.water_records[i];
        NodeRecord& grains = call.records[i];
        const bool flows = call.water->flows && has_water(call, i);
        const double n = flows ? call.porosity(i) : 0.0;
        if (flows) {
            NodeMotion now{};
            const double m = w[water_record::m];
            for (int k = 0; k < 2; ++k) {
                const Component c = component(call, i, k);
                if (!c.water_free) {
                    now[motion::v_r + k] = now[motion::other_r + k] = poured(call, i, k);
                    continue;
                }
                const double of_grains =
                    c.grains_free ? grains[record::p_r + k] / grains[record::m] : 0.0;
                const double old = of_grains + w[water_record::p_r + k] / m;
                now[motion::other_r + k] = old;
                now[motion::v_r + k] =
                    old + call.grains.dt * (n * w[water_record::f_r + k] / m +
                                            call.grains.gravity[static_cast<std::size_t>(k)]);
            }
            call.grains.add(sums.mapped_away, i, mapped_away(call, i, n, now));
            call.flowing[i] = now;
        }
        for (int k = 0; k < 2; ++k) grains[record::f_r + k] += (1.0 - n) * w[water_record::f_r + k];
    }
}

void drag_water(const WaterNodeCall& call) {
    for (std::ptrdiff_t i = call.grains.begin; i < call.grains.end; ++i) {
        if (!has_water(call, i)) continue;
        const NodeRecord& w = call.water_records[i];
        NodeMotion &grains = call.grains.motions[i], &water = call.flowing[i];
        const double C = call.grains.dt * w[water_record::drag];
        for (const Component& c : {component(call, i, 0), component(call, i, 1)}) {
            const double per_grains = c.grains_free ? 1.0 / call.grains.records[i][record::m] : 0.0;
            const double per_water = c.water_free ? 1.0 / w[water_record::m] : 0.0;
            const int now = motion::v_r + c.k;
            const double against =
                (water[now] - grains[now]) / (1.0 + C * (per_grains + per_water));
            const double impulse = C * against;
            grains[now] += impulse * per_grains;
            water[now] -= impulse * per_water;
            call.volume[i][drag_impulse + c.k] = impulse;
        }
    }
}

void close_water(const WaterNodeCall& call, WaterSums& sums) {
    for (std::ptrdiff_t i = call.grains.begin; i < call.grains.end; ++i) {
        const NodeMotion& grains = call.grains.motions[i];
        NodeMotion &water = call.flowing[i], &volume = call.volume[i];
        const double impulse[] = {volume[drag_impulse], volume[drag_impulse + 1]};
        volume = NodeMotion{};
        if (!has_water(call, i)) {
            water = grains;
            for (int k = 0; k < 2; ++k) volume[k] = grains[k];
            continue;
        }
        const double n = call.porosity(i), m = call.water_records[i][water_record::m];
        double change = 0.0, gravity = 0.0, drag = 0.0, sides = 0.0;
        for (int k = 0; k < 2; ++k) {
            const double now = water[motion::v_r + k], old = water[motion::other_r + k];
            volume[k] = (1.0 - n) * grains[motion::v_r + k] + n * now;
            volume[motion::other_r + k] = n * (now - grains[motion::v_r + k]);
            change += (now - old) * (now - old + 2.0 * grains[motion::other_r + k]);
            drag +=
                impulse[k] * (now + old - grains[motion::v_r + k] - grains[motion::other_r + k]);
            gravity += call.grains.gravity[static_cast<std::size_t>(k)] * (now + old);
            if (call.poured && !component(call, i, k).water_free)
                sides +=
                    now * (impulse[k] -
                           call.grains.dt * (n * call.water_records[i][water_record::f_r + k] +
                                             m * call.grains.gravity[static_cast<std::size_t>(k)]));
        }
        call.grains.add(sums.side_work, i, sides);
        call.grains.add(sums.change, i, 0.5 * m * change);
        call.grains.add(sums.drag, i, 0.5 * drag);
        call.grains.add(sums.gravity_work, i, 0.5 * call.grains.dt * m * gravity);
    }
}

}  // namespace grit::mpm
