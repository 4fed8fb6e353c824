// SPDX-License-Identifier: GPL-2.0-only
#include "adapters/lammps/run_bytes.hpp"

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace grit::lammps {
namespace {

constexpr std::uint64_t format = 0x677269746d706d04;  // "gritmpm", 4

class Writer {
  public:
    template <class Number> void add(const Number& number) {
        static_assert(std::is_trivially_copyable_v<Number>);
        out.append(reinterpret_cast<const char*>(&number), sizeof number);
    }
    template <class List> void add_list(const List& list) {
        add(static_cast<std::uint64_t>(list.size()));
        out.append(reinterpret_cast<const char*>(list.data()), list.size() * sizeof list[0]);
    }
    std::string out;
};

class Reader {
  public:
    Reader(const char* begin, std::uint64_t bytes) : at(begin), end(begin + bytes) {}
    template <class Number> void take(Number& number) {
        static_assert(std::is_trivially_copyable_v<Number>);
        copy(&number, sizeof number);
    }
    template <class List> void take_list(List& list) {
        std::uint64_t count = 0;
        take(count);
        if (count > static_cast<std::uint64_t>(end - at)) fail();
        list.resize(count);
        copy(list.data(), count * sizeof list[0]);
    }

  private:
    [[noreturn]] static void fail() {
        throw std::runtime_error("the state in the restart file is damaged");
    }
    void copy(void* to, std::uint64_t bytes) {
        if (bytes > static_cast<std::uint64_t>(end - at)) fail();
        std::memcpy(to, at, bytes);
        at += bytes;
    }
    const char *at, *end;
};

// act(x) for every number, act.list(x) for every list of them.
template <class Run, class Act> void visit(Run& run, Act& act) {
    act.number(run.energy_scale);
    auto& s = run.state;
    for (auto* x : {&s.last_dt, &s.start_level, &s.stage_level, &s.next_row, &s.row_time})
        act.number(*x);
    act.number(s.stage);
    act.number(s.impulse);
    act.list(s.stage_time);
    act.list(run.common);
    act.list(run.nodes);
}

struct Writing {
    Writer& to;
    template <class Number> void number(const Number& x) { to.add(x); }
    template <class List> void list(const List& x) { to.add_list(x); }
};

struct Reading {
    Reader& from;
    template <class Number> void number(Number& x) { from.take(x); }
    template <class List> void list(List& x) { from.take_list(x); }
};

template <class Stage, class Act> void visit_stage(Stage& stage, Act& act) {
    act.list(stage.name);
    act.number(stage.gravity);
    for (auto* x : {&stage.local_damping, &stage.pic_rate, &stage.cfl}) act.number(*x);
    act.number(stage.end);
}

}  // namespace

std::string to_bytes(const StoredRun* run, std::uint64_t fingerprint) {
    Writer writer;
    writer.add(format);
    writer.add(fingerprint);
    writer.add(static_cast<std::uint64_t>(run ? 1 : 0));
    if (run) {
        Writing act{writer};
        visit(*run, act);
        writer.add(static_cast<std::uint64_t>(run->stages.size()));
        for (const mpm::StagePlan& stage : run->stages) visit_stage(stage, act);
    }
    Writer size;
    size.add(static_cast<std::uint64_t>(writer.out.size()));
    return size.out + writer.out;
}

std::unique_ptr<StoredRun> from_bytes(const char* bytes, std::uint64_t fingerprint) {
    std::uint64_t size = 0;
    std::memcpy(&size, bytes, sizeof size);
    Reader reader(bytes + sizeof size, size);
    std::uint64_t stamp = 0, of_words = 0, has_begun = 0, stages = 0;
    reader.take(stamp);
    if (stamp != format) throw std::runtime_error("the restart file is of another version of Grit");
    reader.take(of_words);
    if (of_words != fingerprint)
        throw std::runtime_error("the restart file is of a fix with other words; only names of "
                                 "files and threads may change");
    reader.take(has_begun);
    if (has_begun == 0) return nullptr;
    auto out = std::make_unique<StoredRun>();
    Reading act{reader};
    visit(*out, act);
    reader.take(stages);
    for (; stages > 0; --stages) visit_stage(out->stages.emplace_back(), act);
    return out;
}

}  // namespace grit::lammps
