// SPDX-License-Identifier: GPL-2.0-or-later
// The whole program: robot file → Robot → Mechanism → functions → passes → proof → text → the text read back.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "code/languages/emit.hpp"
#include "code/readback/emitted_text.hpp"
#include "functions/planning/make_functions.hpp"
#include "proof/verify/proof.hpp"
#include "proof/verify/torque_deviation.hpp"

namespace flatdyn {

struct GenerationOptions : PipelineOptions {
  std::vector<std::string> staged;  // functions that are also members of stages
  std::vector<std::string> fused;   // functions that one fused function computes together
  EmitOptions form;                 // language, scalars and names; stamps and facts are filled in
  // The options as text, for the stamp.
  std::function<std::string(const std::vector<OptimisedFunction>&)> options_stamp;
  bool needs_quasi_velocities = false;  // whether other robots are refused, since they have no other conventions

  bool is_for_float() const;  // whether the code is compiled for float
};

// Proven code with everything known about it.
struct GenerationResult {
  LoadedRobot robot;
  std::vector<OptimisedFunction> functions;  // fused ones last
  std::optional<Stages> stages;
  std::vector<Proof> proofs;
  AsReadResult as_read;
  std::optional<TorqueDeviation> torque_deviation;  // cost of an error budget
  Diagnostics findings;
  EmitOptions form;
  std::vector<GeneratedFile> files;  // the header, and the source if there is one
  std::optional<EmittedText> read_back;
  std::vector<Function> kernel_parts{};  // in CUDA: the parts in which kernels compute functions
};

// Runs all stages except writing. Throws BadInput for errors in the input, Failure(verification_failed) if the code is
// not what the Lagrangian says, or the Lagrangian not that of the robot as read.
GenerationResult generate_code(const std::filesystem::path& robot_file, const GenerationOptions& options,
                               Progress& progress);

// The same for several scalars, one result for each: functions are derived and proven once, and written and read back
// for every scalar.
std::vector<GenerationResult> generate_code_for(const std::filesystem::path& robot_file,
                                                const GenerationOptions& options,
                                                const std::vector<std::string>& scalars, Progress& progress);

// The functions of the result, in their order.
std::vector<Function> functions_of(const GenerationResult& result);
// The functions of the text without stages: these as the language writes them and, in CUDA, the parts of their kernels.
std::vector<Function> functions_of_text(const GenerationResult& result);

}  // namespace flatdyn
