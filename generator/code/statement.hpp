// SPDX-License-Identifier: GPL-2.0-or-later
// The statements of emitted functions, before any language.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "code/expression.hpp"

namespace flatdyn::code {

// Constants of the function, which belong together for a reader.
struct Define {
  struct Constant {
    std::string name;
    Expression value;
  };
  std::vector<Constant> constants;
};

// Arrays, and single numbers, that are filled later.
struct Declare {
  struct Array {
    std::string name;
    std::optional<std::size_t> length;  // nullopt: a single number
    std::string count{};                // the constant that is the length: "joint_count"; empty: its digits are written
  };
  std::vector<Array> arrays;
};

// The structure that a function makes and returns.
struct DeclareStage {
  std::string type, name;
};

// The value is stored in all places.
using Place = std::variant<Element, Number, Field>;
struct Store {
  std::vector<Place> places;
  Expression value;
};

// Zeros are stored in the entries of an array from `first` to before `end`.
struct StoreZeros {
  std::string array;
  std::size_t first = 0, end = 0;
};

// The arrays of sines and cosines are filled for the angles of these indices in an array.
inline constexpr const char *kSines = "sine", *kCosines = "cosine", *kAngles = "angle";
struct FillSines {
  std::string array;
  std::set<int> angles{};
  std::string sines = kSines, cosines = kCosines;
  // Whether the function has computed the angles, so that no caller can have given their sines.
  bool is_computed = false;
};

// The variable of a function's verdict, and the counter of loops.
inline constexpr const char *kValid = "valid", *kCounter = "k";

// An argument that the function does not read.
struct Ignore {
  std::string name;
};

// A condition that must hold for a result to mean something.
struct Always {};
struct Positive {
  Expression value;
};
struct Finite {
  Element entry;
};
using Condition = std::variant<Always, Positive, Finite>;

// The condition is part of the function's verdict; `is_first`: the verdict begins with it.
struct Check {
  bool is_first = false;
  Condition condition;
};

// All entries from `first` to before `end` are finite.
struct CheckFinite {
  std::string array;
  std::size_t first = 0, end = 0;
};

// All entries are positive.
struct CheckPositive {
  std::string array;
  std::size_t length = 0;
};

// An argument of a function.
struct Argument {
  enum class Role { parameters, stage, input, output, number, made_stage } role = Role::input;
  std::string name;
  std::size_t length = 0;  // of an array
  std::string stage{};     // the type of a stage
  bool is_local = false;   // in a call: whether the caller declares the array
};

// A function of the same file is called. `by_part`: by another such function, otherwise by the robot's function.
// `is_returned`: the caller returns what it returns.
struct CallPart {
  std::string name;
  std::vector<Argument> arguments;
  bool by_part = false, is_returned = false;
};

// The function returns a value, or its verdict.
struct Return {
  std::optional<Expression> value;  // nullopt: the verdict
};

// The type of vectors with a number of each limb, of so many lanes, is introduced.
struct UseLanes {
  int lanes = 0;
};
// A vector is put together from numbers, one for each lane.
struct Gather {
  int lanes = 0;
  std::string name;
  std::vector<Expression> numbers;
};
// A vector is computed, the same expression in all lanes.
struct DefineLanes {
  int lanes = 0;
  std::string name;
  Expression value;
};

using Statement = std::variant<Define, Declare, DeclareStage, Store, StoreZeros, FillSines, Check, CheckFinite,
                               CheckPositive, CallPart, Return, Ignore, UseLanes, Gather, DefineLanes>;
using Statements = std::vector<Statement>;

// A function that only functions of the same file call.
struct Part {
  std::string name;
  std::vector<Argument> arguments;
  Statements statements;
};

}  // namespace flatdyn::code
