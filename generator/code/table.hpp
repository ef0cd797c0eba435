// SPDX-License-Identifier: GPL-2.0-or-later
// Tables of constants that a file has in addition to its functions, independent of the language.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "graph/rational.hpp"

namespace flatdyn::code {

// A limit that is not given: minus or plus infinity.
struct Infinity {
  bool is_negative = false;
};

struct Flag {
  bool is_set = false;
};

using TableEntry = std::variant<std::string, Rational, Infinity, int, Flag>;

struct Table {
  enum class Type { text, real, whole, flag } type = Type::real;
  std::string name;    // as it is emitted
  std::string length;  // "joint_count", "49"
  std::vector<TableEntry> entries;
  int row = 0;  // entries per line; 0: as many as fit
};

}  // namespace flatdyn::code
