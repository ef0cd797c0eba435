// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/casadi/language.hpp"

#include "code/languages/c/language.hpp"
#include "code/languages/casadi/file.hpp"
#include "code/languages/casadi/interface.hpp"
#include "code/languages/casadi/request.hpp"

namespace flatdyn {

LanguageRow casadi_language() {
  LanguageRow row = c_language();
  row.option = "casadi";
  row.name = "CasADi";
  row.description = "the C form with CasADi's interface for external functions, and their derivatives";
  row.more_endings = {"_casadi.c"};
  row.has_scalar = row.is_called_by_python = row.is_for_firmware = false;
  row.batch = nullptr;
  row.batch_reader = nullptr;
  row.functions_needed = functions_for_casadi;
  row.as_written = code_of_casadi_functions;
  row.more_files = casadi_files;
  return row;
}

}  // namespace flatdyn
