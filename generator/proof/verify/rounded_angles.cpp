// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/verify/rounded_angles.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "graph/count.hpp"

namespace flatdyn {
namespace {

constexpr const char* kInverseDynamics = "inverse_dynamics";

// The smallest of a few round tolerances that covers all of these angles.
const char* tolerance_for(const std::vector<Snap>& angles) {
  const bool all_near = std::all_of(angles.begin(), angles.end(), [](const Snap& angle) {
    return magnitude(angle.difference) <= magnitude(exact_decimal("1e-3"));
  });
  return all_near ? "1e-3" : "2e-3";
}

// The number of additions and multiplications of inverse dynamics if the angles are snapped to multiples of pi/12.
std::optional<int> operations_with(const char* tolerance, const LoadedRobot& model, PipelineOptions options) {
  options.read.snap_tolerance = exact_decimal(tolerance);
  options.functions = {kInverseDynamics};
  options.search.reset();
  Progress silent(true);
  Diagnostics ignored;
  try {
    const LoadedRobot other = load_robot(model.robot.file, options);
    return count_operations(make_functions(other, options, silent, ignored).front().function).arithmetic();
  } catch (const Failure&) {
    return std::nullopt;  // that robot has other problems, so no saving is stated
  }
}

std::string saving(const char* tolerance, const LoadedRobot& model, const PipelineOptions& options,
                   const std::vector<OptimisedFunction>& functions) {
  constexpr int kMostBodies = 12;
  const auto made = std::find_if(functions.begin(), functions.end(),
                                 [](const OptimisedFunction& each) { return each.function.name == kInverseDynamics; });
  if (made == functions.end() || model.mechanism.body_count() > kMostBodies) return "";
  const int now = count_operations(made->function).arithmetic();
  const std::optional<int> then = operations_with(tolerance, model, options);
  if (!then || *then >= now) return "";
  return fmt::format("; with these, inverse dynamics take {} operations instead of {}", *then, now);
}

}  // namespace

void note_rounded_angles(const LoadedRobot& model, const PipelineOptions& options,
                         const std::vector<OptimisedFunction>& functions, Diagnostics& findings) {
  const std::vector<Snap>& angles = model.robot.rounded_angles;
  if (angles.empty()) return;
  const Snap& first = angles.front();
  const std::size_t others = angles.size() - 1;
  const std::string and_others =
      others == 0 ? "" : fmt::format(" and {} other angle{}", others, others == 1 ? "" : "s");
  const char* const tolerance = tolerance_for(angles);
  findings.note(first.place,
                fmt::format("{}: {}{} may stand for {} of pi/12, rounded{}", first.what, first.written, and_others,
                            others == 0 ? "a multiple" : "multiples", saving(tolerance, model, options, functions)),
                fmt::format("if so, write more digits, or --snap {}", tolerance));
}

}  // namespace flatdyn
