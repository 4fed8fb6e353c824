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
    const auto strips = static_cast<std::size_t>(model.strips());
    body.cells.resize(static_cast<std::size_t>(model.r.cells()) *
                      static_cast<std::size_t>(model.z.cells()));
    body.records.resize(model.fixed_nodes.size());
    if (model.settings.fixed_point) body.integers.resize(model.fixed_nodes.size(), model.strips());
    body.sums.resize(strips);
    body.speed2.resize(strips);
    if (is_implicit(i)) {
        body.implicit.emplace(model.grid(), model.exchange, model.settings.fixed_point,
                              model.strips());
        const std::size_t nodes = body.implicit->nodes();
        body.volume_velocity.resize(nodes);
        body.impulse.resize(nodes);
        body.all_answers.nodes.resize(nodes);
        body.answers.resize(model.fixed_nodes.size());
    }
    if (!flows(i)) return;
    body.flowing.resize(model.fixed_nodes.size());
    body.loaded.resize(model.fixed_nodes.size());
    body.volume.resize(model.fixed_nodes.size());
    body.met_masses.resize(model.fixed_nodes.size());
    body.met_motions.resize(model.fixed_nodes.size());
}

void Water::drain(int direction, std::size_t node) {
    drained.resize(model.fixed_nodes.size());
    drained[node] |= direction == 0 ? fixed::r : fixed::z;
}

void Water::pour(Inflow inflow) {
    poured.resize(model.fixed_nodes.size());
    inflows.push_back(std::move(inflow));
}

std::vector<double> Water::inflow_words() const {
    std::vector<double> out;
    for (const Inflow& inflow : inflows) {
        out.insert(out.end(), {static_cast<double>(inflow.direction), inflow.sign,
                               static_cast<double>(inflow.nodes.size())});
        out.insert(out.end(), inflow.nodes.begin(), inflow.nodes.end());
    }
    return out;
}

void Water::tie(TiedNodes nodes) {
    tied_bits.resize(model.fixed_nodes.size());
    for (const std::size_t node : nodes.nodes)
        tied_bits[node] |= nodes.direction == 0 ? fixed::r : fixed::z;
    platens.push_back(std::move(nodes));
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
            model.closed_nodes.data(),
            drained.empty() ? nullptr : drained.data(),
            poured.empty() ? nullptr : poured.data()};
}

// The means of cells, of all processes.
void Water::find_pressures() {
    if (!is_anywhere()) return;
    for (OfBody& body : bodies) std::fill(body.cells.begin(), body.cells.end(), WaterCell{});
    model.for_strips_apart([this](std::size_t i, int strip) {
        if (!has(i)) return;
        Part& part = model.parts[i];
        add_pressures(model.grid(), part.body.particles.view(), part.strips.begin(strip),
                      part.strips.begin(strip + 1), *part.body.water, 1.0 / part.largest_volume,
                      bodies[i].cells.data());
    });
    sum_cells();
}

void Water::sum_cells() {
    constexpr int integers = 3;
    static_assert(sizeof(WaterCell) == integers * sizeof(std::int64_t));
    for (OfBody& body : bodies)
        if (!body.cells.empty())
            model.exchange.sum_cells(&body.cells[0].volume,
                                     static_cast<std::ptrdiff_t>(body.cells.size()), integers);
}

bool Water::check_sums() {
    static constexpr const char* names[] = {
        "mass of pore water", "momentum of pore water", "momentum of pore water", "pore pressure",
        "pore pressure",      "volume with pore water", "drag of pore water"};
    bool again = false;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (!has(i)) continue;
        constexpr unsigned all = (1u << std::size(names)) - 1;
        const IntegerRecords::Check found = bodies[i].integers.check(all, model.exchange);
        if (found.failed >= 0) fail_share(model.parts[i].body, names[found.failed], model.t);
        again = again || found.again;
        if (!is_implicit(i)) continue;
        const IntegerRecords::Check patches =
            bodies[i].implicit->integers().check((1u << record::size) - 1, model.exchange);
        if (patches.failed >= 0) fail_share(model.parts[i].body, "volume of cells", model.t);
        again = again || patches.again;
    }
    return again;
}

