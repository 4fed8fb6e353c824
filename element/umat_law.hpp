// SPDX-License-Identifier: BSD-3-Clause
// Any law behind the UMAT symbol of a shared library: Abaqus' Fortran argument list, NTENS 6.
#pragma once

#include "element/library_law.hpp"

namespace element {

// The library sees copies: what it writes to DSTRAN, PROPS or any other input stays its own affair,
// and writing beyond STRESS, STATEV, DDSDDE or PROPS is noticed and refused. PNEWDT < 1 on return
// means a failed increment. STRESS has been rotated before the call, as Abaqus/Standard does.
class UmatLaw : public LibraryLaw {
  public:
    // umat_, UMAT or umat, looked up in this order. Throws BadCase where the library or the symbol
    // cannot be found.
    explicit UmatLaw(UmatSource source);

    Response advance(const MaterialPoint& start, const StrainIncrement& increment) const override;
};

}  // namespace element
