// SPDX-License-Identifier: BSD-3-Clause
// What a step leaves for the next one besides particles, for hosts that store it or cut the grid anew: what all
// processes have, and what a node has. Lines of penalty contacts and forces of absorbing sides are not in it. Of a
// simulation in the plane or in space.
#pragma once

#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "adapters/mpm/io/archive.hpp"

namespace grit::mpm {

class GridState {
    struct CommonWriter : TakesNothing {
        template <class Number> void value(const Number& x) { bytes.value(x); }
        ByteWriter bytes;
    };

    struct CommonReader : TakesNothing {
        explicit CommonReader(const std::string& all) : bytes(all.data(), all.size()) {}
        template <class Number> void value(Number& x) { bytes.value(x); }
        ByteReader bytes;
    };

    // A number of less than a word has one of its own.
    template <class Number>
    static constexpr std::size_t words_of = sizeof(Number) < sizeof(std::uint64_t)
                                                ? 1
                                                : sizeof(Number) / sizeof(std::uint64_t);

    struct NodeWords : TakesNothing {
        template <class Number> void nodes(const std::vector<Number>&) { each += words_of<Number>; }
        std::size_t each = 0;
    };

    struct NodeWriter : TakesNothing {
        NodeWriter(std::size_t words_each, std::size_t nodes)
            : each(words_each), words(words_each * nodes) {}
        template <class Number> void nodes(const std::vector<Number>& v) {
            for (std::size_t i = 0; i < v.size(); ++i)
                std::memcpy(&words[i * each + first], &v[i], sizeof(Number));
            first += words_of<Number>;
        }
        std::size_t each, first = 0;
        std::vector<std::uint64_t> words;
    };

    struct NodeReader : TakesNothing {
        NodeReader(std::size_t words_each, const std::vector<std::uint64_t>& all)
            : each(words_each), words(all) {}
        template <class Number> void nodes(std::vector<Number>& v) {
            for (std::size_t i = 0; i < v.size(); ++i)
                std::memcpy(static_cast<void*>(&v[i]), &words[i * each + first], sizeof(Number));
            first += words_of<Number>;
        }
        std::size_t each, first = 0;
        const std::vector<std::uint64_t>& words;
    };

  public:
    // The same on all processes.
    template <class Simulated> static std::string common(const Simulated& simulation) {
        CommonWriter archive;
        Simulated::visit(simulation, archive);
        return archive.bytes.out;
    }
    // Numbers of all nodes of this process, a node's one after the other.
    template <class Simulated> static std::size_t words_per_node(const Simulated& simulation) {
        NodeWords archive;
        Simulated::visit(simulation, archive);
        return archive.each;
    }
    template <class Simulated>
    static std::vector<std::uint64_t> nodes(const Simulated& simulation) {
        NodeWriter archive(words_per_node(simulation), simulation.constraints().size());
        Simulated::visit(simulation, archive);
        return archive.words;
    }

    // Of a simulation of the same case. Throws std::runtime_error where it cannot be.
    template <class Simulated>
    static void take_common(Simulated& simulation, const std::string& bytes) {
        if (common(simulation).size() != bytes.size())
            throw std::runtime_error("the state is not that of these bodies");
        CommonReader archive(bytes);
        Simulated::visit(simulation, archive);
    }
    template <class Simulated>
    static void take_nodes(Simulated& simulation, const std::vector<std::uint64_t>& words) {
        const std::size_t each = words_per_node(simulation);
        if (words.size() != each * simulation.constraints().size())
            throw std::runtime_error("the state is not that of this grid");
        NodeReader archive(each, words);
        Simulated::visit(simulation, archive);
    }
};

}  // namespace grit::mpm
