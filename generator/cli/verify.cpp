// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/verify/verify.hpp"

#include <fmt/format.h>

#include "cli/held_header.hpp"
#include "report/budget_report.hpp"
#include "report/json_text.hpp"

namespace flatdyn {
namespace {

struct VerifyArguments : OptionsGiven {
  std::string header;  // empty: functions are verified that are made anew
  VerifyOptions options;
};

ExitCode verify_part(const VerifyArguments& arguments, const LoadedRobot& model,
                     const std::vector<Function>& functions) {
  const AbbreviationReport report =
      verify_abbreviated(model.mechanism, *model.abbreviation, functions, model.robot.scene.at_rest);
  print_result(arguments.json ? json_text(to_json(report, model)) : to_text(report, model) + "\n");
  return report.passed ? ExitCode::ok : ExitCode::verification_failed;
}

ExitCode run_verify(const VerifyArguments& arguments) {
  if (!arguments.header.empty()) return verify_header(arguments.header, arguments);
  PipelineOptions options = arguments.RobotArguments::options();
  options.functions = arguments.functions;
  const LoadedRobot model = load_robot(arguments.robot, options);
  print_diagnostics(model.diagnostics, arguments);
  VerifyReport report;
  Diagnostics findings;
  {
    Progress progress(arguments.quiet);
    const std::vector<Function> functions = functions_of(make_functions(model, options, progress, findings));
    if (model.abbreviation) return verify_part(arguments, model, functions);
    report = verify(model.robot, model.mechanism, functions, arguments.options, progress);
  }
  print_diagnostics(findings, arguments);
  print_result(arguments.json ? json_text(to_json(report)) : to_text(report) + "\n");
  return report.passed() ? ExitCode::ok : ExitCode::verification_failed;
}

}  // namespace

Run add_verify(CLI::App& app) {
  auto* command = app.add_subcommand(
      "verify",
      "Compare every function with the Lagrangian, exactly, and with the reference; or prove a file that is held.\n\n"
      "  flatdyn verify robots/panda.urdf\n"
      "  flatdyn verify robots/panda.urdf --header generated/panda.hpp\n"
      "  flatdyn verify robots/puma560.toml --functions inverse_dynamics --states 1000 --json");
  const auto arguments = std::make_shared<VerifyArguments>();
  arguments->add_to(*command);
  add_functions_option(*command, arguments->functions);
  add_error_budget_option(*command, *arguments);
  add_search_option(*command, *arguments);
  CLI::Option* const header =
      command
          ->add_option("--header", arguments->header,
                       "read this file of generated code, with its source beside it if it has one, and compare it "
                       "with the robot; the options with which it was generated are those of its stamp")
          ->check(kNotEmpty)
          ->type_name("FILE");
  command->add_option("--states", arguments->options.states, "random states")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000000))
      ->excludes(header);
  command->add_option("--seed", arguments->options.seed, "of the random states")
      ->capture_default_str()
      ->excludes(header);
  command->add_option("--bound", arguments->options.bound, "largest scaled error allowed in double")
      ->check(positive_number())
      ->capture_default_str()
      ->excludes(header);
  return [arguments] { return run_verify(*arguments); };
}

}  // namespace flatdyn
