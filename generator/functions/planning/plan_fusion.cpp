// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/planning/plan_fusion.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "derivation/dynamics/combined.hpp"
#include "functions/load/bad_input.hpp"
#include "functions/planning/formulations.hpp"
#include "functions/planning/plan.hpp"
#include "functions/scene/specialise.hpp"
#include "graph/passes/draft.hpp"

namespace flatdyn {
namespace {

// The functions of a set from which this one may be made: the kinetic energy from B, inverse dynamics from B and the
// bias.
std::vector<std::string> parts_of(const std::string& function) {
  if (function == "kinetic_energy") return {"inertia_matrix"};
  if (function == "inverse_dynamics") return {"inertia_matrix", "bias"};
  return {};
}

// The function made from these parts.
Function from_parts(const Function& function, const std::vector<const Function*>& parts) {
  return parts.size() == 1 ? from_inertia_matrix(function, *parts[0])
                           : from_inertia_matrix(function, *parts[0], *parts[1]);
}

// The formulation of each part, by the part's name.
using FormulationOfPart = std::map<std::string, std::size_t>;

// One way to make a function of the set, and the formulations of the parts that it is made from.
struct ReuseCandidate {
  Function function;
  FormulationOfPart made_of;
};

// All ways to make the functions of a set from one choice of frames and grouping.
class ReuseCandidates {
 public:
  ReuseCandidates(const LoadedRobot& model, const std::vector<std::string>& functions, const Choices& choices)
      : model_(model), functions_(functions), choices_(choices) {}

  // The candidates for a function: its own formulations, then those made from other functions of the set.
  std::vector<ReuseCandidate> of(const std::string& name) {
    std::vector<ReuseCandidate> ways;
    for (const Function& way : alone(name)) ways.push_back(in_scene(way, {}));
    const std::vector<std::string> parts = parts_of(name);
    if (!makes(name, parts)) return ways;
    const Function usual = alone(name).front();
    for (const FormulationOfPart& chosen : ways_of(parts)) {
      std::vector<const Function*> functions;
      for (const std::string& part : parts) functions.push_back(&alone(part)[chosen.at(part)]);
      ways.push_back(in_scene(from_parts(usual, functions), chosen));
    }
    return ways;
  }

  // Throws BadInput if the scene asks a function for something that it does not have.
  void refuse_what_the_scene_cannot_have() const { refuse_errors(found_); }

 private:
  bool has(const std::string& name) const {
    return std::find(functions_.begin(), functions_.end(), name) != functions_.end();
  }

  // Whether the set has all parts; forward dynamics computes those of inverse dynamics, too.
  bool makes(const std::string& name, const std::vector<std::string>& parts) const {
    if (name == "inverse_dynamics" && has("forward_dynamics")) return true;
    return !parts.empty() && std::all_of(parts.begin(), parts.end(), [this](const auto& part) { return has(part); });
  }

  // All combinations of the parts' formulations.
  std::vector<FormulationOfPart> ways_of(const std::vector<std::string>& parts) {
    std::vector<FormulationOfPart> all(1);
    for (const std::string& part : parts) {
      std::vector<FormulationOfPart> longer;
      for (const FormulationOfPart& chosen : all) {
        for (std::size_t way = 0; way < alone(part).size(); ++way) {
          longer.push_back(chosen);
          longer.back()[part] = way;
        }
      }
      all = std::move(longer);
    }
    return all;
  }

  const std::vector<Function>& alone(const std::string& name) {
    std::vector<Function>& ways = alone_[name];
    if (!ways.empty()) return ways;
    for (FormulationIndex way = 0; way < kFormulationCount; ++way) {
      std::optional<Function> derived = formulation(effective_mechanism(model_), name, way, choices_);
      if (derived) ways.push_back(std::move(*derived));
    }
    return ways;
  }

  ReuseCandidate in_scene(const Function& function, FormulationOfPart made_of) {
    return {specialised(function, model_.mechanism, model_.robot.scene, found_), std::move(made_of)};
  }

  const LoadedRobot& model_;
  const std::vector<std::string>& functions_;
  const Choices& choices_;
  std::map<std::string, std::vector<Function>> alone_;
  Diagnostics found_;
};

// Chooses for each function, one after the other, the candidate that makes the whole cheapest. A candidate made from
// parts fixes the formulations of these parts, too.
class CheapestDerivations {
 public:
  CheapestDerivations(const std::vector<std::string>& functions, std::vector<std::vector<ReuseCandidate>> ways)
      : functions_(functions), ways_(std::move(ways)), chosen_(functions.size(), 0), best_(made(chosen_)) {}

