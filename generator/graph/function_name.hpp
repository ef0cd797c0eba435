// SPDX-License-Identifier: GPL-2.0-or-later
// The parts of a function's name.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace flatdyn {

// The derivatives of functions that are functions, too; J is the Jacobian by all arguments.
enum class Derivative : std::uint8_t {
  none,                   // the function itself
  jacobian_times_vector,  // J d, "jvp"
  vector_times_jacobian,  // wᵀ J, "vjp"
  jacobian,               // J, "jac"
  contracted_hessian      // the derivatives of wᵀ J, "hessian"
};
inline constexpr Derivative kDerivatives[] = {Derivative::jacobian_times_vector, Derivative::vector_times_jacobian,
                                              Derivative::jacobian, Derivative::contracted_hessian};
// "vjp"; empty for none.
std::string prefix_of(Derivative derivative);

// "vjp:jacobian:hand": the product "vjp" of the derivatives of "jacobian" of link "hand".
struct FunctionName {
  Derivative derivative = Derivative::none;
  std::string stem;                 // "jacobian", "step:semi_implicit_euler"
  std::optional<std::string> link;  // "hand"

  // The name of the function itself.
  std::string of_whole() const { return link ? stem + ":" + *link : stem; }
};

FunctionName parts_of_name(const std::string& name);

// The name of the function whose first derivatives a function has: "vjp:gravity" for "hessian:gravity", else that of
// the function itself.
std::string name_of_differentiated(const std::string& name);

}  // namespace flatdyn
