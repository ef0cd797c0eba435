// SPDX-License-Identifier: GPL-2.0-or-later
#include "verify/verify.hpp"

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "diagnostics/table.hpp"
#include "report/budget_report.hpp"
#include "verify/exact.hpp"

namespace flatdyn {
namespace {

// Samples are compared in double.
constexpr double kSampleRounding = 1e-9;

struct VerifyArguments : RobotArguments {
  std::vector<std::string> functions;
  VerifyOptions options;
};

// The reference knows the whole model only. An abbreviated one is compared with its own Lagrangian, exactly, and its
// torques with those of the whole.
ExitCode verify_abbreviated(const VerifyArguments& arguments, const Model& model,
                            const std::vector<Function>& functions) {
  const GivenUp seen = sampled(model);
  bool passed = true;
  nlohmann::ordered_json exactly = nlohmann::ordered_json::object();
  std::vector<std::vector<std::string>> rows = {{"function", "exactly, the abbreviated model"}};
  for (const Function& function : functions) {
    const ExactResult result = prove_exactly(derived_from(model), function);
    passed = passed && result.equal;
    exactly[function.name] = result.summary();
    rows.push_back({function.name, result.equal ? "equal" : result.summary()});
  }
  for (std::size_t i = 0; i < seen.largest.size(); ++i) {
    passed =
        passed && seen.largest[i] <= model.abbreviation->bound[i] + kSampleRounding * model.abbreviation->budget[i];
  }
  if (arguments.json) {
    const nlohmann::ordered_json all = {
        {"passed", passed}, {"exactly", exactly}, {"error_budget", abbreviation_json(model, seen)}};
    fmt::print("{}\n", all.dump(2));
  } else {
    fmt::print("{}\n{}", aligned_table(rows), describe_abbreviation(model, seen));
  }
  return passed ? ExitCode::ok : ExitCode::verification_failed;
}

ExitCode run_verify(const VerifyArguments& arguments) {
  PipelineOptions options = arguments.RobotArguments::options();
  options.functions = arguments.functions;
  const Model model = read_model(arguments.robot, options);
  print_diagnostics(model.diagnostics, arguments.quiet);
  VerifyReport report;
  Diagnostics findings;
  {
    Progress progress(arguments.quiet);
    const std::vector<Function> functions = functions_of(make_functions(model, options, progress, findings));
    if (model.abbreviation) return verify_abbreviated(arguments, model, functions);
    report = verify(model.robot, model.mechanism, functions, arguments.options, progress);
  }
  print_diagnostics(findings, arguments.quiet);
  fmt::print("{}\n", arguments.json ? to_json(report).dump(2) : to_text(report));
  return report.passed() ? ExitCode::ok : ExitCode::verification_failed;
}

}  // namespace

Run add_verify(CLI::App& app) {
  auto* command =
      app.add_subcommand("verify",
                         "Compare every generated function with the Lagrangian, exactly, and with the "
                         "recursive Newton-Euler reference.\n\n"
                         "  flatdyn verify robots/panda.urdf\n"
                         "  flatdyn verify robots/puma560.toml --functions inverse_dynamics --states 1000 --json");
  const auto arguments = std::make_shared<VerifyArguments>();
  arguments->add_to(*command);
  add_functions_option(*command, arguments->functions);
  add_error_budget_option(*command, *arguments);
  command->add_option("--states", arguments->options.states, "random states")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000000));
  command->add_option("--seed", arguments->options.seed, "of the random states")->capture_default_str();
  command->add_option("--bound", arguments->options.bound, "largest scaled error allowed in double")
      ->check(positive_number())
      ->capture_default_str();
  return [arguments] { return run_verify(*arguments); };
}

}  // namespace flatdyn
