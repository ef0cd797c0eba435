// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "cli/commands.hpp"
#include "cli/delivery.hpp"
#include "emit/narrowed.hpp"
#include "firmware/folder.hpp"
#include "input/content_hash.hpp"
#include "python/module.hpp"
#include "report/budget_report.hpp"
#include "report/describe.hpp"
#include "report/json_text.hpp"
#include "report/proof_report.hpp"
#include "report/scene_report.hpp"
#include "verify/rounded_angles.hpp"
#include "verify/snap_effect.hpp"

namespace flatdyn {
namespace {

// A part has to have room for the longest statement and what it needs.
constexpr int kFewestLines = 30, kMostLines = 1'000'000;

struct GenerateArguments : RobotArguments {
  std::string folder;
  std::vector<std::string> functions, staged, fused;
  std::vector<std::string> scalars = {"double"};
  std::string language = "c++", form = "header";
  std::string name_space, file_name;  // empty: the robot's name
  std::string firmware;               // a processor; empty: none
  bool python = false;
  const CLI::Option *scalar_given = nullptr, *language_given = nullptr, *form_given = nullptr;
  int most_lines = 0;  // 0: no limit
  Delivery delivery;

  bool is_pair() const { return form == "pair"; }
  bool is_to_stdout() const { return folder == kStdout; }
};

struct NamedLanguage {
  Language language;
  const char* name;
};
const std::map<std::string, NamedLanguage> kLanguages = {
    {"c++", {Language::cpp, "C++"}}, {"c", {Language::c, "C"}}, {"javascript", {Language::javascript, "JavaScript"}}};

const CLI::Validator kFileName(
    [](const std::string& text) {
      return text.empty() || text.find('/') != std::string::npos ? "it is no name of a file" : "";
    },
    "");

// The options that shape the output, as they go into its stamp.
std::string stamp_of(const GenerateArguments& arguments, const std::vector<OptimisedFunction>& functions) {
  const std::string scalars = fmt::format("{}", fmt::join(arguments.scalars, ","));
  const std::string of_functions =
      stamp({{"--functions", fmt::format("{}", fmt::join(arguments.functions, ","))},
             {"--stages", fmt::format("{}", fmt::join(arguments.staged, ","))},
             {"--fuse", fmt::format("{}", fmt::join(arguments.fused, ","))},
             {"--scalar", scalars == "double" ? "" : scalars},
             {"--language", arguments.language == "c++" ? "" : arguments.language},
             {"--form", arguments.is_pair() ? "pair" : ""},
             {"--namespace", arguments.name_space},
             {"--name", arguments.file_name},
             {"--max-lines", arguments.most_lines == 0 ? "" : std::to_string(arguments.most_lines)}});
  const std::string of_robot = arguments.stamp_of_settings(functions);
  return of_functions + (of_functions.empty() || of_robot.empty() ? "" : " ") + of_robot;
}

struct Emitted {
  std::vector<TextFile> files;  // the header first
  EmittedText read_back;
};

Emitted emitted(const Model& model, const std::vector<Function>& functions, const EmitOptions& options,
                const std::optional<Stages>& stages, const std::filesystem::path& folder) {
  const std::filesystem::path header = folder / header_name(model.mechanism, options);
  const std::filesystem::path source = folder / source_name(model.mechanism, options);
  if (options.language == Language::cpp && options.form == Form::pair) {
    const HeaderAndSource text = emit_cpp_pair(model.mechanism, functions, options, stages);
    return {{{header, text.header}, {source, text.source}}, EmittedText(text.header + text.source)};
  }
  if (options.language == Language::cpp) {
    const std::string text = emit_cpp(model.mechanism, functions, options, stages);
    return {{{header, text}}, EmittedText(text)};
  }
  if (options.language == Language::javascript) {
    const std::string text = emit_javascript(model.mechanism, functions, options);
    return {{{header, text}}, EmittedText::of_javascript(text)};
  }
  const HeaderAndSource text = emit_c(model.mechanism, functions, options);
  return {{{header, text.header}, {source, text.source}}, EmittedText(text.header, text.source, options.scalar)};
}

void choose_c(GenerateArguments& arguments, const char* option) {
  if (arguments.language_given->count() > 0 && arguments.language != "c") {
    throw Failure(ExitCode::usage, fmt::format("{}: its code is in C", option), "leave --language out");
  }
  arguments.language = "c";
}

// What Python calls is in C.
void choose_for_python(GenerateArguments& arguments) {
  if (arguments.python) choose_c(arguments, "--python");
}

// A folder for a processor is in C, and in the scalar that its floating-point unit computes in, unless another is
// given.
void choose_for_firmware(GenerateArguments& arguments) {
  if (arguments.firmware.empty()) return;
  choose_c(arguments, "--firmware");
  if (!arguments.fused.empty()) {
    throw Failure(ExitCode::usage, "--firmware: fused functions have no self test", "leave --fuse out");
  }
  if (arguments.scalar_given->count() == 0) arguments.scalars = {firmware_target(arguments.firmware).scalar};
}

// Two files, and more than one scalar, are for C++.
void check_form(const GenerateArguments& arguments) {
  const bool is_cpp = arguments.language == "c++";
  if (arguments.form_given->count() > 0 && !is_cpp) {
    throw Failure(ExitCode::usage, fmt::format("--form: {} has one form only", kLanguages.at(arguments.language).name),
                  "leave it out");
  }
  if (arguments.scalars.size() == 1 || arguments.is_pair()) return;
  throw Failure(ExitCode::usage, "--scalar: one is enough here",
                is_cpp ? "a header is a template over its scalar: name that of its constants; or use --form pair"
                       : "name one, and run it again with another --name and --namespace for the other");
}

// There is room for one file.
void check_stdout(const GenerateArguments& arguments) {
  if (!arguments.is_to_stdout()) return;
  if (arguments.json) refuse_two_on_stdout();
  if (arguments.delivery.check || arguments.delivery.dry_run || !arguments.delivery.depfile.empty()) {
    throw Failure(ExitCode::usage, "-o -: --check, --dry-run and --depfile are about files", "name a folder");
  }
  if (arguments.language == "c" || arguments.is_pair()) {
    throw Failure(ExitCode::usage, "-o -: several files result, and stdout has room for one",
                  "name a folder; a header in C++ and a module in JavaScript are one file");
  }
}

void check_usage(const GenerateArguments& arguments) {
  check_stdout(arguments);
  check_form(arguments);
  if (arguments.fused.size() == 1) {
    throw Failure(ExitCode::usage, "--fuse: one function is no set", "name two or more, separated by commas");
  }
  if (arguments.language != "c++" && !arguments.staged.empty()) {
    throw Failure(ExitCode::usage,
                  fmt::format("--stages: there are none in {}", kLanguages.at(arguments.language).name),
                  "--fuse computes several functions in one call");
  }
  if (arguments.language != "javascript") return;
  if (arguments.scalars.front() != "double") {
    throw Failure(ExitCode::usage, "--scalar: all numbers of JavaScript are doubles", "leave it out");
  }
  if (!arguments.name_space.empty()) {
    throw Failure(ExitCode::usage, "--namespace: a module of JavaScript has none",
                  "leave it out; --name names the file");
  }
}

// What is made of the robot, all of it proven.
struct Made {
  std::vector<OptimisedFunction> functions;  // the fused one last
  std::optional<Stages> stages;
  std::vector<Proof> proofs;
  std::optional<GivenUp> given_up;  // to an error budget
  Diagnostics findings;
};

Made make(const Model& model, const PipelineOptions& options, const GenerateArguments& arguments) {
  Progress progress(arguments.quiet);
  Made made;
  std::optional<OptimisedFusion> fused;
  made.functions = make_functions(model, options, progress, made.findings);
  if (!arguments.fused.empty()) fused = make_fusion(model, arguments.fused, progress);
  if (!arguments.staged.empty()) made.stages = stages_of(make_fusion(model, arguments.staged, progress).fusion);
  progress.step("proving");
  made.proofs = prove(derived_from(model), made.functions, fused, made.stages);
  if (fused) made.functions.push_back({fused->fusion.function, fused->derived, fused->passes, {}});
  if (model.abbreviation) {
    made.given_up = given_up(model.mechanism, derived_from(model), model.robot.scene.at_rest);
  }
  return made;
}

bool is_for_float(const GenerateArguments& arguments) {
  return std::find(arguments.scalars.begin(), arguments.scalars.end(), "float") != arguments.scalars.end();
}

// What the text says of constants, and what becomes of them where C++ is compiled for float.
std::string rounding_of_constants(const EmittedText& text, const GenerateArguments& arguments) {
  const std::string written = text.constants();
  return written == "double" && is_for_float(arguments) ? "double, and float rounds these once more" : written;
}

// All that is written, in stages and on its own.
std::vector<Function> functions_written(const Made& made) {
  std::vector<Function> functions = functions_of(made.functions);
  if (!made.stages) return functions;
  for (const Stage* stage : {&made.stages->configuration, &made.stages->motion}) {
    functions.push_back(stage->make);
    functions.insert(functions.end(), stage->members.begin(), stage->members.end());
  }
  return functions;
}

EmitOptions emit_options(const Model& model, const Made& made, const GenerateArguments& arguments) {
  return {arguments.name_space,
          arguments.scalars.front(),
          stamp_of(arguments, made.functions),
          model.input_hash,
          scene_stamp(model),
          scene_facts(model),
          arguments.most_lines,
          kLanguages.at(arguments.language).language,
          arguments.file_name,
          arguments.is_pair() ? Form::pair : Form::header,
          {arguments.scalars.begin() + 1, arguments.scalars.end()}};
}

// `files`: the header, and the source if there is one.
nlohmann::ordered_json manifest_of(const Model& model, const Made& made, const EmitOptions& options,
                                   const std::vector<TextFile>& files, const std::vector<double>& effects) {
  nlohmann::ordered_json manifest = {{"flatdyn", FLATDYN_VERSION},
                                     {"options", options.options_stamp},
                                     {"header", header_name(model.mechanism, options)}};
  manifest.update(model_json(model, effects));
  manifest["functions"] = functions_json(made.functions, symbol_names(model.mechanism));
  if (made.given_up) manifest["error_budget"] = abbreviation_json(model, *made.given_up);
  if (made.stages) manifest["stages"] = stages_json(*made.stages);
  manifest["proof"] = proofs_json(made.proofs);
  // So that a reader sees whether the files belong together.
  manifest["header_hash"] = content_hash({files[0].text});
  if (files.size() > 1) {
    manifest["source"] = files[1].path.filename().string();
    manifest["source_hash"] = content_hash({files[1].text});
  }
  return manifest;
}

// What is asked for beside header and source.
std::vector<TextFile> companions(const Model& model, const std::vector<Function>& functions, const EmitOptions& options,
                                 const GenerateArguments& arguments) {
  const std::filesystem::path folder = arguments.folder;
  std::vector<TextFile> files;
  if (!arguments.firmware.empty()) {
    Progress progress(arguments.quiet);
    const FirmwareTarget& target = firmware_target(arguments.firmware);
    for (const FirmwareFile& file :
         firmware_files(model.robot, model.mechanism, functions, options, target, progress)) {
      files.push_back({folder / file.name, file.text});
    }
  }
  if (arguments.python) {
    const std::string name = module_name(model.mechanism, options);
    const PythonModule module = python_module(model.mechanism, functions, options);
    files.push_back({folder / (name + ".py"), module.module});
    files.push_back({folder / (name + "_batch.c"), module.batch});
  }
  return files;
}

// For people.
std::string tables(const Model& model, const Made& made, const std::vector<double>& effects,
                   const GenerateArguments& arguments, const EmittedText& read_back) {
  const SnapDetail detail = arguments.verbose ? SnapDetail::each : SnapDetail::one_line;
  std::string text = describe_model(model, effects, detail) + "\n" +
                     describe_functions(made.functions, symbol_names(model.mechanism)) + "\n";
  if (made.stages) text += describe_stages(*made.stages) + "\n";
  if (made.given_up) text += describe_abbreviation(model, *made.given_up) + "\n";
  text += describe_proofs(made.proofs, rounding_of_constants(read_back, arguments)) + "\n";
  if (!arguments.firmware.empty()) {
    text += fmt::format("a self test for {}: make -C {} run\n", arguments.firmware, arguments.folder);
  }
  return text;
}

ExitCode generate(GenerateArguments arguments) {
  choose_for_firmware(arguments);
  choose_for_python(arguments);
  check_usage(arguments);
  PipelineOptions options = arguments.options();
  options.functions = arguments.functions;
  const Model model = read_model(arguments.robot, options);
  Made made = make(model, options, arguments);
  const EmitOptions emit = emit_options(model, made, arguments);
  const std::vector<Function> functions = functions_of(made.functions);
  auto [files, read_back] = emitted(model, functions, emit, made.stages, arguments.folder);
  if (is_for_float(arguments)) {
    warn_of_narrowed(narrowed_constants(functions_written(made)), {model.robot.file, 0}, made.findings);
    if (options.warnings_are_errors && made.findings.has_warnings()) throw BadInput(ExitCode::input, made.findings);
  }
  prove_text(read_back, made.functions, made.stages);
  if (!arguments.quiet) ask_for_rounded_angles(model, options, made.functions, made.findings);
  const std::vector<double> effects = snap_effects(model, options.read);
  const std::string manifest = json_text(manifest_of(model, made, emit, files, effects));
  if (arguments.is_to_stdout()) {
    files.front().path = kStdout;
  } else {
    const std::filesystem::path beside_header = std::filesystem::path(files[0].path).replace_extension(".json");
    for (TextFile& file : companions(model, functions, emit, arguments)) files.push_back(std::move(file));
    files.push_back({beside_header, manifest});
  }
  const std::string done = arguments.delivery.deliver(std::move(files), model.robot.files);
  print_diagnostics(model.diagnostics, arguments);
  print_diagnostics(made.findings, arguments);
  if (arguments.json) {
    print_result(manifest);
  } else if (!arguments.is_to_stdout()) {
    if (!arguments.quiet) print_result(tables(model, made, effects, arguments, read_back));
    if (!arguments.quiet || arguments.delivery.is_only_told()) print_result(done);
  }
  return ExitCode::ok;
}

// In what the code is written, and what is written around it.
void add_form_options(CLI::App& command, GenerateArguments& arguments) {
  arguments.scalar_given =
      command
          .add_option("--scalar", arguments.scalars,
                      "scalar of the constants; of a pair, one or two that it is compiled for: double,float")
          ->delimiter(',')
          ->allow_extra_args(false)
          ->check(CLI::IsMember({"double", "float"}))
          ->default_str("double");
  arguments.language_given =
      command
          .add_option("--language", arguments.language,
                      "a C++17 header, a C99 header and source in one scalar, or a JavaScript module")
          ->check(CLI::IsMember({"c++", "c", "javascript"}))
          ->capture_default_str();
  arguments.form_given =
      command
          .add_option("--form", arguments.form,
                      "of C++: all in one header, or a pair of header and source, which is compiled once")
          ->check(CLI::IsMember({"header", "pair"}))
          ->capture_default_str();
  command
      .add_option("--firmware", arguments.firmware,
                  "a folder in C that builds for this processor as it is, with a self test that qemu runs; in "
                  "float for cortex-m4 and riscv32")
      ->check(CLI::IsMember(firmware_target_names()));
  command.add_flag("--python", arguments.python,
                   "a module for Python over the C form, for one state or a batch: ctypes and numpy");
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
  command
      ->add_option("-o,--output", arguments->folder,
                   "folder to write to, made if it is not there; - writes the header alone, to stdout")
      ->required()
      ->check(kNotEmpty)
      ->type_name("FOLDER");
  add_functions_option(*command, arguments->functions);
  add_error_budget_option(*command, *arguments);
  add_search_option(*command, *arguments);
  add_names_option(*command, "--stages", arguments->staged,
                   "these functions once more as members of what at(q) and with(qd) return: what they share at the "
                   "same positions, or positions and velocities, is computed once");
  add_names_option(*command, "--fuse", arguments->fused, "one more function that computes all of these at once");
  add_form_options(*command, *arguments);
  command
      ->add_option("--namespace", arguments->name_space,
                   "C++ namespace, and in C what names begin with; default: the robot's name")
      ->check(kNotEmpty)
      ->type_name("NAME");
  command->add_option("--name", arguments->file_name, "name of the files, without folder; default: the robot's name")
      ->check(kFileName)
      ->type_name("NAME");
  command
      ->add_option("--max-lines", arguments->most_lines,
                   "no function of the header is longer: longer ones call parts of their own")
      ->check(CLI::Range(kFewestLines, kMostLines))
      ->type_name("N");
  arguments->delivery.add_to(*command);
  return [arguments] { return generate(*arguments); };
}

}  // namespace flatdyn
