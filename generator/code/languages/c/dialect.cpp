// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/c/dialect.hpp"

#include <fmt/format.h>

#include "code/emit/known_answer.hpp"
#include "code/emit/literals.hpp"
#include "code/emit/name_space.hpp"
#include "code/emit/page.hpp"
#include "code/emit/sections.hpp"
#include "code/emit/writer.hpp"
#include "code/languages/common/given_sines.hpp"
#include "templates.hpp"

namespace flatdyn {

using kainjow::mustache::data;

namespace {

std::string prefix_of(const std::string& name_space) {
  std::string prefix;
  for (std::string part : parts_of_namespace(name_space)) {
    while (part.size() > 1 && part.back() == '_') part.pop_back();  // C++ reserves two underscores in a row
    prefix += part + "_";
  }
  return prefix;
}

// "void panda_gravity(const double q[7], double g[7])", followed by `end`, " {" or ";".
std::string c_signature(const std::string& returns, const std::string& name, const std::vector<std::string>& parameters,
                        const std::string& end) {
  return without_newline(list_line(fmt::format("{} {}(", returns, name), parameters, ")" + end, 0));
}

}  // namespace

CDialect::CDialect(const std::string& number, const std::string& name_space)
    : CDialect(number, name_space, {"", number}) {}

CDialect::CDialect(const std::string& number, const std::string& name_space, const Vectors& vectors)
    : PageDialect(vectors.scalar, prefix_of(name_space) + vectors.prefix),
      number_(number),
      exported_(prefix_of(name_space)) {}

std::string CDialect::library(const std::string& function) const {
  return number_ == "float" ? function + "f" : function;
}

std::string CDialect::count_name(const std::string& name) const { return in_capitals(exported(name)); }

std::vector<std::string> CDialect::reserved() const {
  std::vector<std::string> words = {"restrict", "sin",  "cos",   "sqrt",
                                    "sinf",     "cosf", "sqrtf", count_name("joint_count")};
  words.push_back(count_name("nodiscard"));
  for (const char* name : {"joint_names", "parameters", "sign", "fma", "is_zero", "sine_and_cosine",
                           "sines_and_cosines", "angles", "rounding_is_as_written", "text_hash"}) {
    words.push_back(global(name));
  }
  return words;
}

std::string CDialect::literal(const Rational& value) const {
  return number_ == "float" ? float_literal(value) : decimal_literal(value);
}

std::string CDialect::infinity(bool negative) const {
  return (negative ? "-" : "") + std::string(number_ == "float" ? "HUGE_VALF" : "HUGE_VAL");
}

std::string CDialect::sign(const std::string& of) const { return global("sign(") + of + ")"; }

std::optional<std::string> CDialect::excess(const std::string& sum, const std::string& term) const {
  return fmt::format("{}({}, {})", global("excess"), sum, term);
}

std::string CDialect::sqrt(const std::string& of) const { return library("sqrt") + "(" + of + ")"; }

std::string CDialect::fused(const std::string& a, const std::string& b, const std::string& c) const {
  return fmt::format("{}({}, {}, {})", global("fma"), a, b, c);
}

std::string CDialect::parameter(const std::string& member) const { return "parameters->" + member; }

std::string CDialect::output(const std::string& name, std::size_t) const { return scalar() + "* restrict " + name; }

std::string CDialect::parameters_argument() const { return "const " + exported("parameters") + "* parameters"; }

std::string CDialect::part_begin(const std::string& name) const { return "static void " + name + "("; }

void CDialect::declare(FunctionText& text, const UndeclaredFunction& function) const {
  declare_with_given_sines(text, function, true, [this](const std::vector<Argument>& arguments, bool restricts) {
    return parameters(arguments, restricts);
  });
}

std::vector<std::string> CDialect::parameters(const std::vector<Argument>& arguments, bool restricts) const {
  std::vector<std::string> list;
  for (const Argument& argument : arguments) {
    list.push_back(argument.kind == Argument::Kind::parameters ? parameters_argument()
                   : is_sized(argument)                        ? sized(argument, restricts)
                   : argument.kind == Argument::Kind::input    ? input(argument.name, argument.length)
                   : restricts                                 ? output(argument.name, argument.length)
                                                               : scalar() + "* " + argument.name);
  }
  return list;
}

bool CDialect::is_sized(const Argument& argument) const {
  return declares_lengths() && argument.length > 0 && !argument.is_number;
}

// "const double q[7]", and in definitions "double tau[restrict 7]": compilers warn of shorter arrays.
std::string CDialect::sized(const Argument& argument, bool restricts) const {
  const bool is_input = argument.kind == Argument::Kind::input;
  return fmt::format("{}{} {}[{}{}]", is_input ? "const " : "", scalar(), argument.name,
                     restricts && !is_input ? "restrict " : "", argument.length);
}

std::string CDialect::filled_sines(const code::FillSines& fill) const {
  std::string text;
  for (const auto& [first, last] : runs_of(fill.angles)) {
    text += list_line(global("sines_and_cosines("),
                      {fill.array, std::to_string(first), std::to_string(last), fill.sines, fill.cosines}, ");",
                      kStatementIndent);
  }
  return text;
}

std::string CDialect::count_definition(const std::string& name, int value) const {
  return fmt::format("enum {{ {} = {} }};\n", name, value);
}

std::string CDialect::type_of(const code::Table& table) const {
  switch (table.type) {
    case code::Table::Type::text:
      return "const char* const";
    case code::Table::Type::real:
      break;
    case code::Table::Type::whole:
      return "const int";
    case code::Table::Type::flag:
      return "const bool";
  }
  return "const " + scalar();
}

std::string CDialect::definition_begin(const code::Table& table) const {
  return fmt::format("{} {}[{}] = {{", type_of(table), table.name, table.length);
}

std::string CDialect::declaration(const code::Table& table) const {
  return fmt::format("extern {} {}[{}];\n", type_of(table), table.name, table.length);
}

std::vector<FileTemplate> CDialect::files() const { return {{".h", templates::header_h}, {".c", templates::source_c}}; }

// If the function has a variant that takes sines and cosines, it comes before the one that calls it.
std::string CDialect::definitions(const FunctionText& text) const {
  const auto definition = [&](const std::string& name, const std::vector<std::string>& parameters,
                              const std::string& body) {
    return c_signature(linkage() + text.returns, name, parameters, " {") + "\n" + body + "}";
  };
  const std::string own = definition(text.name, text.parameters, text.body);
  return text.sin_cos_variant
             ? definition(text.sin_cos_variant->name, text.sin_cos_variant->parameters, text.sin_cos_variant->body) +
                   "\n\n" + own
             : own;
}

void CDialect::write_function(data& item, const Function& function, const FunctionText& text) const {
  const std::string returns = (text.returns == "bool" ? count_name("nodiscard") + " " : "") + text.returns;
  item["brief"] = list_of(brief_comment(function));
  item["declaration"] = c_signature(returns, text.name, text.declared, ";");
  item["definitions"] = definitions(text);
  item["given?"] = text.sin_cos_variant.has_value();
  if (!text.sin_cos_variant) return;
  item["given_comment"] = given_sines_comment(*text.sin_cos_variant);
  item["given_declaration"] = c_signature(returns, text.sin_cos_variant->name, text.sin_cos_variant->declared, ";");
}

void CDialect::write_page(data& page, const CodeContent& content) const {
  const bool is_float = scalar() == "float";
  page["header_file"] = content.file_name + CDialect::files().front().ending;
  page["prefix"] = global("");
  page["count"] = count_name("joint_count");
  page["nodiscard"] = count_name("nodiscard");
  page["sin"] = library("sin");
  page["cos"] = library("cos");
  page["F"] = std::string(is_float ? "F" : "");
  page["floats_bit"] = std::string(is_float ? "4" : "8");
  page["floats_length"] = std::string(is_float ? "32" : "64");
  page["f"] = std::string(is_float ? "f" : "");
  page["half_a_place"] = std::string(is_float ? "0x1.001p-24f" : "0x1.001p-53");
  page["smallest"] = std::string(is_float ? "0x1p-126f" : "0x1p-1022");
  page["is_float"] = is_float;
  page["most_angle"] = std::string(is_float ? "6400" : "1e5");
  page["hash_of_sines"] = std::string(is_float ? kFloatSines : kDoubleSines);
  page["places"] = std::string(is_float ? "8388608.0f" : "4503599627370496.0");
  page["bits"] = std::string(is_float ? "uint32_t" : "uint64_t");
  page["signed_bits"] = std::string(is_float ? "int32_t" : "int64_t");
  const std::string statements =
      known_answer_statements(content, {scalar(), global(""), global("parameters"), "&parameters", ""});
  const char* const polynomials = is_float ? templates::polynomials_of_floats_c : templates::polynomials_of_doubles_c;
  page["polynomials"] = without_newline(rendered(polynomials, page));
  page["known_answer?"] = !statements.empty();
  page["known_answer"] = without_newline(statements);
  page["verdict"] = statements.empty() ? "true" : fmt::format("hash == {}u", is_float ? kFloatAnswer : kDoubleAnswer);
  if (content.texts.empty()) return;
  const FunctionText& text = content.texts.front();
  const std::string type = content.scope.parameters.empty() ? "" : global("parameters");
  page["example"] = list_of(call_example(text, {text.name, text.returns, scalar(), "{0}", type, "&parameters"}));
}

}  // namespace flatdyn
