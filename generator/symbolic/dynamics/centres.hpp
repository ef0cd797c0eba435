// SPDX-License-Identifier: GPL-2.0-or-later
// Points where the axes of three or more successive revolute joints meet: shoulders and wrists. A joint feels of a
// wrench behind it only the moment about such a point, so all joints of one centre share that moment, and no velocities
// are needed. For two joints the moment costs more than the velocities.
#pragma once

#include <map>
#include <vector>

#include "symbolic/kernel/frames.hpp"

namespace flatdyn {

class Centres {
 public:
  explicit Centres(Frames& frames);

  // The centre that joint i's axis passes through, by a number; -1 for a prismatic joint and for a joint that shares
  // its centre with no other.
  int centre_of(int i) const { return centre_[static_cast<std::size_t>(i)]; }

  // From a centre to the origin of body j, in frame j, m. The centre's first joint must be j or between it and the
  // base.
  Vec3 lever(int centre, int j);

 private:
  void place(int i);

  Frames& frames_;
  std::vector<int> centre_;     // the first joint of the centre
  std::vector<Number> height_;  // where on joint i's axis its centre is: z in frame i, m
  std::map<std::pair<int, int>, Vec3> levers_;
};

}  // namespace flatdyn
