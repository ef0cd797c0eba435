// SPDX-License-Identifier: GPL-2.0-or-later
#include "emit/function_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "diagnostics/table.hpp"
#include "emit/angles.hpp"
#include "emit/arguments.hpp"
#include "emit/function_body.hpp"
#include "emit/writer.hpp"

namespace flatdyn {

namespace {

class FunctionWriter {
 public:
  FunctionWriter(const Function& function, const std::string& name, const HeaderScope& scope)
      : function_(function),
        name_(name),
        scope_(scope),
        dialect_(scope.dialect),
        body_(function_body(function, name, scope)) {}

  FunctionText text(const std::string& given_name) const {
    FunctionText text;
    text.name = name_;
    text.returns = return_type(dialect_.scalar());
    text.parameters = parameters(kTemplate);
    text.inputs = input_arrays();
    text.outputs = output_arrays();
    text.arguments = argument_lines();
    text.reads = reads_text();
    text.result = result_text();
    text.body = body_.text;
    text.parts = body_.parts;
    text.uses_sign = body_.uses_sign;
    text.uses_sqrt = body_.uses_sqrt;
    text.uses_trigonometry = body_.uses_trigonometry();
    if (dialect_.is_c()) in_two(text, given_name);
    if (dialect_.is_javascript()) text.parameters = c_parameters(false, false);
    if (is_apart()) set_apart(text);
    return text;
  }

 private:
  std::string reads_text() const {
    const std::string inputs = list_of_inputs(body_.inputs, scope_.parameters, dialect_);
    if (scope_.stored.empty()) return inputs;
    return (body_.inputs.empty() ? "" : inputs + " and ") + "what is stored";
  }

  // Splits a C function in two: one takes sines and cosines as arguments; the other one computes them and calls it.
  void in_two(FunctionText& text, const std::string& given_name) const {
    text.declared = c_parameters(false, false);
    text.parameters = c_parameters(false, true);
    if (!body_.uses_trigonometry()) {
      text.body = unread() + text.body;
      return;
    }
    GivenText given{given_name, c_parameters(true, true), c_parameters(true, false), {}, angle_array(scope_),
                    "",         unread() + text.body};
    for (const CArgument& argument : c_arguments(true)) given.arguments.push_back(argument.name);
    text.body = body_that_asks(given);
    text.given = std::move(given);
  }

  struct CArgument {
    enum class Kind { parameters, input, output } kind;
    std::string name;
    bool is_read;  // or written
  };

  // The arguments. With `given`, sines and cosines replace q, unless positions themselves are read, too.
  std::vector<CArgument> c_arguments(bool given) const {
    std::vector<CArgument> list;
    if (!scope_.parameters.empty()) {
      list.push_back({CArgument::Kind::parameters, "parameters", reads(InputKind::parameter)});
    }
    if (given) {
      list.push_back({CArgument::Kind::input, "sine", body_.takes_sines});
      list.push_back({CArgument::Kind::input, "cosine", body_.takes_cosines});
    }
    for (InputKind kind : function_.inputs) {
      if (given && kind == InputKind::q && !body_.uses_positions) continue;
      list.push_back({CArgument::Kind::input, input_argument(kind, 0).name, reads(kind)});
    }
    for (std::size_t k = 0; k < function_.outputs.size() && !returns_value(function_); ++k) {
      list.push_back({CArgument::Kind::output, body_.output_names[k], function_.outputs[k].is_written()});
    }
    return list;
  }

  std::vector<std::string> c_parameters(bool given, bool restricts) const {
    std::vector<std::string> list;
    for (const CArgument& argument : c_arguments(given)) {
      list.push_back(argument.kind == CArgument::Kind::parameters ? dialect_.parameters_argument()
                     : argument.kind == CArgument::Kind::input    ? dialect_.input(argument.name)
                                                                  : dialect_.output(argument.name, restricts));
    }
    return list;
  }

