// SPDX-License-Identifier: BSD-3-Clause
// The impulses of all points of two bodies that carry pressure, (V3)-(V5), (V8): rows of a system that projected Gauss-Seidel
// sweeps solve, to and fro, on copies of the velocities of the nodes. Beside the impulses on a body are those of its water on
// the surface (V7): none of it passes.
#pragma once

#include <cmath>

#include "contact/surface/ascending.hpp"
#include "contact/surface/meeting.hpp"
#include "contact/surface/pressures.hpp"

namespace grit::surface {

// What a point of integration gives to a point that carries pressure.
struct Share {
    std::ptrdiff_t pressure, point;
    double share;
};

// Between the surfaces, over a step.
struct Layer {
    double dt;
    double stiffness = 0.0, relaxation_time = 0.0;  // (V8); 0: rigid

    // How much of a point counts with this gap now and at the end of the step; closed: the widest one that does. With a stiffness
    // points come and go little by little, up to twice that, for what is open within a mean pulls.
    double weight(double gap, double at_end, double closed) const {
        if (stiffness > 0.0) return std::clamp(2.0 - std::min(gap, at_end) / closed, 0.0, 1.0);
        return at_end <= closed ? 1.0 : 0.0;
    }
    // The approach at which a mean gap bears nothing.
    double bound(double gap) const {
        if (stiffness > 0.0 && gap < 0.0) return gap / (dt + relaxation_time);
        return std::max(gap, 0.0) / dt;
    }
    // Approach beyond that, by impulse, of an area.
    double compliance(double area) const {
        if (!(stiffness > 0.0)) return 0.0;
        return std::min(1.0 / (stiffness * dt * (dt + relaxation_time) * area), 1e300);
    }
    // What it holds at an overlap.
    double energy(double area, double overlap) const {
        return overlap > 0.0 ? 0.5 * stiffness * area * overlap * overlap : 0.0;
    }
};

// A node of either body that feels contact.
template <int C> struct ContactNode {
    std::ptrdiff_t id;
    Vector<double, C> v, v_old;
    Vector<double, C> inverse_mass;  // 0: held
    double unheld;                   // ... as if nothing were
    // Of water that flows through the body: against it, as drag leaves it, and by what porosity it counts. What it
    // answers: to an impulse on the body, and to one on it with the opposite on the body [1/mass].
    Vector<double, C> seepage, seepage_old, by_body, by_itself;
    double porosity;  // 0: there is none
};

// Direction 0 is the normal, the others are tangents; all fields are means around the point.
template <int C> struct Row {
    std::ptrdiff_t pressure;    // which point
    std::ptrdiff_t begin, end;  // its terms
    double size;                // area that it answers for
    double gap;                 // its mean
    double bound;               // largest approach that closes the gap and no more
    double compliance;          // approach beyond that, by impulse
    double rigid[C];            // approach by rigid bodies
    double effective[C];        // 1 / mass
    double impulse[C];
    double before[C];  // approach without contact
    // Of the water of A and of B, by the flow into the other body that is left [length / time].
    double water_effective[2], water_impulse[2], water_before[2];
    double pore_impulse;  // of water, which does not rub
};
template <int C> struct Directions { Vector<double, C> d[C]; };
template <int C> struct Term {
    std::ptrdiff_t node;
    Vector<double, C> d[C];  // approach = sum d . v
};

// What a node of several pairs has in common.
template <int C> struct Motion { Vector<double, C> v, seepage; };

// Of impulses J that change approaches from w to w'.
struct Work {
    double work = 0.0, twice_kinetic = 0.0;  // J . w, J . (w - w')
    double given = 0.0;                      // by layers at these
};

template <int C> class System {
  public:
    System(Arena& memory, const Skin<C>& of_a, const Skin<C>& of_b, const Pressures<C>& carriers)
        : arena(memory), skin{&of_a, &of_b}, pressures(carriers) {}

    // False where the workspace is too small.
    bool build(const MeetingPoint<C>* of_points, std::ptrdiff_t n_points, const Share* given,
               std::ptrdiff_t n_shares, const Layer& between) {
        points = of_points;
        shares = given;
        layer = between;
        return sort_shares(n_shares) && find_nodes(n_points) && find_rows();
    }

    // Before sweeps, with the velocities as they are.
    struct Start {
        double largest_approach;  // beyond the bound
        double largest_change;    // of a velocity that is wanted, of water too
    };
    Start begin() {
        Start out{0.0, 0.0};
        for (std::ptrdiff_t r = 0; r < n_rows; ++r) {
            for (int k = 0; k < C; ++k) rows[r].before[k] = approach(rows[r], k, &Node::v);
            for (int body = 0; body < 2; ++body) {
                const double q = rows[r].water_before[body] =
                    seepage(rows[r], body, &Node::seepage);
                if (rows[r].water_effective[body] > 0.0)
                    out.largest_change =
                        std::max(out.largest_change, std::fabs(q) / rows[r].water_effective[body] *
                                                         rows[r].effective[0]);
            }
            out.largest_approach =
                std::max(out.largest_approach, rows[r].before[0] - rows[r].bound);
        }
        out.largest_change = std::max(out.largest_change, out.largest_approach);
        return out;
    }
    // Every row once, in order or back. Returns the largest change of a velocity.
    double sweep(double mu, bool forth) {
        double largest = 0.0;
        for (std::ptrdiff_t i = 0; i < n_rows; ++i)
            largest = std::max(largest, correct(rows[forth ? i : n_rows - 1 - i], mu));
        return largest;
    }
    // Of a velocity, that its roundoff lets sweeps tell from none.
    double smallest_change() const {
        double largest = 0.0;
        for (std::ptrdiff_t r = 0; r < n_rows; ++r)
            for (int k = 0; k < C; ++k) {
                double w = std::fabs(rows[r].rigid[k]);
                for (std::ptrdiff_t i = rows[r].begin; i < rows[r].end; ++i)
                    w += std::fabs(dot(terms[i].d[k], nodes[terms[i].node].v));
                largest = std::max(largest, w);
            }
        return 4.0 * std::numeric_limits<double>::epsilon() * largest;
    }
    void add_work(Work& all) const {
        const auto add = [&](double impulse, double before, double after) {
            all.work += impulse * before;
            all.twice_kinetic += impulse * (before - after);
        };
        for (std::ptrdiff_t r = 0; r < n_rows; ++r) {
            for (int k = 0; k < C; ++k)
                add(rows[r].impulse[k], rows[r].before[k], approach(rows[r], k, &Node::v));
            for (int body = 0; body < 2; ++body)
                add(rows[r].water_impulse[body], rows[r].water_before[body],
                    seepage(rows[r], body, &Node::seepage));
            const double overlap = layer.dt * approach(rows[r], 0, &Node::v) - rows[r].gap;
            if (rows[r].impulse[0] > 0.0)
                all.given +=
                    layer.energy(rows[r].size, -rows[r].gap) - layer.energy(rows[r].size, overlap);
        }
    }
    // All impulses, and what they do to velocities.
    void scale(double share) {
        for (std::ptrdiff_t r = 0; r < n_rows; ++r) {
            for (int k = 0; k < C; ++k) {
                push(rows[r], k, (share - 1.0) * rows[r].impulse[k]);
                rows[r].impulse[k] *= share;
            }
            for (int body = 0; body < 2; ++body) {
                push_water(rows[r], body, (share - 1.0) * rows[r].water_impulse[body]);
                rows[r].water_impulse[body] *= share;
            }
        }
    }

    // take(body, number, place) of the nodes of bodies that pairs have in common.
    template <class Take> void each_common_node(const Take& take) const {
        for (int body = 0; body < 2; ++body) {
            const grit_surface& s = *skin[body]->given;
            if (s.body == 0 || s.rigid) continue;
            for (std::ptrdiff_t i = first_node[body]; i < first_node[body + 1]; ++i)
                take(s.body, s.number ? s.number[nodes[i].id] : nodes[i].id, i);
        }
    }
    Motion<C> motion(std::ptrdiff_t node) const { return {nodes[node].v, nodes[node].seepage}; }
    void set_motion(std::ptrdiff_t node, const Motion<C>& to) {
        nodes[node].v = to.v;
        nodes[node].seepage = to.seepage;
    }

    template <class Take> void each_row(const Take& take) const {
        for (std::ptrdiff_t r = 0; r < n_rows; ++r) take(rows[r]);
    }
    // Work of a row's impulse, normal and tangential: on the mean of the approach before the step and after it.
    Vector2 dissipation(const Row<C>& row) const {
        double work[C];
        for (int k = 0; k < C; ++k)
            work[k] = 0.5 * row.impulse[k] *
                      (approach(row, k, &Node::v_old) + approach(row, k, &Node::v));
        Vector2 out{work[0], 0.0};
        for (int body = 0; body < 2; ++body)
            out[0] += 0.5 * row.water_impulse[body] *
                      (seepage(row, body, &Node::seepage_old) + seepage(row, body, &Node::seepage));
        for (int k = 1; k < C; ++k) out[1] += work[k];
        return out;
    }
    // Impulse per share of a point's area, on A.
    static Vector<double, C> traction(const Row<C>& row, const Directions<C>& direction, int first,
                                      int last) {
        Vector<double, C> out{};
        for (int k = first; k < last; ++k) out = out - (row.impulse[k] / row.size) * direction.d[k];
        return out;
    }
    // take(point, share, directions there) of what gives to a point that carries pressure.
    template <class Take> void each_share(std::ptrdiff_t pressure, const Take& take) const {
        Directions<C> direction;
        std::ptrdiff_t facet = -1;  // points of a facet follow each other
        for (std::ptrdiff_t i = start[pressure]; i < start[pressure + 1]; ++i) {
            const MeetingPoint<C>& p = points[shares[order[i]].point];
            if (p.facet_a != facet) direction = directions(pressure, facet = p.facet_a);
            take(p, shares[order[i]].share, direction);
        }
    }
    // Velocities back to the nodes.
    void write() const {
        for (int body = 0; body < 2; ++body)
            for (std::ptrdiff_t i = first_node[body]; i < first_node[body + 1]; ++i)
                for (int c = 0; c < C; ++c) {
                    if (nodes[i].inverse_mass[c] > 0.0)
                        component(skin[body]->given->velocity, nodes[i].id, c) = nodes[i].v[c];
                    if (nodes[i].by_itself[c] > 0.0)
                        component(skin[body]->given->seepage, nodes[i].id, c) = nodes[i].seepage[c];
                }
    }
    // The rows and their terms, for a host that goes on with them.
    void list(const grit_surface_row** out_rows, const grit_surface_term** out_terms,
              std::ptrdiff_t* count) const {
        *out_rows = given_rows;
        *out_terms = given_terms;
        *count = n_rows;
    }
    // Room for these, before anything is written; false: there is none.
    bool make_lists() {
        given_rows = arena.take<grit_surface_row>(n_rows);
        given_terms = arena.take<grit_surface_term>(n_terms);
        return !arena.is_overrun();
    }
    void fill_lists() const {
        for (std::ptrdiff_t r = 0; r < n_rows; ++r) {
            grit_surface_row& to = given_rows[r];
            to = {};
            to.first_term = rows[r].begin;
            to.terms = rows[r].end - rows[r].begin;
            to.bound = rows[r].bound;
            for (int k = 0; k < C; ++k) {
                to.rigid[k] = rows[r].rigid[k];
                to.impulse[k] = rows[r].impulse[k];
            }
            for (int body = 0; body < 2; ++body)
                to.water_impulse[body] = rows[r].water_impulse[body];
        }
        for (std::ptrdiff_t i = 0; i < n_terms; ++i) {
            grit_surface_term& to = given_terms[i];
            to = {};
            to.of_b = terms[i].node >= first_node[1];
            to.node = nodes[terms[i].node].id;
            for (int k = 0; k < C; ++k)
                for (int c = 0; c < C; ++c) to.direction[k][c] = terms[i].d[k][c];
        }
    }

  private:
    using Node = ContactNode<C>;

    bool sort_shares(std::ptrdiff_t n) {
        const std::ptrdiff_t count = pressures.size();
        start = arena.take<std::ptrdiff_t>(count + 1);
        order = arena.take<std::ptrdiff_t>(n);
        auto* next = arena.take<std::ptrdiff_t>(count);
        if (arena.is_overrun()) return false;
        std::fill_n(start, count + 1, 0);
        for (std::ptrdiff_t i = 0; i < n; ++i) ++start[shares[i].pressure + 1];
        for (std::ptrdiff_t k = 0; k < count; ++k) start[k + 1] += start[k];
        std::copy_n(start, count, next);
        for (std::ptrdiff_t i = 0; i < n; ++i) order[next[shares[i].pressure]++] = i;
        return true;
    }

    std::ptrdiff_t facet_of(const MeetingPoint<C>& p, int body) const {
        return body == 0 ? p.facet_a : p.facet_b;
    }

    // Nodes of the vertices of all facets that meet, ids ascending, A's and then B's.
    bool find_nodes(std::ptrdiff_t n_points) {
        for (int body = 0; body < 2; ++body) {
            const grit_surface& s = *skin[body]->given;
            place[body] = arena.take<std::ptrdiff_t>(s.vertices);
            sum[body] = arena.take<Directions<C>>(s.vertices);
            if (arena.is_overrun()) return false;
            std::fill_n(place[body], s.vertices, -1);
            std::ptrdiff_t used = 0;
            for (std::ptrdiff_t p = 0; p < n_points; ++p)
                for (int i = 0; i < C; ++i) {
                    std::ptrdiff_t& at =
                        place[body][skin[body]->vertex(facet_of(points[p], body), i)];
                    if (at < 0) at = used++;
                }
            local[body] = arena.take<std::ptrdiff_t>(s.rigid ? 0 : used * s.nodes_each);
            if (arena.is_overrun()) return false;
        }
        Growing<std::ptrdiff_t> ids(arena);
        std::ptrdiff_t end[2];
        for (int body = 0; body < 2; ++body) {
            const grit_surface& s = *skin[body]->given;
            for (std::ptrdiff_t v = 0; v < s.vertices && !s.rigid; ++v)
                for (std::ptrdiff_t k = v * s.nodes_each;
                     place[body][v] >= 0 && k < (v + 1) * s.nodes_each; ++k)
                    if (s.weight[k] != 0.0) ids.add(s.node[k]);
            end[body] = ids.size();
        }
        std::ptrdiff_t* id = ids.close();
        if (arena.is_overrun()) return false;
        std::ptrdiff_t* last[2];
        for (int body = 0; body < 2; ++body) {
            std::ptrdiff_t *const from = id + (body == 0 ? 0 : end[0]), *const to = id + end[body];
            sort_ascending(from, to);
            last[body] = std::unique(from, to);
            first_node[body + 1] = first_node[body] + (last[body] - from);
        }
        nodes = arena.take<Node>(first_node[2]);
        node_sum = arena.take<Directions<C>>(first_node[2]);
        is_touched = arena.take<bool>(first_node[2]);
        touched = arena.take<std::ptrdiff_t>(first_node[2]);
        if (arena.is_overrun()) return false;
        std::fill_n(is_touched, first_node[2], false);
        for (int body = 0; body < 2; ++body) {
            const std::ptrdiff_t* from = id + (body == 0 ? 0 : end[0]);
            read_nodes(body, from);
            const grit_surface& s = *skin[body]->given;
            for (std::ptrdiff_t v = 0; v < s.vertices && !s.rigid; ++v)
                for (int k = 0; place[body][v] >= 0 && k < s.nodes_each; ++k) {
                    const std::ptrdiff_t given = v * s.nodes_each + k;
                    local[body][place[body][v] * s.nodes_each + k] =
                        s.weight[given] == 0.0
                            ? -1
                            : first_node[body] +
                                  (std::lower_bound(from,
                                                    static_cast<const std::ptrdiff_t*>(last[body]),
                                                    s.node[given]) -
                                   from);
                }
        }
        return true;
    }
    void read_nodes(int body, const std::ptrdiff_t* id) {
        const grit_surface& s = *skin[body]->given;
        for (std::ptrdiff_t i = first_node[body]; i < first_node[body + 1]; ++i) {
            Node& node = nodes[i];
            node.id = id[i - first_node[body]];
            node.v = vector_of<C>(read_only(s.velocity), node.id);
            node.v_old =
                s.previous_velocity.base ? vector_of<C>(s.previous_velocity, node.id) : node.v;
            const int held = s.fixed ? s.fixed[node.id] : 0;
            node.unheld = 1.0 / component(s.mass, node.id, 0);
            for (int c = 0; c < C; ++c) node.inverse_mass[c] = held >> c & 1 ? 0.0 : node.unheld;
            read_water(s, node, held);
        }
    }
    // Drag is implicit: what moves one of the two drags the other within the step.
    static void read_water(const grit_surface& s, Node& node, int held) {
        node.porosity = 0.0;
        node.seepage = node.seepage_old = node.by_body = node.by_itself = {};
        // No less water than a node may have of the body.
        if (!s.pores.base || !(component(s.pores, node.id, 0) >= 1.0 / largest_number)) return;
        const double m = component(s.mass, node.id, 0), m_w = component(s.pores, node.id, 0);
        const double drag = component(s.pores, node.id, 1);
        const double all = m * m_w + drag * (m + m_w);
        const int water_held = s.water_fixed ? s.water_fixed[node.id] : held;
        node.porosity = component(s.pores, node.id, 2);
        node.seepage = vector_of<C>(read_only(s.seepage), node.id);
        node.seepage_old =
            s.previous_seepage.base ? vector_of<C>(s.previous_seepage, node.id) : node.seepage;
        for (int c = 0; c < C; ++c) {
            const bool body_moves = !(held >> c & 1), water_moves = !(water_held >> c & 1);
            if (body_moves && water_moves) {
                node.inverse_mass[c] = (m_w + drag) / all;
                node.by_body[c] = -m_w / all;
                node.by_itself[c] = (m + m_w) / all;
            } else if (body_moves) {
                node.inverse_mass[c] = node.by_itself[c] = 1.0 / (m + drag);
                node.by_body[c] = -node.by_itself[c];
            } else if (water_moves) {
                node.by_itself[c] = 1.0 / (m_w + drag);
            }
        }
    }

    // Normal and tangents of a facet of A around a point that carries pressure.
    Directions<C> directions(std::ptrdiff_t pressure, std::ptrdiff_t facet) const {
        const Vector<double, C>& n = skin[0]->facet[facet].n;
        Directions<C> out;
        out.d[0] = n;
        if constexpr (C == 2) {
            out.d[1] = {-n[1], n[0]};
        } else {
            // Tangents of the point, turned the shortest way from its normal to the facet's.
            const Vector3& around = pressures[pressure].n;
            const Vector3& m = norm(around) > 0.0 ? around : n;
            int least = 0;
            for (int c = 1; c < 3; ++c)
                if (std::fabs(m[c]) < std::fabs(m[least])) least = c;
            Vector3 axis{};
            axis[least] = 1.0;
            Vector3 t = cross(m, axis);
            t = t / norm(t);
            const double cosine = dot(m, n);
            if (cosine > -1.0 + 1e-9) t = t - (dot(t, n) / (1.0 + cosine)) * (m + n);
            t = t - dot(t, n) * n;
            out.d[1] = t / norm(t);
            out.d[2] = cross(n, out.d[1]);
        }
        return out;
    }

    bool find_rows() {
        rows = arena.take<Row<C>>(pressures.size());
        std::ptrdiff_t* vertex[2] = {arena.take<std::ptrdiff_t>(skin[0]->given->vertices),
                                     arena.take<std::ptrdiff_t>(skin[1]->given->vertices)};
        std::ptrdiff_t* last_row[2] = {arena.take<std::ptrdiff_t>(skin[0]->given->vertices),
                                       arena.take<std::ptrdiff_t>(skin[1]->given->vertices)};
        if (arena.is_overrun()) return false;
        for (int body = 0; body < 2; ++body) {
            std::fill_n(sum[body], skin[body]->given->vertices, Directions<C>{});
            std::fill_n(last_row[body], skin[body]->given->vertices, -1);
        }
        Growing<Term<C>> found(arena);
        n_rows = 0;
        for (std::ptrdiff_t k = 0; k < pressures.size(); ++k) {
            if (start[k] == start[k + 1]) continue;
            Row<C> row{};
            row.pressure = k;
            row.begin = found.size();
            std::ptrdiff_t count[2] = {0, 0};
            double gap = 0.0;
            const bool both = skin[0]->given->pore_pressure && skin[1]->given->pore_pressure;
            each_share(k, [&](const MeetingPoint<C>& p, double share,
                              const Directions<C>& direction) {
                const double size = share * p.size;
                row.size += size;
                gap += size * p.gap;
                for (int body = 0; body < 2; ++body)
                    if (const double* pressure = skin[body]->given->pore_pressure)
                        row.pore_impulse +=
                            (both ? 0.5 : 1.0) * layer.dt * size * pressure[facet_of(p, body)];
                for (int body = 0; body < 2; ++body)
                    for (int j = 0; j < C; ++j) {
                        const std::ptrdiff_t v = skin[body]->vertex(facet_of(p, body), j);
                        Directions<C>& of_vertex = sum[body][v];
                        if (last_row[body][v] != k) vertex[body][count[body]++] = v;
                        last_row[body][v] = k;
                        const double N =
                            (body == 0 ? size : -size) * (body == 0 ? p.place_a[j] : p.place_b[j]);
                        for (int m = 0; m < C; ++m)
                            of_vertex.d[m] = of_vertex.d[m] + N * direction.d[m];
                    }
            });
            if (!(row.size > 0.0)) {
                clear(vertex, count);
                continue;
            }
            row.gap = gap / row.size;
            row.bound = layer.bound(row.gap);
            row.compliance = layer.compliance(row.size);
            add_terms(vertex, count, row, found);
            clear(vertex, count);
            row.end = found.size();
            if (row.end > row.begin) rows[n_rows++] = row;
        }
        n_terms = found.size();
        terms = found.close();
        return !arena.is_overrun();
    }
    void clear(std::ptrdiff_t* const* vertex, const std::ptrdiff_t* count) {
        for (int body = 0; body < 2; ++body)
            for (std::ptrdiff_t w = 0; w < count[body]; ++w) sum[body][vertex[body][w]] = {};
    }
    // From vertices to nodes.
    void add_terms(std::ptrdiff_t* const* vertex, const std::ptrdiff_t* count, Row<C>& row,
                   Growing<Term<C>>& found) {
        std::ptrdiff_t n_touched = 0;
        double unheld[C] = {};  // 1 / mass, as if nothing were held
        for (int body = 0; body < 2; ++body) {
            const grit_surface& s = *skin[body]->given;
            for (std::ptrdiff_t w = 0; w < count[body]; ++w) {
                const std::ptrdiff_t v = vertex[body][w];
                const Directions<C>& of_vertex = sum[body][v];
                if (s.rigid) {
                    for (int m = 0; m < C; ++m)
                        row.rigid[m] += dot(of_vertex.d[m], skin[body]->velocity[v]) / row.size;
                    continue;
                }
                for (int k = 0; k < s.nodes_each; ++k) {
                    const std::ptrdiff_t node = local[body][place[body][v] * s.nodes_each + k];
                    if (node < 0) continue;
                    if (!is_touched[node]) {
                        is_touched[node] = true;
                        touched[n_touched++] = node;
                        node_sum[node] = {};
                    }
                    const double N = s.weight[v * s.nodes_each + k] / row.size;
                    for (int m = 0; m < C; ++m)
                        node_sum[node].d[m] = node_sum[node].d[m] + N * of_vertex.d[m];
                }
            }
        }
        for (std::ptrdiff_t i = 0; i < n_touched; ++i) {
            const std::ptrdiff_t node = touched[i];
            is_touched[node] = false;
            Term<C> term{node, {}};
            bool any = false;
            for (int m = 0; m < C; ++m) {
                term.d[m] = node_sum[node].d[m];
                for (int c = 0; c < C; ++c) {
                    const double square = term.d[m][c] * term.d[m][c];
                    row.effective[m] += square * nodes[node].inverse_mass[c];
                    unheld[m] += square * nodes[node].unheld;
                    any = any || term.d[m][c] != 0.0;
                }
            }
            const Node& at = nodes[node];
            const int body = node >= first_node[1];
            for (int c = 0; c < C; ++c)
                row.water_effective[body] +=
                    at.porosity * at.porosity * term.d[0][c] * term.d[0][c] * at.by_itself[c];
            if (any) found.add(term);
        }
        // What moves by roundoff alone, as all else is held, does not move.
        for (int m = 0; m < C; ++m)
            if (!(row.effective[m] > 1e-20 * unheld[m])) row.effective[m] = 0.0;
    }

    double approach(const Row<C>& row, int k, Vector<double, C> Node::*velocity) const {
        double w = row.rigid[k];
        for (std::ptrdiff_t i = row.begin; i < row.end; ++i)
            w += dot(terms[i].d[k], nodes[terms[i].node].*velocity);
        return w;
    }
    void push(const Row<C>& row, int k, double impulse) {
        for (std::ptrdiff_t i = row.begin; i < row.end; ++i) {
            Node& node = nodes[terms[i].node];
            for (int c = 0; c < C; ++c) {
                node.v[c] -= impulse * node.inverse_mass[c] * terms[i].d[k][c];
                node.seepage[c] -= impulse * node.by_body[c] * terms[i].d[k][c];
            }
        }
    }
    // Flow of a body's water, along the normal out of A.
    double seepage(const Row<C>& row, int body, Vector<double, C> Node::*velocity) const {
        double q = 0.0;
        for (std::ptrdiff_t i = row.begin; i < row.end; ++i)
            if (is_of(terms[i].node, body))
                q += nodes[terms[i].node].porosity *
                     dot(terms[i].d[0], nodes[terms[i].node].*velocity);
        return q;
    }
    void push_water(const Row<C>& row, int body, double impulse) {
        for (std::ptrdiff_t i = row.begin; i < row.end; ++i) {
            if (!is_of(terms[i].node, body)) continue;
            Node& node = nodes[terms[i].node];
            const double share = impulse * node.porosity;
            for (int c = 0; c < C; ++c) {
                node.v[c] -= share * node.by_body[c] * terms[i].d[0][c];
                node.seepage[c] -= share * node.by_itself[c] * terms[i].d[0][c];
            }
        }
    }
    bool is_of(std::ptrdiff_t node, int body) const {
        return (node >= first_node[1]) == (body == 1);
    }
    // No water passes. Returns by how much velocities have changed: of the body, as the same impulse on it would change
    // them, for flow may be as slow as it likes; of the flow where the body is held.
    double correct_water(Row<C>& row) {
        double largest = 0.0;
        for (int body = 0; body < 2; ++body) {
            if (!(row.water_effective[body] > 0.0)) continue;
            const double change = seepage(row, body, &Node::seepage) / row.water_effective[body];
            row.water_impulse[body] += change;
            if (change != 0.0) push_water(row, body, change);
            const double yields =
                row.effective[0] > 0.0 ? row.effective[0] : row.water_effective[body];
            largest = std::max(largest, std::fabs(change) * yields);
        }
        return largest;
    }
    // Returns by how much a velocity has changed.
    double correct(Row<C>& row, double mu) {
        if (!(row.effective[0] > 0.0)) return correct_water(row);
        const double w = approach(row, 0, &Node::v) - row.bound - row.compliance * row.impulse[0];
        const double wanted =
            std::max(row.impulse[0] + w / (row.effective[0] + row.compliance), 0.0);
        const double change = wanted - row.impulse[0];
        row.impulse[0] = wanted;
        if (change != 0.0) push(row, 0, change);
        double largest = std::max(std::fabs(change) * row.effective[0], correct_water(row));
        if (!(mu > 0.0)) return largest;
        double tangential[C] = {}, squared = 0.0, most = 0.0;
        for (int k = 1; k < C; ++k) most = std::max(most, row.effective[k]);
        if (!(most > 0.0)) return largest;
        for (int k = 1; k < C; ++k) {
            tangential[k] = row.impulse[k] + approach(row, k, &Node::v) / most;
            squared += tangential[k] * tangential[k];
        }
        const double limit =
            row.impulse[0] > 0.0 ? mu * std::max(row.impulse[0] - row.pore_impulse, 0.0) : 0.0;
        const double back = squared > limit * limit ? limit / std::sqrt(squared) : 1.0;
        for (int k = 1; k < C; ++k) {
            const double step = back * tangential[k] - row.impulse[k];
            row.impulse[k] += step;
            if (step != 0.0) push(row, k, step);
            largest = std::max(largest, std::fabs(step) * most);
        }
        return largest;
    }
    Arena& arena;
    const Skin<C>* skin[2];
    const Pressures<C>& pressures;
    Layer layer{};
    const MeetingPoint<C>* points = nullptr;
    const Share* shares = nullptr;
    std::ptrdiff_t *start = nullptr, *order = nullptr;  // shares by what carries the pressure
    std::ptrdiff_t* place[2] = {};                      // of vertices that are used, in local
    std::ptrdiff_t* local[2] = {};                      // nodes of these
    Directions<C>* sum[2] = {};
    Directions<C>* node_sum = nullptr;
    bool* is_touched = nullptr;
    std::ptrdiff_t* touched = nullptr;
    Node* nodes = nullptr;
    std::ptrdiff_t first_node[3] = {0, 0, 0};
    Row<C>* rows = nullptr;
    Term<C>* terms = nullptr;
    std::ptrdiff_t n_rows = 0, n_terms = 0;
    grit_surface_row* given_rows = nullptr;
    grit_surface_term* given_terms = nullptr;
};

}  // namespace grit::surface
