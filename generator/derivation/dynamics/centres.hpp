// SPDX-License-Identifier: GPL-2.0-or-later
// Centres: points where the axes of three or more successive revolute joints meet, as in shoulders and wrists. The
// torque of a joint depends only on a wrench's moment about such a point, so all joints of one centre share that
// moment, and no velocities are needed. For two joints the moment would cost more than the velocities.
#pragma once

#include <map>
#include <vector>

#include "derivation/kernel/frames.hpp"

namespace flatdyn {

class Centres {
 public:
  explicit Centres(Frames& frames);

  // The number of the centre on joint i's axis; -1 for a prismatic joint and for a joint that shares its centre with no
  // other.
  int centre_of(int i) const { return centre_[static_cast<std::size_t>(i)]; }

  // The displacement from a centre to the origin of body j, in frame j, m. The centre's first joint must be j or
  // between it and the base.
  Vec3 lever(int centre, int j);

 private:
  void place(int i);

  Frames& frames_;
  std::vector<int> centre_;     // by joint: the first joint of its centre
  std::vector<Number> height_;  // by joint i: z of its centre in frame i, m
  std::map<std::pair<int, int>, Vec3> levers_;
};

}  // namespace flatdyn
