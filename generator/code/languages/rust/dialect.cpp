// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/rust/dialect.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "code/emit/known_answer.hpp"
#include "code/emit/literals.hpp"
#include "code/emit/name_space.hpp"
#include "code/emit/page.hpp"
#include "code/emit/sections.hpp"
#include "code/languages/common/given_sines.hpp"
#include "code/languages/rust/known_answer.hpp"
#include "code/languages/rust/names.hpp"
#include "code/lower/angles.hpp"
#include "templates.hpp"

namespace flatdyn {

using kainjow::mustache::data;

namespace {

// "pub fn gravity(q: &[f64; 7], g: &mut [f64; 7]) {"
std::string signature(const std::string& returns, const std::string& name, const std::vector<std::string>& parameters) {
  const std::string arrow = returns == "void" ? "" : " -> " + returns;
  return without_newline(list_line(fmt::format("pub fn {}(", name), parameters, ")" + arrow + " {", 0));
}

// Lines of documentation: a summary, and lines that are shown as they are, as brackets would be taken for links.
std::string documentation(const std::vector<std::string>& summary, const std::vector<std::string>& lines) {
  std::string text;
  const auto add = [&text](const std::string& line) { text += line.empty() ? "///\n" : "/// " + line + "\n"; };
  for (const std::string& line : summary) add(line);
  add("");
  add("```text");
  for (const std::string& line : lines) add(line);
  add("```");
  return text;
}

std::string function_definition(const FunctionText& text, const std::string& name,
                                const std::vector<std::string>& parameters, const std::string& body) {
  const std::string used = text.returns == "bool" ? "#[must_use]\n" : "";
  return used + signature(text.returns, name, parameters) + "\n" + body + "}";
}

// A call as a user writes it.
std::vector<std::string> rust_example(const FunctionText& text, const std::string& crate, bool has_parameters) {
  std::vector<std::string> lines;
  std::string arguments;
  const auto pass = [&arguments](const std::string& name) { arguments += (arguments.empty() ? "&" : ", &") + name; };
  if (has_parameters) {
    lines.push_back(fmt::format("let parameters = {}::Parameters::default();  // with values of its members", crate));
    pass("parameters");
  }
  for (const ArrayArgument& input : text.inputs) {
    lines.push_back(fmt::format("let {} = [0.0; {}];", input.name, input.length));
    pass(input.name);
  }
  for (const ArrayArgument& output : text.outputs) {
    lines.push_back(fmt::format("let mut {} = [0.0; {}];", output.name, output.length));
    pass("mut " + output.name);
  }
  const char* const receiver = text.returns == "void" ? "" : "let result = ";
  lines.push_back(fmt::format("{}{}::{}({});", receiver, crate, text.name, arguments));
  return lines;
}

std::string range(const std::string& array, std::size_t first, std::size_t end) {
  return fmt::format("{}[{}..{}]", array, first, end);
}

}  // namespace

RustDialect::RustDialect(const EmitOptions& options) : PageDialect(options.scalar == "float" ? "f32" : "f64", "") {}

std::string RustDialect::count_name(const std::string& name) const { return in_capitals(name); }

std::vector<std::string> RustDialect::reserved() const {
  std::vector<std::string> words = rust_keywords();
  for (const char* name : {"Parameters",
                           "f32",
                           "f64",
                           "sign",
                           "sqrt",
                           "multiply_add",
                           "sine_and_cosine",
                           "of_quarter",
                           "sine_and_cosine_of_large",
                           "sines_and_cosines",
                           "angles",
                           "gap_at",
                           "close_loops",
                           "fill",
                           "fill_sines",
                           "hash_of",
                           "sines_are_right",
                           "rounding_is_as_written",
                           "joint_names",
                           "black_box",
                           "x",
                           "std"}) {
    words.emplace_back(name);
  }
  words.push_back(count_name("joint_count"));
  return words;
}

std::vector<std::string> RustDialect::reserved_members() const { return rust_keywords(); }

std::string RustDialect::literal(const Rational& value) const {
  if (!is_float()) return decimal_literal(value);
  std::string text = float_literal(value);
  text.pop_back();  // its suffix; the type follows from where it stands
  return text;
}

std::string RustDialect::infinity(bool negative) const {
  return scalar() + (negative ? "::NEG_INFINITY" : "::INFINITY");
}

std::string RustDialect::text(const std::string& value) const { return rust_string(value); }

std::string RustDialect::fused(const std::string& a, const std::string& b, const std::string& c) const {
  return fmt::format("multiply_add({}, {}, {})", a, b, c);
}

std::string RustDialect::filled_sines(const code::FillSines& fill) const {
  std::string text;
  for (const auto& [first, last] : runs_of(fill.angles)) {
    const auto from = static_cast<std::size_t>(first), end = static_cast<std::size_t>(last) + 1;
    text += list_line("sines_and_cosines(",
                      {"&" + range(fill.array, from, end), "&mut " + range(fill.sines, from, end),
                       "&mut " + range(fill.cosines, from, end)},
                      ");", indent());
  }
  return text;
}

std::string RustDialect::input(const std::string& name, std::size_t length) const {
  return fmt::format("{}: &[{}; {}]", name, scalar(), length);
}

std::string RustDialect::output(const std::string& name, std::size_t length) const {
  return fmt::format("{}: &mut [{}; {}]", name, scalar(), length);
}

std::string RustDialect::passed(const code::Argument& argument) const {
  if (!argument.is_local) return argument.name;
  return (argument.role == code::Argument::Role::input ? "&" : "&mut ") + argument.name;
}

std::string RustDialect::array(const std::string& name, const std::string& length) const {
  return fmt::format("{} = [0.0; {}]", name, length);
}

std::string RustDialect::declarations(const std::string& begin, const std::vector<std::string>& rests) const {
  std::string lines;
  for (const std::string& rest : rests) lines += code_line(begin + rest + ";", indent());
  return lines;
}

std::string RustDialect::stored(const std::vector<std::string>& places, const std::string& value) const {
  if (places.size() == 1) return fmt::format("{} = {};", places[0], value);
  return fmt::format("[{}] = [{}; {}];", fmt::join(places, ", "), value, places.size());
}

std::string RustDialect::check_finite(const std::string& array, std::size_t first, std::size_t end) const {
  return code_line(fmt::format("valid &= {}.iter().all(|x| x.is_finite());", range(array, first, end)), indent());
}

std::string RustDialect::check_positive(const std::string& array, std::size_t length) const {
  return code_line(fmt::format("valid &= {}.iter().all(|x| *x > 0.0);", range(array, 0, length)), indent());
}

void RustDialect::declare(FunctionText& text, const UndeclaredFunction& function) const {
  declare_with_given_sines(text, function, false, [this](const std::vector<Argument>& arguments, bool) {
    std::vector<std::string> list;
    for (const Argument& each : arguments) {
      list.push_back(each.kind == Argument::Kind::parameters ? parameters_argument()
                     : each.kind == Argument::Kind::input    ? input(each.name, each.length)
                                                             : output(each.name, each.length));
    }
    return list;
  });
}

std::string RustDialect::count_definition(const std::string& name, int value) const {
  return fmt::format("pub const {}: usize = {};\n", name, value);
}

std::string RustDialect::definition_begin(const code::Table& table) const {
  using Type = code::Table::Type;
  const std::string type = table.type == Type::text    ? "&str"
                           : table.type == Type::whole ? "usize"
                           : table.type == Type::flag  ? "bool"
                                                       : scalar();
  return fmt::format("pub static {}: [{}; {}] = [", in_capitals(table.name), type, table.length);
}

std::vector<FileTemplate> RustDialect::files() const {
  return {{"/src/lib.rs", templates::lib_rs}, {"/Cargo.toml", templates::cargo_toml}};
}

std::string RustDialect::member(const std::string& name, const std::string& unit) const {
  const std::string documentation = unit.empty() ? "" : "/// " + unit + "\n" + std::string(indent(), ' ');
  return documentation + fmt::format("pub {}: {},", name, scalar());
}

void RustDialect::write_function(data& item, const Function& function, const FunctionText& text) const {
  const std::vector<std::string> summary = brief_comment(function), comment = function_comment(function, text);
  const std::vector<std::string> rest(comment.begin() + static_cast<std::ptrdiff_t>(summary.size()), comment.end());
  std::string definitions =
      documentation(summary, rest) + function_definition(text, text.name, text.parameters, text.body);
  if (text.sin_cos_variant) {
    const SinCosVariant& given = *text.sin_cos_variant;
    const std::string begin = fmt::format("`{}()` with sines and cosines of the caller's.", text.name);
    definitions += "\n\n" + documentation({begin}, {given_sines_comment(given)}) +
                   function_definition(text, given.name, given.parameters, given.body);
  }
  item["definitions"] = definitions;
}

void RustDialect::write_page(data& page, const CodeContent& content) const {
  const std::string crate = crate_name(content.file_name);
  page["crate"] = crate;
  page["real"] = scalar();
  page["no_std?"] = !content.uses_fma && !(content.uses_trigonometry && content.options.sines == Sines::library);
  page["is_float"] = is_float();
  page["most_angle"] = std::string(is_float() ? "6400.0" : "1e5");
  page["hash_of_sines"] = std::string(is_float() ? kFloatSines : kDoubleSines);
  const std::string answer = rust_known_answer(content, indent());
  page["known_answer?"] = !answer.empty();
  page["known_answer"] = without_newline(answer);
  page["answer"] = std::string(is_float() ? kFloatAnswer : kDoubleAnswer);
  const char* const polynomials =
      is_float() ? templates::polynomials_of_floats_rs : templates::polynomials_of_doubles_rs;
  page["polynomials"] = without_newline(rendered(polynomials, page));
  if (content.texts.empty()) return;
  page["example"] = list_of(rust_example(content.texts.front(), crate, !content.scope.parameters.empty()));
}

}  // namespace flatdyn
