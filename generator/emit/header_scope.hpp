// SPDX-License-Identifier: GPL-2.0-or-later
// What the text of one function takes from the rest of its header.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "emit/dialect.hpp"
#include "graph/rational.hpp"

namespace flatdyn {

// A multiple of an entry of q.
struct MultipleOfPosition {
  int position = 0;
  Rational factor;
};

struct HeaderScope {
  Dialect dialect;
  int joints = 0;                          // length of qd
  int positions = 0;                       // of q
  std::vector<MultipleOfPosition> angles;  // whose sines and cosines are asked for, beyond those of q
  int most_lines = 0;                      // of a function; 0: no limit but that of compilers
  std::vector<std::string> parameters;     // members of Parameters, by index of the free symbol
  std::set<std::string> names;             // taken at namespace scope
  std::string enclosing_stage;             // the stage whose member a function is, if it is one: its name,
  std::vector<std::string> stored;         // and those of its fields, by index
  std::string made;                        // the stage that a function makes, if it does: its name,
  std::vector<std::string> fields;         // and those of its fields
  std::vector<std::string> compiled;       // C++ in header and source: the scalars that the source is compiled for

  std::size_t angle_count() const { return static_cast<std::size_t>(positions) + angles.size(); }
};

}  // namespace flatdyn
