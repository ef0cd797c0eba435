// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/lower/body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>

#include "code/lower/angles.hpp"
#include "code/lower/arguments.hpp"
#include "code/lower/checks.hpp"
#include "code/lower/expressions.hpp"
#include "code/lower/kernel_parts.hpp"
#include "code/lower/limb_statements.hpp"
#include "code/lower/names.hpp"
#include "code/lower/parts.hpp"
#include "code/lower/schedule.hpp"
#include "code/lower/sine_rounds.hpp"
#include "code/lower/zeros.hpp"
#include "code/walk.hpp"
#include "graph/passes/fuse_products.hpp"

namespace flatdyn {
namespace {

constexpr int kLongPart = 1000;  // lines of a part, unless fewer are asked for

// Parts have no limbs in lanes, which save more than parts do: a function may be this many times as long for them.
constexpr int kLongerWithLimbs = 4;

// Names that parts share in addition to a function's own arguments and kKept.
constexpr const char *kPivots = "pivots", *kStored = "stored", *kResult = "result";

using Role = code::Argument::Role;

void append(code::Statements& statements, code::Statements more) {
  statements.insert(statements.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

// The inputs that are read from arguments; values stored by an earlier stage are not.
std::vector<Input> arguments_read(const Function& function) {
  std::vector<Input> inputs = inputs_read(function);
  std::erase_if(inputs, [](const Input& input) { return input.kind == InputKind::stored; });
  return inputs;
}

NameTable names_in_scope(const Function& function, const Scope& scope, const SineRounds& rounds) {
  std::set<std::string> taken = scope.names;
  taken.insert(scope.stored.begin(), scope.stored.end());
  for (InputKind kind : function.inputs) taken.insert(input_argument(kind, 0).name);
  taken.insert({code::kParameters, "sin_cos", kSines, kCosines, angle_array(scope)});
  if (!function.validity_conditions.empty()) taken.insert({code::kValid, code::kCounter});
  taken.insert({kKept, kPivots, kStored, kResult});
  for (std::string& name : rounds.names()) taken.insert(std::move(name));
  return NameTable(taken);
}

std::vector<bool> fused_products(const Function& function, const Scope& scope) {
  return scope.fuses ? products_to_fuse(function) : std::vector<bool>(static_cast<std::size_t>(function.graph.size()));
}

class BodyMaker {
 public:
  BodyMaker(const Function& function, const std::string& name, const Scope& scope)
      : function_(function),
        name_(name),
        scope_(scope),
        lines_around_(scope.language.lines_around_body +
                      scope.language.lines_per_argument *
                          static_cast<int>(function.inputs.size() + function.outputs.size())),
        inputs_(arguments_read(function)),
        is_fused_(fused_products(function, scope)),
        schedule_(make_schedule(function, is_fused_, scope.language.lives)),
        rounds_(function.graph, schedule_),
        limb_plan_(rounds_.count() == 0 ? limb_plan(function, scope.limbs, schedule_) : std::nullopt),
        expressions_(function.graph, variables_, scope.fuses ? is_fused_ : std::vector<bool>(), &read_in_place_) {
    NameTable names = names_in_scope(function, scope, rounds_);
    for (const Output& output : function_.outputs) output_names_.push_back(names.unique(output.name));
    variables_ = name_variables(function_, schedule_, scope_.parameters, scope_.stored, names);
    find_entries_read();
    for (const Statement& statement : schedule_.statements) {
      if (is_angle_function(statement)) angles_.insert(angle_index(function_.graph, statement.node, scope_));
    }
    if (!limb_plan_) return;
    limbs_.emplace(
        function_, *limb_plan_, scope.limbs, [this](NodeId id) { return given(id); }, names, variables_);
  }

  FunctionBody whole_body() const {
    FunctionBody body;
    body.inputs = inputs_;
    body.output_names = output_names_;
    body.uses_positions = std::any_of(inputs_.begin(), inputs_.end(), [this](const Input& input) {
      return input.kind == InputKind::q && is_used_by_itself(find_input(input));
    });
    body.angles.assign(angles_.begin(), angles_.end());
    body.takes_sines = has_angle_function(Op::sin);
    body.takes_cosines = has_angle_function(Op::cos);
    body.statements = whole();
    body.uses_sign = code::uses(body.statements, code::Operation::sign);
    body.uses_sqrt = code::uses(body.statements, code::Operation::sqrt);
    body.uses_excess = code::uses(body.statements, code::Operation::excess);
    body.uses_fma = code::uses(body.statements, code::Operation::multiply_add);
    body.uses_limbs = limbs_.has_value();
    body.uses_zeros = code::stores_zeros(body.statements);
    const int longest = scope_.language.longest_function * (limbs_ ? kLongerWithLimbs : 1);
    body.most_lines = (scope_.most_lines > 0 ? scope_.most_lines : longest) - lines_around_;
    return body;
  }

  // Writes the same statements as several functions. The first ones read all inputs.
  void divide(FunctionBody& body, const TextLength& length) const {
    const std::string name = scope_.enclosing_stage.empty() ? name_ : scope_.enclosing_stage + "_" + name_;
    LongBody long_body{name, input_steps(), sources(), part_arguments(), scope_.most_lines, length};
    if (long_body.most_lines == 0) long_body.most_lines = kLongPart;
    append(long_body.statements, steps(true));
    append(long_body.statements, pivot_steps());
    body.statements = sines_in_arrays(true);
    append(body.statements, stage());
    code::Statements after = ending_of_parts();
    const int lines = length.lines_of(body.statements) + length.lines_of(after);
    Parts parts = in_parts(long_body, std::max(2, (long_body.most_lines - lines - lines_around_) / 2));
    body.parts = std::move(parts.definitions);
    append(body.statements, shared_by_parts(parts.kept));
    append(body.statements, std::move(parts.calls));
    append(body.statements, std::move(after));
    code::mark_local_arguments(body.statements);
  }

 private:
  code::Statements whole() const {
    code::Statements statements;
    if (limbs_) append(statements, limbs_->types());
    append(statements, loads());
    append(statements, sines_in_arrays(false));
    append(statements, sines_and_cosines());
    append(statements, stage());
    append(statements, limbs_ ? limb_steps() : steps(false));
    append(statements, ending());
    code::mark_local_arguments(statements);
    return statements;
  }

  code::Statements limb_steps() const {
    code::Statements statements = limbs_->given();
    for (const LimbStep& step : limbs_->steps()) append(statements, limb_step(step));
    return statements;
  }

  code::Statements limb_step(const LimbStep& step) const {
    switch (step.kind) {
      case LimbStep::Kind::scalar:
        return {definition(step.index)};
      case LimbStep::Kind::stored:
        return stored_steps(schedule_.statements[static_cast<std::size_t>(step.index)]);
      case LimbStep::Kind::limbs:
        return {limbs_->definition(step.index)};
      case LimbStep::Kind::gathered:
        return {limbs_->gathered(step.index)};
      case LimbStep::Kind::taken:
        break;
    }
    return {limbs_->taken(step.index)};
  }

  // The arrays of sines of computed angles, which parts share.
  code::Declare arrays_of_rounds() const {
    code::Declare all;
    for (std::size_t round = 0; round < rounds_.count() && !scope_.language.evaluates_sines; ++round) {
      for (code::Declare::Array& each : rounds_.arrays(round).arrays) all.arrays.push_back(std::move(each));
    }
    return all;
  }

  code::Statements shared_by_parts(int kept) const {
    code::Declare shared = arrays_of_rounds();
    if (kept > 0) shared.arrays.push_back({kKept, static_cast<std::size_t>(kept)});
    if (const std::size_t pivots = pivots_to_check(function_).size(); pivots > 0) {
      shared.arrays.push_back({kPivots, pivots});
    }
    if (returns_value(function_)) shared.arrays.push_back({kResult, std::nullopt});
    return shared.arrays.empty() ? code::Statements() : code::Statements{std::move(shared)};
  }

  code::Statements ending_of_parts() const {
    if (returns_value(function_)) return {code::Return{code::Number{kResult}}};
    const std::size_t pivots = pivots_to_check(function_).size();
    return pivots == 0 ? ending() : checks_of_parts(function_, output_names_, kPivots, pivots);
  }

  code::Statements input_steps() const {
    code::Statements steps;
    for (const Input& input : inputs_) {
      const NodeId id = find_input(input);
      if (is_used_by_itself(id)) steps.emplace_back(code::Define{{{variable(id), read(input)}}});
    }
    return steps;
  }

  code::Statements pivot_steps() const {
    code::Statements steps;
    for (const CheckedPivot& pivot : pivots_to_check(function_)) {
      steps.emplace_back(
          code::Store{{code::Element{kPivots, static_cast<int>(steps.size())}}, checked(pivot, expressions_)});
    }
    return steps;
  }

  // The values that every part can read for itself.
  std::map<std::string, code::Expression> sources() const {
    std::map<std::string, code::Expression> sources;
    for (const Statement& statement : schedule_.statements) {
      if (is_angle_function(statement)) sources.emplace(variable(statement.node), entry_of_sines(statement.node));
    }
    for (NodeId id = 0; id < function_.graph.size(); ++id) {
      const Node& node = function_.graph[id];
      if (node.op != Op::input || node.input.kind != InputKind::stored || variable(id).empty()) continue;
      sources.emplace(variable(id), code::Field{kStored, variable(id)});
    }
    return sources;
  }

  std::vector<code::Argument> part_arguments() const {
    std::vector<code::Argument> list = {{Role::parameters, code::kParameters}};
    if (const std::string& stage = scope_.enclosing_stage; !stage.empty()) {
      list.push_back({Role::stage, kStored, 0, stage});
    }
    for (InputKind kind : function_.inputs) {
      const InputArgument input = input_argument(kind, scope_.counts, function_);
      list.push_back({Role::input, input.name, static_cast<std::size_t>(input.length)});
    }
    for (const char* name : {kSines, kCosines}) list.push_back({Role::input, name, scope_.angle_count()});
    for (const code::Declare::Array& each : arrays_of_rounds().arrays) {
      list.push_back({Role::output, each.name, *each.length});
    }
    list.push_back({Role::output, kKept});  // its length is known when all parts are
    list.push_back({Role::output, kPivots, pivots_to_check(function_).size()});
    list.push_back({Role::number, kResult, 1});
    for (std::size_t k = 0; k < output_names_.size(); ++k) {
      const std::string& name = output_names_[k];
      list.push_back(makes_stage() ? code::Argument{Role::made_stage, name, 0, scope_.made}
                                   : code::Argument{Role::output, name, function_.outputs[k].entries.size()});
    }
    return list;
  }

  // Stored values that are no variables are entries of the outputs, over all of which their indices count.
  void find_entries_read() {
    if (!scope_.language.reads_parts) return;
    for (NodeId id = 0; id < function_.graph.size(); ++id) {
      const Node& node = function_.graph[id];
      if (node.op != Op::input || node.input.kind != InputKind::stored) continue;
      const Target read = entry_read(function_, node.input.index);
      const std::string& output = output_names_.at(static_cast<std::size_t>(read.output));
      read_in_place_.emplace(id, code::WrittenEntry{output, read.entry});
    }
  }

  bool makes_stage() const { return !scope_.made.empty(); }

  bool has_angle_function(Op op) const {
    return std::any_of(schedule_.statements.begin(), schedule_.statements.end(), [&](const Statement& statement) {
      return is_angle_function(statement) && function_.graph[statement.node].op == op;
    });
  }

  // Whether the statement makes a variable of a sine or a cosine of an angle that is given.
  bool is_angle_function(const Statement& statement) const {
    const Op op = function_.graph[statement.node].op;
    return statement.targets.empty() && (op == Op::sin || op == Op::cos) && !is_of_computed_angle(statement);
  }

  // The same of an angle that is computed.
  bool is_of_computed_angle(const Statement& statement) const {
    return statement.targets.empty() && flatdyn::is_of_computed_angle(function_.graph, statement.node);
  }

  bool is_variable(NodeId id) const { return schedule_.is_variable[static_cast<std::size_t>(id)]; }

  const std::string& variable(NodeId id) const { return variables_[static_cast<std::size_t>(id)]; }

  // An input as it is read: qd[1], parameters.m1.
  code::Expression read(const Input& input) const {
    if (input.kind == InputKind::parameter) return code::Parameter{variable_of_input(input, scope_.parameters)};
    return code::Element{input_argument(input.kind, 0).name, input.index};
  }

  // Reads all inputs before any output is written, so that outputs may overlap inputs and no value is read twice.
  code::Statements loads() const {
    code::Statements statements;
    code::Define of_kind;
    for (std::size_t k = 0; k < inputs_.size(); ++k) {
      const NodeId input = find_input(inputs_[k]);
      if (limbs_ ? limbs_->reads(input) : is_used_by_itself(input)) {
        of_kind.constants.push_back({variable(input), read(inputs_[k])});
      }
      const bool last_of_kind = k + 1 == inputs_.size() || inputs_[k + 1].kind != inputs_[k].kind;
      if (!last_of_kind || of_kind.constants.empty()) continue;
      statements.emplace_back(std::move(of_kind));
      of_kind = {};
    }
    return statements;
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
  code::Statements sines_in_arrays(bool of_parts) const {
    if (angles_.empty()) return {};
    if (scope_.language.fills_sines) return filling_sines(angles_, kFunctionOfAngles, scope_);
    if (!scope_.language.evaluates_sines || !of_parts) return {};
    const std::size_t count = scope_.angle_count();
    code::Statements statements = {code::Declare{{{kSines, count}, {kCosines, count}}}};
    for (const Statement& statement : schedule_.statements) {
      if (!is_angle_function(statement)) continue;
      statements.emplace_back(code::Store{{entry_of_sines(statement.node)}, angle_function(statement.node)});
    }
    return statements;
  }

  code::Statements sines_and_cosines() const {
    code::Define all;
    for (const Statement& statement : schedule_.statements) {
      if (!is_angle_function(statement) || (limbs_ && !limbs_->reads(statement.node))) continue;
      all.constants.push_back({variable(statement.node), angle_function(statement.node)});
    }
    return all.constants.empty() ? code::Statements() : code::Statements{std::move(all)};
  }

  bool is_sine(NodeId id) const { return function_.graph[id].op == Op::sin; }

  // A sine or cosine: sine[2], sin(q[2]).
  code::Expression angle_function(NodeId id) const {
    if (!scope_.language.evaluates_sines) return entry_of_sines(id);
    const int index = angle_index(function_.graph, id, scope_);
    return code::Call{is_sine(id) ? code::Operation::sine : code::Operation::cosine, {angle_of_index(index, scope_)}};
  }

  code::Element entry_of_sines(NodeId id) const {
    return {is_sine(id) ? kSines : kCosines, angle_index(function_.graph, id, scope_)};
  }

  // An input, a sine or a cosine that is read.
  code::Expression given(NodeId id) const {
    const Node& node = function_.graph[id];
    return node.op == Op::input ? read(node.input) : entry_of_sines(id);
  }

  NodeId find_input(const Input& input) const {
    for (NodeId id = 0; id < function_.graph.size(); ++id) {
      const Node& node = function_.graph[id];
      if (node.op == Op::input && node.input == input) return id;
    }
    throw std::logic_error("input that is read is not in the graph");
  }

  code::Statements stage() const {
    if (!makes_stage()) return {};
    return {code::DeclareStage{scope_.made, output_names_[0]}};
  }

  // The steps without sines and cosines of given angles.
  code::Statements steps(bool of_parts) const {
    code::Statements steps;
    std::size_t rounds = 0;
    for (const Statement& statement : schedule_.statements) {
      if (is_angle_function(statement)) continue;
      if (is_of_computed_angle(statement)) {
        if (rounds_.round_of(statement.node) == rounds) append(steps, round_steps(rounds++, of_parts));
        continue;
      }
      append(steps, statement.targets.empty() ? code::Statements{definition(statement.node)}
                                              : stored_steps(statement, of_parts));
    }
    return steps;
  }

  // A round of sines and cosines: one by one, or all together in arrays, which parts share.
  code::Statements round_steps(std::size_t round, bool of_parts) const {
    code::Statements steps;
    if (scope_.language.evaluates_sines) {
      for (const NodeId id : rounds_.sines(round)) {
        const code::Operation operation = is_sine(id) ? code::Operation::sine : code::Operation::cosine;
        const code::Call value{operation, {expressions_.use(function_.graph[id].operands[0])}};
        steps.emplace_back(code::Define{{{variable(id), value}}});
      }
      return steps;
    }
    if (!of_parts) steps.emplace_back(rounds_.arrays(round));
    append(steps, rounds_.filling(round, expressions_));
    code::Define values;
    for (const NodeId id : rounds_.sines(round)) {
      code::Define::Constant value{variable(id), rounds_.entry(id)};
      if (of_parts) {
        steps.emplace_back(code::Define{{std::move(value)}});
      } else {
        values.constants.push_back(std::move(value));
      }
    }
    if (!of_parts) steps.emplace_back(std::move(values));
    return steps;
  }

  code::Statement definition(NodeId id) const { return code::Define{{{variable(id), expressions_.definition(id)}}}; }

  // An entry is stored, or the function's value is returned; parts store that, too.
  code::Statements stored_steps(const Statement& statement, bool of_parts = false) const {
    code::Expression value = limbs_ ? limbs_->stored(statement.node) : expressions_.use(statement.node);
    if (returns_value(function_)) {
      if (of_parts) return {code::Store{{code::Number{kResult}}, std::move(value)}};
      return {code::Return{std::move(value)}};
    }
    code::Store store{{}, std::move(value)};
    for (const Target& target : statement.targets) store.places.push_back(place_of(target));
    const bool is_divided = scope_.language.stores_zeros_together && function_.graph.is_zero(statement.node);
    return is_divided ? zeros_together(std::move(store)) : code::Statements{std::move(store)};
  }

  // The place of a target: B[1], or stage.x1.
  code::Place place_of(const Target& target) const {
    const std::string& output = output_names_[static_cast<std::size_t>(target.output)];
    if (!makes_stage()) return code::Element{output, target.entry};
    return code::Field{output, scope_.fields.at(static_cast<std::size_t>(target.entry))};
  }

  // The return of a stage, or the checks of validity and their verdict.
  code::Statements ending() const {
    if (makes_stage()) return {code::Return{code::Variable{output_names_[0]}}};
    if (function_.validity_conditions.empty()) return {};
    return checks_of(function_, output_names_, expressions_);
  }

  const Function& function_;
  const std::string& name_;
  const Scope& scope_;
  int lines_around_;
  std::vector<Input> inputs_;
  std::vector<bool> is_fused_;  // by node
  Schedule schedule_;
  SineRounds rounds_;
  std::optional<LimbPlan> limb_plan_;
  std::vector<std::string> output_names_;
  VariableNames variables_;
  ReadInPlace read_in_place_;
  NodeExpressions expressions_;
  std::optional<LimbStatements> limbs_;  // if limbs are computed together
  std::set<int> angles_;                 // indices of the angles whose sines or cosines are used
};

}  // namespace

FunctionBody function_body(const Function& function, const std::string& name, const Scope& scope) {
  return BodyMaker(function, name, scope).whole_body();
}

FunctionBody divided_body(const Function& function, const std::string& name, const Scope& scope,
                          const TextLength& length) {
  Scope apart = scope;
  apart.limbs.clear();
  const BodyMaker maker(function, name, apart);
  FunctionBody body = maker.whole_body();
  if (length.lines_of(body.statements) > body.most_lines) maker.divide(body, length);
  return body;
}

}  // namespace flatdyn
