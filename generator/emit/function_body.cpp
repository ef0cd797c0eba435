// SPDX-License-Identifier: GPL-2.0-or-later
#include "emit/function_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "emit/angles.hpp"
#include "emit/arguments.hpp"
#include "emit/expression.hpp"
#include "emit/kernel_parts.hpp"
#include "emit/limb_text.hpp"
#include "emit/names.hpp"
#include "emit/parts.hpp"
#include "emit/schedule.hpp"
#include "emit/validity.hpp"
#include "emit/writer.hpp"
#include "passes/fuse_products.hpp"

namespace flatdyn {
namespace {

constexpr int kLongPart = 1000;  // lines of a part, unless fewer are asked for

// Parts have no limbs in lanes, which save more than parts do: a function may be this many times as long for them.
constexpr int kLongerWithLimbs = 4;

// The arrays that parts share, beside a function's own arguments.
constexpr const char *kKept = "kept", *kPivots = "pivots", *kStored = "stored", *kResult = "result";

// The inputs that are read from arguments; values stored by an earlier stage are not.
std::vector<Input> arguments_read(const Function& function) {
  std::vector<Input> inputs = inputs_read(function);
  std::erase_if(inputs, [](const Input& input) { return input.kind == InputKind::stored; });
  return inputs;
}

NameTable names_in_scope(const Function& function, const HeaderScope& scope) {
  std::set<std::string> taken = scope.names;
  taken.insert(scope.stored.begin(), scope.stored.end());
  for (InputKind kind : function.inputs) taken.insert(input_argument(kind, 0).name);
  taken.insert({"parameters", "sin_cos", "sine", "cosine", angle_array(scope)});
  if (!function.validity_conditions.empty()) taken.insert({kValid, kCounter});
  taken.insert({kKept, kPivots, kStored, kResult});
  return NameTable(taken);
}

std::vector<bool> fused_products(const Function& function, const HeaderScope& scope) {
  return scope.fuses ? products_to_fuse(function) : std::vector<bool>(static_cast<std::size_t>(function.graph.size()));
}

class BodyWriter {
 public:
  BodyWriter(const Function& function, const std::string& name, const HeaderScope& scope)
      : function_(function),
        name_(name),
        scope_(scope),
        dialect_(scope.dialect),
        lines_around_(
            scope.dialect.lines_around_body(static_cast<int>(function.inputs.size() + function.outputs.size()))),
        inputs_(arguments_read(function)),
        is_fused_(fused_products(function, scope)),
        schedule_(make_schedule(function, is_fused_, scope.dialect.lives())),
        limb_plan_(limb_plan(function, scope.limbs, scope.dialect, schedule_)),
        printer_(function.graph, variables_, scope.dialect, scope.fuses ? is_fused_ : std::vector<bool>()),
        validity_(printer_, scope.dialect) {
    NameTable names = names_in_scope(function, scope);
    for (const Output& output : function_.outputs) output_names_.push_back(names.unique(output.name));
    variables_ = name_variables(function_, schedule_, scope_.parameters, scope_.stored, names);
    name_entries_read();
    for (const Statement& statement : schedule_.statements) {
      if (is_angle_function(statement)) angles_.insert(angle_index(function_.graph, statement.node, scope_));
    }
    if (!limb_plan_) return;
    limbs_.emplace(
        function_, *limb_plan_, scope.limbs, dialect_, [this](NodeId id) { return given_text(id); }, names, variables_);
  }

  FunctionBody body() const {
    FunctionBody body;
    body.inputs = inputs_;
    body.output_names = output_names_;
    body.uses_sign = has_op(Op::sign);
    body.uses_sqrt = has_op(Op::sqrt);
    const std::vector<CheckedPivot> pivots = pivots_to_check(function_);
    body.uses_excess =
        std::any_of(pivots.begin(), pivots.end(), [](const CheckedPivot& pivot) { return pivot.scale.has_value(); });
    body.uses_positions = std::any_of(inputs_.begin(), inputs_.end(), [this](const Input& input) {
      return input.kind == InputKind::q && is_used_by_itself(find_input(input));
    });
    body.angles.assign(angles_.begin(), angles_.end());
    body.takes_sines = has_op(Op::sin);
    body.takes_cosines = has_op(Op::cos);
    body.text = whole();
    body.uses_fma = has_fused(body.text);
    body.uses_limbs = limbs_.has_value();
    const auto lines = std::count(body.text.begin(), body.text.end(), '\n');
    body.is_too_long = lines + lines_around_ > longest();
    if (body.is_too_long && !limbs_) write_parts(body);
    return body;
  }

