// SPDX-License-Identifier: BSD-3-Clause
// The scalar of reference values.
#pragma once

#include <Eigen/Core>

#include "flatdyn/reference/mpfr_real.hpp"

namespace flatdyn::reference {

// The type for "50 digits", which carries 60.
using Real50 = MpfrReal<201>;

}  // namespace flatdyn::reference

namespace Eigen {

template <int kBits>
struct NumTraits<flatdyn::reference::MpfrReal<kBits>> : GenericNumTraits<flatdyn::reference::MpfrReal<kBits>> {
  using Real = flatdyn::reference::MpfrReal<kBits>;
  using NonInteger = Real;
  using Literal = double;
  using Nested = Real;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 1,
    AddCost = 4,
    MulCost = 8
  };
  static Real dummy_precision() { return 1000 * std::numeric_limits<Real>::epsilon(); }
};

// Products and sums with double.
template <int kBits, class Operation>
struct ScalarBinaryOpTraits<flatdyn::reference::MpfrReal<kBits>, double, Operation> {
  using ReturnType = flatdyn::reference::MpfrReal<kBits>;
};
template <int kBits, class Operation>
struct ScalarBinaryOpTraits<double, flatdyn::reference::MpfrReal<kBits>, Operation> {
  using ReturnType = flatdyn::reference::MpfrReal<kBits>;
};

}  // namespace Eigen