void Water::begin_sums() {
    for (OfBody& body : bodies) {
        body.integers.begin();
        if (body.implicit) body.implicit->begin();
    }
    model.for_strips([this](std::size_t i, int strip) {
        if (!has(i)) return;
        const Model::Rows rows = model.nodes_of(strip);
        const auto begin = bodies[i].records.begin();
        std::fill(begin + rows.begin, begin + rows.end, NodeRecord{});
    });
}

WaterScatter Water::scattered(std::size_t i, int strip) {
    OfBody& body = bodies[i];
    const bool fixed_point = model.settings.fixed_point, implicit = is_implicit(i);
    return {&*model.parts[i].body.water,
            body.cells.data(),
            body.records.data(),
            fixed_point ? body.integers.part(strip) : nullptr,
            implicit ? body.implicit->patches() : nullptr,
            implicit && fixed_point ? body.implicit->integers().part(strip) : nullptr};
}

void Water::finish_sums() {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        OfBody& body = bodies[i];
        if (!has(i)) continue;
        if (model.settings.fixed_point) body.integers.add_to(body.records, model.exchange);
        else
            model.exchange.sum_nodes(body.records.data(),
                                     static_cast<std::ptrdiff_t>(body.records.size()));
        if (body.implicit) body.implicit->finish();
    }
}

void Water::push() {
    if (!is_anywhere()) return;
    impulses_took = {};
    for (OfBody& body : bodies) std::fill(body.loaded.begin(), body.loaded.end(), Vector2{});
    std::fill(poured.begin(), poured.end(), Vector2{});
    for (const Inflow& inflow : inflows) {
        const double speed = inflow.sign * inflow.speed(model.t + model.dt);
        for (const std::size_t node : inflow.nodes) poured[node][inflow.direction] += speed;
    }
    model.for_strips([this](std::size_t i, int strip) {
        if (!has(i)) return;
        WaterSums& sums = bodies[i].sums[static_cast<std::size_t>(strip)];
        sums = {};
        push_water(nodes(i, strip), sums);
    });
}

void Water::load(std::size_t i, std::size_t node, const Vector2& force) {
    const double n = has_pores(i, node) ? porosity(i, node) : 0.0, m_w = water_mass(i, node);
    NodeRecord& grains = model.parts[i].records[node];
    for (int k = 0; k < 2; ++k) {
        grains[record::f_r + k] += (1.0 - n) * force[k];
        if (n > 0.0) bodies[i].loaded[node][k] += n * force[k];
        const int bit = k == 0 ? fixed::r : fixed::z;
        if (n > 0.0 && !(fixed_bits(node) & bit))
            bodies[i].flowing[node][motion::v_r + k] += model.dt * n * force[k] / m_w;
    }
}

void Water::drag() {
    if (!is_anywhere()) return;
    model.for_strips([this](std::size_t i, int strip) {
        if (flows(i)) drag_water(nodes(i, strip));
    });
}

WaterGather Water::gathered(std::size_t i, int strip) {
    OfBody& body = bodies[i];
    Part& part = model.parts[i];
    return {&*part.body.water,
            flows(i) ? body.volume.data() : part.motions.data(),
            body.flowing.data(),
            body.cells.data(),
            body.places.data(),
            1.0 / part.largest_volume,
            &body.sums[static_cast<std::size_t>(strip)]};
}

namespace {

double along(const Vector2& v, const Vector2& normal) {
    return v[0] * normal[0] + v[1] * normal[1];
}

// The components of a normal along which a node is free.
Vector2 free_part(const Vector2& normal, std::uint8_t bits) {
    return {bits & fixed::r ? 0.0 : normal[0], bits & fixed::z ? 0.0 : normal[1]};
}

Vector2 now(const NodeMotion& v) { return {v[motion::v_r], v[motion::v_z]}; }
Vector2 before(const NodeMotion& v) { return {v[motion::other_r], v[motion::other_z]}; }

}  // namespace

double Water::impulse(std::size_t i, std::size_t node, const Vector2& normal) const {
    if (!has(i)) return 0.0;
    const NodeRecord& w = bodies[i].records[node];
    return model.dt * along({w[water_record::f_r], w[water_record::f_z]}, normal);
}

