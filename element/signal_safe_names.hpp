// SPDX-License-Identifier: BSD-3-Clause
// Names of files that a signal handler may have to remove.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <string>

namespace element {

// In fixed memory and without locks, for a handler may not allocate, nor wait for the thread that it has
// interrupted. Needs no destructor, for handlers run after those of static objects.
template <std::size_t places> class SignalSafeNames {
  public:
    static constexpr int none = -1;
    static constexpr std::size_t longest = 4095;

    constexpr SignalSafeNames() = default;
    SignalSafeNames(const SignalSafeNames&) = delete;
    SignalSafeNames& operator=(const SignalSafeNames&) = delete;

    // The place it got; none where the name is too long or all places are taken. The descriptor is kept
    // beside the name, for whoever reads it.
    int add(const std::filesystem::path& path, int descriptor = -1) {
        const std::string& name = path.native();
        if (name.size() > longest) return none;
        for (std::size_t i = 0; i < places; ++i) {
            State expected = State::free;
            if (!table[i].state.compare_exchange_strong(expected, State::taken)) continue;
            std::memcpy(table[i].name.data(), name.c_str(), name.size() + 1);
            table[i].descriptor = descriptor;
            table[i].state = State::readable;
            return static_cast<int>(i);
        }
        return none;
    }

    void remove(int place) {
        if (place != none) table[static_cast<std::size_t>(place)].state = State::free;
    }

    // read(name, descriptor) of every name that is there. May be called by a signal handler.
    template <class Read> void for_each(const Read& read) const noexcept {
        for (const Place& place : table)
            if (place.state == State::readable)
                read(static_cast<const char*>(place.name.data()), place.descriptor.load());
    }

  private:
    enum class State : int { free, taken, readable };
    static_assert(std::atomic<State>::is_always_lock_free && std::atomic<int>::is_always_lock_free,
                  "signal handlers read nothing else");
    struct Place {
        std::atomic<State> state{State::free};
        std::atomic<int> descriptor{0};
        std::array<char, longest + 1> name{};
    };
    std::array<Place, places> table{};
};

}  // namespace element
