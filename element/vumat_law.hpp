// SPDX-License-Identifier: BSD-3-Clause
// Any law behind the VUMAT symbol of a shared library: Abaqus/Explicit's argument list, double
// precision, three-dimensional.
#pragma once

#include "element/library_law.hpp"

namespace element {

// A VUMAT has no tangent: it is taken from differences, for which the increment and six others beside
// it go to the library as one block. Its frame turns with the material, which the driver does not
// follow: increments with a rotation are refused. It has no PNEWDT either: only values that are not
// finite are known as a failure.
class VumatLaw : public LibraryLaw {
  public:
    // vumat_, VUMAT or vumat, looked up in this order. Throws BadCase.
    explicit VumatLaw(UmatSource source);

    Response advance(const MaterialPoint& start, const StrainIncrement& increment) const override;
};

}  // namespace element
