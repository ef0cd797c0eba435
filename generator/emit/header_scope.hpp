// SPDX-License-Identifier: GPL-2.0-or-later
// The context in the header that the text of a function depends on.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "emit/dialect.hpp"
#include "emit/limbs.hpp"
#include "graph/rational.hpp"

namespace flatdyn {

// A multiple of an entry of q.
struct MultipleOfPosition {
  int position = 0;
  Rational factor;
};

struct HeaderScope {
  explicit HeaderScope(const Dialect& language) : dialect(language) {}

  const Dialect& dialect;
  int joints = 0;                          // length of qd, or of v
  int positions = 0;                       // length of q
  std::vector<MultipleOfPosition> angles;  // angles beyond those of q whose sines and cosines are needed
  bool floating_base = false;              // whether the length of v is velocity_count
  bool spherical = false;                  // whether there are spherical joints
  bool fuses = false;                      // whether products and sums are fused multiply-adds
  int most_lines = 0;                      // limit of lines per function; 0: only that of compilers
  std::string proven_positions;            // where pivots are proven not to be lost: "at every position"
  std::vector<std::string> parameters;     // members of Parameters, by index of the free symbol
  std::set<std::string> names;             // taken at namespace scope
  std::string enclosing_stage;             // for a member function, the name of its stage,
  std::vector<std::string> stored;         // and the names of the stage's fields, by index
  std::string made;                        // for a function that makes a stage, the name of that stage,
  std::vector<std::string> fields;         // and the names of its fields
  std::vector<Limbs> limbs;                // that are computed together, a limb in each lane; empty: each by itself

  std::size_t angle_count() const { return static_cast<std::size_t>(positions) + angles.size(); }
};

}  // namespace flatdyn
