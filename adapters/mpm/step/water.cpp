// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/water.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace grit::mpm {

void Water::add_body() {
    const std::size_t i = bodies.size();
    OfBody& body = bodies.emplace_back();
    if (!has(i)) return;
    if (!model.is_alone())
        throw std::invalid_argument("body " + model.parts[i].body.name +
                                    ": pore water is for one process");
    const auto strips = static_cast<std::size_t>(model.strips());
    body.cells.resize(static_cast<std::size_t>(model.r.cells()) *
                      static_cast<std::size_t>(model.z.cells()));
    body.records.resize(model.fixed_nodes.size());
    body.sums.resize(strips);
    body.speed2.resize(strips);
    if (is_implicit(i)) {
        body.implicit.emplace(model.grid());
        const std::size_t nodes = body.implicit->nodes();
        body.volume_velocity.resize(nodes);
        body.impulse.resize(nodes);
        body.answers.resize(nodes);
    }
    if (!flows(i)) return;
    body.flowing.resize(model.fixed_nodes.size());
    body.volume.resize(model.fixed_nodes.size());
}

void Water::drain(int direction, std::size_t node) {
    drained.resize(model.fixed_nodes.size());
    drained[node] |= direction == 0 ? fixed::r : fixed::z;
}

bool Water::is_anywhere() const {
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (has(i)) return true;
    return false;
}

WaterNodeCall Water::nodes(std::size_t i, int strip) {
    OfBody& body = bodies[i];
    Part& part = model.parts[i];
    return {momentum.call(i, strip),
            part.records.data(),
            &*part.body.water,
            body.records.data(),
            body.flowing.data(),
            body.volume.data(),
            drained.empty() ? nullptr : drained.data()};
}

void Water::scatter() {
    for (OfBody& body : bodies) std::fill(body.cells.begin(), body.cells.end(), CellIntegers{});
    model.for_strips_apart([this](std::size_t i, int strip) {
        if (!has(i)) return;
        Part& part = model.parts[i];
        add_pressures(model.grid(), part.body.particles.view(), part.strips.begin(strip),
                      part.strips.begin(strip + 1), *part.body.water, 1.0 / part.largest_volume,
                      bodies[i].cells.data());
    });
    model.for_strips([this](std::size_t i, int strip) {
        if (!has(i)) return;
        const Model::Rows rows = model.nodes_of(strip);
        const auto begin = bodies[i].records.begin();
        std::fill(begin + rows.begin, begin + rows.end, NodeRecord{});
    });
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (is_implicit(i)) bodies[i].implicit->clear();
    model.for_strips_apart([this](std::size_t i, int strip) {
        if (!has(i)) return;
        Part& part = model.parts[i];
        kernels().scatter_water(model.settings.shape, model.settings.axisymmetric,
                                {model.grid(), part.body.particles.view(), part.strips.begin(strip),
                                 part.strips.begin(strip + 1), &*part.body.water,
                                 bodies[i].cells.data(), bodies[i].records.data(),
                                 is_implicit(i) ? bodies[i].implicit->patches() : nullptr});
    });
}

void Water::push() {
    if (!is_anywhere()) return;
    scatter();
    model.for_strips([this](std::size_t i, int strip) {
        if (!has(i)) return;
        WaterSums& sums = bodies[i].sums[static_cast<std::size_t>(strip)];
        sums = {};
        push_water(nodes(i, strip), sums);
    });
}

void Water::drag() {
    if (!is_anywhere()) return;
    model.for_strips([this](std::size_t i, int strip) {
        if (flows(i)) drag_water(nodes(i, strip));
    });
}

void Water::gather(std::size_t i, int strip) {
    OfBody& body = bodies[i];
    Part& part = model.parts[i];
    const std::vector<NodeMotion>& volume = flows(i) ? body.volume : part.motions;
    kernels().gather_water(model.settings.shape, model.settings.axisymmetric,
                           {model.grid(), part.body.particles.view(), part.strips.begin(strip),
                            part.strips.begin(strip + 1), &*part.body.water, volume.data(),
                            part.motions.data(), body.flowing.data(), model.dt,
                            std::min(model.settings.pic_rate * model.dt, 1.0), body.cells.data(),
                            body.cell.data(), 1.0 / part.largest_volume},
                           body.sums[static_cast<std::size_t>(strip)]);
}

