// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/code_size.hpp"

#include <fmt/format.h>

#include "code/languages/language_table.hpp"

namespace flatdyn {

int code_bytes(const OperationCount& operations, int written_entries) {
  constexpr int kPerOperation = 9, kPerEntry = 10;
  return kPerOperation * operations.arithmetic() + kPerEntry * written_entries;
}

int code_bytes(const Function& function) {
  return code_bytes(count_operations(function), count_written_entries(function));
}

std::string describe_code_size(const std::vector<OptimisedFunction>& functions, const EmitOptions& options) {
  if (!language_row(options.language).is_compiled_by_host) return "";
  std::string large;
  for (const OptimisedFunction& each : functions) {
    const int bytes = code_bytes(each.function);
    if (bytes <= kInstructionCache) continue;
    large += fmt::format("{}{} (some {} KiB)", large.empty() ? "" : ", ", each.function.name, (bytes + 512) / 1024);
  }
  if (large.empty()) return "";
  return "larger than the 32 KiB of machine code that most processors keep at hand, so that single calls are slower "
         "and "
         "batches gain more: " +
         large + "\n\n";
}

}  // namespace flatdyn
