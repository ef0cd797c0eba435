// SPDX-License-Identifier: BSD-3-Clause
// The scalar of reference values.
#pragma once

#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/mpfr.hpp>

namespace flatdyn::reference {

// What "50 digits" are: a few more are carried. Rounded correctly by MPFR, its sines and cosines too.
using Real50 =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<60, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;

}  // namespace flatdyn::reference