namespace {

double along(const Vector2& v, const Vector2& normal) {
    return v[0] * normal[0] + v[1] * normal[1];
}

// The components of a normal along which a node is free.
Vector2 free_part(const Vector2& normal, std::uint8_t bits) {
    return {bits & fixed::r ? 0.0 : normal[0], bits & fixed::z ? 0.0 : normal[1]};
}

}  // namespace

double Water::press(std::size_t i, std::size_t other, std::size_t node, const Vector2& normal) {
    Part &part = model.parts[i], &wall = model.parts[other];
    const NodeRecord& w = bodies[i].records[node];
    const double m_w = w[water_record::m], m_s = part.records[node][record::m];
    const double m_o = wall.records[node][record::m];
    if (!(m_w > 0.0 && m_s > part.least_mass && m_o > wall.least_mass)) return 0.0;
    const Vector2 n = free_part(normal, model.fixed_nodes[node]);
    const double size2 = along(n, n);
    if (size2 == 0.0) return 0.0;
    NodeMotion &grains = part.motions[node], &water = bodies[i].flowing[node];
    NodeMotion& others = wall.motions[node];
    const auto push = [&n](NodeMotion& v, double impulse, double m) {
        v[motion::v_r] += impulse * n[0] / m;
        v[motion::v_z] += impulse * n[1] / m;
    };
    const auto velocity = [&n](const NodeMotion& v) {
        return along({v[motion::v_r], v[motion::v_z]}, n);
    };
    const double porosity = m_w / (part.body.water->density * w[water_record::volume]);
    const double pressed =
        model.dt * along({w[water_record::f_r], w[water_record::f_z]}, n) / size2;
    // As drag, which has acted, shares it out.
    const double C = model.dt * w[water_record::drag];
    const double dragged = C * (porosity / m_w - (1.0 - porosity) / m_s) * pressed /
                           (1.0 + C * (1.0 / m_s + 1.0 / m_w));
    const double on_grains = -(1.0 - porosity) * pressed - dragged;
    double on_water = -porosity * pressed + dragged;
    push(grains, on_grains, m_s);
    push(water, on_water, m_w);
    if (!wall.body.rigid()) push(others, pressed, m_o);
    // Across, water and the other body then move alike.
    const double reduced = wall.body.rigid() ? m_w : m_w * m_o / (m_w + m_o);
    const double met = reduced * (velocity(water) - velocity(others)) / size2;
    push(water, -met, m_w);
    on_water -= met;
    if (!wall.body.rigid()) push(others, met, m_o);
    walls.push_back({i, other, node, n, on_grains, on_water});
    return -(on_grains + on_water);
}

// Work of impulses is that on the mean of the velocities before and after; what it lacks to nothing is the contact's.
void Water::account_for(const Wall& wall, Energy& energies) const {
    const auto mean = [&wall](const NodeMotion& v) {
        return 0.5 *
               along({v[motion::v_r] + v[motion::other_r], v[motion::v_z] + v[motion::other_z]},
                     wall.normal);
    };
    const Part& other = model.parts[wall.other];
    const double on_other = -(wall.on_grains + wall.on_water);
    const double on_other_work = on_other * mean(other.motions[wall.node]);
    energies.contact -=
        wall.on_grains * mean(model.parts[wall.body].motions[wall.node]) + on_other_work;
    if (flows(wall.body))
        energies.contact -= wall.on_water * mean(bodies[wall.body].flowing[wall.node]);
    if (other.body.rigid()) energies.rigid_work -= on_other_work;
}

void Water::account_for_walls(Energy& energies) {
    for (const Wall& wall : walls) account_for(wall, energies);
    walls.clear();
}

double Water::porosity(std::size_t i, std::size_t node) const {
    if (!flows(i)) return 0.0;
    const NodeRecord& w = bodies[i].records[node];
    return w[water_record::m] / (model.parts[i].body.water->density * w[water_record::volume]);
}

// The pressure pushes grains by 1 - n and water by n; drag is implicit.
Water::Answer Water::answer(std::size_t i, std::size_t node, bool grains_free,
                            bool water_free) const {
    const double m_s = model.parts[i].records[node][record::m];
    if (!flows(i)) return {grains_free ? 1.0 / m_s : 0.0, 0.0, 0.0};
    const NodeRecord& w = bodies[i].records[node];
    const double m_w = w[water_record::m], n = porosity(i, node);
    const double C = model.dt * w[water_record::drag];
    Answer out{};
    if (grains_free) {
        const double all = m_s * m_w + C * (m_s + m_w);
        out.grains = ((1.0 - n) * m_w + C) / all;
        out.water = (n * m_s + C) / all;
    } else if (water_free) {
        out.water = n / (m_w + C);
    }
    out.drag = C * (out.water - out.grains);
    return out;
}

