// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/version.hpp"
#include "cli/commands.hpp"
#include "cli/delivery.hpp"
#include "cli/held_header.hpp"
#include "cli/option_values.hpp"
#include "code/conventions/convention.hpp"
#include "code/emit/page_writer.hpp"
#include "code/languages/language_table.hpp"
#include "code/lower/limbs.hpp"
#include "delivery/firmware/folder.hpp"
#include "delivery/python/cuda_module.hpp"
#include "delivery/python/module.hpp"
#include "pipeline/generation.hpp"
#include "pipeline/pass_dump.hpp"
#include "proof/verify/rounded_angles.hpp"
#include "proof/verify/snap_effect.hpp"
#include "report/budget_report.hpp"
#include "report/code_size.hpp"
#include "report/compile_time.hpp"
#include "report/describe.hpp"
#include "report/json_text.hpp"
#include "report/proof_report.hpp"
#include "report/trace_report.hpp"
#include "robot/input/common/content_hash.hpp"

namespace flatdyn {
namespace {

// The range of --max-lines: a part must have room for the longest statement with everything it needs.
constexpr int kFewestLines = 30, kMostLines = 1'000'000;

struct GenerateArguments : RobotArguments {
  std::string folder;
  std::vector<std::string> functions, staged, fused, conventions;
  std::vector<std::string> scalars = {"double"};
  std::string language = EmitOptions().language, form = "header", frames = "file", sincos = "polynomials",
              limbs = "apart";
  std::string name_space, file_name;  // empty: from the robot's name
  std::string firmware;               // a processor; empty: none
  bool python = false, fuses = false;
  const CLI::Option *scalar_given = nullptr, *language_given = nullptr, *form_given = nullptr;
  int most_lines = 0;  // 0: no limit
  std::vector<std::string> dumped_passes;
  bool trace = false;
  Delivery delivery;

