// SPDX-License-Identifier: GPL-2.0-or-later
// The choices that are free when functions are derived from a mechanism: the result is the same function, at another
// cost.
#pragma once

#include <functional>
#include <vector>

#include "derivation/kernel/frames.hpp"
#include "derivation/kernel/regroup.hpp"
#include "robot/model/equivalents.hpp"
#include "robot/model/inertia_bound.hpp"

namespace flatdyn {

struct JointChoice {
  Number axial_shift = 0;  // offset of the frame's origin along the joint's axis, m; rational
  JointGrouping grouping;
  Axes axes = Axes::turning;  // axes of the link's frame
};

// How a function checks the pivots of B (Function::pivot_scales, proven_pivot_share).
struct PivotGuard {
  bool compares = false;                   // whether pivots are compared with their scales
  double proven_share = 0;                 // without scales: the share of these that pivots are proven to keep
  std::vector<DiagonalBound> diagonals{};  // by entry of q; empty if unknown
};

struct Choices {
  std::vector<JointChoice> joints;  // one per joint
  Number length_unit = 1;           // m; rational
  unsigned order = 0;               // seed of the order in which the passes look for factors; 0: as derived
  PivotGuard guard{};               // the same in all choices
};

// The mechanism with these frames, and nothing else changed.
Mechanism with_shifted_frames(const Mechanism& mechanism, const Choices& choices);

// The mechanism with these frames, units and parameters.
Mechanism chosen(const Mechanism& mechanism, const Choices& choices);

// Choices with the same grouping for all joints, and nothing else changed.
Choices uniform_choices(const Mechanism& mechanism, Grouping grouping);

// The frames that stay still among those that can: none, those of links at the end of a branch, the others, or all.
enum class StillFrames { none, leaves, inner, all };
Choices with_still_frames(const Mechanism& mechanism, Choices choices, StillFrames which);
// These choices with each set of still frames other than their own.
std::vector<Choices> with_other_still_frames(const Mechanism& mechanism, const Choices& choices);

std::vector<Axes> axes_of(const Choices& choices);

// Other useful places for the origin of a revolute joint's frame, relative to its present one, m: where the parent
// needs fewer numbers to reach it, and where it needs fewer to reach its children. They are rational, each listed once.
std::vector<Number> possible_axial_shifts(const Mechanism& mechanism, int i);

// Useful units of length, m: distances between neighbouring frames, each of which becomes 1 in its unit; each listed
// once, the most frequent first. Empty if a joint is prismatic, as lengths are then not free.
std::vector<Number> possible_length_units(const Mechanism& mechanism);

// Choices with the same length unit and frames, with one grouping for all joints and no mass kept back to balance a
// moment.
std::vector<Choices> plain_variants(const Mechanism& mechanism, const Choices& choices);

// These choices with the first possible length unit, and with 1 m, unless they have it already.
std::vector<Choices> with_other_length_units(const Mechanism& mechanism, const Choices& choices);

// The choices from which functions are derived unless a search has found better ones: the cheapest of one grouping for
// all joints, then of still frames, a usual length unit, and balanced masses. `operations`: the number of operations of
// the function derived from some choices.
Choices cheapest_choices(const Mechanism& mechanism, const std::function<int(const Choices&)>& operations);

}  // namespace flatdyn
