// SPDX-License-Identifier: BSD-3-Clause
#include "element/law.hpp"

#include "element/errors.hpp"

namespace element {
namespace {

[[noreturn]] void refuse() { throw BadCase("this law has no derivatives by its parameters"); }

}  // namespace

Response Law::differentiate(const MaterialPoint&, const StrainIncrement&, const Directions&,
                            const Matrix6X&, PointSlopes&) const {
    refuse();
}

ObservedSlopes Law::observe(const MaterialPoint&, const PointSlopes&) const { refuse(); }

}  // namespace element
