// SPDX-License-Identifier: BSD-3-Clause
// What is computed: bodies on one grid, how, by whom, and when it is. The passes of a step share it.
#pragma once

#include <cstdint>
#include <vector>

#include "adapters/mpm/kernel/exchange.hpp"
#include "adapters/mpm/kernel/id_index.hpp"
#include "adapters/mpm/kernel/nodes.hpp"
#include "adapters/mpm/kernel/strips.hpp"
#include "adapters/mpm/step/settings.hpp"
#include "adapters/mpm/step/thread_pool.hpp"

namespace grit::mpm {

// A body on the grid: its particles in strips, and what they leave at its nodes.
struct Part {
    Body body;
    Strips strips;
    std::vector<NodeRecord> records = {};
    std::vector<NodeMotion> motions = {};
    IdIndex by_id = {};
    Separation separation = {};
    bool reduces_domains = false;
    double least_mass = 0.0;      // of a node that moves [kg]
    double largest_volume = 0.0;  // of a particle at the start [m3]

    // Particle with this id; -1: another process has it.
    std::ptrdiff_t find(int id) const { return by_id.find(body.particles, id); }
    void index_ids() { by_id.find_all(body.particles); }
    template <class Self, class Archive> static void visit(Self& part, Archive& archive) {
        Particles::visit(part.body.particles, archive);
        Strips::visit(part.strips, archive);
        archive.value(part.least_mass);
        archive.value(part.largest_volume);
        archive.nodes(part.records);
        archive.nodes(part.motions);
    }
};

class Model {
  public:
    // exchange: of processes that share the grid, outlives this; null: there is one process.
    Model(Axis r, Axis z, const Settings& settings, Exchange* exchange);
    Model(const Model&) = delete;
    Model& operator=(const Model&) = delete;

    void add_body(Body body);
    // Between steps, after particles of a body came from or went to other processes.
    void particles_changed(std::size_t body);
    // Particles by cells, where they have moved on too far for the strips: these allow a row, and one more
    // step moves less than the other half.
    void sort_if_moved();
    void sort();

    GridView grid() const { return {r.view(), z.view()}; }
    bool is_alone() const { return &exchange == &nobody; }
    int strips() const { return parts.empty() ? 0 : parts[0].strips.count(); }
    // work(body, strip) for all bodies and strips.
    template <class Work> void for_strips(const Work& work) {
        const int count = strips();
        pool.run(count * static_cast<int>(parts.size()),
                 [&](int i) { work(static_cast<std::size_t>(i / count), i % count); });
    }
    // Neighbours may add to the same cell or node: strips with even numbers first.
    template <class Work> void for_strips_apart(const Work& work) {
        for (const int colour : {0, 1})
            for_strips([&](std::size_t body, int strip) {
                if (strip % 2 == colour) work(body, strip);
            });
    }
    // Rows of nodes of a strip; the last one has one more.
    struct Rows {
        std::ptrdiff_t begin, end;
    };
    Rows nodes_of(int strip) const;

    template <class Self, class Archive> static void visit(Self& model, Archive& archive) {
        for (auto& part : model.parts) Part::visit(part, archive);
        for (auto* number : {&model.t, &model.dt, &model.dt_before}) archive.value(*number);
        archive.value(model.steps);
        archive.own(&model.drift, 1);
        auto& s = model.settings;
        for (auto* of_stage :
             {&s.cfl, &s.largest_step, &s.pic_rate, &s.local_damping, &s.gravity_r, &s.gravity_z})
            archive.value(*of_stage);
    }

    Settings settings;
    Axis r, z;
    std::vector<std::uint8_t> fixed_nodes;
    std::vector<std::uint8_t> closed_nodes;  // to water, which nothing holds along a side
    std::vector<Part> parts;

  private:
    Exchange nobody;

  public:
    Exchange& exchange;
    ThreadPool pool;
    double shortest = 0.0;  // edge of a cell, of all processes [m]
    // Now; of the step that is done or comes next; of the one before [s].
    double t = 0.0, dt = 0.0, dt_before = 0.0;
    double drift = 0.0;  // how far particles may have moved along z since they were sorted [m]
    long steps = 0;
};

}  // namespace grit::mpm
