// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/verify/eval.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/output_file.hpp"
#include "report/eval_plot.hpp"
#include "report/json_text.hpp"
#include "report/plot/time_table.hpp"

namespace flatdyn {
namespace {

struct EvalArguments : RobotArguments {
  std::string function, states, output, plot;
  EvalOptions options;
};

nlohmann::ordered_json table_json(const CsvTable& table) {
  nlohmann::ordered_json json = {{"columns", table.columns}, {"rows", nlohmann::ordered_json::array()}};
  for (const auto& row : table.rows) json["rows"].push_back(row);
  return json;
}

// The times of the states, s; empty if they have none.
std::vector<double> times_to_draw(CsvTable states, const std::string& file, const Mechanism& mechanism,
                                  Diagnostics& found) {
  const std::optional<CsvTime> time = states.heading(file, mechanism, found).find_time();
  return time ? times_of(states, *time, file, found) : std::vector<double>();
}

ExitCode run_eval(const EvalArguments& arguments) {
  PipelineOptions options = arguments.RobotArguments::options();
  options.functions = {arguments.function};
  const LoadedRobot model = load_robot(arguments.robot, options);
  print_diagnostics(model.diagnostics, arguments);
  if (model.abbreviation && arguments.options.reference) {
    throw Failure(FailureKind::usage, "the reference knows the whole model only",
                  "leave out --reference, or the error budget");
  }
  std::vector<std::string> inputs = model.robot.files;
  inputs.push_back(arguments.states);
  check_outputs({arguments.output, arguments.plot}, inputs);
  Diagnostics found;
  const CsvTable states = read_csv(arguments.states, found);
  if (states.rows.empty() && !arguments.plot.empty()) {
    found.error({arguments.states, 0}, "there is no row to draw", "write at least one state, or leave out --plot");
  }
  std::vector<double> times;
  if (!arguments.plot.empty()) times = times_to_draw(states, arguments.states, model.mechanism, found);
  if (found.has_errors()) throw BadInput(FailureKind::input, found);
  Progress progress(arguments.quiet);
  const std::vector<Function> functions = functions_of(make_functions(model, options, progress, found));
  const CsvTable result =
      evaluate_table(model.robot, model.mechanism, functions[0], states, arguments.states, arguments.options, found);
  arguments.report(found);
  const std::string text = arguments.json ? json_text(table_json(result)) : to_text(result);
  std::vector<TextFile> files;
  if (!arguments.output.empty()) files.push_back({arguments.output, text});
  if (!arguments.plot.empty()) {
    const std::string title = model.mechanism.name + ": " + arguments.function;
    files.push_back(
        {arguments.plot, eval_plot(title, result, states.columns.size(), times, picture_format(arguments.plot))});
  }
  write_files(files);
  if (arguments.output.empty()) print_result(text);
  return ExitCode::ok;
}

}  // namespace

Run add_eval(CLI::App& app) {
  auto* command = app.add_subcommand(
      "eval",
      "Evaluate a function at the states of a CSV file, from the emitted code's graph or from the reference.\n\n"
      "  flatdyn eval robots/panda.urdf --function gravity --states docs/examples/panda_states.csv\n"
      "  flatdyn eval robots/panda.urdf --function inertia_matrix --states docs/examples/panda_states.csv \\\n"
      "      --reference --digits 50 -o B.csv");
  const auto arguments = std::make_shared<EvalArguments>();
  arguments->add_to(*command);
  add_error_budget_option(*command, *arguments);
  command->add_option("--function", arguments->function, "which one; see flatdyn generate --help")->required();
  command->add_option("--states", arguments->states, "CSV: q1,…,qd1,…,qdd1,…,tau1,…, or by joint: q_<joint>,…")
      ->required();
  command->add_flag("--reference", arguments->options.reference,
                    "evaluate the recursive Newton-Euler reference instead");
  command->add_option("--digits", arguments->options.digits, "significant digits")
      ->capture_default_str()
      ->check(CLI::Range(1, 50));
  command->add_option("-o,--output", arguments->output, "write to this file instead of stdout")
      ->check(kNotEmpty)
      ->type_name("FILE");
  add_plot_option(*command, arguments->plot, "the function's entries, over the column t if there is one");
  return [arguments] { return run_eval(*arguments); };
}

}  // namespace flatdyn
