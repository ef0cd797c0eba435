// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/common/given_sines.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "code/emit/printer.hpp"
#include "code/lower/angles.hpp"
#include "code/lower/arguments.hpp"
#include "code/walk.hpp"

namespace flatdyn {
namespace {

// The arguments with sines and cosines in place of q, unless positions themselves are read, too.
std::vector<Argument> with_sines(const UndeclaredFunction& function, bool fewest) {
  const FunctionBody& body = function.body;
  std::vector<Argument> list;
  for (const Argument& argument : function.arguments) {
    const bool is_input = argument.kind == Argument::Kind::input;
    if (is_input && !body.uses_positions && argument.name == input_argument(InputKind::q, 0).name) continue;
    list.push_back(argument);
  }
  const bool has_parameters = !list.empty() && list.front().kind == Argument::Kind::parameters;
  const int last = *std::max_element(body.angles.begin(), body.angles.end());
  const std::size_t length = fewest ? static_cast<std::size_t>(1 + last) : function.scope.angle_count();
  list.insert(list.begin() + (has_parameters ? 1 : 0), {{Argument::Kind::input, kSines, body.takes_sines, length},
                                                        {Argument::Kind::input, kCosines, body.takes_cosines, length}});
  return list;
}

// Statements like "(void)qd;", which silence compilers.
std::string unread(const std::vector<Argument>& arguments, const HeaderScope& scope) {
  code::Statements statements;
  for (const Argument& argument : arguments) {
    if (!argument.is_used) statements.emplace_back(code::Ignore{argument.name});
  }
  return Printer(scope).text(statements);
}

// The body of the function that computes sines and cosines and calls `given`; records in `given` which ones it takes.
std::string asking_body(const UndeclaredFunction& function, bool returns, SinCosVariant& given) {
  const std::set<int> angles(function.body.angles.begin(), function.body.angles.end());
  const std::string function_of_angles = function.scope.dialect.global(kFunctionOfAngles);
  code::Statements statements = filling_sines(angles, function_of_angles, function.scope);
  code::CallPart call{given.name, {}, false, returns};
  for (const std::string& argument : given.arguments) call.arguments.push_back({code::Argument::Role::input, argument});
  statements.emplace_back(std::move(call));
  code::mark_local_arguments(statements);
  for (const auto& [first, last] : runs_of(angles)) {
    given.joints += (given.joints.empty() ? "" : ", ") + std::to_string(first);
    if (last > first) given.joints += ".." + std::to_string(last);
  }
  return Printer(function.scope).text(statements);
}

}  // namespace

void declare_with_given_sines(FunctionText& text, const UndeclaredFunction& function, bool fewest,
                              const DeclareArguments& declared) {
  text.declared = declared(function.arguments, false);
  text.parameters = declared(function.arguments, true);
  if (!function.body.uses_trigonometry()) {
    text.body = unread(function.arguments, function.scope) + text.body;
    return;
  }
  const std::vector<Argument> arguments = with_sines(function, fewest);
  SinCosVariant given{function.sin_cos_variant_name,
                      declared(arguments, true),
                      declared(arguments, false),
                      {},
                      angle_array(function.scope),
                      "",
                      unread(arguments, function.scope) + text.body};
  for (const Argument& argument : arguments) given.arguments.push_back(argument.name);
  text.body = asking_body(function, text.returns != "void", given);
  text.sin_cos_variant = std::move(given);
}

std::string given_sines_comment(const SinCosVariant& given) {
  return fmt::format("The same from sine[k] = sin({0}[k]) and cosine[k] = cos({0}[k]) of the caller's, k = {1}.",
                     given.of, given.joints);
}

std::vector<std::pair<int, int>> runs_of(const std::set<int>& angles) {
  std::vector<std::pair<int, int>> runs;
  for (const int angle : angles) {
    if (!runs.empty() && runs.back().second + 1 == angle) {
      runs.back().second = angle;
    } else {
      runs.emplace_back(angle, angle);
    }
  }
  return runs;
}

}  // namespace flatdyn
