// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/exchanged_limits.hpp"

#include <fmt/format.h>

#include "robot/model/exact_sign.hpp"

namespace flatdyn {

void remove_exchanged_limits(Joint& joint, Diagnostics& diagnostics) {
  std::optional<Value>&lower = joint.limits.lower, &upper = joint.limits.upper;
  if (!lower || !upper || !is_below(upper->number, lower->number)) return;
  if (vanishes(lower->number - 1) && vanishes(upper->number)) return;
  diagnostics.note(lower->place,
                   fmt::format("joint \"{}\": the lower limit ({:.6g}) is above the upper one ({:.6g}), which is no "
                               "limit in Bullet and ODE: lower and upper are taken as not given",
                               joint.name, nearest_double(lower->number), nearest_double(upper->number)),
                   "leave both out; if there are limits, write the lower one first",
                   "joints whose lower limit is above the upper one, which are taken as not given");
  lower.reset();
  upper.reset();
}

}  // namespace flatdyn
