// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <utility>

#include "base/diagnostics/diagnostics.hpp"

namespace flatdyn {

// Errors in the user's input: a robot file, a scene, or options. The caller that catches it prints the diagnostics.
class BadInput : public Failure {
 public:
  BadInput(FailureKind kind, Diagnostics found)
      : Failure(kind, "the robot file has errors"), diagnostics(std::move(found)) {}
  Diagnostics diagnostics;
};

// The kind of these errors: usage, unsupported or input.
FailureKind kind_of(const Diagnostics& errors);

// Throws BadInput if there are errors among the findings.
void refuse_errors(const Diagnostics& found);

}  // namespace flatdyn
