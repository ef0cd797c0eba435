// SPDX-License-Identifier: GPL-2.0-or-later
// The model in closed form, by Lagrange, for people to read and as the definition for small robots. It has polynomials
// in s_i = sin q_i, c_i = cos q_i, d_i and the free symbols, expanded, with s_i² replaced by 1 - c_i², so that equal
// functions are equal expressions. Of a spherical joint they have the quaternion (w, x, y, z), with w² replaced by
// 1 - x² - y² - z², and of a floating base gravity in its axes.
#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "robot/model/mechanism.hpp"

namespace flatdyn {

// The coefficients of products v_i v_j, i <= j, that are not zero.
using VelocityProducts = std::map<std::pair<int, int>, Number>;

struct ClosedForm {
  using Quaternion = std::array<GiNaC::symbol, 4>;

  std::vector<int> joints;              // joints_of_entries()
  std::vector<GiNaC::symbol> d;         // one per joint, for prismatic ones
  std::vector<GiNaC::symbol> c, s;      // one of each per angle: those of revolute joints, and Mechanism::angles
  std::vector<Quaternion> quaternions;  // one per spherical joint: w, x, y, z
  std::vector<GiNaC::symbol> g_b;       // x, y, z of gravity in base axes if the base floats and there is any
  Rows B;                               // (7.32)
  Rows c_ijk;                           // [i][k (k + 1) / 2 + j], j <= k, (7.45); none with quasi-velocities
  std::vector<VelocityProducts> h;      // of every equation, with quasi-velocities: velocity_terms.hpp
  std::vector<Number> g;                // (7.39)

  int size() const { return static_cast<int>(g.size()); }
  const Number& christoffel(int i, int j, int k) const;
};

// The index of a joint as an index of vectors.
inline std::size_t at(int i) { return static_cast<std::size_t>(i); }

// The number of joints, in which a spherical one counts once. With coupled joints: of those that have an entry of q.
int joint_count(const Mechanism& mechanism);

// The joint that each entry of q̇ belongs to, counted in that way from 0; -1 for the motion of a floating base.
std::vector<int> joints_of_entries(const Mechanism& mechanism);

// The terms of B beyond which those in products of quasi-velocities, ten times as many, would take minutes.
inline constexpr std::size_t kMostTermsOfInertia = 100'000;

// B, the Christoffel symbols or what takes their place, and g of the mechanism, expanded. The mechanism must not have
// closed loops. Throws Failure(unsupported) where B has more than `most_terms` terms and there are quasi-velocities.
ClosedForm closed_form(const Mechanism& mechanism, std::size_t most_terms = kMostTermsOfInertia);

// Replaces sin(x)² by 1 - cos(x)² everywhere and expands, for the joints' s_i and c_i and for angles that are free
// symbols, and w² of quaternions by 1 - x² - y² - z².
Number reduced(const Number& expression, const ClosedForm& form);

}  // namespace flatdyn
