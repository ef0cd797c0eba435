// SPDX-License-Identifier: GPL-2.0-or-later
#include "emit/function_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "diagnostics/table.hpp"
#include "emit/arguments.hpp"
#include "emit/expression.hpp"
#include "emit/names.hpp"
#include "emit/schedule.hpp"
#include "emit/writer.hpp"

namespace flatdyn {

namespace {

constexpr std::size_t kIndent = 2;

class FunctionWriter {
 public:
  FunctionWriter(const Function& function, const HeaderScope& scope)
      : function_(function),
        scope_(scope),
        inputs_(inputs_read(function)),
        schedule_(make_schedule(function)),
        names_(names_in_scope()),
        printer_(function.graph, variables_) {
    for (const Output& output : function_.outputs) output_names_.push_back(names_.unique(output.name));
    variables_ = name_variables(function_, schedule_, scope_.parameters, names_);
    for (const Statement& statement : schedule_.statements) {
      if (is_angle_function(statement)) turning_joints_.insert(joint_of_angle(statement.node));
    }
  }

  FunctionText text(const std::string& name) {
    FunctionText text;
    text.name = name;
    text.returns = returns_value(function_) ? "Scalar" : function_.positive.empty() ? "void" : "bool";
    text.parameters = parameters();
    text.inputs = input_arrays();
    text.outputs = output_arrays();
    text.arguments = argument_lines();
    text.reads = list_of_inputs(inputs_, scope_.parameters);
    text.result = result_text();
    text.body = loads() + trigonometry() + statements() + condition();
    text.uses_sign = has_op(Op::sign);
    text.uses_trigonometry = !turning_joints_.empty();
    return text;
  }

 private:
  NameTable names_in_scope() const {
    std::set<std::string> taken = scope_.names;
    for (InputKind kind : function_.inputs) taken.insert(input_argument(kind, 0).name);
    taken.insert({"parameters", "positive", "sin_cos", "sine", "cosine"});
    return NameTable(taken);
  }

  bool has_op(Op op) const {
    return std::any_of(schedule_.statements.begin(), schedule_.statements.end(),
                       [&](const Statement& statement) { return contains(statement.node, op); });
  }

  // Whether the statement of `id` writes an operation of this kind out.
  bool contains(NodeId id, Op op) const {
    const Node& node = function_.graph[id];
    if (node.op == op) return true;
    const std::vector<NodeId> parts = operands_of(node);
    return std::any_of(parts.begin(), parts.end(),
                       [&](NodeId part) { return !is_variable(part) && contains(part, op); });
  }

  // Makes a variable of a sine or a cosine.
  bool is_angle_function(const Statement& statement) const {
    const Op op = function_.graph[statement.node].op;
    return statement.targets.empty() && (op == Op::sin || op == Op::cos);
  }

  // Sines and cosines come joint by joint from whoever knows them: sums of angles are the derivation's own business.
  int joint_of_angle(NodeId id) const {
    const Node& angle = function_.graph[function_.graph[id].operands[0]];
    if (angle.op != Op::input || angle.input.kind != InputKind::q) {
      throw std::logic_error("sine or cosine of what is no joint's position");
    }
    return angle.input.index;
  }

  bool is_variable(NodeId id) const { return schedule_.is_variable[static_cast<std::size_t>(id)]; }

  bool reads(InputKind kind) const {
    return std::any_of(inputs_.begin(), inputs_.end(), [kind](const Input& input) { return input.kind == kind; });
  }

  // An argument that is not read has no name, so that no compiler complains.
  static std::string parameter(const std::string& type, const std::string& name, bool used) {
    return type + " " + (used ? name : "/* " + name + " */");
  }

  std::vector<std::string> parameters() const {
    std::vector<std::string> list;
    if (!scope_.parameters.empty()) {
      list.push_back(parameter("const Parameters<Scalar>&", "parameters", reads(InputKind::parameter)));
    }
    for (InputKind kind : function_.inputs) {
      list.push_back(parameter("const Scalar*", input_argument(kind, 0).name, reads(kind)));
    }
    for (std::size_t k = 0; k < function_.outputs.size() && !returns_value(function_); ++k) {
      list.push_back(parameter("Scalar*", output_names_[k], !function_.outputs[k].entries.empty()));
    }
    if (!turning_joints_.empty()) list.emplace_back("const SinCos& sin_cos = {}");
    return list;
  }

  std::vector<ArrayArgument> input_arrays() const {
    std::vector<ArrayArgument> arrays;
    for (InputKind kind : function_.inputs) {
      const InputArgument argument = input_argument(kind, scope_.joints, function_.base_parameters);
      arrays.push_back({argument.name, static_cast<std::size_t>(argument.length)});
    }
    return arrays;
  }

  std::vector<ArrayArgument> output_arrays() const {
    std::vector<ArrayArgument> arrays;
    if (returns_value(function_)) return arrays;
    for (std::size_t k = 0; k < function_.outputs.size(); ++k) {
      arrays.push_back({output_names_[k], function_.outputs[k].entries.size()});
    }
    return arrays;
  }

