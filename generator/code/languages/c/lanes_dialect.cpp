// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/c/lanes_dialect.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "code/emit/page.hpp"
#include "code/emit/sections.hpp"
#include "code/emit/text_hash.hpp"
#include "code/emit/writer.hpp"
#include "code/lower/arguments.hpp"
#include "templates.hpp"

namespace flatdyn {

using kainjow::mustache::data;

namespace {

constexpr std::size_t kInFunction = 2, kInLoop = 4;

// A function that computes many states in one call.
class BatchFunction {
 public:
  BatchFunction(const Function& function, const FunctionText& text, const LanesDialect& dialect)
      : function_(function),
        text_(text),
        dialect_(dialect),
        has_parameters_(text.inputs.size() + text.outputs.size() < text.declared.size()),
        results_(text.outputs) {
    if (returns_value(function)) results_.push_back({function.outputs[0].name, 1});
  }

  std::string definition() const {
    std::string loop = blocks() + read() + call();
    for (const ArrayArgument& result : results_) loop += write(result);
    return signature() +
           code_line(fmt::format("for (size_t k = 0; k < count; k += {}) {{", dialect_.global("count")), kInFunction) +
           code_line(fmt::format("const size_t states = {}(count - k);", dialect_.global("states")), kInLoop) + loop +
           code_line("}", kInFunction) + "}\n";
  }

 private:
  std::string signature() const {
    std::vector<std::string> parameters = {"size_t count"};
    if (has_parameters_) parameters.push_back(dialect_.parameters_argument());
    for (const ArrayArgument& input : text_.inputs) {
      parameters.push_back(fmt::format("const {}* {}", dialect_.number(), input.name));
      parameters.push_back(fmt::format("size_t {}_step", input.name));
    }
    for (const ArrayArgument& result : results_) {
      parameters.push_back(fmt::format("{}* {}", dialect_.number(), result.name));
    }
    const std::string name = dialect_.exported(cpp_name() + "_batch");
    return list_line(fmt::format("void {}(", name), parameters, ") {", 0);
  }

  // Strips the prefix: "panda_lanes_gravity" → "gravity".
  std::string cpp_name() const { return text_.name.substr(dialect_.global("").size()); }

  std::string blocks() const {
    std::vector<std::string> items;
    for (const ArrayArgument& input : text_.inputs)
      items.push_back(dialect_.array(block(input), std::to_string(input.length)));
    for (std::size_t k = 0; k < results_.size(); ++k) {
      // Entries that a scene leaves out are not written.
      const char* const initial = function_.outputs[k].left_out.empty() ? "" : " = {{0}}";
      items.push_back(dialect_.array(block(results_[k]), std::to_string(results_[k].length)) + initial);
    }
    return list_line(dialect_.arrays(), items, ";", kInLoop);
  }

  static std::string block(const ArrayArgument& array) { return array.name + "_block"; }

  std::string read() const {
    std::string lines;
    for (const ArrayArgument& input : text_.inputs) {
      lines += code_line(fmt::format("{}({} + {}_step * k, {}_step, states, {}, {});", dialect_.global("read"),
                                     input.name, input.name, input.name, input.length, block(input)),
                         kInLoop);
    }
    return lines;
  }

  std::string call() const {
    std::vector<std::string> arguments;
    if (has_parameters_) arguments.emplace_back("parameters");
    for (const ArrayArgument& input : text_.inputs) arguments.push_back(block(input));
    for (const ArrayArgument& output : text_.outputs) arguments.push_back(block(output));
    const std::string receiver = returns_value(function_) ? block(results_[0]) + "[0] = "
                                 : is_checked()           ? "const " + dialect_.condition_type() + " valid = "
                                                          : "";
    return list_line(receiver + text_.name + "(", arguments, ");", kInLoop);
  }

  bool is_checked() const { return !function_.validity_conditions.empty(); }

  std::string write(const ArrayArgument& result) const {
    const std::string checked = is_checked()
                                    ? code_line(fmt::format("{}(valid, {}, {});", dialect_.global("or_not_a_number"),
                                                            result.length, block(result)),
                                                kInLoop)
                                    : "";
    return checked + code_line(fmt::format("{}({}, states, {}, {} + {} * k);", dialect_.global("write"), block(result),
                                           result.length, result.name, result.length),
                               kInLoop);
  }

  const Function& function_;
  const FunctionText& text_;
  const LanesDialect& dialect_;
  bool has_parameters_;
  std::vector<ArrayArgument> results_;
};

}  // namespace

LanesDialect::LanesDialect(const std::string& number, const std::string& name_space)
    : CDialect(number, name_space, {"lanes_", CDialect(number, name_space).exported("lanes")}) {}

std::string LanesDialect::spread(const std::string& value) const { return global("all(") + value + ")"; }

std::string LanesDialect::literal(const Rational& value) const { return spread(CDialect::literal(value)); }

std::string LanesDialect::sqrt(const std::string& of) const { return global("sqrt(") + of + ")"; }

std::string LanesDialect::parameter(const std::string& member) const { return spread(CDialect::parameter(member)); }

std::string LanesDialect::condition_type() const { return global("mask"); }

std::string LanesDialect::always() const { return "~(" + condition_type() + "){0}"; }

std::vector<FileTemplate> LanesDialect::files() const { return {{"_batch.c", templates::batch_c}}; }

void LanesDialect::write_function(data& item, const Function& function, const FunctionText& text) const {
  CDialect::write_function(item, function, text);
  item["batch"] = without_newline(BatchFunction(function, text, *this).definition());
}

void LanesDialect::write_page(data& page, const CodeContent& content) const {
  CDialect::write_page(page, content);
  page["prefix"] = exported("");
  page["lanes"] = scalar();
  page["mask"] = condition_type();
  page["number"] = number();
  const bool is_float = number() == "float";
  page["is_float"] = is_float;
  page["integer"] = std::string(is_float ? "int" : "long long");
  page["first_halves"] = std::string(is_float ? "0, 4, 1, 5" : "0, 2");
  page["second_halves"] = std::string(is_float ? "2, 6, 3, 7" : "1, 3");
  page["checks?"] = std::any_of(content.functions.begin(), content.functions.end(),
                                [](const Function& function) { return !function.validity_conditions.empty(); });
  page["hash"] = std::string(kHashPlaceholder);
  page["sines"] = without_newline(rendered(templates::batch_sines_c, page));
}

}  // namespace flatdyn
