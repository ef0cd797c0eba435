// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/load/bad_input.hpp"

namespace flatdyn {

FailureKind kind_of(const Diagnostics& errors) {
  if (errors.only_on_command_line()) return FailureKind::usage;
  return errors.only_unsupported() ? FailureKind::unsupported : FailureKind::input;
}

void refuse_errors(const Diagnostics& found) {
  if (found.has_errors()) throw BadInput(kind_of(found), found);
}

}  // namespace flatdyn