  std::vector<std::string> argument_lines() const {
    std::vector<std::vector<std::string>> rows;
    for (InputKind kind : function_.inputs) {
      const InputArgument argument = input_argument(kind, scope_.joints, function_.base_parameters);
      rows.push_back({fmt::format("{}[{}]", argument.name, argument.length), "in", argument.meaning});
    }
    for (std::size_t k = 0; k < function_.outputs.size() && !returns_value(function_); ++k) {
      const Output& output = function_.outputs[k];
      rows.push_back({fmt::format("{}[{}]", output_names_[k], output.entries.size()), "out", output.meaning});
      Output renamed = output;
      renamed.name = output_names_[k];
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
    if (function_.positive.empty()) return "";
    return "false if the result means nothing, because a pivot of B is not positive or not a number";
  }

  const std::string& variable(NodeId id) const { return variables_[static_cast<std::size_t>(id)]; }

  // All inputs are read first, before any output is written: so outputs may overlap inputs, and no value is read twice.
  std::string loads() const {
    std::string text;
    std::vector<std::string> items;
    for (std::size_t k = 0; k < inputs_.size(); ++k) {
      const NodeId input = find_input(inputs_[k]);
      if (is_used_by_itself(input)) {
        items.push_back(variable(input) + " = " + access_of_input(inputs_[k], scope_.parameters));
      }
      const bool last_of_kind = k + 1 == inputs_.size() || inputs_[k + 1].kind != inputs_[k].kind;
      if (!last_of_kind || items.empty()) continue;
      text += list_line("const Scalar ", items, ";", kIndent);
      items.clear();
    }
    return text;
  }

  // Not only as an angle whose sine or cosine is wanted.
  bool is_used_by_itself(NodeId input) const {
    return std::any_of(schedule_.statements.begin(), schedule_.statements.end(), [&](const Statement& statement) {
      if (is_angle_function(statement)) return false;
      const bool stores_variable = !statement.targets.empty() && is_variable(statement.node);
      return stores_variable ? statement.node == input : mentions(statement.node, input);
    });
  }

  // Whether the definition of `id` has the variable in it.
  bool mentions(NodeId id, NodeId wanted) const {
    const std::vector<NodeId> parts = operands_of(function_.graph[id]);
    return std::any_of(parts.begin(), parts.end(),
                       [&](NodeId part) { return part == wanted || (!is_variable(part) && mentions(part, wanted)); });
  }

  // One call for the sines and cosines of all joints, so that they can be evaluated together.
  std::string trigonometry() const {
    if (turning_joints_.empty()) return "";
    std::vector<std::string> variables;
    for (const Statement& statement : schedule_.statements) {
      if (!is_angle_function(statement)) continue;
      const char* array = function_.graph[statement.node].op == Op::sin ? "sine" : "cosine";
      variables.push_back(fmt::format("{} = {}[{}]", variable(statement.node), array, joint_of_angle(statement.node)));
    }
    return code_line("Scalar sine[joint_count], cosine[joint_count];", kIndent) +
           code_line(fmt::format("sin_cos(q, Joints<{}>(), sine, cosine);", fmt::join(turning_joints_, ", ")),
                     kIndent) +
           list_line("const Scalar ", variables, ";", kIndent);
  }

  NodeId find_input(const Input& input) const {
    for (NodeId id = 0; id < function_.graph.size(); ++id) {
      const Node& node = function_.graph[id];
      if (node.op == Op::input && node.input == input) return id;
    }
    throw std::logic_error("input that is read is not in the graph");
  }

  std::string statements() const {
    std::string text;
    for (const Statement& statement : schedule_.statements) {
      if (!statement.targets.empty()) {
        text += store(statement);
      } else if (!is_angle_function(statement)) {
        text += code_line(
            fmt::format("const Scalar {} = {};", variable(statement.node), printer_.definition(statement.node)),
            kIndent);
      }
    }
    return text;
  }

  // "B[1] = B[7] = b_12;"
  std::string store(const Statement& statement) const {
    constexpr std::size_t kMostTargets = 8;
    const std::string value = printer_.use(statement.node);
    if (returns_value(function_)) return code_line("return " + value + ";", kIndent);
    std::string text, code;
    const std::vector<Target>& targets = statement.targets;
    for (std::size_t k = 0; k < targets.size(); ++k) {
      const Target& target = targets[k];
      code += fmt::format("{}[{}] = ", output_names_[static_cast<std::size_t>(target.output)], target.entry);
      const bool full = function_.graph.is_constant(statement.node) && (k + 1) % kMostTargets == 0;
      if (k + 1 < targets.size() && !full) continue;
      text += code_line(code + value + ";", kIndent);
      code.clear();
    }
    return text;
  }

  // Not a number compares false; & does not branch. Constants are known to be positive.
  std::string condition() const {
    if (function_.positive.empty()) return "";
    std::string text;
    for (NodeId id : function_.positive) {
      if (function_.graph.is_constant(id) && function_.graph[id].value > 0) continue;
      text += code_line((text.empty() ? "bool positive = " : "positive &= ") + printer_.use(id) + " > Scalar(0.0);",
                        kIndent);
    }
    return text + code_line(text.empty() ? "return true;" : "return positive;", kIndent);
  }

  const Function& function_;
  const HeaderScope& scope_;
  std::vector<Input> inputs_;
  Schedule schedule_;
  NameTable names_;
  std::vector<std::string> output_names_;
  VariableNames variables_;
  ExpressionPrinter printer_;
  std::set<int> turning_joints_;  // whose sines or cosines are used
};

}  // namespace

bool returns_value(const Function& function) {
  return function.positive.empty() && function.outputs.size() == 1 && function.outputs[0].layout == Layout::scalar;
}

FunctionText function_text(const Function& function, const std::string& name, const HeaderScope& scope) {
  return FunctionWriter(function, scope).text(name);
}

}  // namespace flatdyn