void Water::change(std::size_t i, std::vector<Pressed>& pressed, Energy& energies) {
    OfBody& body = bodies[i];
    Part& part = model.parts[i];
    const bool two = flows(i);
    const auto has_pores = [&](std::size_t node) {
        return part.records[node][record::m] > part.least_mass &&
               (!two || body.records[node][water_record::m] > 0.0);
    };
    const auto free_of = [&](std::size_t node, int k) {
        const int bit = k == 0 ? fixed::r : fixed::z;
        const bool grains = !(model.fixed_nodes[node] & bit);
        return std::pair{grains, grains || (!drained.empty() && (drained[node] & bit))};
    };
    ImplicitPressure& implicit = *body.implicit;
    std::vector<std::array<Answer, 2>> answers(model.fixed_nodes.size());
    for (std::size_t node = 0; node < answers.size(); ++node) {
        const std::size_t in = implicit.node(node);
        body.answers[in] = {};
        body.volume_velocity[in] = {};
        if (!has_pores(node)) continue;
        const double n = porosity(i, node);
        double share[2];
        for (int k = 0; k < 2; ++k) {
            const auto [grains, water] = free_of(node, k);
            const auto at = static_cast<std::size_t>(k);
            const Answer& a = answers[node][at] = answer(i, node, grains, water);
            share[k] = (1.0 - n) * a.grains + n * a.water;
            body.volume_velocity[in][at] = (1.0 - n) * part.motions[node][motion::v_r + k] +
                                           (two ? n * body.flowing[node][motion::v_r + k] : 0.0);
        }
        body.answers[in] = {share[0], 0.0, share[1]};
    }
    // Where another body presses, all of them move alike across.
    struct Together {
        Pressed* at;
        Vector2 n;
        double per_mass;
    };
    std::vector<Together> together;
    std::vector<char> taken(pressed.empty() ? 0 : answers.size());
    for (Pressed& p : pressed) {
        const Part& other = model.parts[p.other];
        const double m_o = other.records[p.node][record::m];
        if (taken[p.node] || !has_pores(p.node) || !(m_o > other.least_mass)) continue;
        Vector2 n = free_part(p.normal, model.fixed_nodes[p.node]);
        const double size = std::sqrt(along(n, n));
        if (size == 0.0) continue;
        n = {n[0] / size, n[1] / size};
        taken[p.node] = 1;
        const double mass = part.records[p.node][record::m] +
                            (two ? body.records[p.node][water_record::m] : 0.0) + m_o;
        const double per_mass = other.body.rigid() ? 0.0 : 1.0 / mass;
        // Across, and along what is left of the directions that are free.
        NodeAnswer& a = body.answers[implicit.node(p.node)];
        const bool both = n[0] != 0.0 && n[1] != 0.0;
        const double beside_r = both ? a.rr : n[0] == 0.0 ? a.rr : 0.0;
        const double beside_z = both ? a.zz : n[1] == 0.0 ? a.zz : 0.0;
        a = {per_mass * n[0] * n[0] + beside_r * (1.0 - n[0] * n[0]),
             (per_mass - (both ? beside_r : 0.0)) * n[0] * n[1],
             per_mass * n[1] * n[1] + beside_z * (1.0 - n[1] * n[1])};
        together.push_back({&p, n, per_mass});
    }
    implicit.solve(*part.body.water, model.grid(), part.body.particles, model.dt,
                   body.volume_velocity, body.answers, body.impulse);

    Total work;
    const auto push = [&](std::size_t node, const Vector2& J) {
        for (std::size_t k = 0; k < 2; ++k) {
            const Answer& a = answers[node][k];
            const int lane = motion::v_r + static_cast<int>(k);
            part.motions[node][lane] += a.grains * J[k];
            if (!two) continue;
            body.flowing[node][lane] += a.water * J[k];
            body.volume[node][motion::other_r + static_cast<int>(k)] += a.drag * J[k];
        }
    };
    std::size_t next = 0;
    std::sort(together.begin(), together.end(),
              [](const Together& a, const Together& b) { return a.at->node < b.at->node; });
    std::vector<Wall> borne;
    for (std::size_t node = 0; node < answers.size(); ++node) {
        const Vector2 J = body.impulse[implicit.node(node)];
        if (!has_pores(node)) continue;
        if (next < together.size() && together[next].at->node == node) {
            const Together& t = together[next++];
            const double across = along(J, t.n), way = t.per_mass * across;
            push(node, {J[0] - across * t.n[0], J[1] - across * t.n[1]});
            const auto move = [&](NodeMotion& v) {
                v[motion::v_r] += way * t.n[0];
                v[motion::v_z] += way * t.n[1];
            };
            move(part.motions[node]);
            if (two) move(body.flowing[node]);
            Part& other = model.parts[t.at->other];
            if (!other.body.rigid()) move(other.motions[node]);
            const double n = porosity(i, node);
            const double m_s = part.records[node][record::m];
            const double m_w = two ? body.records[node][water_record::m] : 0.0;
            borne.push_back({i, t.at->other, node, t.n, m_s * way - (1.0 - n) * across,
                             m_w * way - n * across});
            t.at->impulse = across - (m_s + m_w) * way;
        } else {
            push(node, J);
        }
        // Its work, on the mean of the velocities before and after.
        const double n = porosity(i, node);
        for (std::size_t k = 0; k < 2; ++k) {
            const int lane = static_cast<int>(k);
            const NodeMotion& v = part.motions[node];
            double mean = 0.5 * (1.0 - n) * (v[motion::v_r + lane] + v[motion::other_r + lane]);
            if (two) {
                const NodeMotion& w = body.flowing[node];
                mean += 0.5 * n * (w[motion::v_r + lane] + w[motion::other_r + lane]);
            }
            work.add(J[k] * mean, false);
        }
    }
    for (const Wall& wall : borne) account_for(wall, energies);
    energies.implicit -= work.value();
}

