// SPDX-License-Identifier: GPL-2.0-or-later
// The coordinates of a tree of bodies: how q, and the entries of q̇, q̈ and τ, belong to its joints. A floating base,
// spherical joints, coupled joints and closed loops are its parts; robots that have none of them have one coordinate
// for each body, and an empty chart.
#pragma once

#include <cstddef>
#include <vector>

#include "robot/model/number.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// A multiple of an entry of q by which joints turn.
struct CoordinateMultiple {
  int position = 0;
  Number factor = 1;  // positive
};

// A closed loop that is not a linear coupling, cut where two points, and perhaps two axes, meet. Its constraint is
// Φ(q) = 0, where Φ has those of these components that the joints change: 0 to 2 are the displacement from the first
// point to the second, in the frame of the carrier; 3 and 4 are the cosines between the second end's axis and two
// directions across the first end's.
struct LoopClosure {
  static constexpr std::size_t kOfPoints = 3;
  struct End {
    int body = -1;  // -1: the base
    Vec3 p = zero_vector();
  };
  End ends[2];
  int carrier = -1;               // the body nearest to the ends that moves both of them; -1: the base
  Mat3 axes = identity_matrix();  // the axes of components 0 to 2, as columns, in the carrier's frame
  int components = kOfPoints;     // 5 if axes meet as well
  // e_1 and e_2 in the first end's body, which with its axis e_1 × e_2 are a frame; a in the second end's body, unit.
  Vec3 across[2] = {zero_vector(), zero_vector()};
  Vec3 axis = zero_vector();
  int sense = 0;                  // whether a is e_1 × e_2 (1) or its opposite (-1) as assembled; 0: not known
  std::vector<std::size_t> rows;  // the components that the joints change, in their order
  std::vector<int> dependent;     // entries of q that follow from the others; as many as rows

  // Whether its joints do not by themselves keep its axes parallel.
  bool aligns_axes() const { return !rows.empty() && rows.back() >= kOfPoints; }
};

struct Chart {
  // With coupled joints: the position of body i's joint is Σ_k coupling[i][k] q_k plus a constant that is part of the
  // frames. q_k belongs to the joint of body coordinates[k]. All are empty where q_i is the position of joint i. Rows
  // of a floating base are zero.
  std::vector<int> coordinates;
  Rows coupling;
  std::vector<Number> offsets;  // the constant part of each body's joint position, rad or m
  // Multiples of coordinates whose sines and cosines are needed, too: a joint turns by them, and they are not small
  // whole ones.
  std::vector<CoordinateMultiple> angles;

  // With closed loops: q has the positions of all joints that are not coupled; q̇, q̈ and τ are those of the
  // independent ones among them, after those of a floating base. Loops are in an order in which each finds all
  // positions that it depends on. The robot counts as coupled.
  std::vector<LoopClosure> loops;
  std::vector<int> independent;  // entries of q; empty: all

  // With a floating base, bodies 0 to 5 are its motion, and the last of them is the base link
  // (robot/model/floating_base.hpp). q has no entries of theirs; the first six of q̇, q̈ and τ are the base's.
  bool floating_base = false;

  // The first of the three bodies of each spherical joint (robot/model/spherical_joint.hpp), in order. q has four
  // entries of such a joint, q̇, q̈ and τ have three.
  std::vector<int> spherical;

  bool is_coupled() const { return !coupling.empty(); }
  bool has_loops() const { return !loops.empty(); }
  bool has_spherical_joints() const { return !spherical.empty(); }
  // Whether q̇ are velocities that are not all the derivatives of q: v and a are arguments instead of q̇ and q̈.
  bool has_quasi_velocities() const { return floating_base || has_spherical_joints(); }
  // Whether entries of q and of q̇, but for those of a base, differ in number.
  bool has_longer_positions() const { return has_loops() || has_spherical_joints(); }
  // Whether every entry of q is the position of one body's joint, and every entry of q̇ but a base's is its rate.
  bool is_joint_by_joint() const { return !is_coupled() && !has_spherical_joints(); }
  // The bodies, and the entries of q̇, that are the motion of a floating base.
  int base_bodies() const { return floating_base ? 6 : 0; }
  bool is_of_base(int body) const { return body < base_bodies(); }
  // The rate of each body's joint by the entries of q̇, where loops do not decide it: `coupling`, after the columns of a
  // floating base. Only of coupled joints.
  Rows rate_coupling() const;
};

}  // namespace flatdyn