  // Statements like "(void)qd;", which silence compilers: in C every parameter has a name.
  std::string unread() const {
    std::string text;
    for (const CArgument& argument : c_arguments(body_.uses_trigonometry())) {
      if (!argument.is_read) text += code_line(fmt::format("(void){};", argument.name), kStatementIndent);
    }
    return text;
  }

  // The angles that are needed, as first and last index of each run of consecutive ones.
  std::vector<std::pair<int, int>> runs_of_angles() const {
    std::vector<std::pair<int, int>> runs;
    for (const int angle : body_.angles) {
      if (!runs.empty() && runs.back().second + 1 == angle) {
        runs.back().second = angle;
      } else {
        runs.emplace_back(angle, angle);
      }
    }
    return runs;
  }

  // The body of the function that computes sines and cosines and calls `given`; records in `given` which ones it takes.
  std::string body_that_asks(GivenText& given) const {
    const std::string count = angle_count_name(scope_), of = angle_array(scope_);
    const bool has_others = !scope_.angles.empty();
    std::string text = code_line(fmt::format("{0} {2}sine[{1}], cosine[{1}];", dialect_.scalar(), count,
                                             has_others ? "angle[" + count + "], " : ""),
                                 kStatementIndent);
    if (has_others) text += angles_call(scope_);
    for (const auto& [first, last] : runs_of_angles()) {
      text +=
          code_line(fmt::format("{}({}, {}, {}, sine, cosine);", dialect_.global("sines_and_cosines"), of, first, last),
                    kStatementIndent);
      given.joints += (given.joints.empty() ? "" : ", ") + std::to_string(first);
      if (last > first) given.joints += ".." + std::to_string(last);
    }
    const char* give_back = return_type(dialect_.scalar()) == "void" ? "" : "return ";
    return text + list_line(fmt::format("{}{}(", give_back, given.name), given.arguments, ");", kStatementIndent);
  }

  bool makes_stage() const { return !scope_.made.empty(); }

  std::string return_type(const std::string& scalar) const {
    if (makes_stage()) return scope_.made + "<" + scalar + ">";
    return returns_value(function_)                ? scalar
           : function_.validity_conditions.empty() ? "void"
                                                   : dialect_.condition_type();
  }

  bool reads(InputKind kind) const {
    return std::any_of(body_.inputs.begin(), body_.inputs.end(),
                       [kind](const Input& input) { return input.kind == kind; });
  }

  // A parameter. One that is not used has no name, so that compilers do not warn.
  static std::string parameter(const std::string& type, const std::string& name, bool used) {
    return type + " " + (used ? name : "/* " + name + " */");
  }

  // The form of C++ parameters: their types, whether unused ones have names, and whether they have defaults.
  struct Manner {
    std::string scalar, sin_cos;
    bool names_all, has_default;
  };
  static inline const Manner kTemplate = {"Scalar", "SinCos", false, true};

  std::vector<std::string> parameters(const Manner& manner) const {
    const std::string array = manner.scalar + "*";
    const auto is_named = [&manner](bool is_used) { return manner.names_all || is_used; };
    std::vector<std::string> list;
    if (!scope_.parameters.empty()) {
      const std::string type = "const Parameters<" + manner.scalar + ">&";
      list.push_back(parameter(type, "parameters", is_named(reads(InputKind::parameter))));
    }
    for (InputKind kind : function_.inputs) {
      list.push_back(parameter("const " + array, input_argument(kind, 0).name, is_named(reads(kind))));
    }
    for (std::size_t k = 0; k < function_.outputs.size() && !returns_value(function_) && !makes_stage(); ++k) {
      list.push_back(parameter(array, body_.output_names[k], is_named(function_.outputs[k].is_written())));
    }
    if (body_.uses_trigonometry()) {
      list.push_back("const " + manner.sin_cos + "& sin_cos" + (manner.has_default ? " = {}" : ""));
    }
    return list;
  }

