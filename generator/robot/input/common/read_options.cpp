// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/read_options.hpp"

namespace flatdyn {

Number dust_part(const ReadOptions& options) {
  const GiNaC::numeric tolerance = magnitude(options.snap_tolerance), usual = magnitude(exact_decimal("1e-9"));
  return tolerance < usual ? tolerance : usual;
}

}  // namespace flatdyn
