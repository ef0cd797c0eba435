// SPDX-License-Identifier: BSD-3-Clause
// The scalar of reference values.
#pragma once

#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/mpfr.hpp>

namespace flatdyn::reference {

// The type for "50 digits", which carries a few more. MPFR rounds it correctly, sines and cosines included.
using Real50 =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<60, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;

}  // namespace flatdyn::reference
