// SPDX-License-Identifier: GPL-2.0-or-later
// The failure of reading a text that the emitter cannot have written. Of text that was just emitted it is a bug; of a
// text that a user holds (proof/verify/held_code.hpp) it is a finding at a line.
#pragma once

#include <string>

#include "base/diagnostics/diagnostics.hpp"

namespace flatdyn {

class UnreadableText : public Failure {
 public:
  UnreadableText(int line, const std::string& what_is_wrong)
      : Failure(FailureKind::bug,
                "emitted text cannot be read back: line " + std::to_string(line) + ": " + what_is_wrong),
        line_(line),
        what_is_wrong_(what_is_wrong) {}
  int line() const { return line_; }
  const std::string& what_is_wrong() const { return what_is_wrong_; }

 private:
  int line_;
  std::string what_is_wrong_;
};

}  // namespace flatdyn
