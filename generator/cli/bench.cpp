// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/bench.hpp"

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/output_file.hpp"
#include "report/bench_report.hpp"

namespace flatdyn {
namespace {

struct BenchArguments : RobotArguments {
  std::vector<std::string> robots;
  std::vector<std::string> functions;
  std::string folder;
  BenchOptions bench;
};

BenchReport bench_robot(const BenchArguments& arguments, const std::string& robot) {
  PipelineOptions options = arguments.options();
  options.functions = arguments.functions;
  const Model model = read_model(robot, options);
  print_diagnostics(model.diagnostics, arguments.quiet);
  Diagnostics findings;
  Progress progress(arguments.quiet);
  const std::vector<Function> functions = functions_of(make_functions(model, options, progress, findings));
  print_diagnostics(findings, arguments.quiet);
  return bench(model, functions, arguments.bench, progress);
}

ExitCode run_bench(const BenchArguments& arguments) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  std::string text;
  for (const std::string& robot : arguments.robots) {
    const BenchReport report = bench_robot(arguments, robot);
    json.push_back(bench_json(report));
    text += (text.empty() ? "" : "\n") + bench_text(report);
  }
  const nlohmann::ordered_json all = {{"robots", json}};
  if (!arguments.folder.empty()) {
    const std::filesystem::path folder = arguments.folder;
    write_files({{folder / "bench.json", all.dump(2) + "\n"}});
    text += fmt::format("wrote {}\n", (folder / "bench.json").string());
  }
  fmt::print("{}", arguments.json ? all.dump(2) + "\n" : text);
  return ExitCode::ok;
}

}  // namespace

Run add_bench(CLI::App& app) {
  auto* command = app.add_subcommand(
      "bench",
      "Measure run time and rounding errors of every function, in every variant, beside other libraries.\n\n"
      "  flatdyn bench robots/panda.urdf --functions inverse_dynamics,inertia_matrix\n"
      "  flatdyn bench robots/panda.urdf robots/ur5.urdf -o out/ --time 60");
  const auto arguments = std::make_shared<BenchArguments>();
  command->add_option("robot", arguments->robots, "robot files: URDF or TOML")->required()->type_name("FILE");
  arguments->add_settings_to(*command);
  add_functions_option(*command, arguments->functions);
  command->add_option("--time", arguments->bench.seconds, "of all timing, per robot")
      ->capture_default_str()
      ->type_name("S")
      ->check(number_between(0.001, 1e5));
  command->add_option("--states", arguments->bench.states, "random states at which errors are measured, at most")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
  command->add_option("--seed", arguments->bench.seed, "of the states and of the order of the runs")
      ->capture_default_str();
  command->add_option("-o,--output", arguments->folder, "folder for bench.json; made if it is not there")
      ->check(kNotEmpty)
      ->type_name("FOLDER");
  return [arguments] { return run_bench(*arguments); };
}

}  // namespace flatdyn