 private:
  int longest() const {
    if (scope_.most_lines > 0) return scope_.most_lines;
    return dialect_.longest_function() * (limbs_ ? kLongerWithLimbs : 1);
  }

  std::string whole() const {
    std::string text = loads() + trigonometry(false) + sines_and_cosines() + stage();
    if (limbs_) {
      text = limbs_->types() + text + limbs_->given();
      for (const LimbStep& step : limbs_->steps()) text += limb_step(step);
      return text + ending();
    }
    for (const PartStep& step : steps(false)) text += step.makes ? definition_line(step) : step.code;
    return (has_fused(text) ? dialect_.fused_begin() : "") + text + ending();
  }

  std::string limb_step(const LimbStep& step) const {
    switch (step.kind) {
      case LimbStep::Kind::scalar:
        return definition_line(definition(step.index));
      case LimbStep::Kind::stored:
        return stored_step(schedule_.statements[static_cast<std::size_t>(step.index)]).code;
      case LimbStep::Kind::limbs:
        return limbs_->definition(step.index);
      case LimbStep::Kind::gathered:
        return limbs_->gathered(step.index);
      case LimbStep::Kind::taken:
        break;
    }
    return limbs_->taken(step.index);
  }

  // Writes the same statements as several functions. The first ones read all inputs.
  void write_parts(FunctionBody& body) const {
    const std::string name = scope_.enclosing_stage.empty() ? name_ : scope_.enclosing_stage + "_" + name_;
    LongBody long_body{name, input_steps(), variables_, sources(), part_arguments(), scope_.most_lines, dialect_};
    if (long_body.most_lines == 0) long_body.most_lines = kLongPart;
    for (const std::vector<PartStep>& more : {steps(true), pivot_steps()}) {
      long_body.steps.insert(long_body.steps.end(), more.begin(), more.end());
    }
    const std::string before = trigonometry(true) + stage(), after = ending_of_parts();
    const auto lines = std::count(before.begin(), before.end(), '\n') + std::count(after.begin(), after.end(), '\n');
    const Parts parts =
        in_parts(long_body, std::max(2, (long_body.most_lines - static_cast<int>(lines) - lines_around_) / 2));
    body.parts = parts.definitions;
    body.text = before + shared_by_parts(parts.kept);
    for (const std::string& call : parts.calls) body.text += call;
    body.text += after;
  }

  std::string shared_by_parts(int kept) const {
    std::vector<std::string> items;
    if (kept > 0) items.push_back(dialect_.array(kKept, static_cast<std::size_t>(kept)));
    if (const std::size_t pivots = pivots_to_check(function_).size(); pivots > 0) {
      items.push_back(dialect_.array(kPivots, pivots));
    }
    if (returns_value(function_)) items.push_back(dialect_.number_definition(kResult));
    return items.empty() ? "" : list_line(dialect_.arrays(), items, ";", kStatementIndent);
  }

  std::string ending_of_parts() const {
    if (returns_value(function_)) {
      return code_line(fmt::format("return {};", dialect_.number_use(kResult)), kStatementIndent);
    }
    const std::size_t pivots = pivots_to_check(function_).size();
    return pivots == 0 ? ending() : validity_.statements_of_parts(function_, output_names_, kPivots, pivots);
  }

  std::vector<PartStep> input_steps() const {
    std::vector<PartStep> steps;
    for (const Input& input : inputs_) {
      const NodeId id = find_input(input);
      if (!is_used_by_itself(id)) continue;
      const bool in_struct = input.kind == InputKind::parameter;
      const std::string argument = in_struct ? "parameters" : input_argument(input.kind, 0).name;
      steps.push_back({access_of_input(input, scope_.parameters, dialect_), id, {}, {argument}});
    }
    return steps;
  }