void Water::join(std::size_t i, std::size_t node, const Vector2& n) {
    const double m_s = model.parts[i].records[node][record::m], m_w = water_mass(i, node);
    const NodeMotion &grains = model.parts[i].motions[node], &water = bodies[i].flowing[node];
    const double share = m_w > 0.0 ? m_w / (m_s + m_w) : 0.0;
    const double faster = share * along(now(water) - now(grains), n);
    const double faster_before = share * along(before(water) - before(grains), n);
    bodies[i].met_masses[node] = m_s + m_w;
    NodeMotion& met = bodies[i].met_motions[node] = grains;
    met[motion::v_r] += faster * n[0];
    met[motion::v_z] += faster * n[1];
    met[motion::other_r] += faster_before * n[0];
    met[motion::other_z] += faster_before * n[1];
}

void Water::part(std::size_t i, std::size_t node, const Vector2& n) {
    const double m_s = model.parts[i].records[node][record::m], m_w = water_mass(i, node);
    NodeMotion &grains = model.parts[i].motions[node], &water = bodies[i].flowing[node];
    const Vector2 met = now(bodies[i].met_motions[node]);
    const double against = along(now(water) - now(grains), n);
    const Vector2 change = met - now(grains), rubbed = change - along(change, n) * n;
    const double follows = along(met - now(water), n);
    grains[motion::v_r] = met[0];
    grains[motion::v_z] = met[1];
    if (!(m_w > 0.0)) return;
    water[motion::v_r] += rubbed[0] + follows * n[0];
    water[motion::v_z] += rubbed[1] + follows * n[1];
    const double dragged = m_s * m_w / (m_s + m_w) * against;  // on the grains, along n
    NodeMotion& volume = bodies[i].volume[node];
    volume[motion::other_r] += dragged * n[0];
    volume[motion::other_z] += dragged * n[1];
    // The contact has counted friction as if water had the grains' velocity.
    const Vector2 slid = now(water) + before(water) - now(grains) - before(grains);
    if (counts(node))
        impulses_took.contact.add(-0.5 * m_w * along(rubbed, slid), model.settings.fixed_point);
}

Water::Pores Water::pores(std::size_t i, std::size_t node) const {
    if (!has_pores(i, node)) return {};
    const NodeMotion &grains = model.parts[i].motions[node], &water = bodies[i].flowing[node];
    return {water_mass(i, node),      model.dt * bodies[i].records[node][water_record::drag],
            porosity(i, node),        fixed_bits(node),
            now(water) - now(grains), before(water) - before(grains)};
}

void Water::follow(std::size_t i, std::size_t node, const Vector2& grains, const Vector2& seepage) {
    if (!has_pores(i, node)) return;
    const NodeMotion& grains_before = model.parts[i].motions[node];
    NodeMotion &water = bodies[i].flowing[node], &volume = bodies[i].volume[node];
    const double drag = model.dt * bodies[i].records[node][water_record::drag];
    for (int k = 0; k < 2; ++k) {
        const int now = motion::v_r + k;
        const double against = water[now] - grains_before[now];
        if (seepage[k] == against && grains[k] == grains_before[now]) continue;
        volume[motion::other_r + k] += drag * (seepage[k] - against);
        water[now] = grains[k] + seepage[k];
    }
}

double Water::pressure_at(std::size_t i, std::ptrdiff_t p) const {
    const ParticleView q = model.parts[i].body.particles.view();
    const PoreWater& water = *model.parts[i].body.water;
    const WaterCell& cell = bodies[i].cells[static_cast<std::size_t>(
        model.grid().cell_of(q[column::r][p], q[column::z][p]))];
    return cell.volume > 0 ? cell.mean() * water.bulk_modulus : water.pressure(q, p);
}

// Work of impulses is that on the mean of the velocities before and after; what it lacks to nothing is the contact's.
void Water::account_for(const Wall& wall) {
    if (!counts(wall.node)) return;
    const bool fixed_point = model.settings.fixed_point;
    const auto mean = [&wall](const NodeMotion& v) {
        return 0.5 * along(now(v) + before(v), wall.normal);
    };
    const Part& other = model.parts[wall.other];
    const double on_other = -(wall.on_grains + wall.on_water);
    double on_other_work = on_other * mean(other.motions[wall.node]);
    if (flows(wall.other)) {
        const double m = other.records[wall.node][record::m],
                     m_w = water_mass(wall.other, wall.node);
        const double of_water = on_other * m_w / (m + m_w);
        on_other_work += of_water * (mean(bodies[wall.other].flowing[wall.node]) -
                                     mean(other.motions[wall.node]));
    }
    double work = wall.on_grains * mean(model.parts[wall.body].motions[wall.node]) + on_other_work;
    if (flows(wall.body)) work += wall.on_water * mean(bodies[wall.body].flowing[wall.node]);
    impulses_took.contact.add(-work, fixed_point);
    if (other.body.rigid()) impulses_took.rigid_work.add(-on_other_work, fixed_point);
}

