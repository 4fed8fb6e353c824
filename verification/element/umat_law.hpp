// SPDX-License-Identifier: BSD-3-Clause
// Any law behind the UMAT symbol of a shared library: Abaqus' Fortran argument list, NTENS 6.
#pragma once

#include <filesystem>
#include <memory>

#include "element/law.hpp"

namespace element {

struct UmatSource {
    std::filesystem::path library;       // holds umat_, UMAT or umat, looked up in this order
    std::vector<double> props;           // PROPS
    int state_size = 0;                  // NSTATV >= 0
    std::string material_name = "SAND";  // CMNAME, padded to 80 blanks
    // Names of columns; missing ones become statev(1), statev(2), ...
    std::vector<std::string> state_names;
    // Where the law keeps these, 0-based, -1: unknown. Classic hypoplastic layout: 6 and 7.
    int void_ratio = -1;
    int minus_pore_pressure = -1;
};

// The library sees copies: what it writes to DSTRAN, PROPS or any other input stays its own affair,
// and writing beyond STRESS, STATEV, DDSDDE or PROPS is noticed and refused. PNEWDT < 1 on return
// means a failed increment. STRESS has been rotated before the call, as Abaqus/Standard does.
class UmatLaw : public Law {
  public:
    // Throws BadCase where the library or the symbol cannot be found.
    explicit UmatLaw(UmatSource source);

    // A point with the state padded with zeros to NSTATV. Throws BadCase if there are more.
    MaterialPoint start(const Vector6& stress, std::vector<double> state) const;

    Response advance(const MaterialPoint& start, const StrainIncrement& increment) const override;
    Observation observe(const MaterialPoint& point) const override;
    const std::vector<std::string>& state_names() const override { return source.state_names; }

    const std::string& symbol() const { return found; }

  private:
    UmatSource source;
    std::string found;             // the symbol's name
    std::shared_ptr<void> handle;  // of dlopen, closed with the last copy
    void (*function)() = nullptr;  // to be cast to the UMAT's type
};

}  // namespace element
