// SPDX-License-Identifier: GPL-2.0-or-later
// The parts of emitted text outside of function bodies.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "code/readback/emitted_text.hpp"

namespace flatdyn {

struct ScannedText {
  std::vector<ScannedFunction> functions;                  // the robot's functions, in order
  std::map<std::string, ScannedFunction> parts;            // parts that only these call, by name
  std::map<std::string, std::vector<std::string>> fields;  // fields of structs, by name
  std::map<std::string, ScannedCount> counts;              // by the names of EmittedText::count()
  std::string lanes;                                       // in C: the type of vectors; empty if there is none
};

// Notes a count, if its name is "joint_count", "ARM_JOINT_COUNT" or the like.
void note_count(const std::string& name, const std::string& value, ScannedText& found);

// Whether a function of the text is not one of the robot's formulas: rounding_is_as_written, text_hash,
// and close_loops, which calls the robot's functions in a loop.
inline bool is_helper_function(const std::string& name) {
  return name.ends_with("rounding_is_as_written") || name.ends_with("close_loops") || name.ends_with("text_hash");
}

}  // namespace flatdyn
