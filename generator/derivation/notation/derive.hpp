// SPDX-License-Identifier: GPL-2.0-or-later
// The model in closed form as people write it: B, the Christoffel symbols, g and the equations of motion. With a
// floating base or spherical joints, the coefficients of products of velocities take the place of Christoffel symbols.
#pragma once

#include <string>
#include <vector>

#include "derivation/notation/motion_names.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

struct DeriveOptions {
  int max_terms = 200;        // a longer expression is left out, and its number of terms given instead
  int digits = kExactDigits;  // digits that numbers are rounded to; none by default
};

// A name like "b_12 = b_21" and its expression. For an equation of motion: the torque's name and the left side.
struct DerivedLine {
  std::string name;
  std::string text;
  int terms = 0;          // terms of the expression
  bool left_out = false;  // then `text` says so
};

struct DerivedModel {
  // Whether velocities are not all rates of coordinates. Then there are `entries`, `conventions` and `velocity_terms`,
  // and neither `shared` nor `christoffel`.
  bool has_quasi_velocities = false;
  std::vector<std::string> conventions;     // frames, order and units of all names
  std::vector<EntryNames> entries;          // by row of B
  std::vector<DerivedLine> joints;          // q_i, or the quaternion, and the joint's name and type
  std::vector<std::string> coupled;         // "theta_2 = q_2 - q_1": joints that follow others
  std::vector<DerivedLine> inertia;         // b_ij for i <= j
  std::vector<DerivedLine> shared;          // h = …, where several Christoffel symbols share a value
  std::vector<DerivedLine> christoffel;     // those that are not zero
  std::vector<DerivedLine> velocity_terms;  // h_kij of h_k = Σ h_kij v_i v_j over i <= j, those that are not zero
  std::vector<DerivedLine> gravity;
  std::vector<DerivedLine> equations;  // (7.42) without tip force
  std::vector<std::string> notes;      // about notation, rounding, and what was left out
};

// Throws Failure(unsupported) for a chain so long that its closed form would be useless.
DerivedModel derive_model(const Mechanism& mechanism, const DeriveOptions& options, Notation notation);

// The model in closed form as text, or in LaTeX. Throws as derive_model does.
std::string derive_text(const Mechanism& mechanism, const DeriveOptions& options = {});
std::string derive_latex(const Mechanism& mechanism, const DeriveOptions& options = {});

}  // namespace flatdyn
