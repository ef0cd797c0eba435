// SPDX-License-Identifier: GPL-2.0-or-later
#include "plan_together.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "passes/draft.hpp"
#include "plan.hpp"
#include "scene/specialise.hpp"
#include "symbolic/combined.hpp"
#include "symbolic/formulations.hpp"

namespace flatdyn {
namespace {

// A way to make one function of the set; and of what it is made, the ways to make that, by name: B in its second way.
struct WayInSet {
  Function function;
  std::map<std::string, std::size_t> made_of;
};

// All ways to make the functions of a set from one choice of frames and grouping.
class Ways {
 public:
  Ways(const Model& model, const std::vector<std::string>& functions, const Choices& choices)
      : model_(model), functions_(functions), choices_(choices) {}

  // Those of the function alone, then those from others that are asked for as well, B and the bias.
  std::vector<WayInSet> of(const std::string& name) {
    std::vector<WayInSet> ways;
    for (const Function& way : alone(name)) ways.push_back(in_scene(way, {}));
    const Function usual = alone(name).front();
    if (name == "kinetic_energy" && has("inertia_matrix")) {
      const std::vector<Function>& matrices = alone("inertia_matrix");
      for (std::size_t b = 0; b < matrices.size(); ++b) {
        ways.push_back(in_scene(from_inertia_matrix(usual, matrices[b]), {{"inertia_matrix", b}}));
      }
    }
    if (name == "inverse_dynamics" && ((has("inertia_matrix") && has("bias")) || has("forward_dynamics"))) {
      const std::vector<Function>&matrices = alone("inertia_matrix"), &biases = alone("bias");
      for (std::size_t b = 0; b < matrices.size(); ++b) {
        for (std::size_t n = 0; n < biases.size(); ++n) {
          ways.push_back(
              in_scene(from_inertia_matrix(usual, matrices[b], biases[n]), {{"inertia_matrix", b}, {"bias", n}}));
        }
      }
    }
    return ways;
  }

  // Throws BadInput.
  void refuse_what_the_scene_cannot_have() const { refuse_errors(found_); }

 private:
  bool has(const char* name) const { return std::find(functions_.begin(), functions_.end(), name) != functions_.end(); }

  const std::vector<Function>& alone(const std::string& name) {
    std::vector<Function>& ways = alone_[name];
    if (!ways.empty()) return ways;
    for (Way way = 0; way < kWays; ++way) {
      std::optional<Function> derived = formulation(derived_from(model_), name, way, choices_);
      if (derived) ways.push_back(std::move(*derived));
    }
    return ways;
  }

  WayInSet in_scene(const Function& function, std::map<std::string, std::size_t> made_of) {
    return {specialised(function, model_.mechanism, model_.robot.scene, found_), std::move(made_of)};
  }

  const Model& model_;
  const std::vector<std::string>& functions_;
  const Choices& choices_;
  std::map<std::string, std::vector<Function>> alone_;
  Diagnostics found_;
};

// Of each function's ways the one that makes the whole cheapest, one function after the other; what a function is made
// of comes with it.
class CheapestWays {
 public:
  CheapestWays(const std::vector<std::string>& functions, std::vector<std::vector<WayInSet>> ways)
      : functions_(functions), ways_(std::move(ways)), chosen_(functions.size(), 0), best_(made(chosen_)) {}

  Fusion find() {
    // Once more, as what one function is made of decides what is cheapest for those before.
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
  std::vector<std::size_t> with_what_it_is_made_of(std::vector<std::size_t> chosen, const WayInSet& way) const {
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
  std::vector<std::vector<WayInSet>> ways_;
  std::vector<std::size_t> chosen_;
  Fusion best_;
};

// From the same choices, so that they share what they can.
Fusion fused_from(const Model& model, const std::vector<std::string>& functions, const Choices& choices) {
  Ways ways(model, functions, choices);
  std::vector<std::vector<WayInSet>> of_all;
  for (const std::string& name : functions) of_all.push_back(ways.of(name));
  ways.refuse_what_the_scene_cannot_have();
  return CheapestWays(functions, std::move(of_all)).find();
}

// Each in its own best form: where there is little to share, that may cost less.
class SideBySide {
 public:
  SideBySide(const Model& model, const std::vector<std::string>& functions, Progress& progress) : model_(model) {
    for (const std::string& name : functions) {
      OptimisedFunction function = planned(model, name, progress).made;
      made_.push_back(std::move(function.function));
      derived_.push_back(std::move(function.derived));
    }
  }

  OptimisedFusion find() {
    for (Function& function : made_) make_of_others(function);
    return {fused(made_), fused(derived_).function, {}};
  }

 private:
  // Where that costs less.
  void make_of_others(Function& function) {
    const Function *B = whole("inertia_matrix"), *bias = whole("bias");
    std::optional<Function> other;
    if (function.name == "kinetic_energy" && B != nullptr) other = from_inertia_matrix(function, *B);
    if (function.name == "inverse_dynamics" && B != nullptr && bias != nullptr) {
      other = from_inertia_matrix(function, *B, *bias);
    }
    if (!other) return;
    Diagnostics none;
    Function changed = specialised(*other, model_.mechanism, model_.robot.scene, none);
    const int before = cost(fused(made_).function);
    std::swap(function, changed);
    if (cost(fused(made_).function) >= before) std::swap(function, changed);
  }

  // One of the set, if the scene leaves out none of its entries.
  const Function* whole(const char* name) const {
    const auto found = std::find_if(made_.begin(), made_.end(), [name](const Function& f) { return f.name == name; });
    return found != made_.end() && found->outputs[0].left_out.empty() ? &*found : nullptr;
  }

  const Model& model_;
  std::vector<Function> made_, derived_;
};

}  // namespace

OptimisedFusion planned_together(const Model& model, const std::vector<std::string>& functions, Progress& progress) {
  progress.step("deriving functions together");
  const Mechanism& mechanism = derived_from(model);
  const bool guards_pivots = std::any_of(functions.begin(), functions.end(),
                                         [&](const std::string& name) { return may_lose_pivots(mechanism, name); });
  OptimisedFusion result;
  std::optional<int> least;
  cheapest_choices(mechanism, [&](Choices choices) {
    choices.guards_pivots = guards_pivots;
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
