// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/emit/global_names.hpp"

#include <algorithm>

#include "code/emit/base_constants.hpp"
#include "code/emit/joints.hpp"
#include "code/lower/names.hpp"

namespace flatdyn {
namespace {

void take_constants(const Mechanism& mechanism, const Dialect& dialect, NameTable& names) {
  for (const LimitColumn& kind : limits_given(mechanism)) names.unique(dialect.global(kind.constant));
  if (mechanism.has_loops()) {
    for (const char* name : {"position_names", "independent_positions", "close_loops"}) {
      names.unique(dialect.global(name));
    }
    names.unique(dialect.count_name("position_count"));
  }
  if (mechanism.has_spherical_joints()) {
    names.unique(dialect.global("position_names"));
    names.unique(dialect.count_name("position_count"));
  }
  if (mechanism.floating_base) names.unique(dialect.count_name("velocity_count"));
  if (!mechanism.angles.empty()) names.unique(dialect.count_name("angle_count"));
}

std::vector<std::string> names_of_base(const Dialect& dialect, NameTable& names) {
  std::vector<std::string> result;
  for (const char* name : kBaseConstants) {
    const bool is_count = result.empty();
    result.push_back(names.unique(is_count ? dialect.count_name(name) : dialect.global(name)));
  }
  return result;
}

std::vector<std::string> names_of_zeros(const Function& function, const std::string& name, NameTable& names) {
  std::vector<std::string> result;
  const bool only = function.outputs.size() == 1;
  for (const Output& output : function.outputs) {
    result.push_back(names.unique(name + (only ? "" : "_" + output.name) + "_nonzero"));
  }
  return result;
}

}  // namespace

GlobalNames global_names(const Mechanism& mechanism, const std::vector<Function>& functions, const Dialect& dialect) {
  const std::vector<std::string> reserved = dialect.reserved();
  NameTable names({reserved.begin(), reserved.end()});
  GlobalNames result;
  take_constants(mechanism, dialect, names);
  const bool has_base = std::any_of(functions.begin(), functions.end(), uses_base_parameters);
  if (has_base) result.base = names_of_base(dialect, names);
  for (const Function& function : functions) {
    result.functions.push_back(names.unique(dialect.global(function.name)));
    if (dialect.has_given_variants())
      result.sin_cos_variants.push_back(names.unique(result.functions.back() + "_given"));
  }
  for (std::size_t k = 0; k < functions.size(); ++k) {
    result.nonzero.push_back(names_of_zeros(functions[k], result.functions[k], names));
  }
  result.taken = names.taken();
  return result;
}

}  // namespace flatdyn
