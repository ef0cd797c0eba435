// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/compile_time.hpp"

#include <fmt/format.h>

#include "code/languages/language_table.hpp"
#include "graph/count.hpp"
#include "report/describe.hpp"

namespace flatdyn {
namespace {

constexpr double kSecondsPerOperation = 1.5e-4, kSecondsPerEntry = 4e-4;
constexpr double kInstancesPerScalar = 2;  // of a pair: with sines of its own, and with given ones
constexpr double kWorthALine = 3;          // s

// Where the time is spent, and what saves it.
std::string place_of(const EmitOptions& options) {
  if (!language_row(options.language).is_one_file()) return "once, in its source";
  if (options.form == Form::pair) return "once, in the source of the pair";
  return "in each file that calls all of it; --form pair compiles it once";
}

}  // namespace

double compile_seconds(const Function& function) {
  return kSecondsPerOperation * count_operations(function).arithmetic() +
         kSecondsPerEntry * count_written_entries(function);
}

std::string describe_compile_time(const std::vector<OptimisedFunction>& functions, const std::optional<Stages>& stages,
                                  const EmitOptions& options) {
  if (!language_row(options.language).is_compiled_by_host) return "";
  double seconds = 0;
  if (stages) {
    for (const StagePiece& piece : stage_pieces(*stages)) seconds += compile_seconds(*piece.function);
  }
  for (const OptimisedFunction& each : functions) seconds += compile_seconds(each.function);
  if (options.form == Form::pair) seconds *= kInstancesPerScalar * (1.0 + double(options.more_scalars.size()));
  if (seconds < kWorthALine) return "";
  return fmt::format("compiling all of it takes some {:.0f} s of a processor at -O2, {}\n\n", seconds,
                     place_of(options));
}

}  // namespace flatdyn
