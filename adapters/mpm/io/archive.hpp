// SPDX-License-Identifier: BSD-3-Clause
// Each type says once what of it is kept, in
//
//   template <class Self, class Archive> static void visit(Self& object, Archive& archive)
//
// which hands every number to the archive by what it is; checkpoints, restart files and new cuts of the grid
// take from it what they need:
//
//   archive.value(x)            one number or plain struct, the same on all processes
//   archive.nodes(v)            a vector with an element for each node
//   archive.own(data, count)    of this process, as many in every simulation of the same case
//   archive.list(v)             of any length
//   archive.texts(v)            of any length
//   archive.objects(v)          of any length, of types that say it themselves
//   archive.ids(v)              of particles, in their order ...
//   archive.starts(v)           ... and where their strips start
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace grit::mpm {

// All of it, one after the other.
class ByteWriter {
  public:
    template <class Number> void value(const Number& x) { own(&x, 1); }
    template <class Number> void own(const Number* data, std::size_t count) {
        static_assert(std::is_trivially_copyable_v<Number>);
        if (count > 0) out.append(reinterpret_cast<const char*>(data), count * sizeof(Number));
    }
    template <class Number> void nodes(const std::vector<Number>& v) { own(v.data(), v.size()); }
    template <class List> void list(const List& v) {
        value(static_cast<std::uint64_t>(v.size()));
        own(v.data(), v.size());
    }
    template <class Object> void objects(const std::vector<Object>& v) {
        value(static_cast<std::uint64_t>(v.size()));
        for (const Object& object : v) Object::visit(object, *this);
    }
    void texts(const std::vector<std::string>& v) {
        value(static_cast<std::uint64_t>(v.size()));
        for (const std::string& text : v) list(text);
    }
    void ids(const std::vector<int>& v) { nodes(v); }
    void starts(const std::vector<std::ptrdiff_t>& v) { nodes(v); }
    std::string out;
};

// What a ByteWriter has written, of an object that has the same lengths but those of lists.
class ByteReader {
  public:
    ByteReader(const char* begin, std::size_t bytes) : at(begin), end(begin + bytes) {}
    template <class Number> void value(Number& x) { own(&x, 1); }
    template <class Number> void own(Number* data, std::size_t count) {
        static_assert(std::is_trivially_copyable_v<Number>);
        require(count, sizeof(Number));
        if (count > 0) std::memcpy(static_cast<void*>(data), at, count * sizeof(Number));
        at += count * sizeof(Number);
    }
    template <class Number> void nodes(std::vector<Number>& v) { own(v.data(), v.size()); }
    template <class List> void list(List& v) {
        const std::size_t count = size_of_list(sizeof v[0]);
        v.resize(count);
        own(v.data(), count);
    }
    template <class Object> void objects(std::vector<Object>& v) {
        v.resize(size_of_list(1));  // none is shorter than a byte
        for (Object& object : v) Object::visit(object, *this);
    }
    void texts(std::vector<std::string>& v) {
        v.resize(size_of_list(1));
        for (std::string& text : v) list(text);
    }
    void ids(std::vector<int>& v) { nodes(v); }
    void starts(std::vector<std::ptrdiff_t>& v) { nodes(v); }
    std::size_t left() const { return static_cast<std::size_t>(end - at); }

  protected:
    std::size_t size_of_list(std::size_t bytes_each) {
        std::uint64_t count = 0;
        value(count);
        require(count, bytes_each);
        return count;
    }
    void require(std::uint64_t count, std::size_t bytes_each) const {
        if (count > left() / bytes_each)
            throw std::runtime_error("damaged: its state ends before all that is to be in it");
    }
    void skip(std::size_t count, std::size_t bytes_each) {
        require(count, bytes_each);
        at += count * bytes_each;
    }

  private:
    const char *at, *end;
};

// Goes the way of a ByteReader and changes nothing. Throws std::runtime_error where that one could not follow.
class ByteChecker : private ByteReader {
  public:
    using ByteReader::ByteReader;
    using ByteReader::left;
    template <class Number> void value(const Number& x) { own(&x, 1); }
    template <class Number> void own(const Number*, std::size_t count) {
        skip(count, sizeof(Number));
    }
    template <class Number> void nodes(const std::vector<Number>& v) { own(v.data(), v.size()); }
    template <class List> void list(const List& v) { skip(size_of_list(sizeof v[0]), sizeof v[0]); }
    void ids(const std::vector<int>& ours) {
        std::vector<int> theirs(ours.size());
        ByteReader::ids(theirs);
        particles = static_cast<std::ptrdiff_t>(theirs.size());
        std::vector<bool> seen(theirs.size(), false);
        for (const int id : theirs) {
            if (id < 0 || id >= particles || seen[static_cast<std::size_t>(id)])
                throw std::runtime_error(
                    "its particles are not numbered as those of the simulation");
            seen[static_cast<std::size_t>(id)] = true;
        }
    }
    void starts(const std::vector<std::ptrdiff_t>& ours) {
        std::vector<std::ptrdiff_t> theirs(ours.size());
        ByteReader::starts(theirs);
        if (!std::is_sorted(theirs.begin(), theirs.end()) || theirs.front() < 0 ||
            theirs.back() > particles)
            throw std::runtime_error("its strips do not hold the particles of the simulation");
    }

  private:
    std::ptrdiff_t particles = 0;  // of the ids seen last
};

// An archive that takes nothing but what it has a word of its own for.
struct TakesNothing {
    template <class Number> void value(const Number&) {}
    template <class Number> void own(const Number*, std::size_t) {}
    template <class Number> void nodes(const std::vector<Number>&) {}
    template <class List> void list(const List&) {}
    void ids(const std::vector<int>&) {}
    void starts(const std::vector<std::ptrdiff_t>&) {}
};

}  // namespace grit::mpm
