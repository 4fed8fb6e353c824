// SPDX-License-Identifier: BSD-3-Clause
// What is computed in space: bodies on one grid, how, and when it is. The passes of a step share it.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "adapters/mpm/kernel/exchange.hpp"
#include "adapters/mpm/kernel/id_index.hpp"
#include "adapters/mpm/space/kernel/nodes.hpp"
#include "adapters/mpm/space/kernel/pencils.hpp"
#include "adapters/mpm/space/step/settings.hpp"
#include "adapters/mpm/step/thread_pool.hpp"

namespace grit::mpm::space {

// A body on the grid: its particles in pencils, and what they leave at its nodes.
struct Part {
    Body body;
    Pencils pencils;
    std::vector<NodeRecord> records = {};
    std::vector<NodeSlope> slopes = {};       // empty: it meets no other body at nodes ...
    std::vector<NodeSlope> pore_forces = {};  // ... or is dry
    std::vector<NodeMotion> motions = {};
    IdIndex by_id = {};
    Separation separation = {};
    double least_mass = 0.0;      // of a node that moves [kg]
    double largest_volume = 0.0;  // of a particle at the start [m3]

    // Particle with this id; -1: another process has it.
    std::ptrdiff_t find(int id) const { return by_id.find(body.particles, id); }
    void index_ids() { by_id.find_all(body.particles); }
    template <class Self, class Archive> static void visit(Self& part, Archive& archive) {
        Particles::visit(part.body.particles, archive);
        Pencils::visit(part.pencils, archive);
        archive.nodes(part.records);
        archive.nodes(part.motions);
        if (part.body.rigid()) RigidMotion::visit(*part.body.motion, archive);
    }
};

class Model {
  public:
    // exchange: of processes that share the grid, outlives this; null: there is one process.
    Model(std::array<Axis, 3> axes, const Settings& settings, Exchange* exchange);
    Model(const Model&) = delete;
    Model& operator=(const Model&) = delete;

    void add_body(Body body);
    // Between steps, after particles of a body came from or went to other processes.
    void particles_changed(std::size_t body);
    // Particles by cells, where they have moved on too far for the pencils: these allow a row, and one more
    // step moves less than the other half.
    void sort_if_moved();
    void sort();

    GridView grid() const { return {{axis[0].view(), axis[1].view(), axis[2].view()}}; }
    std::size_t nodes() const { return fixed_nodes.size(); }
    std::size_t cells() const {
        return static_cast<std::size_t>(axis[0].cells()) *
               static_cast<std::size_t>(axis[1].cells()) *
               static_cast<std::size_t>(axis[2].cells());
    }
    int pencils() const { return parts.empty() ? 0 : parts[0].pencils.count(); }
    // work(body, pencil) for all bodies and pencils.
    template <class Work> void for_pencils(const Work& work) {
        const int count = pencils();
        pool.run(count * static_cast<int>(parts.size()),
                 [&](int i) { work(static_cast<std::size_t>(i / count), i % count); });
    }
    // Neighbours may add to the same cell or node: one colour after the other.
    template <class Work> void for_pencils_apart(const Work& work) {
        for (int colour = 0; colour < Pencils::colours; ++colour)
            pool.run(static_cast<int>(of_colour[colour].size() * parts.size()), [&](int i) {
                const auto& some = of_colour[static_cast<std::size_t>(colour)];
                const auto k = static_cast<std::size_t>(i);
                work(k / some.size(), some[k % some.size()]);
            });
    }
    Vector3 place_of_node(std::size_t node) const {
        Vector3 out;
        for (int d = 0; d < 3; ++d) {
            const Axis& along = axis[static_cast<std::size_t>(d)];
            const auto count = static_cast<std::size_t>(along.nodes());
            out[d] = along[static_cast<int>(node % count)];
            node /= count;
        }
        return out;
    }
    // The velocities of a rigid body at nodes, now and before.
    void set_rigid_nodes(Part& part, std::size_t begin, std::size_t end) const;
    // work(body, chunk, begin, end) for nodes of all bodies, in chunks that no number of threads changes.
    static constexpr std::size_t chunk_size = 8192;
    std::size_t chunks() const { return (nodes() + chunk_size - 1) / chunk_size; }
    template <class Work> void for_nodes(const Work& work) {
        const std::size_t count = chunks();
        pool.run(static_cast<int>(count * parts.size()), [&](int i) {
            const auto k = static_cast<std::size_t>(i);
            const std::size_t chunk = k % count, begin = chunk * chunk_size;
            work(k / count, chunk, begin, std::min(begin + chunk_size, nodes()));
        });
    }

    template <class Self, class Archive> static void visit(Self& model, Archive& archive) {
        for (auto& part : model.parts) Part::visit(part, archive);
        for (auto* number : {&model.t, &model.dt, &model.dt_before}) archive.value(*number);
        archive.value(model.steps);
        archive.own(model.drift, 2);
        auto& s = model.settings;
        for (auto* of_stage : {&s.cfl, &s.largest_step, &s.pic_rate, &s.local_damping})
            archive.value(*of_stage);
        archive.value(model.gravity);
    }

    Settings settings;
    std::array<Axis, 3> axis;
    Vector3 gravity{0.0, 0.0, 0.0};  // [m/s2]
    std::vector<std::uint8_t> fixed_nodes;
    std::vector<Part> parts;

  private:
    Exchange nobody;

  public:
    Exchange& exchange;
    ThreadPool pool;
    double shortest = 0.0;  // edge of a cell, of all processes [m]
    // Now; of the step that is done or comes next; of the one before [s].
    double t = 0.0, dt = 0.0, dt_before = 0.0;
    double drift[2] =
        {};  // how far particles may have moved along y and z since they were sorted [m]
    long steps = 0;

  private:
    std::array<std::vector<int>, Pencils::colours> of_colour;
};

}  // namespace grit::mpm::space
