// SPDX-License-Identifier: GPL-2.0-or-later
// What may be chosen freely when functions are derived from a mechanism: the result is the same function, at another
// cost.
#pragma once

#include <functional>
#include <vector>

#include "model/equivalents.hpp"
#include "symbolic/kernel/frames.hpp"
#include "symbolic/kernel/regroup.hpp"

namespace flatdyn {

struct JointChoice {
  Number rise = 0;  // of the frame's origin along the joint's axis, m; rational
  JointGrouping grouping;
  Axes axes = Axes::turning;  // of the link's frame
};

struct Choices {
  std::vector<JointChoice> joints;  // one for each
  Number length_unit = 1;           // m; rational
  unsigned order = 0;               // in which the passes find what they may factor; 0: as derived
  bool guards_pivots = false;       // no choice: whether the robot's may be lost in rounding (Function::scales)
};

// The mechanism in these frames, and nothing else changed.
Mechanism in_raised_frames(const Mechanism& mechanism, const Choices& choices);

// The mechanism in these frames, units and parameters.
Mechanism chosen(const Mechanism& mechanism, const Choices& choices);

// The same for all joints, and nothing else changed.
Choices uniform_choices(const Mechanism& mechanism, Grouping grouping);

// Which of the frames that can be still are so: none, those of links at the end of a branch, the others, or all.
enum class StillFrames { none, leaves, inner, all };
Choices with_still_frames(const Mechanism& mechanism, Choices choices, StillFrames which);
// Each of these that is not what the choices are.
std::vector<Choices> with_other_still_frames(const Mechanism& mechanism, const Choices& choices);

std::vector<Axes> axes_of(const Choices& choices);

// Where else the origin of a revolute joint's frame might well be, relative to where it is, m: where its parent needs
// fewer numbers to reach it, and where it needs fewer to reach its children. Rational ones, none twice.
std::vector<Number> possible_rises(const Mechanism& mechanism, int i);

// Distances between neighbouring frames, one of which becomes 1 in that unit, m; none twice, the most frequent first.
// Empty if a joint is prismatic: lengths are not free.
std::vector<Number> possible_length_units(const Mechanism& mechanism);

// In the same length unit and frames, with one grouping for all joints and no mass kept back to balance a moment.
std::vector<Choices> plain_variants(const Mechanism& mechanism, const Choices& choices);

// In the first of these, and in 1 m, where the choices are not.
std::vector<Choices> with_other_length_units(const Mechanism& mechanism, const Choices& choices);

// What functions are derived from unless a search has found better ones: what costs least of one grouping for all
// joints, still frames, a usual length unit, and balanced masses, each tried after the other. `operations`: of the
// function derived from some choices.
Choices cheapest_choices(const Mechanism& mechanism, const std::function<int(const Choices&)>& operations);

}  // namespace flatdyn
