// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/cpp/dialect.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "code/emit/known_answer.hpp"
#include "code/emit/literals.hpp"
#include "code/emit/page.hpp"
#include "code/emit/sections.hpp"
#include "code/emit/writer.hpp"
#include "code/languages/cpp/function.hpp"
#include "code/languages/cpp/pair.hpp"
#include "code/languages/cpp/shapes.hpp"
#include "code/languages/cpp/stages.hpp"
#include "flatdyn/interface.hpp"
#include "templates.hpp"

namespace flatdyn {

using kainjow::mustache::data;

namespace {

// The shapes of all functions, and of those that are members of stages only.
std::vector<ShapedFunction> shapes_of(const CodeContent& content) {
  std::vector<ShapedFunction> shapes;
  for (std::size_t k = 0; k < content.functions.size(); ++k) {
    shapes.push_back(shaped(content.functions[k], content.texts[k], content.scope));
  }
  add_stages(shapes, content.stages, content.scope);
  return shapes;
}

std::vector<std::string> cpp_example(const CodeContent& content) {
  const FunctionText& text = content.texts.front();
  const std::string& name_space = content.name_space;
  const std::string& scalar = content.options.scalar;
  const std::string result = text.returns == "Scalar" ? scalar : text.returns;
  const std::string parameters = content.scope.parameters.empty() ? "" : name_space + "::Parameters<>";
  return call_example(text, {name_space + "::" + text.name, result, scalar, "{}", parameters, "parameters"});
}

// Declarations that are found where objects stand in place of arrays, and have a message.
void write_refusals(data& page, const CodeContent& content) {
  std::vector<std::string> names;
  for (const FunctionText& text : content.texts) names.push_back(text.name);
  if (!content.stages.empty()) names.push_back(content.stages.front().make.name);
  std::vector<std::string> declarations;
  for (const std::string& name : names) declarations.push_back(refusal_of_objects(name));
  page["refusals?"] = !declarations.empty();
  page["refusals"] = list_of(declarations);
  page["object_arguments"] = without_newline(templates::object_arguments_hpp);
}

}  // namespace

CppDialect::CppDialect(const EmitOptions& options) : CppDialect() {
  if (options.form == Form::pair) compiled_ = compiled_scalars(options);
}

std::vector<std::string> CppDialect::reserved() const {
  return {"Scalar",           "Real",        "Parameters",    "SinCos",      "Joints",        "LibrarySinCos",
          "PolynomialSinCos", "GivenSinCos", "DefaultSinCos", "at",          "Configuration", "Motion",
          "detail",           "functions",   "std",           "sin",         "cos",           "fma",
          "Limbs2",           "Limbs4",      "Limbs8",        "joint_count", "joint_names",   "rounding_is_as_written"};
}

std::string CppDialect::literal(const Rational& value) const { return "Scalar(" + decimal_literal(value) + ")"; }

std::string CppDialect::real_literal(const Rational& value) const { return "Real(" + decimal_literal(value) + ")"; }

std::string CppDialect::infinity(bool negative) const { return negative ? "Real(-HUGE_VAL)" : "Real(HUGE_VAL)"; }

std::string CppDialect::sign(const std::string& of) const { return "detail::sign(" + of + ")"; }

std::string CppDialect::sqrt(const std::string& of) const { return "detail::sqrt(" + of + ")"; }

std::optional<std::string> CppDialect::excess(const std::string& sum, const std::string& term) const {
  return fmt::format("detail::Excess<Scalar>::of({}, {})", sum, term);
}

std::string CppDialect::fused_begin() const {
  return code_line("constexpr detail::MultiplyAdd<Scalar> fma{};", kStatementIndent);
}

std::string CppDialect::limbs_definition(int lanes) const {
  return fmt::format("using {0}{1} = detail::{0}<Scalar, {1}>;", kLimbs, lanes);
}

std::string CppDialect::filled_sines(const code::FillSines& fill) const {
  return code_line(fmt::format("{}({}, Joints<{}>(), {}, {});", fill.is_computed ? "DefaultSinCos()" : "sin_cos",
                               fill.array, fmt::join(fill.angles, ", "), fill.sines, fill.cosines),
                   kStatementIndent);
}

void CppDialect::declare(FunctionText& text, const UndeclaredFunction& function) const {
  declare_template(text, function, compiled_);
}

std::string CppDialect::count_definition(const std::string& name, int value) const {
  return fmt::format("inline constexpr int {} = {};\n", name, value);
}

std::string CppDialect::definition_begin(const code::Table& table) const {
  const auto type = [&table] {
    switch (table.type) {
      case code::Table::Type::text:
        return "const char*";
      case code::Table::Type::real:
        break;
      case code::Table::Type::whole:
        return "int";
      case code::Table::Type::flag:
        return "bool";
    }
    return "Real";
  };
  return fmt::format("inline constexpr {} {}[{}] = {{", type(), table.name, table.length);
}

std::string CppDialect::stored_zeros(const std::string& array, std::size_t first, std::size_t end) const {
  return fmt::format("detail::Zeros::store<{}>({}{});", end - first, array,
                     first == 0 ? "" : fmt::format(" + {}", first));
}

std::string CppDialect::check_loop(std::size_t first, std::size_t end, const std::string& check) const {
  return code_line(fmt::format("for (int {0} = {1}; {0} < {2}; ++{0}) {3}{4};", code::kCounter, first, end,
                               conditions_continue(), check),
                   kStatementIndent);
}

std::string CppDialect::check_positive(const std::string& array, std::size_t) const {
  return code_line(fmt::format("for (const Scalar& pivot : {}) valid &= pivot > Scalar(0.0);", array),
                   kStatementIndent);
}

std::vector<FileTemplate> CppDialect::files() const {
  std::vector<FileTemplate> files = {{".hpp", templates::header_hpp}};
  if (is_pair()) files.push_back({".cpp", templates::source_cpp});
  return files;
}

void CppDialect::write_function(data& item, const Function& function, const FunctionText& text) const {
  write_template(item, text);
  if (is_pair()) item["brief"] = list_of(brief_comment(function));
}

void CppDialect::write_page(data& page, const CodeContent& content) const {
  if (!content.texts.empty()) page["example"] = list_of(cpp_example(content));
  if (!content.stages.empty()) write_stages(page, content.stages, content.name_space);
  write_shapes(page, shapes_of(content), content.name_space);
  write_refusals(page, content);
  if (is_pair()) write_instances(page, content);
  page["interface"] = std::to_string(kInterface);
  page["asks_runtime?"] = !is_pair();  // header and source are compiled without the runtime
  page["header_sign?"] = content.uses_sign && !is_pair();
  page["header_sqrt?"] = content.uses_sqrt && !is_pair();
  page["header_excess?"] = content.uses_excess && !is_pair();
  page["header_zeros?"] = content.uses_zeros && !is_pair();
  page["header_fma?"] = content.uses_fma && !is_pair();
  page["header_limbs?"] = content.uses_limbs && !is_pair();
  page["limb_operators"] = list_of({"+", "-", "*", "/"});
  page["limbs_type"] = without_newline(rendered(templates::limbs_hpp, page));
  page["multiply_add"] = without_newline(rendered(templates::multiply_add_hpp, page));
  page["zeros"] = without_newline(rendered(templates::zeros_hpp, page));
  page["excess"] = without_newline(rendered(templates::excess_hpp, page));
  page["header_angles?"] = content.uses_trigonometry && !content.scope.angles.empty() && !is_pair();
  page["polynomial_sines"] = without_newline(rendered(templates::polynomial_sines_hpp, page));
  write_known_answer(page, content);
}

void CppDialect::write_known_answer(data& page, const CodeContent& content) const {
  const std::string statements = known_answer_statements(
      content, {"Scalar", "detail::", "Parameters<Scalar>", "parameters", "GivenSinCos<Scalar>"});
  page["known_answer?"] = !statements.empty();
  page["known_answer"] = without_newline(statements);
  page["hash_of_sines"] = std::string(kDoubleSines);
  page["hash_of_float_sines"] = std::string(kFloatSines);
  page["known_answer_helpers"] = without_newline(rendered(templates::known_answer_hpp, page));
  page["verdict"] =
      statements.empty() ? "true" : fmt::format("hash == (is_float ? {}u : {}u)", kFloatAnswer, kDoubleAnswer);
  page["rounding"] = without_newline(rendered(templates::rounding_hpp, page));
}

void CppDialect::write_instances(data& page, const CodeContent& content) const {
  Instantiations instances;
  for (const FunctionText& text : content.texts) instances.add(text);
  if (!content.stages.empty()) instances.add(content.stages, compiled_);
  instances.add_rounding(compiled_);
  write_pair(page, content.file_name + ".hpp", content.file_name + ".cpp", compiled_);
  page["declared_instances"] = list_of(instances.declared);
  page["defined_instances"] = list_of(instances.defined);
}

}  // namespace flatdyn
