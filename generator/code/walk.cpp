// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/walk.hpp"

#include <algorithm>
#include <set>

namespace flatdyn::code {
namespace {

// Calls use(part) for the operands of an expression, in order.
template <class Use>
void for_each_operand(const Expression& expression, const Use& use) {
  std::visit(
      [&use](const auto& form) {
        if constexpr (requires { form.addends; }) {
          for (const Addend& each : form.addends) use(each.value);
        } else if constexpr (requires { form.operands; }) {
          for (const Expression& each : form.operands) use(each);
        }
      },
      static_cast<const AnyExpression&>(expression));
}

// Calls use(expression) for those that stand in a statement, in order.
template <class Use>
void for_each_expression(const Statement& statement, const Use& use) {
  if (const auto* define = std::get_if<Define>(&statement)) {
    for (const Define::Constant& each : define->constants) use(each.value);
  } else if (const auto* store = std::get_if<Store>(&statement)) {
    use(store->value);
  } else if (const auto* check = std::get_if<Check>(&statement)) {
    if (const auto* positive = std::get_if<Positive>(&check->condition)) use(positive->value);
  } else if (const auto* result = std::get_if<Return>(&statement)) {
    if (result->value) use(*result->value);
  } else if (const auto* vector = std::get_if<Gather>(&statement)) {
    for (const Expression& each : vector->numbers) use(each);
  } else if (const auto* lanes = std::get_if<DefineLanes>(&statement)) {
    use(lanes->value);
  }
}

bool uses_operation(const Expression& expression, Operation operation) {
  const auto* call = std::get_if<Call>(&expression);
  bool found = call != nullptr && call->operation == operation;
  for_each_operand(expression, [&](const Expression& each) { found = found || uses_operation(each, operation); });
  return found;
}

void add_names(const Expression& expression, Names& names) {
  if (const auto* variable = std::get_if<Variable>(&expression)) names.variables.push_back(variable->name);
  if (const auto* element = std::get_if<Element>(&expression)) names.others.push_back(element->array);
  if (const auto* number = std::get_if<Number>(&expression)) names.others.push_back(number->name);
  if (const auto* field = std::get_if<Field>(&expression)) names.others.push_back(field->structure);
  if (const auto* entry = std::get_if<WrittenEntry>(&expression)) names.others.push_back(entry->output);
  if (std::holds_alternative<Parameter>(expression)) names.others.emplace_back(kParameters);
  for_each_operand(expression, [&names](const Expression& each) { add_names(each, names); });
}

}  // namespace

bool uses(const Statements& statements, Operation operation) {
  return std::any_of(statements.begin(), statements.end(), [operation](const Statement& statement) {
    bool found = false;
    for_each_expression(statement, [&](const Expression& each) { found = found || uses_operation(each, operation); });
    return found;
  });
}

Names names_in(const Statement& statement) {
  Names names;
  for_each_expression(statement, [&names](const Expression& each) { add_names(each, names); });
  if (const auto* store = std::get_if<Store>(&statement)) {
    for (const auto& place : store->places) {
      std::visit([&names](const auto& each) { add_names(each, names); }, place);
    }
  }
  if (const auto* zeros = std::get_if<StoreZeros>(&statement)) names.others.push_back(zeros->array);
  if (const auto* fill = std::get_if<FillSines>(&statement)) {
    names.others.insert(names.others.end(), {fill->array, fill->sines, fill->cosines});
  }
  return names;
}

bool stores_zeros(const Statements& statements) {
  return std::any_of(statements.begin(), statements.end(),
                     [](const Statement& each) { return std::holds_alternative<StoreZeros>(each); });
}

void mark_local_arguments(Statements& statements) {
  std::set<std::string> arrays;
  for (Statement& statement : statements) {
    if (const auto* declare = std::get_if<Declare>(&statement)) {
      for (const Declare::Array& each : declare->arrays) arrays.insert(each.name);
    } else if (auto* call = std::get_if<CallPart>(&statement)) {
      for (Argument& each : call->arguments) each.is_local = arrays.count(each.name) != 0;
    }
  }
}

}  // namespace flatdyn::code
