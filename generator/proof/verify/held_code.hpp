// SPDX-License-Identifier: GPL-2.0-or-later
// Code that a user holds, such as a vendored header, compared with the code that its robot has. A function is the
// robot's if its statements are those that are written here, which are proven, or if they compute the same in exact
// arithmetic. Everything around the functions has to be what is written here.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "code/readback/emitted_text.hpp"
#include "proof/verify/text_difference.hpp"
#include "proof/verify/written_code.hpp"

namespace flatdyn {

enum class HeldVerdict {
  same,        // the statements are the same
  equal,       // other statements, which compute the same
  different,   // they compute something else
  unreadable,  // they are no statements of emitted code
  missing,     // the held text has no such function
  unknown,     // the robot has no such function
};

struct HeldFunction {
  std::string name;  // "gravity", "Motion::bias"
  HeldVerdict verdict = HeldVerdict::same;
  std::string reason{};  // "2 of 7 entries differ: tau[0], tau[3]"
  int line = 0;          // in the held text; 0: it is not there

  bool is_right() const { return verdict == HeldVerdict::same || verdict == HeldVerdict::equal; }
};

struct HeldReport {
  std::vector<HeldFunction> functions;
  std::vector<TextDifference> differences;  // but those in functions that compute the same, by line
  bool is_only_first = false;               // whether differences were too many to list them all
  std::string unreadable{};                 // why the text could not be divided into functions; empty: it could
  int unreadable_line = 0;

  bool passed() const;
};

// Compares a text, a header followed by its source if there is one, with the code `own`, which is what emit_code()
// writes of `code`, proven and read back.
HeldReport compare_held(const std::string& held, const EmittedText& own, const WrittenCode& code, std::uint64_t seed);

}  // namespace flatdyn
