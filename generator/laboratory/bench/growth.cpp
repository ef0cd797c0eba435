// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/bench/growth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "base/system/temporary_folder.hpp"
#include "functions/planning/make_functions.hpp"
#include "laboratory/bench/errors.hpp"
#include "laboratory/bench/program.hpp"
#include "robot/model/random_robot.hpp"

namespace flatdyn {
namespace {

using Clock = std::chrono::steady_clock;

// A bound far above rounding errors and far below those of a wrong result.
constexpr double kRoundingBound = 1e6;
constexpr int kStates = 1024;

std::vector<int> sizes_up_to(int joints) {
  std::vector<int> sizes;
  for (int size = 2; size <= joints; size *= 2) sizes.push_back(size);
  return sizes;
}

struct Generated {
  std::vector<Function> functions;
  double seconds = 0;
};

Generated generated(const LoadedRobot& model, const std::string& function, Progress& progress) {
  PipelineOptions options;
  options.functions = {function};
  Diagnostics findings;
  const Clock::time_point start = Clock::now();
  const std::vector<OptimisedFunction> made = make_functions(model, options, progress, findings);
  return {functions_of(made), std::chrono::duration<double>(Clock::now() - start).count()};
}

GrowthRow measured(const LoadedRobot& model, const std::string& function, const Toolchain& toolchain, double seconds,
                   Progress& progress) {
  const Generated made = generated(model, function, progress);
  const ExpectedValues expected(model.robot, model.mechanism, 1);
  std::vector<State> states = random_states(model.mechanism, kStates, 1);
  for (State& state : states) state.pi_b.assign(static_cast<std::size_t>(made.functions[0].base_parameters), 1);
  const BenchSubject subject{model.mechanism,   made.functions, states, toolchain, {bench_variants().front()}, {},
                             expected.symbols()};
  const TemporaryFolder folder;
  progress.step(fmt::format("compiling and timing {} of {}", function, model.mechanism.name));
  const BenchProgram program(subject, folder.path());
  constexpr std::size_t kCompared = 3;
  const BenchErrors errors =
      bench_errors(subject, expected, program.cases(), program.values(kCompared), kCompared).front();
  if (!(errors.scaled.largest <= kRoundingBound)) {
    throw Failure(FailureKind::bug, fmt::format("{} of {} is wrong", function, model.mechanism.name));
  }
  const CompilerUsage compiler = program.compilation();
  return {model.mechanism.size(),
          count_operations(made.functions[0]),
          quartiles(program.times(seconds, 1).begin()->second),
          errors.scaled.largest,
          made.seconds,
          compiler.seconds,
          compiler.peak_kilobytes};
}

// The first row of the fit. The first joints of a robot move in fewer ways and cost less, so the exponents are fitted
// to the rest if there are enough rows.
int first_fitted(const std::vector<GrowthRow>& rows) {
  constexpr int kFirst = 8;
  const auto is_late = [](const GrowthRow& row) { return row.joints >= kFirst; };
  return std::count_if(rows.begin(), rows.end(), is_late) > 1 ? kFirst : rows.front().joints;
}

void fit(GrowthCurve& curve) {
  if (curve.rows.size() < 2) return;
  curve.fitted_from = first_fitted(curve.rows);
  std::vector<double> joints, operations, times;
  for (const GrowthRow& row : curve.rows) {
    if (row.joints < curve.fitted_from) continue;
    joints.push_back(row.joints);
    operations.push_back(row.operations.arithmetic());
    times.push_back(row.time.median);
  }
  curve.operation_exponent = fitted_exponent(joints, operations);
  curve.time_exponent = fitted_exponent(joints, times);
}

}  // namespace

GrowthReport bench_growth(const GrowthOptions& options, Progress& progress) {
  const Toolchain toolchain = find_toolchain();
  const std::vector<int> sizes = sizes_up_to(options.joints);
  const double seconds = options.seconds / static_cast<double>(2 * sizes.size() * options.functions.size());
  GrowthReport report{toolchain.version(), bench_flags(), {}};
  for (const bool chain : {true, false}) {
    for (const std::string& function : options.functions) {
      GrowthCurve curve{chain ? "chain" : "tree", function, {}};
      for (const int joints : sizes) {
        Robot robot = random_robot(chain, joints, options.seed);
        Mechanism mechanism = make_mechanism(robot);
        const LoadedRobot model{std::move(robot), std::move(mechanism), std::nullopt, {}, ""};
        curve.rows.push_back(measured(model, function, toolchain, seconds, progress));
      }
      fit(curve);
      report.curves.push_back(curve);
    }
  }
  return report;
}

}  // namespace flatdyn
