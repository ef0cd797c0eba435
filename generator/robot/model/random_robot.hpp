// SPDX-License-Identifier: GPL-2.0-or-later
// Random robots and parts in exact numbers, the same on every machine.
#pragma once

#include <random>
#include <string>

#include "robot/model/robot.hpp"

namespace flatdyn {

// Random whole multiples of 1/100.
class RandomHundredths {
 public:
  explicit RandomHundredths(unsigned seed) : engine_(seed) {}

  Number between(int low, int high) { return GiNaC::numeric(integer(low, high), 100); }
  int integer(int low, int high) { return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1)); }
  Number any() { return between(-99, 99); }
  Vec3 vector() {
    const Number x = any(), y = any(), z = any();
    return {x, y, z};
  }

 private:
  std::mt19937 engine_;
};

// A body of point masses, so that its inertia is physically possible.
Link random_link(RandomHundredths& draw, const std::string& name);

// A revolute joint about a skew axis, at the end of a skew arm.
Joint random_joint(RandomHundredths& draw, const std::string& name, int parent, int child);

// A chain, or a tree in which every link carries two others, of such joints and links.
Robot random_robot(bool chain, int joints, unsigned seed);

}  // namespace flatdyn