  bool is_apart() const { return !scope_.compiled.empty(); }

  // Separates declaration and definition: defaults belong to the declaration. The source of sines and cosines is the
  // header's own.
  void set_apart(FunctionText& text) const {
    text.declared = parameters({"Scalar", "SinCos", true, true});
    text.parameters = parameters({"Scalar", "SinCos", false, false});
    if (!scope_.enclosing_stage.empty()) return;  // a stage's struct is instantiated as a whole
    for (const std::string& scalar : scope_.compiled) {
      text.compiled.push_back({return_type(scalar), parameters({scalar, "LibrarySinCos", true, false})});
      if (!body_.uses_trigonometry()) continue;
      text.compiled.push_back({return_type(scalar), parameters({scalar, "GivenSinCos<" + scalar + ">", true, false})});
    }
  }

  JointCounts counts() const {
    JointCounts result(scope_.joints);
    result.positions = scope_.positions;
    return result;
  }

  std::vector<ArrayArgument> input_arrays() const {
    std::vector<ArrayArgument> arrays;
    for (InputKind kind : function_.inputs) {
      const InputArgument argument = input_argument(kind, counts(), function_.base_parameters);
      arrays.push_back({argument.name, static_cast<std::size_t>(argument.length)});
    }
    return arrays;
  }

  std::vector<ArrayArgument> output_arrays() const {
    std::vector<ArrayArgument> arrays;
    if (returns_value(function_) || makes_stage()) return arrays;
    for (std::size_t k = 0; k < function_.outputs.size(); ++k) {
      arrays.push_back({body_.output_names[k], function_.outputs[k].entries.size()});
    }
    return arrays;
  }

  std::vector<std::string> argument_lines() const {
    std::vector<std::vector<std::string>> rows;
    for (InputKind kind : function_.inputs) {
      const InputArgument argument = input_argument(kind, counts(), function_.base_parameters);
      rows.push_back({fmt::format("{}[{}]", argument.name, argument.length), "in", argument.meaning});
    }
    for (std::size_t k = 0; k < function_.outputs.size() && !returns_value(function_) && !makes_stage(); ++k) {
      const Output& output = function_.outputs[k];
      rows.push_back({fmt::format("{}[{}]", body_.output_names[k], output.entries.size()), "out", output.meaning});
      Output renamed = output;
      renamed.name = body_.output_names[k];
      const std::string layout = layout_text(renamed);
      if (!layout.empty()) rows.push_back({"", "", layout});
    }
    return aligned_lines(rows);
  }

  std::string result_text() const {
    if (returns_value(function_)) {
      const Output& output = function_.outputs[0];
      return output.name + (output.meaning.empty() ? "" : ": " + output.meaning);
    }
    if (function_.validity_conditions.empty()) return "";
    const std::string also = function_.task.empty()       ? ""
                             : function_.task.is_damped() ? " or of J B^-1 J^T + lambda^2 1"
                                                          : " or of J B^-1 J^T";
    const bool asks_loops = function_.loop_conditions > 0;
    const bool asks_pivots = function_.validity_conditions.size() > static_cast<std::size_t>(function_.loop_conditions);
    const char* const lost = function_.pivot_diagonals.empty() ? "not positive" : "not positive, lost in rounding,";
    return fmt::format("false if the result means nothing, because {}{}{}",
                       asks_loops ? "a closed loop is within 1e-6 of being singular" : "",
                       asks_loops && asks_pivots ? ", or " : "",
                       asks_pivots ? fmt::format("a pivot of B{} is {} or not a number", also, lost) : "");
  }

  const Function& function_;
  const std::string& name_;
  const HeaderScope& scope_;
  const Dialect& dialect_;
  FunctionBody body_;
};

}  // namespace

FunctionText function_text(const Function& function, const std::string& name, const HeaderScope& scope,
                           const std::string& given_name) {
  return FunctionWriter(function, name, scope).text(given_name);
}

}  // namespace flatdyn
