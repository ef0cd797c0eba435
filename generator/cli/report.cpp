// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "cli/commands.hpp"
#include "cli/output_file.hpp"
#include "code/languages/emit.hpp"
#include "code/languages/language_table.hpp"
#include "code/languages/readers.hpp"
#include "functions/function_table.hpp"
#include "proof/verify/proof.hpp"
#include "proof/verify/snap_effect.hpp"
#include "report/describe.hpp"
#include "report/html/page.hpp"

namespace flatdyn {
namespace {

// The largest number of joints for which Christoffel symbols and the regressor are computed; beyond it they take too
// long and are too large to look at.
constexpr std::size_t kMostJointsOfLargeMaps = 12;

struct ReportArguments : RobotArguments {
  std::string file;
  std::string parameters = "given";
  std::string frames = "file";
  std::string with;    // "certificate"; empty: nothing more
  std::string stress;  // path of stress.json; empty: none
};

// Whether the function has an entry per pair of joints and joint, or per parameter and joint.
bool has_large_map(const FunctionRow& row) {
  return std::any_of(row.outputs.begin(), row.outputs.end(), [](const OutputRow& output) {
    return output.cols == Extent::joint_pairs || output.cols == Extent::parameters;
  });
}

// The functions that are made by default, and the regressor: large ones for robots with few joints only.
std::vector<std::string> wanted_functions(const Mechanism& mechanism) {
  const bool is_small = mechanism.joints().size() <= kMostJointsOfLargeMaps;
  std::vector<std::string> names;
  for (const FunctionRow& row : function_table()) {
    const bool is_wanted = has_large_map(row) ? is_small : !row.traits.on_request;
    if (is_wanted && row.applies_to(mechanism)) names.emplace_back(row.name);
  }
  return names;
}

// The functions that the robot allows, one by one; each one left out is a warning in `findings`.
std::vector<OptimisedFunction> allowed_functions(const LoadedRobot& model, PipelineOptions options, Progress& progress,
                                                 Diagnostics& findings) {
  std::vector<OptimisedFunction> functions;
  for (const std::string& name : wanted_functions(model.mechanism)) {
    options.functions = {name};
    try {
      for (OptimisedFunction& made : make_functions(model, options, progress, findings)) {
        functions.push_back(std::move(made));
      }
    } catch (const Failure& failure) {
      if (failure.kind() != FailureKind::unsupported) throw;
      findings.warning({model.robot.file, 0}, std::string("left out ") + failure.what(), failure.hint());
    }
  }
  return functions;
}

// All functions, made at once in several processes, or those that the robot allows.
std::vector<OptimisedFunction> functions_for(const LoadedRobot& model, PipelineOptions options, Progress& progress,
                                             Diagnostics& findings) {
  options.functions = wanted_functions(model.mechanism);
  Diagnostics found;
  try {
    std::vector<OptimisedFunction> functions = make_functions(model, options, progress, found);
    for (const Diagnostic& each : found.all()) findings.add(each);
    return functions;
  } catch (const Failure& failure) {
    if (failure.kind() != FailureKind::unsupported) throw;
    return allowed_functions(model, options, progress, findings);
  }
}

std::string proof_text(const std::vector<Proof>& proofs) {
  return fmt::format(
      "All {} functions are what the Lagrangian says, proven in exact arithmetic; the JavaScript, read back, says the "
      "same.",
      proofs.size());
}

std::optional<WorstStates> worst_states(const std::string& file, const LoadedRobot& model) {
  if (file.empty()) return std::nullopt;
  Diagnostics diagnostics;
  WorstStates states = read_worst_states(file, model.mechanism.name, diagnostics);
  if (diagnostics.has_errors()) throw BadInput(FailureKind::input, diagnostics);
  return states;
}

// The certificate by flatdyn's own bounds: what Gappa proves in a given time depends on the computer.
Certificate certificate_of(const LoadedRobot& model, const std::vector<OptimisedFunction>& functions,
                           Progress& progress) {
  const std::vector<OptimisedFunction> torques = {functions.front()};
  CertifyOptions options;
  options.observed.states = 100'000;
  options.time_limit = 0;
  const std::string text = emit_header(model.mechanism, functions_of(torques), {});
  prove_text(EmittedText(text, header_reader()), {model.mechanism, functions_of(torques), std::nullopt, {}});
  Certificate certificate = certify(model.mechanism, functions_of(torques), text, options, progress);
  if (!is_refuted(certificate)) return certificate;
  throw Failure(FailureKind::verification_failed, "a bound is wrong: a larger error was seen",
                "nothing was written; this is a mistake of the program: report it, with the robot file");
}

ExitCode report(const ReportArguments& arguments) {
  const PipelineOptions options = arguments.options();
  const LoadedRobot model = without_scene_restrictions([&] {
    LoadedRobot read = load_robot(arguments.robot, options);
    refuse_loops(read, "report");
    arguments.note_function_keys(read);
    return read;
  }());
  std::vector<std::string> read = model.robot.files;
  if (!arguments.stress.empty()) read.push_back(arguments.stress);
  check_outputs({arguments.file}, read);
  const std::optional<WorstStates> worst = worst_states(arguments.stress, model);
  Progress progress(arguments.quiet);
  Diagnostics findings;
  std::vector<OptimisedFunction> functions = functions_for(model, options, progress, findings);
  arguments.report(findings);
  progress.step("proving");
  const std::vector<Proof> proofs = prove(model.mechanism, functions, {}, std::nullopt, proof_seed({model.input_hash}));
  progress.step("drawing");
  const std::string parameters = arguments.parameters == "given" ? "" : arguments.parameters;
  const std::string frames = arguments.frames == "file" ? "" : arguments.frames;
  const std::string settings = arguments.stamp_of_settings({});
  const std::string of_base = stamp({{"--parameters", parameters}, {"--frames", frames}, {"--with", arguments.with}});
  PageContent content{model,
                      std::move(functions),
                      drawing_of(model.robot, model.mechanism),
                      findings,
                      snap_effects(model, options.read),
                      parameter_set(arguments.parameters),
                      parameter_frames(arguments.frames),
                      settings + (settings.empty() || of_base.empty() ? "" : " ") + of_base,
                      proof_text(proofs)};
  content.worst_states = worst;
  const PageCode code = page_code(content);
  if (!arguments.with.empty()) content.certificate = certificate_of(model, code.functions, progress);
  const EmitOptions form = page_script_options();
  prove_text(EmittedText(code.text, reader_of(form)),
             {model.mechanism, functions_of(code.functions), std::nullopt, form, false}, proof_seed({code.text}));
  print_diagnostics(model.diagnostics, arguments);
  nlohmann::ordered_json json = model_json(model, content.snap_effects);
  json["functions"] = functions_json(content.functions, model.mechanism);
  write_and_print({{arguments.file, report_page(content, code)}}, {"", json}, arguments);
  return ExitCode::ok;
}

}  // namespace

Run add_report(CLI::App& app) {
  auto* command = app.add_subcommand(
      "report",
      "Write a page of HTML on which the robot moves, with its torques, its structure and what its functions cost. It "
      "needs no network.\n\n"
      "  flatdyn report robots/panda.urdf -o panda.html\n"
      "  flatdyn report robots/scara.toml -o scara.html --gravity off\n"
      "  flatdyn report robots/quadruped12.urdf --base floating -o quadruped12.html");
  const auto arguments = std::make_shared<ReportArguments>();
  arguments->add_to(*command);
  command->add_option("-o,--output", arguments->file, "the page; its folder is made if it is not there")
      ->required()
      ->check(kNotEmpty)
      ->type_name("FILE.html");
  add_parameters_option(*command, arguments->parameters, "what base parameters are made of: ");
  add_frames_option(*command, arguments->frames);
  command
      ->add_option("--with", arguments->with,
                   "also on the page: certificate, how large the rounding errors of the torques can be")
      ->check(CLI::IsMember({"certificate"}));
  command
      ->add_option("--stress", arguments->stress,
                   "also on the page: the worst states, from stress.json that `flatdyn stress ROBOT -o FOLDER` wrote")
      ->check(kNotEmpty)
      ->type_name("FILE.json");
  return [arguments] { return report(*arguments); };
}

}  // namespace flatdyn
