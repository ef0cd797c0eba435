// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/function_name.hpp"

namespace flatdyn {

std::string prefix_of(Derivative derivative) {
  switch (derivative) {
    case Derivative::none:
      break;
    case Derivative::jacobian_times_vector:
      return "jvp";
    case Derivative::vector_times_jacobian:
      return "vjp";
    case Derivative::jacobian:
      return "jac";
    case Derivative::contracted_hessian:
      return "hessian";
  }
  return "";
}

FunctionName parts_of_name(const std::string& name) {
  FunctionName parts;
  std::string rest = name;
  for (const Derivative derivative : kDerivatives) {
    const std::string beginning = prefix_of(derivative) + ":";
    if (!name.starts_with(beginning)) continue;
    parts.derivative = derivative;
    rest = name.substr(beginning.size());
  }
  // The method of a step is part of its function's name: "step:rk4".
  const bool names_method = rest.starts_with("step:") || rest.starts_with("step_derivatives:");
  const std::size_t colon = names_method ? std::string::npos : rest.find(':');
  parts.stem = rest.substr(0, colon);
  if (colon != std::string::npos) parts.link = rest.substr(colon + 1);
  return parts;
}

std::string name_of_differentiated(const std::string& name) {
  const FunctionName parts = parts_of_name(name);
  const bool is_second = parts.derivative == Derivative::contracted_hessian;
  return (is_second ? prefix_of(Derivative::vector_times_jacobian) + ":" : "") + parts.of_whole();
}

}  // namespace flatdyn
