// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/io/shared_state.hpp"

#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace grit::mpm {

// take(pointer) for each number.
template <class Take> void SharedState::visit_common(Simulation& s, const Take& take) {
    for (double* number : {&s.t, &s.dt, &s.dt_before, &s.largest_speed, &s.settings.cfl,
                           &s.settings.largest_step, &s.settings.pic_rate,
                           &s.settings.local_damping, &s.settings.gravity_r, &s.settings.gravity_z})
        take(number);
    take(&s.step_count);
    take(&s.started);
    take(&s.sums);
    for (Simulation::Part& part : s.parts) {
        take(&part.scale);
        take(&part.least_mass);
        take(&part.mean.per_volume);
    }
    for (ContactPair& contact : s.contacts) {
        take(&contact.step_totals);
        take(&contact.step_faces);
    }
}

// take(first number of the first node, numbers of a node).
template <class Take> void SharedState::visit_nodes(Simulation& s, const Take& take) {
    for (Simulation::Part& part : s.parts) {
        take(part.records.data(), record::size);
        take(part.motions.data(), motion::size);
        take(part.internal.data(), 2);
    }
}

std::string SharedState::common(Simulation& simulation) {
    std::string out;
    visit_common(simulation, [&out](const auto* number) {
        static_assert(std::is_trivially_copyable_v<std::remove_pointer_t<decltype(number)>>);
        out.append(reinterpret_cast<const char*>(number), sizeof *number);
    });
    return out;
}

void SharedState::take_common(Simulation& simulation, const std::string& bytes) {
    if (common(simulation).size() != bytes.size())
        throw std::runtime_error("the state is not that of these bodies");
    const char* at = bytes.data();
    visit_common(simulation, [&at](auto* number) {
        std::memcpy(static_cast<void*>(number), at, sizeof *number);
        at += sizeof *number;
    });
}

std::size_t SharedState::words_per_node(Simulation& simulation) {
    std::size_t count = simulation.contacts.size();
    visit_nodes(simulation,
                [&count](const void*, int numbers) { count += static_cast<std::size_t>(numbers); });
    return count;
}

std::vector<std::uint64_t> SharedState::nodes(Simulation& simulation) {
    const std::size_t each = words_per_node(simulation), count = simulation.fixed_nodes.size();
    std::vector<std::uint64_t> out(each * count);
    std::size_t first = 0;
    visit_nodes(simulation, [&](const void* numbers, int of_node) {
        const auto* from = static_cast<const std::uint64_t*>(numbers);
        const auto size = static_cast<std::size_t>(of_node);
        for (std::size_t i = 0; i < count; ++i)
            std::memcpy(&out[i * each + first], from + i * size, size * sizeof *from);
        first += size;
    });
    for (ContactPair& contact : simulation.contacts) {
        for (std::size_t i = 0; i < count; ++i) out[i * each + first] = contact.pressed()[i] != 0;
        ++first;
    }
    return out;
}

void SharedState::take_nodes(Simulation& simulation, const std::vector<std::uint64_t>& words) {
    const std::size_t each = words_per_node(simulation), count = simulation.fixed_nodes.size();
    if (words.size() != each * count)
        throw std::runtime_error("the state is not that of this grid");
    std::size_t first = 0;
    visit_nodes(simulation, [&](void* numbers, int of_node) {
        auto* to = static_cast<std::uint64_t*>(numbers);
        const auto size = static_cast<std::size_t>(of_node);
        for (std::size_t i = 0; i < count; ++i)
            std::memcpy(to + i * size, &words[i * each + first], size * sizeof *to);
        first += size;
    });
    for (ContactPair& contact : simulation.contacts) {
        for (std::size_t i = 0; i < count; ++i) contact.pressed()[i] = words[i * each + first] != 0;
        ++first;
    }
}

}  // namespace grit::mpm
