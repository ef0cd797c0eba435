// SPDX-License-Identifier: GPL-2.0-or-later
// Emitted code with all that it was made from, and what its files have to hold by that.
#pragma once

#include <optional>
#include <vector>

#include "code/emit/emit_options.hpp"
#include "code/lower/stages.hpp"
#include "code/readback/file_contents.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

struct WrittenCode {
  const Mechanism& mechanism;              // that of the constants
  const std::vector<Function>& functions;  // the fused one last
  const std::optional<Stages>& stages;
  const EmitOptions& options;
  bool is_module = true;  // in JavaScript: exports names instead of returning them
};

// All functions of the text, members of stages included, in its order.
std::vector<Function> functions_in_text(const WrittenCode& code);

// Refers to the functions of `code`.
FileContents contents_of(const WrittenCode& code);

}  // namespace flatdyn
