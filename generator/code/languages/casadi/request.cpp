// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/casadi/request.hpp"

#include <algorithm>

#include "base/diagnostics/diagnostics.hpp"
#include "functions/derivative_names.hpp"
#include "graph/function_name.hpp"

namespace flatdyn {
namespace {

// A function, and its derivatives that are asked for by name.
struct Asked {
  std::string function;
  std::vector<Derivative> derivatives;

  bool has(Derivative derivative) const {
    return std::find(derivatives.begin(), derivatives.end(), derivative) != derivatives.end();
  }
};

std::vector<Asked> by_function(const std::vector<std::string>& names) {
  std::vector<Asked> functions;
  for (const std::string& name : names) {
    const FunctionName parts = parts_of_name(name);
    const std::string function = parts.of_whole();
    auto found = std::find_if(functions.begin(), functions.end(),
                              [&function](const Asked& each) { return each.function == function; });
    if (found == functions.end()) found = functions.insert(functions.end(), Asked{function, {}});
    if (parts.derivative != Derivative::none) found->derivatives.push_back(parts.derivative);
  }
  return functions;
}

// Why there are no derivatives by the entries of q; empty: there are.
std::string obstacle(const Mechanism& mechanism) {
  if (mechanism.has_loops()) {
    return "CasADi derives by the entries of q, and derivatives of robots with closed loops are by the independent "
           "joints, along which the others move";
  }
  if (!mechanism.has_spherical_joints()) return "";
  return "CasADi derives by the entries of q, and derivatives of spherical joints are by turns, not by the entries of "
         "quaternions";
}

// The derivatives of a function that are needed for those that CasADi asks for.
void add_derivatives(const Asked& asked, FunctionsNeeded& needed) {
  const auto name = [&asked](Derivative derivative) { return prefix_of(derivative) + ":" + asked.function; };
  const bool has_all = asked.derivatives.empty(), has_second = has_all || asked.has(Derivative::contracted_hessian);
  const auto add_if = [&](bool is_needed, Derivative derivative) {
    if (is_needed) needed.functions.push_back(name(derivative));
  };
  add_if(has_all || asked.has(Derivative::jacobian), Derivative::jacobian);
  add_if(has_second || asked.has(Derivative::vector_times_jacobian), Derivative::vector_times_jacobian);
  add_if(asked.has(Derivative::jacobian_times_vector), Derivative::jacobian_times_vector);
  if (has_second) {
    needed.fused.push_back({name(Derivative::contracted_hessian), name(Derivative::jacobian)});
  }
}

}  // namespace

FunctionsNeeded functions_for_casadi(const Mechanism& mechanism, const std::vector<std::string>& asked) {
  static const std::vector<std::string> usual = {"inverse_dynamics", "forward_dynamics", "forward_kinematics"};
  const std::string why_none = obstacle(mechanism);
  FunctionsNeeded needed;
  for (const Asked& each : by_function(asked.empty() ? usual : asked)) {
    needed.functions.push_back(each.function);
    if (!why_none.empty() && !each.derivatives.empty()) {
      throw Failure(FailureKind::unsupported,
                    prefix_of(each.derivatives.front()) + ":" + each.function + ": " + why_none,
                    "leave derivatives out");
    }
    if (why_none.empty() && (has_derivatives(each.function) || !each.derivatives.empty())) {
      add_derivatives(each, needed);
    }
  }
  if (!why_none.empty()) needed.note = "left out derivatives: " + why_none;
  return needed;
}

}  // namespace flatdyn
