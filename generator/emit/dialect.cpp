// SPDX-License-Identifier: GPL-2.0-or-later
#include "emit/dialect.hpp"

#include <fmt/format.h>

#include "emit/literals.hpp"
#include "emit/name_space.hpp"
#include "emit/writer.hpp"

namespace flatdyn {
namespace {

constexpr std::size_t kRowIndent = 4;

std::string prefix_of(const std::string& name_space) {
  std::string prefix;
  for (std::string part : parts_of_namespace(name_space)) {
    while (part.size() > 1 && part.back() == '_') part.pop_back();  // C++ reserves two underscores in a row
    prefix += part + "_";
  }
  return prefix;
}

}  // namespace

Dialect Dialect::c(const std::string& scalar, const std::string& name_space) {
  Dialect dialect;
  dialect.language_ = Language::c;
  dialect.scalar_ = dialect.number_ = scalar;
  dialect.prefix_ = prefix_of(name_space);
  return dialect;
}

Dialect Dialect::c_lanes(const std::string& scalar, const std::string& name_space) {
  Dialect dialect = c(scalar, name_space);
  dialect.scalar_ = dialect.prefix_ + "lanes";
  return dialect;
}

Dialect Dialect::javascript() {
  Dialect dialect;
  dialect.language_ = Language::javascript;
  dialect.scalar_ = dialect.number_ = "number";
  return dialect;
}

std::string Dialect::count_name(const std::string& name) const { return is_c() ? in_capitals(prefix_ + name) : name; }

std::string Dialect::count_definition(const std::string& name, int value) const {
  if (is_javascript()) return fmt::format("const {} = {};\n", name, value);
  return is_c() ? fmt::format("enum {{ {} = {} }};\n", name, value)
                : fmt::format("inline constexpr int {} = {};\n", name, value);
}

std::vector<std::string> Dialect::reserved() const {
  if (is_javascript()) {
    return {"Math",   "Float64Array", "Infinity",   "NaN",       "undefined",   "null",        "arguments",
            "await",  "debugger",     "eval",       "extends",   "finally",     "function",    "implements",
            "import", "in",           "instanceof", "interface", "let",         "package",     "super",
            "typeof", "var",          "with",       "yield",     "joint_count", "joint_names", "parameter_names"};
  }
  if (is_cpp()) {
    return {"Scalar",      "Real", "Parameters",    "SinCos",      "Joints",      "LibrarySinCos",
            "GivenSinCos", "at",   "Configuration", "Motion",      "detail",      "functions",
            "std",         "sin",  "cos",           "joint_count", "joint_names", "rounding_is_as_written"};
  }
  std::vector<std::string> words = {"restrict", "sin",  "cos",   "sqrt",
                                    "sinf",     "cosf", "sqrtf", count_name("joint_count")};
  for (const char* name :
       {"joint_names", "parameters", "sign", "is_zero", "sines_and_cosines", "rounding_is_as_written", "text_hash"}) {
    words.push_back(global(name));
  }
  return words;
}

std::string Dialect::literal(const Rational& value) const {
  if (is_cpp()) return "Scalar(" + decimal_literal(value) + ")";
  return spread(number_ == "float" ? float_literal(value) : decimal_literal(value));
}

std::string Dialect::spread(const std::string& number) const {
  return is_lanes() ? global("all(") + number + ")" : number;
}

std::string Dialect::real_literal(const Rational& value) const {
  return is_cpp() ? "Real(" + decimal_literal(value) + ")" : literal(value);
}

std::string Dialect::infinity(bool negative) const {
  const std::string sign = negative ? "-" : "";
  if (is_javascript()) return sign + "Infinity";
  if (is_cpp()) return "Real(" + sign + "HUGE_VAL)";
  return sign + (number_ == "float" ? "HUGE_VALF" : "HUGE_VAL");
}

std::string Dialect::text(const std::string& value) const {
  return is_javascript() ? javascript_string(value) : quoted(value);
}

std::string Dialect::library(const std::string& function) const {
  return is_c() && number_ == "float" ? function + "f" : function;
}

std::string Dialect::sign(const std::string& of) const {
  return (is_javascript() ? "Math.sign(" : is_c() ? global("sign(") : "detail::sign(") + of + ")";
}

std::string Dialect::sqrt(const std::string& of) const {
  return (is_javascript() ? "Math.sqrt("
          : is_lanes()    ? global("sqrt(")
          : is_c()        ? library("sqrt") + "("
                          : "detail::sqrt(") +
         of + ")";
}

std::string Dialect::parameter(const std::string& member) const {
  return is_c() ? spread("parameters->" + member) : "parameters." + member;
}

std::string Dialect::pointer(const std::string& type, const std::string& name) const {
  return is_javascript() ? name : type + "* " + name;
}

std::string Dialect::input(const std::string& name) const { return pointer("const " + scalar_, name); }

std::string Dialect::output(const std::string& name, bool restricts) const {
  return pointer(scalar_, (is_c() && restricts ? "restrict " : "") + name);
}

std::string Dialect::parameters_argument() const {
  if (is_cpp()) return "const Parameters<Scalar>& parameters";
  return pointer("const " + exported("parameters"), "parameters");
}

std::string Dialect::number_output(const std::string& name) const {
  return is_cpp() ? scalar_ + "& " + name : output(name);
}

std::string Dialect::number_definition(const std::string& name) const { return is_cpp() ? name : array(name, 1); }

std::string Dialect::number_use(const std::string& name) const { return is_cpp() ? name : name + "[0]"; }

std::string Dialect::constant() const { return is_javascript() ? "const " : "const " + scalar_ + " "; }
std::string Dialect::arrays() const { return is_javascript() ? "const " : scalar_ + " "; }

std::string Dialect::array(const std::string& name, std::size_t length) const {
  return is_javascript() ? fmt::format("{} = new Float64Array({})", name, length) : fmt::format("{}[{}]", name, length);
}

std::string Dialect::condition_type() const { return is_lanes() ? global("mask") : "bool"; }
std::string Dialect::always() const { return is_lanes() ? "~(" + condition_type() + "){0}" : "true"; }

std::string Dialect::conditions_begin() const { return (is_javascript() ? "let" : condition_type()) + " positive = "; }

std::string Dialect::conditions_continue() const { return is_javascript() ? "positive &&= " : "positive &= "; }

std::string Dialect::part_begin(const std::string& name) const {
  return (is_javascript() ? "function " : is_c() ? "static void " : "void ") + name + "(";
}

std::string Dialect::function_end() const { return is_cpp() ? ") noexcept {" : ") {"; }

std::string Dialect::part_call(const std::string& name) const { return (is_cpp() ? "detail::" : "") + name + "("; }

std::string Dialect::type_of(const ConstantArray& array) const {
  if (!is_c()) return array.type;
  if (array.type == kReal) return "const " + scalar_;
  return array.type.back() == '*' ? array.type + " const" : "const " + array.type;
}

std::string Dialect::definition(const ConstantArray& array) const {
  const std::string begin = is_javascript() ? fmt::format("const {} = [", array.name)
                                            : fmt::format("{}{} {}[{}] = {{", is_c() ? "" : "inline constexpr ",
                                                          type_of(array), array.name, array.length);
  const std::string end = is_javascript() ? "];" : "};";
  if (array.row == 0) return list_line(begin, array.entries, end, 0);
  std::string text = begin + "\n";
  const auto row = static_cast<std::size_t>(array.row);
  for (std::size_t k = 0; k < array.entries.size(); k += row) {
    const auto first = array.entries.begin() + static_cast<std::ptrdiff_t>(k);
    const bool is_last = k + row >= array.entries.size();
    text += list_line("", {first, first + static_cast<std::ptrdiff_t>(row)}, is_last ? end : ",", kRowIndent);
  }
  return text;
}

std::string Dialect::declaration(const ConstantArray& array) const {
  return fmt::format("extern {} {}[{}];\n", type_of(array), array.name, array.length);
}

std::string Dialect::all_positive(const std::string& array, std::size_t length) const {
  const std::string loop = is_cpp()
                               ? fmt::format("for (const Scalar& pivot : {}) positive &= pivot > Scalar(0.0);", array)
                               : fmt::format("for ({} k = 0; k < {}; ++k) {{ {}{}[k] > {}; }}", is_c() ? "int" : "let",
                                             length, conditions_continue(), array, literal(0));
  return code_line(loop, kStatementIndent);
}

}  // namespace flatdyn