  bool is_pair() const { return form == "pair"; }
  bool has_lanes() const { return limbs == "lanes"; }
  bool is_to_stdout() const { return folder == kStdout; }
};

// The options that shape the output, as they go into its stamp.
std::string stamp_of(const GenerateArguments& arguments, const std::vector<OptimisedFunction>& functions) {
  const std::string scalars = fmt::format("{}", fmt::join(arguments.scalars, ","));
  const std::string of_functions =
      stamp({{"--functions", fmt::format("{}", fmt::join(arguments.functions, ","))},
             {"--stages", fmt::format("{}", fmt::join(arguments.staged, ","))},
             {"--fuse", fmt::format("{}", fmt::join(arguments.fused, ","))},
             {"--scalar", scalars == "double" ? "" : scalars},
             {"--language", arguments.language == EmitOptions().language ? "" : arguments.language},
             {"--form", arguments.is_pair() ? "pair" : ""},
             {"--sincos", arguments.sincos == "polynomials" ? "" : arguments.sincos},
             {"--limbs", arguments.has_lanes() ? arguments.limbs : ""},
             {"--namespace", arguments.name_space},
             {"--name", arguments.file_name},
             {"--convention", fmt::format("{}", fmt::join(arguments.conventions, ","))},
             {"--frames", arguments.frames == "file" ? "" : arguments.frames},
             {"--max-lines", arguments.most_lines == 0 ? "" : std::to_string(arguments.most_lines)}});
  return joined_stamps({of_functions, arguments.fuses ? "--fma" : "", arguments.stamp_of_settings(functions)});
}

// Chooses the language that an option asks for, unless one is given that has it, too.
void choose_language(GenerateArguments& arguments, const char* option, bool LanguageRow::*what) {
  const bool is_given = arguments.language_given->count() > 0 && arguments.language != kPython;
  if (is_given && language_row(arguments.language).*what) return;
  if (is_given) {
    throw Failure(FailureKind::usage, fmt::format("{}: its code is in {}", option, languages_text(what)),
                  "leave --language out");
  }
  arguments.language = language_with(what).option;
}

void choose_for_python(GenerateArguments& arguments) {
  if (arguments.language == kPython) arguments.python = true;
  if (arguments.python) choose_language(arguments, "--python", &LanguageRow::is_called_by_python);
}

// Chooses the scalar of a processor's floating-point unit, too, unless another is given.
void choose_for_firmware(GenerateArguments& arguments) {
  if (arguments.firmware.empty()) return;
  choose_language(arguments, "--firmware", &LanguageRow::is_for_firmware);
  if (!arguments.fused.empty()) {
    throw Failure(FailureKind::usage, "--firmware: fused functions have no self test", "leave --fuse out");
  }
  if (arguments.scalar_given->count() == 0) arguments.scalars = {firmware_target(arguments.firmware).scalar};
}

// Requires a language with forms for a pair, and a pair for more than one scalar.
void check_form(const GenerateArguments& arguments) {
  const LanguageRow& language = language_row(arguments.language);
  if (arguments.form_given->count() > 0 && !language.has_pair) {
    throw Failure(FailureKind::usage, fmt::format("--form: {} has one form only", language.name), "leave it out");
  }
  if (arguments.scalars.size() == 1 || arguments.is_pair()) return;
  throw Failure(FailureKind::usage, "--scalar: one is enough here",
                language.has_pair
                    ? "a header is a template over its scalar: name that of its constants; or use --form pair"
                    : "name one, and run it again with another --name and --namespace for the other");
}

// Allows one file at most on stdout.
void check_stdout(const GenerateArguments& arguments) {
  if (!arguments.is_to_stdout()) return;
  if (arguments.json) refuse_two_on_stdout();
  if (arguments.delivery.check || arguments.delivery.dry_run || !arguments.delivery.depfile.empty()) {
    throw Failure(FailureKind::usage, "-o -: --check, --dry-run and --depfile are about files", "name a folder");
  }
  if (!language_row(arguments.language).is_one_file() || arguments.is_pair() || arguments.python) {
    throw Failure(FailureKind::usage, "-o -: several files result, and stdout has room for one",
                  fmt::format("name a folder; {} is one file", languages_text(&LanguageRow::is_one_file)));
  }
  if (!arguments.conventions.empty()) {
    throw Failure(FailureKind::usage, "-o -: --convention writes headers of its own", "name a folder");
  }
  if (!arguments.dumped_passes.empty()) {
    throw Failure(FailureKind::usage, "-o -: --dump-after writes files of its own", "name a folder");
  }
}

// Requires a language and a target that have fused multiply-adds.
void check_fma(const GenerateArguments& arguments) {
  if (!arguments.fuses) return;
  const LanguageRow& language = language_row(arguments.language);
  if (!language.has_fma || (arguments.python && !language.has_kernels)) {
    throw Failure(FailureKind::usage,
                  arguments.python ? "--fma: the module for Python is without fused multiply-adds"
                                   : fmt::format("--fma: {} has no fused multiply-add", language.name),
                  "leave it out");
  }
  if (arguments.firmware.empty() || arguments.scalars.front() == "float") return;
  if (std::string(firmware_target(arguments.firmware).scalar) == "float") {
    throw Failure(FailureKind::usage,
                  fmt::format("--fma: {} has fused multiply-adds in float only", arguments.firmware),
                  "use --scalar float, or leave --fma out");
  }
}

// Requires C++ without fused operations for limbs in the lanes of vectors.
void check_limbs(const GenerateArguments& arguments) {
  if (!arguments.has_lanes()) return;
  if (!language_row(arguments.language).has_lanes) {
    throw Failure(FailureKind::usage, fmt::format("--limbs lanes: not in {}", language_row(arguments.language).name),
                  "leave it out, or use " + languages_text(&LanguageRow::has_lanes));
  }
  if (arguments.fuses) {
    throw Failure(FailureKind::usage, "--limbs lanes: not with fused multiply-adds", "leave it out, or --fma");
  }
}

// Requires C++ for conventions, each named once.
void check_conventions(const GenerateArguments& arguments) {
  const std::vector<std::string>& names = arguments.conventions;
  for (auto name = names.begin(); name != names.end(); ++name) {
    if (std::find(names.begin(), name, *name) == name) continue;
    throw Failure(FailureKind::usage, "--convention: \"" + *name + "\" is asked for twice", "name it once");
  }
  if (arguments.conventions.empty() || language_row(arguments.language).has_conventions()) return;
  throw Failure(FailureKind::usage, fmt::format("--convention: not in {}", language_row(arguments.language).name),
                "leave it out, or use " + languages_text(&LanguageRow::has_conventions));
}

void check_usage(const GenerateArguments& arguments) {
  check_conventions(arguments);
  check_stdout(arguments);
  check_form(arguments);
  check_fma(arguments);
  check_limbs(arguments);
  check_pass_names(arguments.dumped_passes);
  if (arguments.fused.size() == 1) {
    throw Failure(FailureKind::usage, "--fuse: one function is no set", "name two or more, separated by commas");
  }
  const LanguageRow& language = language_row(arguments.language);
  if (!language.has_parts && arguments.most_lines > 0) {
    throw Failure(
        FailureKind::usage,
        fmt::format("--max-lines: functions of {} stay whole, as calls within a kernel are slow", language.name),
        "leave it out");
  }
  if (!language.has_stages && !arguments.staged.empty()) {
    throw Failure(FailureKind::usage, fmt::format("--stages: there are none in {}", language.name),
                  "--fuse computes several functions in one call");
  }
  if (!language.has_scalar && arguments.scalars.front() != "double") {
    throw Failure(FailureKind::usage, fmt::format("--scalar: all numbers of {} are doubles", language.name),
                  "leave it out");
  }
  if (!language.has_namespace && !arguments.name_space.empty()) {
    throw Failure(FailureKind::usage, fmt::format("--namespace: a module of {} has none", language.name),
                  "leave it out; --name names the file");
  }
}

GenerationOptions generation_options(const GenerateArguments& arguments) {
  GenerationOptions options{arguments.options(), arguments.staged, arguments.fused, {}, {}};
  options.functions = arguments.functions;
  options.in_processes = !arguments.trace;  // which shows what each function takes
  options.needs_quasi_velocities = !arguments.conventions.empty();
  options.form.name_space = arguments.name_space;
  options.form.scalar = arguments.scalars.front();
  options.form.most_lines = arguments.most_lines;
  options.form.language = arguments.language;
  options.form.file_name = arguments.file_name;
  options.form.form = arguments.is_pair() ? Form::pair : Form::header;
  options.form.sines = arguments.sincos == "library" ? Sines::library : Sines::polynomials;
  options.form.fuses = arguments.fuses;
  options.form.limbs_in_lanes = arguments.has_lanes();
  options.form.frames = parameter_frames(arguments.frames);
  options.form.more_scalars = {arguments.scalars.begin() + 1, arguments.scalars.end()};
  options.options_stamp = [&arguments](const std::vector<OptimisedFunction>& functions) {
    return stamp_of(arguments, functions);
  };
  return options;
}

GenerationResult generated(const GenerateArguments& arguments, const GenerationOptions& options) {
  Progress progress(arguments.quiet);
  GenerationResult result = generate_code(arguments.robot, options, progress);
  if (arguments.trace) {
    erase_progress();
    fmt::print(stderr, "{}", describe_trace(progress.steps(), result.functions));
  }
  return result;
}

// The rounding of the text's constants, and the rounding again when C++ is compiled for float.
std::string rounding_of_constants(const GenerationResult& result, const GenerationOptions& options) {
  const std::string written = result.read_back->constants();
  return written == "double" && options.is_for_float() ? "double, and float rounds these once more" : written;
}

nlohmann::ordered_json manifest_of(const GenerationResult& result, const SnapEffects& effects) {
  const LoadedRobot& robot = result.robot;
  const std::vector<GeneratedFile>& files = result.files;
  nlohmann::ordered_json manifest = {
      {"flatdyn", kProgramVersion}, {"options", result.form.options_stamp}, {"header", files[0].name}};
  manifest.update(model_json(robot, effects));
  manifest["functions"] = functions_json(result.functions, robot.mechanism, result.form.fuses);
  if (result.torque_deviation) manifest["error_budget"] = abbreviation_json(robot, *result.torque_deviation);
  if (result.stages) manifest["stages"] = stages_json(*result.stages, result.form.fuses);
  manifest["proof"] = proofs_json(result.proofs);
  manifest["proof_of_robot"] = as_read_json(result.as_read);
  // The hash tells a reader whether the files belong together.
  manifest["header_hash"] = content_hash({files[0].text});
  if (files.size() > 1) {
    manifest["source"] = files[1].name;
    manifest["source_hash"] = content_hash({files[1].text});
  }
  return manifest;
}

// The files that were asked for in addition to header and source.
std::vector<GeneratedFile> companions(GenerationResult& result, const GenerateArguments& arguments) {
  const LoadedRobot& robot = result.robot;
  const std::vector<Function> functions = functions_of(result);
  std::vector<GeneratedFile> files;
  if (!arguments.firmware.empty()) {
    Progress progress(arguments.quiet);
    const FirmwareTarget& target = firmware_target(arguments.firmware);
    if (const std::string soft = note_of_soft_scalar(target, arguments.scalars.front()); !soft.empty()) {
      result.findings.note({robot.robot.file, 0}, soft, "use --scalar float, unless time does not matter");
    }
    for (const FirmwareFile& file :
         firmware_files(robot.robot, robot.mechanism, functions, result.form, target, progress)) {
      files.push_back({file.name, file.text});
    }
  }
  if (language_row(result.form.language).types != nullptr) {
    files.push_back(
        {file_name(robot.mechanism, result.form) + ".d.ts", emit_types(robot.mechanism, functions, result.form)});
  }
  if (const auto more_files = language_row(result.form.language).more_files; more_files != nullptr) {
    for (GeneratedFile& file : more_files(robot.mechanism, functions, result.form)) files.push_back(std::move(file));
  }
  const std::string name = arguments.python ? module_name(robot.mechanism, result.form) : "";
  if (arguments.python && language_row(arguments.language).has_kernels) {
    const CudaPythonModule module = cuda_python_module(robot.mechanism, functions, result.form);
    files.push_back({name + ".py", module.module});
    files.push_back({name + "_python.cu", module.launchers});
  } else if (arguments.python) {
    const PythonModule module = python_module(robot.mechanism, functions, result.form);
    files.push_back({name + ".py", module.module});
    files.push_back({name + "_batch.c", module.batch});
  }
  for (GeneratedFile& file : pass_dump(result, arguments.dumped_passes)) files.push_back(std::move(file));
  return files;
}

// The headers in other conventions. Functions that they leave out are noted.
std::vector<GeneratedFile> convention_headers(GenerationResult& result, const GenerateArguments& arguments) {
  std::vector<GeneratedFile> files;
  for (const std::string& name : arguments.conventions) {
    ConventionHeader header =
        language_row(result.form.language)
            .convention_header(result.robot.mechanism, functions_of(result), result.form, convention_of(name));
    files.push_back(std::move(header.file));
    for (const std::string& each : header.left_out) {
      result.findings.note({result.robot.robot.file, 0}, "--convention: " + each, "");
    }
  }
  return files;
}

// All files with their paths.
std::vector<TextFile> files_to_write(GenerationResult& result, const std::string& manifest,
                                     const GenerateArguments& arguments) {
  if (arguments.is_to_stdout()) return {{kStdout, result.files.front().text}};
  const std::filesystem::path folder = arguments.folder;
  std::vector<TextFile> files;
  for (const GeneratedFile& file : result.files) files.push_back({folder / file.name, file.text});
  for (const GeneratedFile& file : companions(result, arguments)) files.push_back({folder / file.name, file.text});
  for (const GeneratedFile& file : convention_headers(result, arguments)) {
    files.push_back({folder / file.name, file.text});
  }
  files.push_back({folder / (file_name(result.robot.mechanism, result.form) + ".json"), manifest});
  return files;
}

// The tables that people read.
std::string tables(const GenerationResult& result, const SnapEffects& effects, const GenerateArguments& arguments,
                   const std::string& rounding) {
  const LoadedRobot& robot = result.robot;
  const SnapDetail detail = arguments.verbose ? SnapDetail::each : SnapDetail::one_line;
  std::string text = describe_model(robot, effects, detail) + "\n" +
                     describe_functions(result.functions, symbol_names(robot.mechanism), arguments.fuses) + "\n";
  text += describe_formulations(result.functions);
  if (result.stages) text += describe_stages(*result.stages, arguments.fuses) + "\n";
  if (result.torque_deviation) text += describe_abbreviation(robot, *result.torque_deviation) + "\n";
  text += describe_compile_time(result.functions, result.stages, result.form);
  text += describe_code_size(result.functions, result.form, !limbs_of(robot.mechanism).empty());
  text += describe_proofs(result.proofs, result.as_read, rounding) + "\n";
  if (!arguments.firmware.empty()) {
    text += fmt::format("a self test for {}: make -C {} run\n", arguments.firmware, arguments.folder);
  }
  return text;
}

ExitCode generate(GenerateArguments arguments) {
  choose_for_python(arguments);
  choose_for_firmware(arguments);
  check_usage(arguments);
  const GenerationOptions options = generation_options(arguments);
  GenerationResult result = generated(arguments, options);
  const LoadedRobot& robot = result.robot;
  if (!arguments.quiet) note_rounded_angles(robot, options, result.functions, result.findings);
  const SnapEffects effects = snap_effects(robot, options.read);
  const std::string manifest = json_text(manifest_of(result, effects));
  const std::string done = arguments.delivery.deliver(files_to_write(result, manifest, arguments), robot.robot.files);
  print_diagnostics(robot.diagnostics, arguments);
  print_diagnostics(result.findings, arguments);
  if (arguments.json) {
    print_result(manifest);
  } else if (!arguments.is_to_stdout()) {
    if (!arguments.quiet) {
      print_result(tables(result, effects, arguments, rounding_of_constants(result, options)));
    }
    if (!arguments.quiet || arguments.delivery.only_prints()) print_result(done);
  }
  return ExitCode::ok;
}

// Adds the options for the language of the code and the files around it.
void add_form_options(CLI::App& command, GenerateArguments& arguments) {
  arguments.scalar_given =
      command
          .add_option("--scalar", arguments.scalars,
                      "scalar of the constants; of a pair, one or two that it is compiled for: double,float")
          ->delimiter(',')
          ->allow_extra_args(false)
          ->check(CLI::IsMember({"double", "float"}))
          ->default_str("double");
  arguments.language_given = command.add_option("--language", arguments.language, descriptions_of_languages())
                                 ->check(CLI::IsMember(language_options()))
                                 ->capture_default_str();
  command
      .add_option(
          "--convention", arguments.conventions,
          "of C++, with a floating base or spherical joints: also a header with the functions as these programs "
          "write pose, velocity, acceleration and force, and steps of q; pose: flatdyn's own, with the pose "
          "of the base for gravity")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(convention_names()));
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
  command.add_flag(
      "--python", arguments.python,
      "a module for Python over the C form, for one state or a batch: ctypes and numpy; over the CUDA form, for "
      "arrays of PyTorch, CuPy or JAX on the device");
}

// Adds the options that shape the code, which its stamp has.
void add_code_options(CLI::App* command, const std::shared_ptr<GenerateArguments>& arguments) {
  add_functions_option(*command, arguments->functions);
  add_error_budget_option(*command, *arguments);
  add_search_option(*command, *arguments);
  add_names_option(*command, "--stages", arguments->staged,
                   "these functions once more as members of what at(q) and with(qd) return: what they share at the "
                   "same positions, or positions and velocities, is computed once");
  add_names_option(*command, "--fuse", arguments->fused, "one more function that computes all of these at once");
  add_form_options(*command, *arguments);
  command
      ->add_option(
          "--sincos", arguments->sincos,
          "where sines and cosines are from: polynomials of the code's own, with the same bits on every machine, "
          "or the library")
      ->check(CLI::IsMember({"polynomials", "library"}))
      ->capture_default_str();
  command->add_flag("--fma", arguments->fuses,
                    "fused multiply-adds, a b + c rounded once, where the target has an instruction for them: fewer "
                    "instructions and errors, other bits");
  command
      ->add_option("--limbs", arguments->limbs,
                   "of C++: each limb by itself (apart), or limbs of the same structure, such as legs, in the lanes of "
                   "vectors")
      ->check(CLI::IsMember({"apart", "lanes"}))
      ->capture_default_str();
  command
      ->add_option("--namespace", arguments->name_space,
                   "C++ namespace, and in C what names begin with; default: the robot's name")
      ->check(kNotEmpty)
      ->type_name("NAME");
  command->add_option("--name", arguments->file_name, "name of the files, without folder; default: the robot's name")
      ->check(file_name_fault)
      ->type_name("NAME");
  command
      ->add_option("--max-lines", arguments->most_lines,
                   "no function of the header is longer: longer ones call parts of their own")
      ->check(CLI::Range(kFewestLines, kMostLines))
      ->type_name("N");
  add_frames_option(*command, arguments->frames);
}

}  // namespace

