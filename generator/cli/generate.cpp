// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/output_file.hpp"
#include "input/content_hash.hpp"
#include "report/budget_report.hpp"
#include "report/describe.hpp"
#include "report/proof_report.hpp"
#include "report/scene_report.hpp"
#include "verify/snap_effect.hpp"

namespace flatdyn {
namespace {

// A part has to have room for the longest statement and what it needs.
constexpr int kFewestLines = 30, kMostLines = 1'000'000;

struct GenerateArguments : RobotArguments {
  std::string folder;
  std::vector<std::string> functions, staged, fused;
  std::string scalar = "double";
  std::string name_space;
  int most_lines = 0;  // 0: no limit
};

// The options that shape the output, as they go into its stamp.
std::string stamp_of(const GenerateArguments& arguments, const std::vector<OptimisedFunction>& functions) {
  const std::string of_functions =
      stamp({{"--functions", fmt::format("{}", fmt::join(arguments.functions, ","))},
             {"--stages", fmt::format("{}", fmt::join(arguments.staged, ","))},
             {"--fuse", fmt::format("{}", fmt::join(arguments.fused, ","))},
             {"--scalar", arguments.scalar == "double" ? "" : arguments.scalar},
             {"--namespace", arguments.name_space},
             {"--max-lines", arguments.most_lines == 0 ? "" : std::to_string(arguments.most_lines)}});
  const std::string of_robot = arguments.stamp_of_settings(functions);
  return of_functions + (of_functions.empty() || of_robot.empty() ? "" : " ") + of_robot;
}

ExitCode generate(const GenerateArguments& arguments) {
  PipelineOptions options = arguments.options();
  options.functions = arguments.functions;
  std::vector<OptimisedFunction> functions;
  std::optional<OptimisedFusion> fused;
  std::optional<Stages> stages;
  std::vector<Proof> proofs;
  Diagnostics findings;
  const Model model = read_model(arguments.robot, options);
  {
    Progress progress(arguments.quiet);
    functions = make_functions(model, options, progress, findings);
    if (arguments.fused.size() == 1) {
      throw Failure(ExitCode::usage, "--fuse: one function is no set", "name two or more, separated by commas");
    }
    if (!arguments.fused.empty()) fused = make_fusion(model, arguments.fused, progress);
    if (!arguments.staged.empty()) stages = stages_of(make_fusion(model, arguments.staged, progress).fusion);
    progress.step("proving");
    proofs = prove(derived_from(model), functions, fused, stages);
    if (fused) functions.push_back({fused->fusion.function, fused->derived, fused->passes, {}});
  }
  const EmitOptions emit{arguments.name_space, arguments.scalar,   stamp_of(arguments, functions),
                         model.input_hash,     scene_stamp(model), scene_facts(model),
                         arguments.most_lines};
  const std::filesystem::path folder = arguments.folder;
  const std::string header = header_name(model.mechanism, emit);
  const std::vector<double> effects = snap_effects(model, options.read);
  nlohmann::ordered_json manifest = {{"flatdyn", FLATDYN_VERSION}, {"options", emit.options_stamp}, {"header", header}};
  manifest.update(model_json(model, effects));
  manifest["functions"] = functions_json(functions, symbol_names(model.mechanism));
  std::optional<GivenUp> seen;
  if (model.abbreviation) {
    seen = given_up(model.mechanism, derived_from(model), model.robot.scene.at_rest);
    manifest["error_budget"] = abbreviation_json(model, *seen);
  }
  if (stages) manifest["stages"] = stages_json(*stages);
  manifest["proof"] = proofs_json(proofs);
  const std::string text = emit_cpp(model.mechanism, functions_of(functions), emit, stages);
  prove_text(text, functions, stages);
  // So that a reader sees whether the two files belong together.
  manifest["header_hash"] = content_hash({text});
  write_files({{folder / header, text}, {(folder / header).replace_extension(".json"), manifest.dump(2) + "\n"}});
  print_diagnostics(model.diagnostics, arguments.quiet);
  print_diagnostics(findings, arguments.quiet);
  if (arguments.json) {
    fmt::print("{}\n", manifest.dump(2));
  } else {
    fmt::print("{}\n{}\n", describe_model(model, effects),
               describe_functions(functions, symbol_names(model.mechanism)));
    if (stages) fmt::print("{}\n", describe_stages(*stages));
    if (seen) fmt::print("{}\n", describe_abbreviation(model, *seen));
    fmt::print("{}\nwrote {}\n", describe_proofs(proofs, "double"), (folder / header).string());
  }
  return ExitCode::ok;
}

}  // namespace

Run add_generate(CLI::App& app) {
  auto* command = app.add_subcommand(
      "generate",
      "Write a header that computes the robot's dynamics.\n\n"
      "  flatdyn generate robots/panda.urdf -o out/\n"
      "  flatdyn generate robots/puma560.toml -o out/ --functions inverse_dynamics,gravity --scalar float");
  const auto arguments = std::make_shared<GenerateArguments>();
  arguments->add_to(*command);
  command->add_option("-o,--output", arguments->folder, "folder to write to; made if it is not there")
      ->required()
      ->check(kNotEmpty)
      ->type_name("FOLDER");
  add_functions_option(*command, arguments->functions);
  add_error_budget_option(*command, *arguments);
  add_search_option(*command, *arguments);
  command
      ->add_option(
          "--stages", arguments->staged,
          "these functions once more as members of what at(q) and with(qd) return: what they share at the same "
          "positions, or positions and velocities, is computed once")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("NAMES");
  command->add_option("--fuse", arguments->fused, "one more function that computes all of these at once")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("NAMES");
  command->add_option("--scalar", arguments->scalar, "scalar of the constants")
      ->check(CLI::IsMember({"double", "float"}))
      ->capture_default_str();
  command->add_option("--namespace", arguments->name_space, "C++ namespace; default: the robot's name")
      ->check(kNotEmpty)
      ->type_name("NAME");
  command
      ->add_option("--max-lines", arguments->most_lines,
                   "no function of the header is longer: longer ones call parts of their own")
      ->check(CLI::Range(kFewestLines, kMostLines))
      ->type_name("N");
  return [arguments] { return generate(*arguments); };
}

}  // namespace flatdyn
