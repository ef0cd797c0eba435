// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/load/bad_input.hpp"

namespace flatdyn {

ExitCode exit_code_of(const Diagnostics& errors) {
  if (errors.only_on_command_line()) return ExitCode::usage;
  return errors.only_unsupported() ? ExitCode::unsupported : ExitCode::input;
}

void refuse_errors(const Diagnostics& found) {
  if (found.has_errors()) throw BadInput(exit_code_of(found), found);
}

}  // namespace flatdyn
