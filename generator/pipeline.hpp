// SPDX-License-Identifier: GPL-2.0-or-later
// The whole program: robot file ──▶ Robot ──▶ Mechanism ──▶ functions ──▶ passes ──▶ text. One line per stage.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "diagnostics/progress.hpp"
#include "emit/emit.hpp"
#include "graph/fusion.hpp"
#include "input/reader.hpp"
#include "passes/passes.hpp"
#include "scene/abbreviate.hpp"
#include "search/limit.hpp"
#include "symbolic/choices.hpp"

namespace flatdyn {

struct PipelineOptions {
  ReadOptions read;
  bool warnings_are_errors = false;
  std::vector<std::string> functions;  // empty: those of the scene; without one: default_function_names
  bool whole_functions = false;        // no error budget is worked out, whatever the scene says
  std::optional<SearchLimit> search;   // for the choices that each function is derived from; none: the usual ones
};

// A robot as read, and as made canonical. Diagnostics (warnings, notes) are kept for whoever reports.
struct Model {
  Robot robot;
  Mechanism mechanism;
  std::optional<Abbreviation> abbreviation;  // if the scene has an error budget
  Diagnostics diagnostics;
  std::string input_hash;  // of the texts of the robot file, of one that it names, and of the scene file
};

// What functions are derived from: the mechanism, or as much of it as the error budget leaves.
const Mechanism& derived_from(const Model& model);

// Reads and makes canonical. Errors in the input end in BadInput, which carries the diagnostics.
Model read_model(const std::filesystem::path& path, const PipelineOptions& options);

// Throws Failure(unsupported) if the robot has free symbols. what: that needs their values, "a simulation".
void require_numbers(const Robot& robot, const std::string& what);

// The same robot, with nothing that its scene says of functions: they are whole, hold at any speed, and know no budget.
Model with_whole_functions(Model model);

// Throws BadInput if errors are among them.
void refuse_errors(const Diagnostics& found);

class BadInput : public Failure {
 public:
  BadInput(ExitCode code, Diagnostics found)
      : Failure(code, "the robot file has errors"), diagnostics(std::move(found)) {}
  Diagnostics diagnostics;
};

// What a search for the choices of a function came to.
struct SearchRecord {
  int candidates = 0;
  OperationCount before;
  bool is_closed_form = false;  // which is made without choices, but for the order of factoring
  Choices choices;
};

// A function as derived, then as the passes left it.
struct OptimisedFunction {
  Function function;
  Function derived;
  std::vector<PassRecord> passes;
  std::optional<SearchRecord> search;
};

// Those that options.functions or the scene names, made as the scene needs them; or all that the robot allows: what is
// left out is a warning in `findings`.
std::vector<OptimisedFunction> make_functions(const Model& model, const PipelineOptions& options, Progress& progress,
                                              Diagnostics& findings);

// These functions as one, made from one grouping of the parameters, so that they share what they can.
struct OptimisedFusion {
  Fusion fusion;
  Function derived;
  std::vector<PassRecord> passes;
};
OptimisedFusion make_fusion(const Model& model, const std::vector<std::string>& functions, Progress& progress);

std::vector<Function> functions_of(const std::vector<OptimisedFunction>& optimised);

// To be run in numbers, whatever the scene says of functions. Throws Failure(unsupported) for a robot with free
// symbols; `what` needs their values.
std::vector<Function> whole_functions(const Model& model, const std::vector<std::string>& names,
                                      const std::string& what, Progress& progress);

// Throws Failure(unsupported) for robots with closed loops that are no linear couplings. `what`: "simulate".
void refuse_loops(const Model& model, const std::string& what);

// Names of the functions of the table that are made unless others are asked for, in its order.
std::vector<std::string> default_function_names(const Mechanism& mechanism);

}  // namespace flatdyn