  Fusion find() {
    // A second round, because the choice for one function affects what is cheapest for those before it.
    for (int round = 0; round < 2; ++round) {
      for (std::size_t k = 0; k < ways_.size(); ++k) {
        for (std::size_t way = 0; way < ways_[k].size(); ++way) {
          std::vector<std::size_t> changed = chosen_;
          changed[k] = way;
          keep_if_cheaper(changed);
          keep_if_cheaper(with_what_it_is_made_of(changed, ways_[k][way]));
        }
      }
    }
    return std::move(best_);
  }

 private:
  std::vector<std::size_t> with_what_it_is_made_of(std::vector<std::size_t> chosen, const ReuseCandidate& way) const {
    for (std::size_t k = 0; k < functions_.size(); ++k) {
      const auto part = way.made_of.find(functions_[k]);
      if (part != way.made_of.end()) chosen[k] = part->second;
    }
    return chosen;
  }

  Fusion made(const std::vector<std::size_t>& chosen) const {
    std::vector<Function> functions;
    for (std::size_t k = 0; k < chosen.size(); ++k) functions.push_back(ways_[k][chosen[k]].function);
    return fused(functions);
  }

  void keep_if_cheaper(const std::vector<std::size_t>& changed) {
    if (changed == chosen_) return;
    Fusion candidate = made(changed);
    if (cost(candidate.function) >= cost(best_.function)) return;
    best_ = std::move(candidate);
    chosen_ = changed;
  }

  const std::vector<std::string>& functions_;
  std::vector<std::vector<ReuseCandidate>> ways_;
  std::vector<std::size_t> chosen_;
  Fusion best_;
};

// Fuses the functions made from the same choices, so that they share as much as possible.
Fusion fused_from(const LoadedRobot& model, const std::vector<std::string>& functions, const Choices& choices) {
  ReuseCandidates ways(model, functions, choices);
  std::vector<std::vector<ReuseCandidate>> of_all;
  for (const std::string& name : functions) of_all.push_back(ways.of(name));
  ways.refuse_what_the_scene_cannot_have();
  return CheapestDerivations(functions, std::move(of_all)).find();
}

// The set with each function in its own best form: where there is little to share, that may cost less.
class SideBySide {
 public:
  SideBySide(const LoadedRobot& model, const std::vector<std::string>& functions, Progress& progress) : model_(model) {
    for (const std::string& name : functions) {
      OptimisedFunction function = planned(model, name, progress).optimised;
      made_.push_back(std::move(function.function));
      derived_.push_back(std::move(function.derived));
    }
  }

  OptimisedFusion find() {
    for (Function& function : made_) make_of_others(function);
    return {fused(made_), fused(derived_).function, {}};
  }

 private:
  // Makes the function from others of the set, if that costs less.
  void make_of_others(Function& function) {
    std::vector<const Function*> parts;
    for (const std::string& part : parts_of(function.name)) parts.push_back(whole(part));
    if (parts.empty() || std::find(parts.begin(), parts.end(), nullptr) != parts.end()) return;
    Diagnostics none;
    Function changed = specialised(from_parts(function, parts), model_.mechanism, model_.robot.scene, none);
    const int before = cost(fused(made_).function);
    std::swap(function, changed);
    if (cost(fused(made_).function) >= before) std::swap(function, changed);
  }

  // A function of the set; nullptr if it is not in the set or the scene leaves out entries of it.
  const Function* whole(const std::string& name) const {
    const auto found = std::find_if(made_.begin(), made_.end(), [&name](const Function& f) { return f.name == name; });
    return found != made_.end() && found->outputs[0].left_out.empty() ? &*found : nullptr;
  }

  const LoadedRobot& model_;
  std::vector<Function> made_, derived_;
};

}  // namespace

OptimisedFusion planned_fusion(const LoadedRobot& model, const std::vector<std::string>& functions,
                               Progress& progress) {
  progress.step("deriving functions together");
  const Mechanism& mechanism = effective_mechanism(model);
  const PivotGuard guard = pivot_guard(mechanism, functions);
  OptimisedFusion result;
  std::optional<int> least;
  cheapest_choices(mechanism, [&](Choices choices) {
    choices.guard = guard;
    Fusion made = fused_from(model, functions, choices);
    const int operations = cost(made.function);
    if (!least || operations < *least) {
      least = operations;
      result.fusion = std::move(made);
    }
    return operations;
  });
  progress.step("optimising functions together");
  result.derived = result.fusion.function;
  result.fusion.function = run_passes(result.fusion.function, &result.passes);
  OptimisedFusion apart = SideBySide(model, functions, progress).find();
  return cost(apart.fusion.function) < cost(result.fusion.function) ? std::move(apart) : std::move(result);
}

}  // namespace flatdyn