  std::vector<PartStep> pivot_steps() const {
    std::vector<PartStep> steps;
    for (const CheckedPivot& pivot : pivots_to_check(function_)) {
      std::vector<NodeId> variables = variables_used(pivot.value);
      if (pivot.scale) {
        const std::vector<NodeId> more = variables_used(*pivot.scale);
        variables.insert(variables.end(), more.begin(), more.end());
      }
      steps.push_back(
          {code_line(fmt::format("{}[{}] = {};", kPivots, steps.size(), validity_.checked(pivot)), kStatementIndent),
           {},
           variables,
           {kPivots}});
    }
    return steps;
  }

  // The values that every part can read for itself.
  std::map<NodeId, PartSource> sources() const {
    std::map<NodeId, PartSource> sources;
    for (const Statement& statement : schedule_.statements) {
      if (is_angle_function(statement)) sources[statement.node] = given_angle_function(statement.node);
    }
    for (NodeId id = 0; id < function_.graph.size(); ++id) {
      const Node& node = function_.graph[id];
      if (node.op != Op::input || node.input.kind != InputKind::stored || variable(id).empty()) continue;
      sources[id] = {fmt::format("{}.{}", kStored, variable(id)), kStored};
    }
    return sources;
  }

  std::vector<PartArgument> part_arguments() const {
    std::vector<PartArgument> list = {{"parameters", dialect_.parameters_argument(), "parameters"}};
    if (const std::string& stage = scope_.enclosing_stage; !stage.empty()) {
      list.push_back({kStored, fmt::format("const {}& {}", dialect_.stage_type(stage), kStored), "*this"});
    }
    const auto add_input = [&](const std::string& name) { list.push_back({name, dialect_.input(name), name}); };
    const auto add_output = [&](const std::string& name) { list.push_back({name, dialect_.output(name), name}); };
    for (InputKind kind : function_.inputs) add_input(input_argument(kind, 0).name);
    for (const char* name : {"sine", "cosine"}) add_input(name);
    for (const char* name : {kKept, kPivots}) add_output(name);
    list.push_back({kResult, dialect_.number_output(kResult), kResult});
    for (const std::string& name : output_names_) {
      if (makes_stage()) {
        list.push_back({name, dialect_.stage_type(scope_.made) + "& " + name, name});
      } else {
        add_output(name);
      }
    }
    return list;
  }

  // Stored values that are no variables are entries of the outputs, over all of which their indices count.
  void name_entries_read() {
    if (dialect_.lives() != Lives::fewest) return;
    for (NodeId id = 0; id < function_.graph.size(); ++id) {
      const Node& node = function_.graph[id];
      if (node.op != Op::input || node.input.kind != InputKind::stored) continue;
      const Target read = entry_read(function_, node.input.index);
      const std::string& output = output_names_.at(static_cast<std::size_t>(read.output));
      variables_[static_cast<std::size_t>(id)] = fmt::format("detail::stored({}, {})", output, read.entry);
    }
  }

  bool makes_stage() const { return !scope_.made.empty(); }

  bool has_op(Op op) const {
    return std::any_of(schedule_.statements.begin(), schedule_.statements.end(),
                       [&](const Statement& statement) { return contains(statement.node, op); });
  }

  // Whether the statement of `id` has an operation of this kind inline.
  bool contains(NodeId id, Op op) const {
    const Node& node = function_.graph[id];
    if (node.op == op) return true;
    const std::vector<NodeId> parts = operands_of(node);
    return std::any_of(parts.begin(), parts.end(),
                       [&](NodeId part) { return !is_variable(part) && contains(part, op); });
  }

  // Whether the statement makes a variable of a sine or a cosine.
  bool is_angle_function(const Statement& statement) const {
    const Op op = function_.graph[statement.node].op;
    return statement.targets.empty() && (op == Op::sin || op == Op::cos);
  }

  bool is_variable(NodeId id) const { return schedule_.is_variable[static_cast<std::size_t>(id)]; }

  const std::string& variable(NodeId id) const { return variables_[static_cast<std::size_t>(id)]; }

