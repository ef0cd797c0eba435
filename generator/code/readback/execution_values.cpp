// SPDX-License-Identifier: GPL-2.0-or-later
// Expressions and limbs, executed: each expression becomes operations, in its order.
#include <algorithm>

#include "code/readback/execution.hpp"

namespace flatdyn {
namespace {

constexpr int kMostLanes = 8;

}  // namespace

bool Execution::is_input(const std::string& array) const {
  const auto& parameters = written_.parameters;
  return find_argument(array) != nullptr && std::any_of(parameters.begin(), parameters.end(), [&](const auto& each) {
           return each.name == array && !each.is_output;
         });
}

int Execution::value(const code::Expression& expression) {
  return std::visit([this](const auto& form) { return value_of(form); },
                    static_cast<const code::AnyExpression&>(expression));
}

int Execution::value_of(const code::Literal& literal) { return lines_.constant(literal.value.truncated()); }

// A variable, in lanes the number of this lane, or a value that a stage has stored.
int Execution::value_of(const code::Variable& variable) {
  const auto limbs = limbs_.find(variable.name);
  if (limbs != limbs_.end() && !is_in_part()) {
    if (lane_ == kNoLane || static_cast<int>(limbs->second.size()) != lanes_) fail("another number of limbs");
    ++limbs_named_;
    return limbs->second[static_cast<std::size_t>(lane_)];
  }
  const auto known = frame_.variables.find(variable.name);
  if (known != frame_.variables.end()) return known->second;
  if (is_in_part()) fail("an unknown name");
  return lines_.input({InputKind::stored, field(written_.member_of, variable.name)});
}

int Execution::value_of(const code::Element& element) {
  const auto& [name, entry] = element;
  const auto limbs = limbs_.find(name);
  if (limbs != limbs_.end() && !is_in_part()) {
    if (lane_ != kNoLane || entry >= static_cast<int>(limbs->second.size())) fail("no such limb");
    return limbs->second[static_cast<std::size_t>(entry)];
  }
  if (!is_visible(name)) fail("no array " + name);
  if (is_output(name)) fail("an output that is read");
  if (name == "sine" || name == "cosine") angles_read_.insert(entry);
  if (!is_input(name)) return written_entry(name, entry);
  const InputKind kind = find_argument(name)->kind;
  const int length = length_of(kind);
  if (length >= 0 && entry >= length) fail("an entry too many");
  return input({kind, entry});
}

int Execution::value_of(const code::Number& number) {
  if (!is_visible(number.name)) fail("no number " + number.name);
  return written_entry(number.name, 0);
}

int Execution::value_of(const code::Parameter& parameter) {
  if (!is_visible("parameters")) fail("no such struct");
  return input({InputKind::parameter, field("Parameters", parameter.name)});
}

int Execution::value_of(const code::Field& stored) {
  if (!is_visible(stored.structure) || stored.structure != "stored") fail("no such struct");
  return lines_.input({InputKind::stored, field(written_.member_of, stored.name)});
}

// An entry of an output that an earlier part of the function has written, and this one does not. Its index is that
// among all entries of the outputs.
int Execution::value_of(const code::WrittenEntry& read) {
  int before = 0;
  for (const std::string& output : outputs_) {
    const Array& array = arrays_.at(output);
    if (output == read.output) {
      if (!is_visible(output) || read.index >= array.length) fail("no such entry");
      if (array.entries.count(read.index) != 0) fail("an entry that is written already");
      return lines_.input({InputKind::stored, before + read.index});
    }
    before += array.length;
  }
  fail("no output " + read.output);
}

int Execution::value_of(const code::Sum& sum) {
  const code::Addend& first = sum.addends.front();
  int result = value(first.value);
  if (first.is_negative) result = lines_.negate(result);
  for (std::size_t k = 1; k < sum.addends.size(); ++k) {
    const int next = value(sum.addends[k].value);
    result = sum.addends[k].is_negative ? lines_.subtract(result, next) : lines_.add(result, next);
  }
  return result;
}

int Execution::value_of(const code::Product& product) {
  int result = value(product.operands.front());
  for (std::size_t k = 1; k < product.operands.size(); ++k) {
    result = lines_.multiply(result, value(product.operands[k]));
  }
  return result;
}

int Execution::value_of(const code::Quotient& quotient) {
  const int dividend = value(quotient.operands[0]);
  return lines_.divide(dividend, value(quotient.operands[1]));
}

int Execution::value_of(const code::Negation& negation) { return lines_.negate(value(negation.operands[0])); }

int Execution::value_of(const code::Call& call) {
  switch (call.operation) {
    case code::Operation::sign:
      return lines_.sign(scalar(call.operands[0]));
    case code::Operation::sqrt:
      return lines_.sqrt(scalar(call.operands[0]));
    case code::Operation::sine:
    case code::Operation::cosine: {
      const int operation = value(call.operands[0]);
      const int angle = angle_at(operation), joint = angle < 0 ? lines_[operation].input.index : 0;
      return call.operation == code::Operation::sine ? lines_.sine(joint, angle) : lines_.cosine(joint, angle);
    }
    case code::Operation::multiply_add: {
      if (lane_ != kNoLane) fail("a fused operation of limbs");
      const int a = value(call.operands[0]), b = value(call.operands[1]);
      return lines_.fused(a, b, value(call.operands[2]));
    }
    case code::Operation::excess:
      break;
  }
  const int sum = value(call.operands[0]);
  return lines_.subtract(sum, value(call.operands[1]));
}

// The argument of a function of scalars.
int Execution::scalar(const code::Expression& expression) {
  const int named_before = limbs_named_;
  const int result = value(expression);
  if (limbs_named_ != named_before) fail("a function of limbs");
  return result;
}

// All inputs are read before an output is written, because they may share memory.
int Execution::input(Input input) {
  if (has_written_) fail("read after an output is written");
  return lines_.input(input);
}

int Execution::written_entry(const std::string& name, int entry) const {
  const auto array = arrays_.find(name);
  if (array == arrays_.end() || array->second.entries.count(entry) == 0) fail("read before it is written");
  return array->second.entries.at(entry);
}

void Execution::execute(const code::UseLanes& use) {
  if (is_in_part()) fail("an unknown statement");
  const bool is_power = use.lanes >= 2 && use.lanes <= kMostLanes && (use.lanes & (use.lanes - 1)) == 0;
  if (!is_power) fail("an unknown type");
  if (!types_of_limbs_.insert(use.lanes).second) fail("a type made twice");
}

void Execution::execute(const code::Gather& gather) {
  refuse_known(gather.name);
  const bool is_known = types_of_limbs_.count(gather.lanes) != 0 && !is_in_part();
  if (!is_known || static_cast<int>(gather.numbers.size()) != gather.lanes) fail("another number of limbs");
  std::vector<int> values;
  for (const code::Expression& each : gather.numbers) values.push_back(value(each));
  limbs_.emplace(gather.name, std::move(values));
}

// The same expression for one lane after the other. Scalars are the same in all lanes.
void Execution::execute(const code::DefineLanes& define) {
  refuse_known(define.name);
  if (types_of_limbs_.count(define.lanes) == 0 || is_in_part()) fail("an unknown type");
  std::vector<int> values;
  const int named_before = limbs_named_;
  lanes_ = define.lanes;
  for (lane_ = 0; lane_ < define.lanes; ++lane_) values.push_back(value(define.value));
  lane_ = kNoLane;
  if (limbs_named_ == named_before) fail("a scalar where limbs are expected");
  limbs_.emplace(define.name, std::move(values));
}

}  // namespace flatdyn
