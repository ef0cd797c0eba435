// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/stress/stress.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands.hpp"
#include "cli/output_file.hpp"
#include "laboratory/stress/families.hpp"
#include "laboratory/stress/random_robots.hpp"
#include "report/family_report.hpp"
#include "report/json_text.hpp"
#include "report/random_robots_report.hpp"
#include "report/stress_report.hpp"

namespace flatdyn {
namespace {

struct StressArguments : RobotArguments {
  std::vector<std::string> functions;
  std::string folder, family;
  std::optional<int> robots;
  int joints = 4;
  StressOptions stress;
};

void write_findings(const StressArguments& arguments, const StressReport& report) {
  const std::filesystem::path folder = arguments.folder;
  std::vector<TextFile> files = {{folder / "stress.json", json_text(stress_json(report))},
                                 {folder / "stress.svg", stress_plot(report)}};
  for (const StressRow& row : report.rows) {
    files.push_back(
        {folder / fmt::format("worst_{}_{}.csv", row.function, row.scalar), state_csv(report, row, row.worst.state)});
  }
  write_files(files);
  if (arguments.json || arguments.quiet) return;
  fmt::print("\nwrote {0}/stress.json, stress.svg, worst_*.csv\n{1}", arguments.folder, left_out_of_plot(report));
}

ExitCode run_family(const StressArguments& arguments) {
  FamilyOptions options;
  options.family = arguments.family;
  options.robots = arguments.robots.value_or(options.robots);
  options.joints = arguments.joints;
  options.stress = arguments.stress;
  if (!arguments.functions.empty()) options.functions = arguments.functions;
  Progress progress(arguments.quiet);
  const FamilyReport report = stress_family(options, progress);
  print_result(arguments.json ? json_text(family_json(report)) : family_text(report));
  std::fflush(stdout);
  if (!arguments.folder.empty()) {
    const std::string stem = (std::filesystem::path(arguments.folder) / ("family_" + arguments.family)).string();
    write_files({{stem + ".json", json_text(family_json(report))}, {stem + ".svg", family_plot(report)}});
    if (!arguments.json && !arguments.quiet) fmt::print("\nwrote {0}.json\nwrote {0}.svg\n", stem);
  }
  return report.passed() ? ExitCode::ok : ExitCode::verification_failed;
}

// Runs random robots and writes each failing one to a file.
ExitCode run_random(const StressArguments& arguments) {
  RandomRobotsOptions options;
  options.robots = arguments.robots.value_or(options.robots);
  options.seed = arguments.stress.seed;
  options.bound = arguments.stress.bound;
  if (!arguments.functions.empty()) options.functions = arguments.functions;
  Progress progress(arguments.quiet);
  const RandomRobotsReport report = stress_random_robots(options, progress);
  print_result(arguments.json ? json_text(random_robots_json(report)) : random_robots_text(report));
  std::fflush(stdout);
  if (!arguments.folder.empty()) {
    const std::filesystem::path folder = arguments.folder;
    std::vector<TextFile> files = {{folder / "family_random.json", json_text(random_robots_json(report))}};
    for (const RandomRobotFailure& failure : report.failures) {
      files.push_back({folder / (failure.smallest.name + ".toml"), failure.file});
    }
    write_files(files);
  }
  return report.passed() ? ExitCode::ok : ExitCode::verification_failed;
}

ExitCode run_robot(const StressArguments& arguments) {
  PipelineOptions options = arguments.options();
  options.functions = arguments.functions;
  const LoadedRobot model = load_robot(arguments.robot, options);
  print_diagnostics(model.diagnostics, arguments);
  if (model.robot.scene.at_rest || !model.robot.scene.outputs.empty() || model.abbreviation) {
    throw Failure(FailureKind::unsupported, "stress compares whole functions in motion",
                  "take static, error_budget and [outputs] out of the scene");
  }
  Diagnostics findings;
  StressReport report;
  {
    Progress progress(arguments.quiet);
    const std::vector<Function> functions = functions_of(make_functions(model, options, progress, findings));
    report = stress(model.robot, model.mechanism, functions, arguments.stress, progress);
  }
  print_diagnostics(findings, arguments);
  print_result(arguments.json ? json_text(stress_json(report)) : stress_text(report));
  std::fflush(stdout);
  if (!arguments.folder.empty()) write_findings(arguments, report);
  return report.passed() ? ExitCode::ok : ExitCode::verification_failed;
}

ExitCode run_stress(const StressArguments& arguments) {
  if (arguments.robot.empty() == arguments.family.empty()) {
    throw Failure(FailureKind::usage, "a robot file or --family is needed, and not both",
                  "flatdyn stress robots/panda.urdf, or flatdyn stress --family chains");
  }
  if (arguments.family.empty()) return run_robot(arguments);
  return arguments.family == kRandomFamily ? run_random(arguments) : run_family(arguments);
}

std::string families_text() {
  std::string text = "instead of a robot file, robots made for it:";
  for (const FamilyEntry& entry : family_table()) text += fmt::format("\n{}: {}", entry.name, entry.meaning);
  return text +
         fmt::format("\n{}: random chains and trees; those that fail are made small and written to -o", kRandomFamily);
}

}  // namespace

Run add_stress(CLI::App& app) {
  auto* command = app.add_subcommand(
      "stress",
      "Search for the states at which rounding errors of generated code are largest, and compare them with 50 digits "
      "and with what the recursive Newton-Euler reference loses in the same precision.\n\n"
      "  flatdyn stress robots/panda.urdf --functions inverse_dynamics,inertia_matrix\n"
      "  flatdyn stress robots/ur5.urdf -o out/ --states 1000000\n"
      "  flatdyn stress --family chains -o out/");
  const auto arguments = std::make_shared<StressArguments>();
  command->add_option("robot", arguments->robot, kRobotMeaning)->type_name("FILE");
  arguments->add_settings_to(*command);
  add_functions_option(*command, arguments->functions);
  add_search_option(*command, *arguments);
  command->add_option("--states", arguments->stress.states, "random states, per function and scalar")
      ->capture_default_str()
      ->check(CLI::Range(1, 100'000'000));
  command->add_option("--edges", arguments->stress.edges, "states of extremes")
      ->capture_default_str()
      ->check(CLI::Range(3, 1'000'000));
  command->add_option("--evaluations", arguments->stress.evaluations, "of the search, per function and scalar")
      ->capture_default_str()
      ->check(CLI::Range(1, 100'000'000));
  add_names_option(
      *command, "--variants", arguments->stress.variants,
      fmt::format("ways to call, separated by commas; default: all of {}", fmt::join(stress_variant_names(), ", ")));
  command->add_option("--family", arguments->family, families_text())->type_name("NAME");
  command->add_option("--robots", arguments->robots, "of the family, at most")
      ->default_str("20; of random 1000")
      ->check(CLI::Range(1, 1'000'000))
      ->needs("--family");
  command->add_option("--joints", arguments->joints, "of each robot of the family; not for chains, of trees about")
      ->capture_default_str()
      ->check(CLI::Range(3, 100))
      ->needs("--family");
  command->add_option("--seed", arguments->stress.seed, "of the states and of the search")->capture_default_str();
  command->add_option("--bound", arguments->stress.bound, "largest scaled error allowed")
      ->check(positive_number())
      ->capture_default_str();
  command->add_option("--ratio", arguments->stress.ratio, "largest error allowed, over the reference's own")
      ->check(positive_number())
      ->capture_default_str();
  command
      ->add_option("-o,--output", arguments->folder,
                   "folder for stress.json, stress.svg and the worst states as CSV; made if it is not there")
      ->check(folder_name())
      ->type_name("FOLDER");
  return [arguments] { return run_stress(*arguments); };
}

}  // namespace flatdyn
