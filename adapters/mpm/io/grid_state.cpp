// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/io/grid_state.hpp"

#include <cstring>
#include <stdexcept>

#include "adapters/mpm/io/archive.hpp"

namespace grit::mpm {
namespace {

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
constexpr std::size_t words_of = sizeof(Number) < sizeof(std::uint64_t)
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

}  // namespace

std::string GridState::common(const Simulation& simulation) {
    CommonWriter archive;
    Simulation::visit(simulation, archive);
    return archive.bytes.out;
}

void GridState::take_common(Simulation& simulation, const std::string& bytes) {
    if (common(simulation).size() != bytes.size())
        throw std::runtime_error("the state is not that of these bodies");
    CommonReader archive(bytes);
    Simulation::visit(simulation, archive);
}

std::size_t GridState::words_per_node(const Simulation& simulation) {
    NodeWords archive;
    Simulation::visit(simulation, archive);
    return archive.each;
}

std::vector<std::uint64_t> GridState::nodes(const Simulation& simulation) {
    NodeWriter archive(words_per_node(simulation), simulation.constraints().size());
    Simulation::visit(simulation, archive);
    return archive.words;
}

void GridState::take_nodes(Simulation& simulation, const std::vector<std::uint64_t>& words) {
    const std::size_t each = words_per_node(simulation);
    if (words.size() != each * simulation.constraints().size())
        throw std::runtime_error("the state is not that of this grid");
    NodeReader archive(each, words);
    Simulation::visit(simulation, archive);
}

}  // namespace grit::mpm
