// SPDX-License-Identifier: GPL-2.0-or-later
#include "pipeline/generation.hpp"

#include <algorithm>
#include <utility>

#include "code/conventions/coverage.hpp"
#include "code/emit/narrowed.hpp"
#include "code/languages/language_table.hpp"
#include "code/languages/readers.hpp"
#include "code/lower/kernel_parts.hpp"
#include "code/lower/limbs.hpp"
#include "functions/load/bad_input.hpp"
#include "functions/load/scene_text.hpp"
#include "functions/planning/kernel_columns.hpp"
#include "proof/verify/kernel_proof.hpp"

namespace flatdyn {
namespace {

// Proves of functions in parts that the parts, in their order, compute the function.
void prove_kernels(const GenerationResult& result, std::uint64_t seed) {
  const std::vector<Function> functions = functions_of(result);
  auto next = result.kernel_parts.begin();
  for (std::size_t k = 0; k < result.form.kernel_parts.size(); ++k) {
    const auto end = next + result.form.kernel_parts[k];
    if (next != end) prove_parts(functions[k], {next, end}, seed);
    next = end;
  }
}

void divide_for_kernels(GenerationResult& result, Progress& progress) {
  if (!language_row(result.form.language).has_kernels) return;
  progress.step("dividing among kernels");
  const std::vector<Function> functions = functions_of(result);
  ReadingParts reading;
  for (const Function& each : functions) reading.push_back(reading_own_outputs(result.robot, each));
  KernelParts parts = kernel_parts(functions, values_in_registers(result.form.scalar == "double"), reading);
  result.kernel_parts = std::move(parts.functions);
  result.form.kernel_parts = std::move(parts.counts);
}

// Emits the code and reads all of its files back as one text, which is returned.
std::string emit_and_read_back(GenerationResult& result) {
  const Mechanism& mechanism = result.robot.mechanism;
  result.files = emit_code(mechanism, functions_of_text(result), result.form, result.stages);
  std::string text;
  for (const GeneratedFile& file : result.files) text += file.text;
  result.read_back = EmittedText(text, reader_of(result.form));
  return text;
}

// All functions that are written, including the members of stages.
std::vector<Function> functions_written(const GenerationResult& result) {
  std::vector<Function> functions = functions_of_text(result);
  if (!result.stages) return functions;
  for (const Stage* stage : {&result.stages->configuration, &result.stages->motion}) {
    functions.push_back(stage->make);
    functions.insert(functions.end(), stage->members.begin(), stage->members.end());
  }
  return functions;
}

void check_narrowed_constants(const GenerationOptions& options, GenerationResult& result) {
  if (!options.is_for_float()) return;
  warn_of_narrowed(narrowed_constants(functions_written(result)), {result.robot.robot.file, 0}, result.findings);
  if (options.warnings_are_errors && result.findings.has_warnings()) {
    throw BadInput(FailureKind::input, result.findings);
  }
}

bool has_limbs_in_lanes(const EmittedText& text, std::size_t function) {
  const auto begin = text.tokens().begin();
  const ScannedFunction& scanned = text.functions()[function];
  return std::any_of(begin + static_cast<std::ptrdiff_t>(scanned.begin),
                     begin + static_cast<std::ptrdiff_t>(scanned.end),
                     [](const Token& token) { return token.text == "Limbs"; });
}

// Says which functions are the same as without limbs in the lanes of vectors.
void note_limbs_apart(GenerationResult& result) {
  if (!result.form.limbs_in_lanes) return;
  const Place place{result.robot.robot.file, 0};
  if (limbs_of(result.robot.mechanism).empty()) {
    result.findings.note(place, "--limbs lanes has no effect: the robot has no limbs of the same structure", "");
    return;
  }
  std::string names;
  for (std::size_t k = 0; k < result.functions.size(); ++k) {  // members of stages come behind them
    if (has_limbs_in_lanes(*result.read_back, k)) continue;
    names += (names.empty() ? "" : ", ") + result.functions[k].function.name;
  }
  if (names.empty()) return;
  result.findings.note(
      place, "--limbs lanes has no effect on " + names + ": it saves nothing there, or the code is too long", "");
}

EmitOptions stamped(const GenerationOptions& options, const GenerationResult& result) {
  EmitOptions form = options.form;
  if (options.options_stamp) form.options_stamp = options.options_stamp(result.functions);
  form.input_hash = result.robot.input_hash;
  form.scene_stamp = scene_stamp(result.robot);
  form.scene_facts = scene_facts(result.robot);
  return form;
}

// The functions that are asked for, and those that the language needs for them.
FunctionsNeeded functions_needed(const LoadedRobot& robot, const GenerationOptions& options, Diagnostics& findings) {
  FunctionsNeeded needed{options.functions, {}, ""};
  if (const auto of_language = language_row(options.form.language).functions_needed; of_language != nullptr) {
    needed = of_language(robot.mechanism, functions_asked_for(options.functions, robot.robot.scene));
  }
  if (!needed.note.empty()) findings.note({robot.robot.file, 0}, needed.note, "");
  const bool is_new = std::find(needed.fused.begin(), needed.fused.end(), options.fused) == needed.fused.end();
  if (!options.fused.empty() && is_new) needed.fused.push_back(options.fused);
  return needed;
}

PipelineOptions with_functions(PipelineOptions options, const std::vector<std::string>& names) {
  options.functions = names;
  return options;
}

// With the file's name, where conventions do not apply.
void check_conventions(const LoadedRobot& robot) {
  try {
    check_conventions_apply(robot.mechanism);
  } catch (const Failure& failure) {
    Diagnostics found;
    found.unsupported({robot.robot.file, 0}, failure.what(), failure.hint());
    throw BadInput(failure.kind(), std::move(found));
  }
}

}  // namespace

bool GenerationOptions::is_for_float() const {
  const auto& more = form.more_scalars;
  return form.scalar == "float" || std::find(more.begin(), more.end(), "float") != more.end();
}

std::vector<GenerationResult> generate_code_for(const std::filesystem::path& robot_file,
                                                const GenerationOptions& options,
                                                const std::vector<std::string>& scalars, Progress& progress) {
  GenerationResult result;
  // Read, canonicalise.
  progress.step("reading");
  result.robot = load_robot(robot_file, options);
  const LoadedRobot& robot = result.robot;
  if (options.needs_quasi_velocities) check_conventions(robot);
  // Derive, specialise to the scene, optimise: every function in each of its formulations.
  const FunctionsNeeded needed = functions_needed(robot, options, result.findings);
  result.functions = make_functions(robot, with_functions(options, needed.functions), progress, result.findings);
  std::vector<OptimisedFusion> fused;
  for (const auto& names : needed.fused) fused.push_back(make_fusion(robot, names, progress));
  if (!options.staged.empty()) result.stages = stages_of(make_fusion(robot, options.staged, progress).fusion);
  if (robot.abbreviation) {
    result.torque_deviation = torque_deviation(robot.mechanism, effective_mechanism(robot), robot.robot.scene.at_rest);
  }
  const std::vector<OptimisedFunction> apart = result.functions;
  for (const OptimisedFusion& each : fused) {
    result.functions.push_back({each.fusion.function, each.derived, each.passes, {}});
  }
  // Emit.
  std::vector<GenerationResult> results;
  std::vector<std::string> texts = {robot.input_hash};
  for (const std::string& scalar : scalars) {
    GenerationResult& each = results.emplace_back(result);
    progress.step("emitting and reading back");
    each.form = stamped(options, result);
    each.form.scalar = scalar;
    divide_for_kernels(each, progress);
    texts.push_back(emit_and_read_back(each));
    check_narrowed_constants(options, each);
  }
  // Prove in exact arithmetic, against the Lagrangian, which is that of the robot as read; and the text, read back,
  // must mean what was proven.
  progress.step("proving");
  const std::uint64_t seed = proof_seed(texts);
  result.as_read = prove_robot(robot.robot, robot.mechanism);
  result.proofs = prove(effective_mechanism(robot), apart, fused, result.stages, seed);
  for (GenerationResult& each : results) {
    each.as_read = result.as_read;
    each.proofs = result.proofs;
    prove_text(*each.read_back, {each.robot.mechanism, functions_of_text(each), each.stages, each.form}, seed);
    prove_kernels(each, seed);
    note_limbs_apart(each);
  }
  return results;
}

GenerationResult generate_code(const std::filesystem::path& robot_file, const GenerationOptions& options,
                               Progress& progress) {
  return std::move(generate_code_for(robot_file, options, {options.form.scalar}, progress).front());
}

std::vector<Function> functions_of(const GenerationResult& result) { return functions_of(result.functions); }

std::vector<Function> functions_of_text(const GenerationResult& result) {
  std::vector<Function> functions = functions_of(result);
  const auto as_written = language_row(result.form.language).as_written;
  if (as_written != nullptr) functions = as_written(result.robot.mechanism, functions);
  functions.insert(functions.end(), result.kernel_parts.begin(), result.kernel_parts.end());
  return functions;
}

}  // namespace flatdyn
