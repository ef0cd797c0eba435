// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/emit/printer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "code/emit/writer.hpp"
#include "code/walk.hpp"

namespace flatdyn {
namespace {

int count_lines(const std::string& text) { return static_cast<int>(std::count(text.begin(), text.end(), '\n')); }

std::string lanes_type(int lanes) { return fmt::format("{}{}", kLimbs, lanes); }

std::string entry_text(const std::string& array, int index) {
  return fmt::format("{}[{}]", array, index == code::kCounted ? code::kCounter : std::to_string(index));
}

std::string field_text(const code::Field& field) { return field.structure + "." + field.name; }

}  // namespace

std::string Printer::operand(const code::Expression& expression, Binding at_least) const {
  const Bound operand = bound(expression);
  return operand.binding < at_least ? "(" + operand.text + ")" : operand.text;
}

Printer::Bound Printer::bound(const code::Expression& expression) const {
  struct Visitor {
    const Printer& printer;

    Bound operator()(const code::Literal& literal) const {
      const bool has_minus = literal.value < 0 && !printer.dialect_.encloses_literals();
      return {printer.dialect_.literal(literal.value), has_minus ? Binding::sum : Binding::atom};
    }
    Bound operator()(const code::Variable& variable) const { return {variable.name}; }
    Bound operator()(const code::Element& element) const { return {entry_text(element.array, element.index)}; }
    Bound operator()(const code::Number& number) const { return {printer.dialect_.number_use(number.name)}; }
    Bound operator()(const code::Parameter& parameter) const { return {printer.dialect_.parameter(parameter.name)}; }
    Bound operator()(const code::Field& field) const { return {field_text(field)}; }
    Bound operator()(const code::WrittenEntry& entry) const {
      return {printer.dialect_.written_entry(entry.output, entry.index)};
    }
    Bound operator()(const code::Sum& sum) const { return printer.sum(sum); }
    Bound operator()(const code::Product& product) const { return printer.product(product); }
    Bound operator()(const code::Quotient& quotient) const {
      return {printer.operand(quotient.operands[0], Binding::product) + " / " +
                  printer.operand(quotient.operands[1], Binding::atom),
              Binding::quotient};
    }
    Bound operator()(const code::Negation& negation) const {
      return {"-" + printer.operand(negation.operands[0], Binding::product), Binding::sum};
    }
    Bound operator()(const code::Call& call) const { return {printer.call(call)}; }
  };
  return std::visit(Visitor{*this}, static_cast<const code::AnyExpression&>(expression));
}

// A negative literal in front needs no parentheses, and binds the whole like a sum.
Printer::Bound Printer::product(const code::Product& product) const {
  const Bound first = bound(product.operands[0]);
  const bool has_minus = std::holds_alternative<code::Literal>(product.operands[0]) && first.binding == Binding::sum;
  std::string text = has_minus ? first.text : operand(product.operands[0], Binding::product);
  for (std::size_t k = 1; k < product.operands.size(); ++k) {
    text += " * " + operand(product.operands[k], Binding::product);
  }
  return {std::move(text), has_minus ? Binding::sum : Binding::product};
}

// In front, a product or a literal may have a minus of its own.
Printer::Bound Printer::sum(const code::Sum& sum) const {
  const auto& [is_negative, first] = sum.addends[0];
  const bool may_be_negative =
      std::holds_alternative<code::Product>(first) || std::holds_alternative<code::Literal>(first);
  std::string text = is_negative ? "-" : "";
  text += may_be_negative && !is_negative ? bound(first).text : operand(first, Binding::quotient);
  for (std::size_t k = 1; k < sum.addends.size(); ++k) {
    const code::Addend& each = sum.addends[k];
    text += (each.is_negative ? " - " : " + ") + operand(each.value, Binding::quotient);
  }
  return {std::move(text), Binding::sum};
}

std::string Printer::call(const code::Call& call) const {
  const auto argument = [&](std::size_t k) { return text(call.operands[k]); };
  switch (call.operation) {
    case code::Operation::sign:
      return dialect_.sign(argument(0));
    case code::Operation::sqrt:
      return dialect_.sqrt(argument(0));
    case code::Operation::sine:
    case code::Operation::cosine:
      return dialect_.angle_function(call.operation == code::Operation::sine ? "sin" : "cos", argument(0));
    case code::Operation::multiply_add:
      return dialect_.fused(argument(0), argument(1), argument(2));
    case code::Operation::excess:
      break;
  }
  if (const std::optional<std::string> excess = dialect_.excess(argument(0), argument(1))) return *excess;
  code::Sum difference = std::get<code::Sum>(call.operands[0]);
  code::Addend term = code::without_sign(call.operands[1]);
  term.is_negative = !term.is_negative;
  difference.addends.push_back(std::move(term));
  return text(difference);
}

std::string Printer::text(const code::Statements& statements) const {
  std::string lines;
  if (code::uses(statements, code::Operation::multiply_add)) lines += dialect_.fused_begin();
  for (const code::Statement& each : statements) {
    lines += std::visit([this](const auto& statement) { return line(statement); }, each);
  }
  return lines;
}

std::string Printer::text(const code::Part& part) const {
  std::vector<std::string> arguments;
  for (const code::Argument& each : part.arguments) arguments.push_back(declared(each));
  return list_line(dialect_.part_begin(part.name), arguments, dialect_.function_end(), 0) + text(part.statements) +
         "}\n";
}

int Printer::lines_of(const code::Statement& statement) const {
  return count_lines(std::visit([this](const auto& each) { return line(each); }, statement));
}

int Printer::lines_of(const code::Statements& statements) const { return count_lines(text(statements)); }

int Printer::lines_of(const code::Part& part) const { return count_lines(text(part)); }

std::string Printer::declared(const code::Argument& argument) const {
  using Role = code::Argument::Role;
  switch (argument.role) {
    case Role::parameters:
      return dialect_.parameters_argument();
    case Role::stage:
      return fmt::format("const {}& {}", dialect_.stage_type(argument.stage), argument.name);
    case Role::input:
      return dialect_.input(argument.name, argument.length);
    case Role::output:
      return dialect_.output(argument.name, argument.length);
    case Role::number:
      return dialect_.number_output(argument.name);
    case Role::made_stage:
      break;
  }
  return dialect_.stage_type(argument.stage) + "& " + argument.name;
}

std::string Printer::line(const code::Define& define) const {
  if (define.constants.size() == 1) {
    const code::Define::Constant& only = define.constants[0];
    return code_line(fmt::format("{}{} = {};", dialect_.constant(), only.name, text(only.value)), dialect_.indent());
  }
  std::vector<std::string> items;
  for (const code::Define::Constant& each : define.constants) items.push_back(each.name + " = " + text(each.value));
  return dialect_.declarations(dialect_.constant(), items);
}

std::string Printer::line(const code::Declare& declare) const {
  std::vector<std::string> items;
  for (const code::Declare::Array& each : declare.arrays) {
    if (!each.length) {
      items.push_back(dialect_.number_definition(each.name));
      continue;
    }
    const std::string digits = std::to_string(*each.length);
    items.push_back(dialect_.array(each.name, each.count.empty() ? digits : dialect_.count_name(each.count)));
  }
  return dialect_.declarations(dialect_.arrays(), items);
}

std::string Printer::line(const code::DeclareStage& stage) const {
  return code_line(fmt::format("{} {};", dialect_.stage_type(stage.type), stage.name), dialect_.indent());
}

std::string Printer::place(const code::Place& place) const {
  if (const auto* element = std::get_if<code::Element>(&place)) return entry_text(element->array, element->index);
  if (const auto* field = std::get_if<code::Field>(&place)) return field_text(*field);
  return dialect_.number_use(std::get<code::Number>(place).name);
}

// "B[1] = B[7] = b_12;", constants in lines of some places each.
std::string Printer::line(const code::Store& store) const {
  constexpr std::size_t kMostPlaces = 8;
  const bool is_constant = std::holds_alternative<code::Literal>(store.value);
  const std::string value = text(store.value);
  std::string lines;
  std::vector<std::string> places;
  for (std::size_t k = 0; k < store.places.size(); ++k) {
    places.push_back(place(store.places[k]));
    const bool is_full = is_constant && (k + 1) % kMostPlaces == 0;
    if (k + 1 < store.places.size() && !is_full) continue;
    lines += code_line(dialect_.stored(places, value), dialect_.indent());
    places.clear();
  }
  return lines;
}

std::string Printer::line(const code::StoreZeros& zeros) const {
  return code_line(dialect_.stored_zeros(zeros.array, zeros.first, zeros.end), dialect_.indent());
}

std::string Printer::line(const code::FillSines& fill) const { return dialect_.filled_sines(fill); }

// & does not branch.
std::string Printer::condition(const code::Condition& condition) const {
  if (const auto* positive = std::get_if<code::Positive>(&condition)) {
    return fmt::format("{} > {}", text(positive->value), dialect_.literal(0));
  }
  if (const auto* finite = std::get_if<code::Finite>(&condition)) {
    return dialect_.finite(entry_text(finite->entry.array, finite->entry.index));
  }
  return dialect_.always();
}

std::string Printer::line(const code::Check& check) const {
  const std::string begin = check.is_first ? dialect_.conditions_begin() : dialect_.conditions_continue();
  return code_line(begin + condition(check.condition) + ";", dialect_.indent());
}

std::string Printer::line(const code::CheckFinite& check) const {
  return dialect_.check_finite(check.array, check.first, check.end);
}

std::string Printer::line(const code::CheckPositive& check) const {
  return dialect_.check_positive(check.array, check.length);
}

std::string Printer::line(const code::CallPart& call) const {
  std::vector<std::string> passed;
  for (const code::Argument& each : call.arguments) {
    const bool is_own = each.role == code::Argument::Role::stage && !call.by_part;
    passed.push_back(is_own ? dialect_.own_stage() : dialect_.passed(each));
  }
  const std::string begin = call.by_part ? call.name + "(" : dialect_.part_call(call.name);
  return list_line(dialect_.call_begin(call.is_returned) + begin, passed, dialect_.call_end(call.is_returned),
                   dialect_.indent());
}

std::string Printer::line(const code::Return& give_back) const {
  return code_line(dialect_.returned(give_back.value ? text(*give_back.value) : code::kValid), dialect_.indent());
}

std::string Printer::line(const code::Ignore& ignore) const {
  return code_line(dialect_.ignored(ignore.name), dialect_.indent());
}

std::string Printer::line(const code::UseLanes& use) const {
  return code_line(dialect_.limbs_definition(use.lanes), dialect_.indent());
}

std::string Printer::line(const code::Gather& gather) const {
  std::vector<std::string> items;
  for (const code::Expression& each : gather.numbers) items.push_back(text(each));
  return list_line(fmt::format("const {} {} = {{", lanes_type(gather.lanes), gather.name), items, "};",
                   dialect_.indent());
}

std::string Printer::line(const code::DefineLanes& define) const {
  return code_line(fmt::format("const {} {} = {};", lanes_type(define.lanes), define.name, text(define.value)),
                   dialect_.indent());
}

}  // namespace flatdyn
