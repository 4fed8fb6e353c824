// SPDX-License-Identifier: BSD-3-Clause
#include "element/library_law.hpp"

#include <algorithm>
#include <dlfcn.h>

#include "element/errors.hpp"
#include "element/text.hpp"
#include "element/umat_law.hpp"
#include "element/vumat_law.hpp"

namespace element {

LibraryLaw::LibraryLaw(UmatSource given, std::initializer_list<const char*> symbols)
    : source(std::move(given)) {
    if (source.state_size < 0)
        throw BadCase(text("NSTATV must be >= 0, got %d", source.state_size));
    const auto size = static_cast<std::size_t>(source.state_size);
    for (std::size_t i = source.state_names.size(); i < size; ++i)
        source.state_names.push_back(text("statev(%d)", static_cast<int>(i) + 1));
    source.state_names.resize(size);
    for (const int index : {source.void_ratio, source.minus_pore_pressure})
        if (index >= source.state_size)
            throw BadCase(
                text("NSTATV is %d: there is no STATEV(%d)", source.state_size, index + 1));
    // A bare name would be looked up in the folders of the system.
    const std::string path = std::filesystem::absolute(source.library).string();
    void* opened = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!opened) {
        const char* why = dlerror();
        throw BadCase(text("cannot load the UMAT: %s", why ? why : path.c_str()));
    }
    handle = std::shared_ptr<void>(opened, [](void* library) { dlclose(library); });
    std::string names;
    for (const char* name : symbols) {
        if (void* symbol = dlsym(opened, name)) {
            function = reinterpret_cast<void (*)()>(symbol);
            found = name;
            return;
        }
        names += (names.empty()                  ? ""
                  : name == *(symbols.end() - 1) ? " or "
                                                 : ", ") +
                 std::string(name);
    }
    throw BadCase(text("%s has no symbol %s", path.c_str(), names.c_str()));
}

MaterialPoint LibraryLaw::start(const Vector6& stress, std::vector<double> state) const {
    const auto size = static_cast<std::size_t>(source.state_size);
    if (state.size() > size)
        throw BadCase(text("%d state variables are given, NSTATV is %d",
                           static_cast<int>(state.size()), source.state_size));
    state.resize(size, 0.0);
    return {stress, std::move(state)};
}

Observation LibraryLaw::observe(const MaterialPoint& point) const {
    Observation out;
    if (source.void_ratio >= 0)
        out.void_ratio = point.state[static_cast<std::size_t>(source.void_ratio)];
    if (source.minus_pore_pressure >= 0)
        out.pore_pressure =
            std::max(-point.state[static_cast<std::size_t>(source.minus_pore_pressure)],
                     -source.largest_tension);
    return out;
}

std::shared_ptr<const LibraryLaw> open_library_law(const UmatSource& source) {
    try {
        return std::make_shared<UmatLaw>(source);
    } catch (const BadCase&) {
        try {
            return std::make_shared<VumatLaw>(source);
        } catch (const BadCase&) {
            // What is missing is a UMAT.
        }
        throw;
    }
}

}  // namespace element