bool Water::counts(std::size_t node) const {
    const std::uint8_t* mine = model.exchange.counted();
    return !mine || mine[node];
}

double Water::porosity(std::size_t i, std::size_t node) const {
    return flows(i) ? model.parts[i].body.water->porosity_at(bodies[i].records[node]) : 0.0;
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

// Of what holds the water where grains are held.
std::uint8_t Water::fixed_bits(std::size_t node) const {
    const std::uint8_t free = drained.empty() ? std::uint8_t{0} : drained[node];
    return static_cast<std::uint8_t>(model.closed_nodes[node] & ~free);
}

bool Water::has_pores(std::size_t i, std::size_t node) const {
    const Part& part = model.parts[i];
    return part.records[node][record::m] > part.least_mass &&
           (!flows(i) || model.parts[i].body.water->is_at(bodies[i].records[node]));
}

double Water::water_mass(std::size_t i, std::size_t node) const {
    return flows(i) ? bodies[i].records[node][water_record::m] : 0.0;
}

// (1 - n) of the grains' and n of the water's, of the sum of two lanes of each.
double Water::volume_velocity(std::size_t i, std::size_t node, int lane, int other_lane) const {
    const auto sum = [&](const NodeMotion& v) { return v[lane] + v[other_lane]; };
    const double grains = sum(model.parts[i].motions[node]);
    if (!flows(i) || !has_pores(i, node)) return grains;
    const double n = porosity(i, node);
    return (1.0 - n) * grains + n * sum(bodies[i].flowing[node]);
}

double Water::loaded_velocity(std::size_t i, std::size_t node, int k) const {
    const int now = motion::v_r + k, before = motion::other_r + k;
    if (flows(i) && (fixed_bits(node) & (k == 0 ? fixed::r : fixed::z))) {
        const NodeMotion& v = model.parts[i].motions[node];
        return (1.0 - (has_pores(i, node) ? porosity(i, node) : 0.0)) * (v[now] + v[before]);
    }
    return volume_velocity(i, node, now, before);
}

void Water::find_answers(std::size_t i) {
    OfBody& body = bodies[i];
    body.all_answers.compact.assign(body.answers.size(), {});
    for (std::size_t node = 0; node < body.answers.size(); ++node) {
        const std::size_t in = body.implicit->node(node);
        body.all_answers.nodes[in] = {};
        body.volume_velocity[in] = {};
        if (!has_pores(i, node)) continue;
        const double n = porosity(i, node);
        double share[2];
        for (int k = 0; k < 2; ++k) {
            const int bit = k == 0 ? fixed::r : fixed::z;
            const bool grains_free = !(model.fixed_nodes[node] & bit);
            const bool water_free = !(fixed_bits(node) & bit);
            const Answer& a = body.answers[node][static_cast<std::size_t>(k)] =
                answer(i, node, grains_free, water_free);
            share[k] = (1.0 - n) * a.grains + n * a.water;
            body.volume_velocity[in][k] =
                0.5 * volume_velocity(i, node, motion::v_r + k, motion::v_r + k);
        }
        body.all_answers.nodes[in] = {share[0], 0.0, share[1]};
        body.all_answers.compact[node] = compact_answers(i, node, {share[0], share[1]});
    }
}

// Within the grid.
CompactAnswer Water::compact_answers(std::size_t i, std::size_t node, const Vector2& answer) const {
    const auto row = static_cast<std::size_t>(model.r.nodes());
    const auto i_r = static_cast<int>(node % row), i_z = static_cast<int>(node / row);
    if (i_r == 0 || i_z == 0 || i_r == model.r.cells() || i_z == model.z.cells()) return {};
    const double h_r = 0.5 * (model.r[i_r + 1] - model.r[i_r - 1]);
    const double h_z = 0.5 * (model.z[i_z + 1] - model.z[i_z - 1]);
    const NodeRecord& w = bodies[i].records[node];
    const double V = w[water_record::volume], dt = model.dt;
    CompactAnswer out{compact_answer(V, h_r, h_z, answer, dt), 0.0};
    if (!flows(i)) return out;
    const double n = porosity(i, node);
    const double through = n * n / (w[water_record::m] + dt * w[water_record::drag]);
    out.to_pressure = compact_answer(V, h_r, h_z, {through, through}, dt);
    return out;
}

// Where another body presses, what the contact takes of an approach moves all that meets there alike, and what it leaves grains and water,
// alike as well; beside, what is free answers as it did.
std::vector<Water::Together> Water::hold_together(std::size_t i, std::vector<Pressed>& pressed) {
    OfBody& body = bodies[i];
    std::vector<Together> out;
    for (Pressed& p : pressed) {
        const Part& other = model.parts[p.other];
        const double m_o = other.records[p.node][record::m];
        if (!has_pores(i, p.node) || !(m_o > other.least_mass)) continue;
        const std::uint8_t tied = tied_bits.empty() ? std::uint8_t{0} : tied_bits[p.node];
        Vector2 n = free_part(p.normal, model.fixed_nodes[p.node] | tied);
        const double size = std::sqrt(along(n, n));
        if (size == 0.0) continue;
        n = {n[0] / size, n[1] / size};
        const double mass = model.parts[i].records[p.node][record::m] + water_mass(i, p.node);
        // The contact knows what is fixed, not what a platen ties: of the direction that is left it takes what its normal has of it.
        const double share = tied ? p.share * size * size : p.share;
        const double alike =
            other.body.rigid() ? 0.0 : share / (mass + m_o + water_mass(p.other, p.node));
        out.push_back({&p, n, alike + (1.0 - share) / mass, alike});
    }
    const auto node_of = [](const Together& t) { return t.at->node; };
    // Of several bodies the one whose contact takes most, of these the first one.
    std::stable_sort(out.begin(), out.end(), [&](const Together& a, const Together& b) {
        return node_of(a) != node_of(b) ? node_of(a) < node_of(b) : a.at->share > b.at->share;
    });
    out.erase(
        std::unique(out.begin(), out.end(),
                    [&](const Together& a, const Together& b) { return node_of(a) == node_of(b); }),
        out.end());
    for (const Together& t : out) {
        NodeAnswer& a = body.all_answers.nodes[body.implicit->node(node_of(t))];
        const double r = t.normal[0], z = t.normal[1];
        const double beside = r != 0.0 && z != 0.0 ? a.rr : 0.0;  // both are free, and alike
        a = {t.per_mass * r * r + (r == 0.0 ? a.rr : beside * z * z), (t.per_mass - beside) * r * z,
             t.per_mass * z * z + (z == 0.0 ? a.zz : beside * r * r)};
    }
    return out;
}

// An impulse of the pressure on a node [N s].
void Water::push_by(std::size_t i, std::size_t node, const Vector2& J) {
    OfBody& body = bodies[i];
    for (int k = 0; k < 2; ++k) {
        const Answer& a = body.answers[node][static_cast<std::size_t>(k)];
        model.parts[i].motions[node][motion::v_r + k] += a.grains * J[k];
        if (!flows(i)) continue;
        body.flowing[node][motion::v_r + k] += a.water * J[k];
        body.volume[node][motion::other_r + k] += a.drag * J[k];
    }
}

// ... across which grains and water move alike, and the other one as far as the contact lets it: what is left along it moves grains and
// water, what they do not take bears on the other.
Water::Wall Water::push_together(std::size_t i, const Together& together, const Vector2& J) {
    const Vector2& n = together.normal;
    const std::size_t node = together.at->node, other = together.at->other;
    const double across = along(J, n), way = together.per_mass * across;
    push_by(i, node, {J[0] - across * n[0], J[1] - across * n[1]});
    const double other_way = together.other_per_mass * across;
    const auto move = [&n](NodeMotion& v, double by) {
        v[motion::v_r] += by * n[0];
        v[motion::v_z] += by * n[1];
    };
    move(model.parts[i].motions[node], way);
    if (flows(i)) move(bodies[i].flowing[node], way);
    if (!model.parts[other].body.rigid()) move(model.parts[other].motions[node], other_way);
    if (flows(other)) move(bodies[other].flowing[node], other_way);
    const double porosity_there = porosity(i, node);
    const Wall wall{i,
                    other,
                    node,
                    n,
                    model.parts[i].records[node][record::m] * way - (1.0 - porosity_there) * across,
                    water_mass(i, node) * way - porosity_there * across};
    together.at->impulse = -(wall.on_grains + wall.on_water);
    return wall;
}

// Nodes of platens: across, the mass of all that moves with them answers.
void Water::hold_platens(std::size_t i) {
    OfBody& body = bodies[i];
    body.all_answers.ties.clear();
    for (const TiedNodes& platen : platens) {
        double mass = 0.0;
        each_mass(platen, [&](double m, const NodeMotion&) { mass += m; });
        Answers::Tie& tie = body.all_answers.ties.emplace_back();
        tie.nodes.direction = platen.direction;
        const int bit = platen.direction == 0 ? fixed::r : fixed::z;
        for (const std::size_t node : platen.nodes) {
            if (!has_pores(i, node) || (model.fixed_nodes[node] & bit)) continue;
            tie.nodes.nodes.push_back(body.implicit->node(node));
            body.answers[node][static_cast<std::size_t>(platen.direction)] = {};
            tie.per_mass = 1.0 / mass;
        }
    }
}

void Water::push_platens(std::size_t i) {
    const OfBody& body = bodies[i];
    for (std::size_t k = 0; k < platens.size(); ++k) {
        const Answers::Tie& tie = body.all_answers.ties[k];
        const int now = motion::v_r + tie.nodes.direction;
        double impulse = 0.0;
        for (const std::size_t node : tie.nodes.nodes)
            impulse += body.impulse[node][tie.nodes.direction];
        const double way = tie.per_mass * impulse;
        double work = 0.0;  // of the platen, on the mean of the velocities before and after
        each_mass(platens[k], [&](double m, NodeMotion& v) {
            v[now] += way;
            work += 0.5 * m * way * (v[now] + v[now + motion::other_r - motion::v_r]);
        });
        for (const std::size_t node : platens[k].nodes)
            if (has_pores(i, node))
                work -= 0.5 * body.impulse[body.implicit->node(node)][tie.nodes.direction] *
                        volume_velocity(i, node, now, now + motion::other_r - motion::v_r);
        impulses_took.contact.add(-work, model.settings.fixed_point);
    }
}

// An error says whose water it is of, and when.
template <class Do> void Water::naming(std::size_t i, const Do& act) const {
    try {
        act();
    } catch (const std::runtime_error& error) {
        throw std::runtime_error("pore water of " + model.parts[i].body.name +
                                 " at t = " + std::to_string(model.t) + " s: " + error.what());
    }
}

Mobility Water::mobility(std::size_t i, std::size_t node, int k) const {
    const int bit = k == 0 ? fixed::r : fixed::z;
    const bool grains_free = !(model.fixed_nodes[node] & bit);
    const double m = model.parts[i].records[node][record::m];
    if (!flows(i) || !has_pores(i, node)) return {grains_free ? 1.0 / m : 0.0, 0.0, 0.0};
    const NodeRecord& w = bodies[i].records[node];
    const double m_w = w[water_record::m], C = model.dt * w[water_record::drag];
    if (grains_free) {
        const double all = m * m_w + C * (m + m_w);
        return {(m_w + C) / all, -m_w / all, (m + m_w) / all};
    }
    return {0.0, 0.0, fixed_bits(node) & bit ? 0.0 : 1.0 / (m_w + C)};
}

void Water::move(std::size_t i, std::size_t node, int k, double grains, double against) {
    model.parts[i].motions[node][motion::v_r + k] += grains;
    if (!flows(i) || !has_pores(i, node)) return;
    bodies[i].flowing[node][motion::v_r + k] += grains + against;
    bodies[i].volume[node][motion::other_r + k] +=
        model.dt * bodies[i].records[node][water_record::drag] * against;
}

std::array<double, 4> Water::values(const SurfaceRows& of, const SurfaceRow& row,
                                    bool is_now) const {
    std::array<double, 4> out{row.rigid[0], row.rigid[1], 0.0, 0.0};
    const auto at = [is_now](const NodeMotion& v) { return is_now ? now(v) : before(v); };
    for (std::size_t t = row.begin; t < row.end; ++t) {
        const SurfaceTerm& term = of.terms[t];
        const Vector2 v = at(model.parts[term.body].motions[term.node]);
        for (std::size_t k = 0; k < 2; ++k) out[k] += along(term.direction[k], v);
        if (flows(term.body) && has_pores(term.body, term.node))
            out[2 + static_cast<std::size_t>(term.side)] +=
                porosity(term.body, term.node) *
                along(term.direction[0], at(bodies[term.body].flowing[term.node]) - v);
    }
    return out;
}

// Rows let go of what they hold: they will hold it by other impulses.
void Water::give_back(const std::vector<SurfaceRows*>& surfaces) {
    for (const SurfaceRows* of : surfaces)
        for (const SurfaceRow& row : of->rows)
            for (std::size_t t = row.begin; t < row.end; ++t) {
                const SurfaceTerm& term = of->terms[t];
                const double n =
                    has_pores(term.body, term.node) ? porosity(term.body, term.node) : 0.0;
                const double of_water = n * row.water_impulse[term.side];
                for (int k = 0; k < 2; ++k) {
                    const Mobility m = mobility(term.body, term.node, k);
                    const double d = term.direction[0][k];
                    move(term.body, term.node, k,
                         d * (row.impulse[0] * m.grains + of_water * m.against_by_grains),
                         d * (row.impulse[0] * m.against_by_grains + of_water * m.against));
                }
            }
}

void Water::hold_surfaces(std::size_t i, const std::vector<SurfaceRows*>& surfaces) {
    OfBody& body = bodies[i];
    HeldRows& held = body.held;
    held.holds.clear();
    held.entries.clear();
    held.pushes.clear();
    const auto add = [&](SurfaceRows& of, SurfaceRow& row, int water) {
        HeldRows::Hold hold{&row,
                            water,
                            held.entries.size(),
                            0,
                            held.pushes.size(),
                            0,
                            0.0,
                            water >= 0 || row.impulse[0] > 0.0,
                            0.0};
        const std::array<double, 4> value = values(of, row, true);
        hold.free = water < 0 ? value[0] - row.bound : value[2 + static_cast<std::size_t>(water)];
        for (std::size_t t = row.begin; t < row.end; ++t) {
            const SurfaceTerm& term = of.terms[t];
            if (water >= 0 && term.side != water) continue;
            const bool pores = has_pores(term.body, term.node);
            const double n = pores ? porosity(term.body, term.node) : 0.0;
            HeldRows::Entry entry{term.body, term.node, {}, {}, {}, {}};
            HeldRows::Push push{0, {}};
            for (int k = 0; k < 2; ++k) {
                const Mobility m = mobility(term.body, term.node, k);
                const double d = (water < 0 ? 1.0 : n) * term.direction[0][k];
                (water < 0 ? entry.of_grains : entry.of_water)[k] = d;
                entry.takes_grains[k] = d * (water < 0 ? m.grains : m.against_by_grains);
                entry.takes_water[k] = d * (water < 0 ? m.against_by_grains : m.against);
                push.answer[k] = entry.takes_grains[k] + n * entry.takes_water[k];
            }
            held.entries.push_back(entry);
            if (term.body != i || !pores) continue;
            push.at = body.implicit->node(term.node);
            held.pushes.push_back(push);
        }
        hold.end = held.entries.size();
        hold.last = held.pushes.size();
        held.holds.push_back(hold);
    };
    for (SurfaceRows* of : surfaces)
        for (SurfaceRow& row : of->rows) {
            add(*of, row, -1);
            if (flows(of->a)) add(*of, row, 0);
            if (flows(of->b)) add(*of, row, 1);
        }
    body.all_answers.held = held.empty() ? nullptr : &held;
    if (!held.empty()) held.couple();
}

void Water::push_surfaces(const HeldRows& held) {
    for (const HeldRows::Hold& hold : held.holds) {
        if (hold.water < 0) hold.row->impulse[0] = hold.impulse;
        else hold.row->water_impulse[hold.water] = hold.impulse;
        for (std::size_t e = hold.begin; e < hold.end; ++e) {
            const HeldRows::Entry& at = held.entries[e];
            for (int k = 0; k < 2; ++k)
                move(at.body, at.node, k, -hold.impulse * at.takes_grains[k],
                     -hold.impulse * at.takes_water[k]);
        }
    }
}

void Water::change(std::size_t i, std::vector<Pressed>& pressed,
                   const std::vector<SurfaceRows*>& surfaces) {
    constexpr int most_changes = 10;  // of what bears along surfaces
    OfBody& body = bodies[i];
    give_back(surfaces);
    find_answers(i);
    const std::vector<Together> together = hold_together(i, pressed);
    hold_platens(i);
    hold_surfaces(i, surfaces);
    Part& part = model.parts[i];
    bool again = false, settled = false;
    for (int change = 0; change < most_changes && !settled; ++change) {
        if (!body.held.empty()) body.held.factor();
        std::vector<Vector2>& u = body.held.empty() ? body.volume_velocity : body.held_velocity;
        if (!body.held.empty()) {
            u = body.volume_velocity;
            body.held.hold_free(u);
        }
        naming(i, [&] {
            body.implicit->solve(*part.body.water, model.grid(), part.body.particles, model.dt, u,
                                 body.all_answers, again, body.impulse);
        });
        again = true;
        settled = body.held.empty() || !body.held.find_impulses(body.impulse);
    }
    if (!settled) ++body.unsettled;
    body.implicit->remember(model.dt);
    push_surfaces(body.held);
    push_platens(i);
    auto next = together.begin();
    std::vector<Wall> borne;
    for (std::size_t node = 0; node < body.answers.size(); ++node) {
        if (!has_pores(i, node)) continue;
        const Vector2& J = body.impulse[body.implicit->node(node)];
        if (next != together.end() && next->at->node == node)
            borne.push_back(push_together(i, *next++, J));
        else push_by(i, node, J);
        // On the mean of the velocities before and after.
        for (int k = 0; k < 2 && counts(node); ++k) {
            const int bit = k == 0 ? fixed::r : fixed::z;
            if (flows(i) && (fixed_bits(node) & bit))
                impulses_took.side_work.add(-porosity(i, node) * J[k] *
                                                bodies[i].flowing[node][motion::v_r + k],
                                            model.settings.fixed_point);
            impulses_took.implicit.add(
                -0.5 * J[k] * volume_velocity(i, node, motion::v_r + k, motion::other_r + k),
                model.settings.fixed_point);
        }
    }
    for (const Wall& wall : borne) account_for(wall);
}

void Water::close() {
    if (!is_anywhere()) return;
    model.for_strips([this](std::size_t i, int strip) {
        if (flows(i)) close_water(nodes(i, strip), bodies[i].sums[static_cast<std::size_t>(strip)]);
    });
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        OfBody& body = bodies[i];
        std::fill(body.cells.begin(), body.cells.end(), WaterCell{});
        if (has(i))
            body.places.resize(static_cast<std::size_t>(model.parts[i].body.particles.size()));
    }
}

void Water::update() {
    if (!is_anywhere()) return;
    sum_cells();
    const double pic = std::min(model.settings.pic_rate * model.dt, 1.0);
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (is_implicit(i)) bodies[i].implicit->find_after(pic);
    model.for_strips([this](std::size_t i, int strip) {
        if (!has(i)) return;
        Part& part = model.parts[i];
        OfBody& body = bodies[i];
        const auto s = static_cast<std::size_t>(strip);
        naming(i, [&] {
            body.speed2[s] = update_pressures(
                part.body.particles.view(), part.strips.begin(strip), part.strips.begin(strip + 1),
                *part.body.water, body.cells.data(), body.places.data(), 1.0 / part.largest_volume,
                is_implicit(i) ? body.implicit->after() : nullptr, model.settings.fixed_point,
                body.sums[s]);
        });
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
    const double n = model.parts[body].body.water->porosity_at(w);
    return n * w[water_record::f_z] + m * model.settings.gravity_z + bodies[body].loaded[node][1];
}

}  // namespace grit::mpm
