// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/code_size.hpp"

#include <fmt/format.h>

#include "code/languages/language_table.hpp"

namespace flatdyn {
namespace {

constexpr int kKibibyte = 1024, kInstructionCache = 32 * kKibibyte;

}  // namespace

int code_bytes(const OperationCount& operations, int written_entries, int written_zeros) {
  constexpr int kPerOperation = 9, kPerEntry = 10, kPerZero = 2;
  return kPerOperation * operations.arithmetic() + kPerEntry * (written_entries - written_zeros) +
         kPerZero * written_zeros;
}

int code_bytes(const Function& function) {
  return code_bytes(count_operations(function), count_written_entries(function), count_written_zeros(function));
}

std::string describe_code_size(const std::vector<OptimisedFunction>& functions, const EmitOptions& options,
                               bool has_limbs) {
  const LanguageRow& language = language_row(options.language);
  if (!language.is_compiled_by_host) return "";
  std::string large;
  for (const OptimisedFunction& each : functions) {
    const int bytes = code_bytes(each.function);
    if (bytes <= kInstructionCache) continue;
    large += fmt::format("{}{} (some {} KiB)", large.empty() ? "" : ", ", each.function.name,
                         (bytes + kKibibyte / 2) / kKibibyte);
  }
  if (large.empty()) return "";
  const bool suggests_lanes = has_limbs && language.has_lanes && !options.limbs_in_lanes && !options.fuses;
  return "larger than 32 KiB of machine code, which is what most processors keep at hand, so that single calls are "
         "slowed down: " +
         large + (suggests_lanes ? "; --limbs lanes makes those shorter that compute limbs" : "") +
         (options.limbs_in_lanes ? ", before limbs are computed together" : "") + "\n\n";
}

}  // namespace flatdyn
