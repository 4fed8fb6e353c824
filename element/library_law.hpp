// SPDX-License-Identifier: BSD-3-Clause
// A law in a shared library, as a host finds it: with PROPS and STATEV, behind a symbol.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <limits>
#include <memory>

#include "element/law.hpp"

namespace element {

struct UmatSource {
    std::filesystem::path library;
    std::vector<double> props;           // PROPS
    int state_size = 0;                  // NSTATV >= 0
    std::string material_name = "SAND";  // CMNAME, padded to 80 blanks
    // Names of columns; missing ones become statev(1), statev(2), ...
    std::vector<std::string> state_names;
    // Where the law keeps these, 0-based, -1: unknown. Classic hypoplastic layout: 6 and 7.
    int void_ratio = -1;
    int minus_pore_pressure = -1;
    double largest_tension = std::numeric_limits<double>::infinity();  // of the water [stress]
};

class LibraryLaw : public Law {
  public:
    // A point with the state padded with zeros to NSTATV. Throws BadCase if there are more.
    MaterialPoint start(const Vector6& stress, std::vector<double> state) const;

    using Law::observe;
    Observation observe(const MaterialPoint& point) const override;
    const std::vector<std::string>& state_names() const override { return source.state_names; }

    const std::string& symbol() const { return found; }

  protected:
    // The first of the symbols that the library has. Throws BadCase where library or symbol are missing.
    LibraryLaw(UmatSource source, std::initializer_list<const char*> symbols);

    template <typename Function> Function function_as() const {
        return reinterpret_cast<Function>(function);
    }

    UmatSource source;

  private:
    std::string found;             // the symbol's name
    std::shared_ptr<void> handle;  // of dlopen, closed with the last copy
    void (*function)() = nullptr;  // to be cast to its type
};

// A UmatLaw, or a VumatLaw if the library has no UMAT. Throws BadCase.
std::shared_ptr<const LibraryLaw> open_library_law(const UmatSource& source);

}  // namespace element
