// SPDX-License-Identifier: GPL-2.0-or-later
// The model and the functions made from it, as text for people and as JSON for programs.
#pragma once

#include <nlohmann/json.hpp>

#include "code/lower/stages.hpp"
#include "derivation/parameters/parameter_frames.hpp"
#include "functions/load/loaded_robot.hpp"
#include "functions/planning/optimised_function.hpp"
#include "report/snap_report.hpp"

namespace flatdyn {

// Joints, merged links, and snapped numbers with their effects (proof/verify/snap_effect.hpp). JSON also has the
// canonical frames and the inertial parameters in them: numbers, or the text of an expression in the free symbols.
std::string describe_model(const LoadedRobot& model, const SnapEffects& snap_effects, SnapDetail detail);
nlohmann::ordered_json model_json(const LoadedRobot& model, const SnapEffects& snap_effects);

// The bodies to which the names of parameters in these frames refer, with their inertial parameters about the frames'
// origins: the canonical ones with their frames, or the links as written. report/links_in_file.hpp has links together
// with what is fixed to them.
std::string describe_bodies(const Mechanism& mechanism, ParameterFrames frames);

// `fuses`, here and below: whether operations are counted with fused multiply-adds.
// For each function its operation counts, the inputs it reads and its structural zeros.
std::string describe_functions(const std::vector<OptimisedFunction>& functions, const std::vector<std::string>& symbols,
                               bool fuses = false);

// The formulations, other than recursions, that cost less than others of the same functions. Empty if there are none.
std::string describe_formulations(const std::vector<OptimisedFunction>& functions);

// Stages and their members in the order of the calls: "at", "Configuration::gravity", …, "with", ….
struct StagePiece {
  std::string name;
  const Function* function;
};
std::vector<StagePiece> stage_pieces(const Stages& stages);

// The cost of each stage and of each of its members.
std::string describe_stages(const Stages& stages, bool fuses = false);
nlohmann::ordered_json stages_json(const Stages& stages, bool fuses = false);

nlohmann::ordered_json functions_json(const std::vector<OptimisedFunction>& functions, const Mechanism& mechanism,
                                      bool fuses = false);

std::vector<std::string> symbol_names(const Mechanism& mechanism);

}  // namespace flatdyn
