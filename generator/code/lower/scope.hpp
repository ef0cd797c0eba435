// SPDX-License-Identifier: GPL-2.0-or-later
// Everything that lowering a function depends on apart from the function: the robot, the names around it, and the
// language's needs.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "code/lower/joint_counts.hpp"
#include "code/lower/limbs.hpp"
#include "code/lower/schedule.hpp"
#include "code/statement.hpp"
#include "graph/rational.hpp"

namespace flatdyn {

// A multiple of an entry of q.
struct MultipleOfPosition {
  int position = 0;
  Rational factor;
};

// The needs of a language, and what it has, as far as the statements of its functions are concerned.
struct LanguageTraits {
  Lives lives = Lives::short_ones;  // which order of statements suits the target
  // Whether each sine and cosine is evaluated by itself, sin(q[2]). Otherwise a function reads all of them from arrays
  // "sine" and "cosine", by index of the angle; it either fills these arrays first, or they are its arguments.
  bool evaluates_sines = false;
  bool fills_sines = false;            // whether a function fills these arrays
  bool reads_parts = false;            // whether stored values are entries of outputs, read wherever they are used
  bool stores_zeros_together = false;  // whether zeros in entries that follow one another are stored by a helper
  bool has_lanes = false;              // whether there are vectors with a number of each limb
  // The number of lines that a function may have before it is written in parts, and the number of its lines outside the
  // body. Compilers optimise best if they see as much as possible.
  int longest_function = 4000;
  int lines_around_body = 4, lines_per_argument = 0;
};

// The number of lines of code when it is printed.
class TextLength {
 public:
  virtual ~TextLength() = default;
  virtual int lines_of(const code::Statement& statement) const = 0;
  virtual int lines_of(const code::Statements& statements) const = 0;
  virtual int lines_of(const code::Part& part) const = 0;
};

struct Scope {
  LanguageTraits language;
  JointCounts counts = 0;
  std::vector<MultipleOfPosition> angles;  // angles beyond those of q whose sines and cosines are needed
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

  std::size_t angle_count() const { return static_cast<std::size_t>(counts.positions) + angles.size(); }
};

}  // namespace flatdyn