void Water::update(Energy& energies) {
    if (!is_anywhere()) return;
    account_for_walls(energies);
    model.for_strips([this](std::size_t i, int strip) {
        if (flows(i)) close_water(nodes(i, strip), bodies[i].sums[static_cast<std::size_t>(strip)]);
    });
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        OfBody& body = bodies[i];
        std::fill(body.cells.begin(), body.cells.end(), CellIntegers{});
        if (has(i))
            body.cell.resize(static_cast<std::size_t>(model.parts[i].body.particles.size()));
    }
    model.for_strips_apart([this](std::size_t i, int strip) {
        if (has(i)) gather(i, strip);
    });
    model.for_strips([this](std::size_t i, int strip) {
        if (!has(i)) return;
        Part& part = model.parts[i];
        update_pressures(part.body.particles.view(), part.strips.begin(strip),
                         part.strips.begin(strip + 1), *part.body.water, bodies[i].cells.data(),
                         bodies[i].cell.data(), bodies[i].sums[static_cast<std::size_t>(strip)]);
        measure(i, strip);
    });
}

void Water::measure() {
    model.for_strips([this](std::size_t i, int strip) {
        if (has(i)) measure(i, strip);
    });
}

void Water::measure(std::size_t i, int strip) {
    Part& part = model.parts[i];
    const ParticleView q = part.body.particles.view();
    const PoreWater& water = *part.body.water;
    double fastest = 0.0;
    for (std::ptrdiff_t p = part.strips.begin(strip); p < part.strips.begin(strip + 1); ++p)
        fastest = std::max(fastest, water.speed2(water.void_ratio(q, p),
                                                 q[column::mass][p] / (q[column::V0][p] * q.J(p))));
    bodies[i].speed2[static_cast<std::size_t>(strip)] = fastest;
}

double Water::speed2(std::size_t body) const {
    const std::vector<double>& strips = bodies[body].speed2;
    return strips.empty() ? 0.0 : *std::max_element(strips.begin(), strips.end());
}

double Water::force_z(std::size_t body, std::size_t node) const {
    if (!flows(body)) return 0.0;
    const NodeRecord& w = bodies[body].records[node];
    const double m = w[water_record::m];
    if (!(m > 0.0)) return 0.0;
    const double n = m / (model.parts[body].body.water->density * w[water_record::volume]);
    return n * w[water_record::f_z] + m * model.settings.gravity_z;
}

}  // namespace grit::mpm
