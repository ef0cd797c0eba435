// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "cli/commands.hpp"
#include "cli/outdated_files.hpp"
#include "cli/output_file.hpp"
#include "code/languages/emit.hpp"
#include "code/languages/readers.hpp"
#include "functions/load/scene_text.hpp"
#include "graph/count.hpp"
#include "proof/certify/sines.hpp"
#include "proof/verify/proof.hpp"
#include "proof/verify/snap_effect.hpp"
#include "report/certificate_report.hpp"
#include "report/json_text.hpp"
#include "robot/input/common/content_hash.hpp"

namespace flatdyn {
namespace {

struct CertifyArguments : RobotArguments {
  std::string folder;
  std::vector<std::string> functions;
  CertifyOptions options;
  double enough = 0.1;  // %
  bool fuses = false;
};

const std::vector<std::string> kUsual = {"inverse_dynamics", "inertia_matrix"};

PipelineOptions pipeline_options(const CertifyArguments& arguments) {
  PipelineOptions options = arguments.RobotArguments::options();
  options.functions = arguments.functions;
  return options;
}

std::string certify_stamp(const CertifyArguments& arguments, const std::vector<OptimisedFunction>& functions) {
  std::vector<std::string> names;
  for (const OptimisedFunction& each : functions) names.push_back(each.function.name);
  const std::string of_functions =
      stamp({{"--functions", fmt::format("{}", fmt::join(names, ","))},
             {"--scalar", arguments.options.scalar == "double" ? "" : arguments.options.scalar}});
  return joined_stamps({of_functions, arguments.fuses ? "--fma" : "", arguments.stamp_of_settings(functions)});
}

struct Certified {
  Certificate certificate;
  std::string header, text;  // name and content of the header
  std::vector<Function> functions{};
  FileContents contents{};  // refers to the functions
  std::vector<GappaScript> of_sines{};
};

Certified certified(const CertifyArguments& arguments, const LoadedRobot& model, PipelineOptions options) {
  const Scene& scene = model.robot.scene;
  if (options.functions.empty() && scene.functions.empty() && scene.outputs.empty()) options.functions = kUsual;
  Progress progress(arguments.quiet);
  Diagnostics findings;
  const std::vector<OptimisedFunction> functions = make_functions(model, options, progress, findings);
  EmitOptions emit{"",
                   arguments.options.scalar,
                   certify_stamp(arguments, functions),
                   model.input_hash,
                   scene_stamp(model),
                   scene_facts(model),
                   0};
  emit.fuses = arguments.fuses;
  Certified result;
  result.header = header_name(model.mechanism, emit);
  result.text = emit_header(model.mechanism, functions_of(functions), emit);
  progress.step("proving");
  const std::uint64_t seed = proof_seed({model.input_hash, result.text});
  prove(effective_mechanism(model), functions, {}, std::nullopt, seed);
  result.functions = functions_of(functions);
  const std::optional<Stages> no_stages;
  const WrittenCode code{model.mechanism, result.functions, no_stages, emit};
  prove_text(EmittedText(result.text, header_reader()), code, seed);
  result.contents = contents_of(code);
  result.certificate = certify(model.mechanism, result.functions, result.text, arguments.options, progress);
  const auto asks_sines = [](const OptimisedFunction& each) {
    return count_operations(each.function).trigonometric > 0;
  };
  if (std::any_of(functions.begin(), functions.end(), asks_sines)) {
    result.of_sines = scripts_of_sines(emit.scalar);
  } else {
    result.contents.angles = 0;
  }
  print_diagnostics(findings, arguments);
  return result;
}

// Writes the header, its certificate, and a folder with the scripts.
void write(const CertifyArguments& arguments, const Certified& result, const CertifiedHeader& about) {
  const std::filesystem::path folder = arguments.folder;
  const std::filesystem::path header = folder / about.name;
  const auto beside = [&header](const char* extension) {
    return std::filesystem::path(header).replace_extension(extension);
  };
  std::vector<TextFile> files = {
      {header, result.text},
      {beside("certificate.md"), certificate_markdown(result.certificate, arguments.enough / 100, about)},
      {beside("certificate.json"), json_text(certificate_json(result.certificate, about))}};
  for (const CertifiedFunction& function : result.certificate.functions) {
    for (const GappaScript& script : function.scripts) files.push_back({beside("gappa") / script.name, script.text});
  }
  for (const GappaScript& script : result.of_sines) files.push_back({beside("gappa") / script.name, script.text});
  write_files(files, outdated_manifest_and_scripts(files.front()));
}

// Refuses errors so large that the values are no sines: bounds would then be meaningless.
void check_trigonometry(const CertifyOptions& options) {
  constexpr double kMost = 0.125;
  const double error = trigonometry_error(options);
  if (error <= kMost) return;
  throw Failure(
      FailureKind::usage, fmt::format("--trigonometry-ulp: sines and cosines that are off by {:.2g}", error),
      fmt::format("give what they are off over 2^-{}: 1000 is {:.2g}", rounding_format(options.scalar).precision,
                  std::ldexp(1000.0, -rounding_format(options.scalar).precision)));
}

ExitCode run_certify(const CertifyArguments& arguments) {
  check_trigonometry(arguments.options);
  const PipelineOptions options = pipeline_options(arguments);
  const LoadedRobot model = load_robot(arguments.robot, options);
  refuse_loops(model, "certify");
  print_diagnostics(model.diagnostics, arguments);
  const Certified result = certified(arguments, model, options);
  const CertifiedHeader about{result.header, content_hash({result.text}), result.contents, model.robot.snaps,
                              snap_effects(model, options.read)};
  if (is_refuted(result.certificate)) {
    if (!arguments.json) print_result(describe_certificate(result.certificate, arguments.enough / 100));
    throw Failure(FailureKind::verification_failed, "a bound is wrong: Gappa refuses it, or a larger error was seen",
                  "nothing was written; this is a mistake of the program: report it, with the robot file");
  }
  if (!arguments.folder.empty()) write(arguments, result, about);
  if (!has_gappa()) {
    Diagnostics missing;
    missing.warning({model.robot.file, 0}, "Gappa is not there: the bounds are flatdyn's own, checked by nobody",
                    "install the package gappa");
    print_diagnostics(missing, arguments);
  }
  if (arguments.json) {
    print_result(json_text(certificate_json(result.certificate, about)));
  } else if (!arguments.quiet || arguments.folder.empty()) {
    print_result(describe_certificate(result.certificate, arguments.enough / 100));
    if (!arguments.folder.empty()) {
      fmt::print("wrote {}, its certificate, and scripts for Gappa\n",
                 (std::filesystem::path(arguments.folder) / result.header).string());
    }
  }
  return ExitCode::ok;
}

}  // namespace

Run add_certify(CLI::App& app) {
  auto* command =
      app.add_subcommand("certify",
                         "Prove how large the rounding errors of the emitted code can be within the joints' limits.\n\n"
                         "  flatdyn certify robots/panda.urdf -o out/\n"
                         "  flatdyn certify robots/puma560.toml --functions gravity --scalar float");
  const auto arguments = std::make_shared<CertifyArguments>();
  arguments->add_to(*command);
  command
      ->add_option("-o,--output", arguments->folder,
                   "folder for the header, its certificate and the scripts; made if it is not there; default: no files")
      ->check(folder_name())
      ->type_name("FOLDER");
  add_functions_option(*command, arguments->functions,
                       "what to certify, separated by commas; default: what the scene names, else inverse_dynamics and "
                       "inertia_matrix");
  add_error_budget_option(*command, *arguments);
  add_search_option(*command, *arguments);
  command->add_option("--scalar", arguments->options.scalar, "scalar that the code runs in")
      ->check(CLI::IsMember({"double", "float"}))
      ->capture_default_str();
  command->add_flag("--fma", arguments->fuses,
                    "code with fused multiply-adds, for targets that have an instruction for them");
  command
      ->add_option(
          "--trigonometry-ulp", arguments->options.trigonometry_ulp,
          "what sines and cosines may be off (a table, a callback), in units of 2^-53 in double, 2^-24 in float")
      ->check(number_between(0.5, 1e12))
      ->capture_default_str();
  command->add_option("--states", arguments->options.observed.states, "states at which errors are looked for")
      ->capture_default_str()
      ->check(CLI::Range(1, 1'000'000'000));
  command->add_option("--seed", arguments->options.observed.seed, "of these states")->capture_default_str();
  command->add_option("--enough", arguments->enough, "error that does not matter, in % of the joints' effort limits")
      ->check(positive_number())
      ->capture_default_str();
  command
      ->add_option("--effort", arguments->options.effort,
                   "for small bounds: with 16 they are some 2 % smaller than with 4, after twice the time")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  command->add_option("--time-limit", arguments->options.time_limit, "of Gappa for one script, s; 0: do not ask it")
      ->check(number_between(0, 1e6))
      ->capture_default_str();
  return [arguments] { return run_certify(*arguments); };
}

}  // namespace flatdyn
