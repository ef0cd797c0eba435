// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "derivation/dynamics/task_rows.hpp"

namespace flatdyn::testing {

// The same mechanism with a task of one row, which leaves redundant joints: then every function can be derived.
inline Mechanism with_spare_joints(Mechanism mechanism) {
  mechanism.task.rows = {task_rows(mechanism).front()};
  return mechanism;
}

}  // namespace flatdyn::testing
