// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/cpp/function.hpp"

#include <fmt/format.h>

#include "code/emit/sections.hpp"
#include "code/emit/writer.hpp"

namespace flatdyn {
namespace {

// A parameter. One that is not used has no name, so that compilers do not warn.
std::string parameter(const std::string& type, const std::string& name, bool is_named) {
  return type + " " + (is_named ? name : "/* " + name + " */");
}

// The form of parameters: their types, whether unused ones have names, and whether they have defaults.
struct ParameterStyle {
  std::string scalar, sin_cos;
  bool names_all, has_default;
};

std::vector<std::string> parameters_of(const UndeclaredFunction& function, const ParameterStyle& style) {
  const std::string array = style.scalar + "*";
  std::vector<std::string> list;
  for (const Argument& argument : function.arguments) {
    const std::string type = argument.kind == Argument::Kind::parameters ? "const Parameters<" + style.scalar + ">&"
                             : argument.kind == Argument::Kind::input    ? "const " + array
                                                                         : array;
    list.push_back(parameter(type, argument.name, style.names_all || argument.is_used));
  }
  if (function.body.uses_trigonometry()) {
    list.push_back("const " + style.sin_cos + "& sin_cos" + (style.has_default ? " = {}" : ""));
  }
  return list;
}

std::string template_parameters(const FunctionText& text) {
  return text.uses_trigonometry ? "class Scalar, class SinCos = DefaultSinCos" : "class Scalar";
}

// "static inline void gravity(const Scalar* q, Scalar* g) noexcept {"; for a member of `stage`, "…
// Motion<Scalar>::bias(… const" that is not static. A function that is declared in a header and defined in a source is
// not inline. The first declaration of a function that returns bool has [[nodiscard]].
std::string signature(const FunctionText& text, const std::string& stage) {
  const std::string scope = stage.empty() ? "" : stage + "<Scalar>::";
  const std::string begin = is_declared_apart(text) ? ""
                            : stage.empty()         ? not_to_discard(text.returns) + "static inline "
                                                    : "inline ";
  return without_newline(list_line(fmt::format("{}{} {}{}(", begin, text.returns, scope, text.name), text.parameters,
                                   stage.empty() ? ") noexcept {" : ") const noexcept {", 0));
}

}  // namespace

std::string not_to_discard(const std::string& returns) { return returns == "bool" ? "[[nodiscard]] " : ""; }

std::string refusal_of_objects(const std::string& name, const std::string& scope) {
  return fmt::format("{}detail::IfObjects<Of...> {}(const Of&...);", scope, name);
}

// Defaults belong to the declaration. The source of sines and cosines is the header's own.
void declare_template(FunctionText& text, const UndeclaredFunction& function,
                      const std::vector<std::string>& compiled) {
  text.parameters = parameters_of(function, {"Scalar", "SinCos", false, compiled.empty()});
  if (compiled.empty()) return;
  text.declared = parameters_of(function, {"Scalar", "SinCos", true, true});
  if (!function.scope.enclosing_stage.empty()) return;  // a stage's struct is instantiated as a whole
  for (const std::string& scalar : compiled) {
    const std::string returns = with_replaced(text.returns, "Scalar", scalar);
    text.compiled.push_back({returns, parameters_of(function, {scalar, "DefaultSinCos", true, false})});
    if (!function.body.uses_trigonometry()) continue;
    text.compiled.push_back({returns, parameters_of(function, {scalar, "GivenSinCos<" + scalar + ">", true, false})});
  }
}

void write_template(kainjow::mustache::data& item, const FunctionText& text, const std::string& stage) {
  item["header_parts?"] = !text.parts.empty() && !is_declared_apart(text);
  item["header_parameters"] = template_parameters(text);
  item["signature"] = signature(text, stage);
  if (!is_declared_apart(text)) return;
  item["source_parameters"] = std::string(text.uses_trigonometry ? "class Scalar, class SinCos" : "class Scalar");
  item["declaration"] = without_newline(list_line(
      fmt::format("{}{} {}(", not_to_discard(text.returns), text.returns, text.name), text.declared, ") noexcept;", 0));
}

}  // namespace flatdyn