  // Reads all inputs before any output is written, so that outputs may overlap inputs and no value is read twice.
  std::string loads() const {
    std::string text;
    std::vector<std::string> items;
    for (std::size_t k = 0; k < inputs_.size(); ++k) {
      const NodeId input = find_input(inputs_[k]);
      if (limbs_ ? limbs_->reads(input) : is_used_by_itself(input)) {
        items.push_back(variable(input) + " = " + access_of_input(inputs_[k], scope_.parameters, dialect_));
      }
      const bool last_of_kind = k + 1 == inputs_.size() || inputs_[k + 1].kind != inputs_[k].kind;
      if (!last_of_kind || items.empty()) continue;
      text += list_line(dialect_.constant(), items, ";", kStatementIndent);
      items.clear();
    }
    return text;
  }

  // Whether an input is used other than as an angle whose sine or cosine is needed.
  bool is_used_by_itself(NodeId input) const {
    return std::any_of(schedule_.statements.begin(), schedule_.statements.end(), [&](const Statement& statement) {
      if (is_angle_function(statement)) return false;
      const bool stores_variable = !statement.targets.empty() && is_variable(statement.node);
      return stores_variable ? statement.node == input : mentions(statement.node, input);
    });
  }

  // Whether the definition of `id` contains the variable `wanted`.
  bool mentions(NodeId id, NodeId wanted) const {
    const std::vector<NodeId> parts = operands_of(function_.graph[id]);
    return std::any_of(parts.begin(), parts.end(),
                       [&](NodeId part) { return part == wanted || (!is_variable(part) && mentions(part, wanted)); });
  }

  // All sines and cosines in arrays. If they are evaluated one by one, only several parts need the arrays.
  std::string trigonometry(bool of_parts) const {
    if (angles_.empty()) return "";
    if (!dialect_.evaluates_sines()) return dialect_.filled_sines(angles_, scope_);
    return of_parts ? angle_functions_in_arrays() : "";
  }

  std::string angle_functions_in_arrays() const {
    const std::size_t count = scope_.angle_count();
    std::string text = list_line(dialect_.arrays(), {dialect_.array("sine", count), dialect_.array("cosine", count)},
                                 ";", kStatementIndent);
    for (const Statement& statement : schedule_.statements) {
      if (!is_angle_function(statement)) continue;
      text += code_line(given_angle_function(statement.node).text + " = " + angle_function(statement.node) + ";",
                        kStatementIndent);
    }
    return text;
  }

  std::string sines_and_cosines() const {
    std::vector<std::string> variables;
    for (const Statement& statement : schedule_.statements) {
      if (!is_angle_function(statement) || (limbs_ && !limbs_->reads(statement.node))) continue;
      variables.push_back(variable(statement.node) + " = " + angle_function(statement.node));
    }
    return variables.empty() ? "" : list_line(dialect_.constant(), variables, ";", kStatementIndent);
  }

  // A sine or cosine in emitted code: "sine[2]", "Math.sin(q[2])".
  std::string angle_function(NodeId id) const {
    const int index = angle_index(function_.graph, id, scope_);
    return dialect_.angle_function(function_.graph[id].op == Op::sin ? "sin" : "cos", index, angle_text(index, scope_));
  }

  PartSource given_angle_function(NodeId id) const {
    const char* array = function_.graph[id].op == Op::sin ? "sine" : "cosine";
    return {fmt::format("{}[{}]", array, angle_index(function_.graph, id, scope_)), array};
  }

  // An input, a sine or a cosine that is read.
  std::string given_text(NodeId id) const {
    const Node& node = function_.graph[id];
    if (node.op != Op::input) return given_angle_function(id).text;
    return access_of_input(node.input, scope_.parameters, dialect_);
  }

  NodeId find_input(const Input& input) const {
    for (NodeId id = 0; id < function_.graph.size(); ++id) {
      const Node& node = function_.graph[id];
      if (node.op == Op::input && node.input == input) return id;
    }
    throw std::logic_error("input that is read is not in the graph");
  }

  std::string stage() const {
    return makes_stage()
               ? code_line(fmt::format("{} {};", dialect_.stage_type(scope_.made), output_names_[0]), kStatementIndent)
               : "";
  }