GenerationOptions options_of_stamp(const std::vector<std::string>& stamp, const OptionsGiven& given) {
  CLI::App command;
  const auto arguments = std::make_shared<GenerateArguments>();
  arguments->add_settings_to(command);
  add_code_options(&command, arguments);
  command.parse(std::vector<std::string>(stamp.rbegin(), stamp.rend()));
  check_usage(*arguments);
  given.replace_in(*arguments);
  if (!given.functions.empty()) arguments->functions = given.functions;
  arguments->quiet = given.quiet;
  GenerationOptions options = generation_options(*arguments);
  options.options_stamp = [arguments](const auto& functions) { return stamp_of(*arguments, functions); };
  return options;
}

Run add_generate(CLI::App& app) {
  auto* command = app.add_subcommand(
      "generate",
      "Write code that computes the robot's dynamics.\n\n"
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
  add_code_options(command, arguments);
  add_names_option(*command, "--dump-after", arguments->dumped_passes,
                   "write every function as text after these passes: names of passes, derived (before the first one), "
                   "or all");
  command->add_flag("--trace", arguments->trace,
                    "show on stderr how long each stage and pass takes, and what operations it leaves");
  arguments->delivery.add_to(*command);
  return [arguments] { return generate(*arguments); };
}

}  // namespace flatdyn