  // The steps without sines and cosines.
  std::vector<PartStep> steps(bool of_parts) const {
    std::vector<PartStep> steps;
    for (const Statement& statement : schedule_.statements) {
      if (is_angle_function(statement)) continue;
      steps.push_back(statement.targets.empty() ? definition(statement.node) : stored_step(statement, of_parts));
    }
    return steps;
  }

  PartStep stored_step(const Statement& statement, bool of_parts = false) const {
    return returns_value(function_) ? give_back(statement.node, of_parts) : store(statement);
  }

  PartStep give_back(NodeId id, bool by_part) const {
    const std::string value = stored_value(id);
    const std::string code =
        by_part ? fmt::format("{} = {};", dialect_.number_use(kResult), value) : fmt::format("return {};", value);
    return {code_line(code, kStatementIndent), {}, variables_used(id), {kResult}};
  }

  PartStep definition(NodeId id) const { return {printer_.definition(id), id, variables_in(id), {}}; }

  std::string definition_line(const PartStep& step) const {
    return code_line(fmt::format("{}{} = {};", dialect_.constant(), variable(*step.makes), step.code),
                     kStatementIndent);
  }

  // The variables in a node's definition.
  std::vector<NodeId> variables_in(NodeId id) const {
    std::vector<NodeId> found;
    for (const NodeId part : operands_of(function_.graph[id])) add_variables_used(part, found);
    return found;
  }

  void add_variables_used(NodeId id, std::vector<NodeId>& found) const {
    if (is_variable(id)) {
      found.push_back(id);
      return;
    }
    for (const NodeId part : operands_of(function_.graph[id])) add_variables_used(part, found);
  }

  std::vector<NodeId> variables_used(NodeId id) const {
    std::vector<NodeId> found;
    add_variables_used(id, found);
    return found;
  }

  std::string stored_value(NodeId id) const { return limbs_ ? limbs_->stored(id) : printer_.use(id); }

  // The statement that stores a value: "B[1] = B[7] = b_12;".
  PartStep store(const Statement& statement) const {
    constexpr std::size_t kMostTargets = 8;
    const std::string value = stored_value(statement.node);
    PartStep step{"", {}, variables_used(statement.node), {}};
    std::string code;
    const std::vector<Target>& targets = statement.targets;
    for (std::size_t k = 0; k < targets.size(); ++k) {
      const Target& target = targets[k];
      step.arguments.push_back(output_names_[static_cast<std::size_t>(target.output)]);
      code += target_text(target) + " = ";
      const bool full = function_.graph.is_constant(statement.node) && (k + 1) % kMostTargets == 0;
      if (k + 1 < targets.size() && !full) continue;
      step.code += code_line(code + value + ";", kStatementIndent);
      code.clear();
    }
    return step;
  }

  // The place of a target: "B[1]", or "stage.x1".
  std::string target_text(const Target& target) const {
    const std::string& output = output_names_[static_cast<std::size_t>(target.output)];
    if (!makes_stage()) return fmt::format("{}[{}]", output, target.entry);
    return output + "." + scope_.fields.at(static_cast<std::size_t>(target.entry));
  }

  // The return of a stage, or the checks of validity and their verdict.
  std::string ending() const {
    if (makes_stage()) return code_line(fmt::format("return {};", output_names_[0]), kStatementIndent);
    return function_.validity_conditions.empty() ? "" : validity_.statements(function_, output_names_);
  }

  const Function& function_;
  const std::string& name_;
  const HeaderScope& scope_;
  const Dialect& dialect_;
  int lines_around_;
  std::vector<Input> inputs_;
  std::vector<bool> is_fused_;  // by node
  Schedule schedule_;
  std::optional<LimbPlan> limb_plan_;
  std::vector<std::string> output_names_;
  VariableNames variables_;
  ExpressionPrinter printer_;
  ValidityText validity_;
  std::optional<LimbText> limbs_;  // if limbs are computed together
  std::set<int> angles_;           // indices of the angles whose sines or cosines are used
};

}  // namespace

FunctionBody function_body(const Function& function, const std::string& name, const HeaderScope& scope) {
  FunctionBody body = BodyWriter(function, name, scope).body();
  if (!body.uses_limbs || !body.is_too_long) return body;
  HeaderScope apart = scope;
  apart.limbs.clear();
  return BodyWriter(function, name, apart).body();
}

}  // namespace flatdyn
