// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/readback/execution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "code/readback/language_reader.hpp"

namespace flatdyn {
namespace {

// The arrays that parts share with the function that calls them.
constexpr const char *kKeptArray = "kept", *kPivotsArray = "pivots", *kResultArray = "result";

// Names that a variable would hide.
bool is_taken_by_language(const std::string& name) {
  constexpr auto kNames = std::to_array<const char*>({"Math", "sin", "cos", "Float64Array", "Scalar", "detail", "std"});
  return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

// The number of the round that an array of computed angles, sine_2, belongs to; 0: it is none.
int round_of_sines(const std::string& array) {
  constexpr std::size_t kMostDigits = 4;
  const std::size_t end = array.rfind('_');
  if (end == std::string::npos) return 0;
  const std::string kind = array.substr(0, end), digits = array.substr(end + 1);
  const bool is_kind = kind == code::kAngles || kind == code::kSines || kind == code::kCosines;
  const bool is_number =
      !digits.empty() && digits.size() <= kMostDigits && digits.find_first_not_of("0123456789") == std::string::npos;
  return is_kind && is_number && digits.front() != '0' ? std::stoi(digits) : 0;
}

bool may_follow_checks(const code::Statement& statement) {
  return std::holds_alternative<code::Check>(statement) || std::holds_alternative<code::CheckFinite>(statement) ||
         std::holds_alternative<code::CheckPositive>(statement) || std::holds_alternative<code::Return>(statement);
}

bool is_name(const std::string& text) {
  return !text.empty() && (std::isalpha(static_cast<unsigned char>(text.front())) != 0 || text.front() == '_');
}

}  // namespace

Execution::Execution(const EmittedText& text, const ScannedFunction& written, const Function& like)
    : text_(text), written_(written), like_(like), parser_(text.language().body_parser(text)) {
  for (const ScannedFunction::Parameter& parameter : written.parameters) {
    if (parameter.is_output) outputs_.push_back(parameter.name);
  }
}

StraightLine Execution::run() {
  const bool returns_value = written_.returns == text_.scalar();
  const bool returns_result = !outputs_.empty() || written_.returns == "void" || written_.returns == text_.verdict();
  token_ = written_.begin;
  if (returns_result) {
    if (outputs_.size() != like_.outputs.size()) fail("another number of outputs");
    for (std::size_t k = 0; k < outputs_.size(); ++k) {
      arrays_[outputs_[k]].length = static_cast<int>(like_.outputs[k].entries.size());
    }
  } else {
    if (like_.outputs.size() != 1) fail("another number of outputs");
    if (returns_value) arrays_[kReturned].length = 1;
  }
  carry_out(written_);
  for (const char* array : {kKeptArray, kPivotsArray}) require_full_use(array);
  const bool all_read =
      std::includes(angles_read_.begin(), angles_read_.end(), angles_asked_.begin(), angles_asked_.end());
  if (!all_read) fail("sines and cosines that nothing reads");
  if (!returns_result && returns_value) outputs_ = {kReturned};
  if (outputs_.size() != like_.outputs.size()) fail("another number of outputs");
  for (std::size_t k = 0; k < outputs_.size(); ++k) {
    lines_.outputs.push_back(entries_of(like_.outputs[k], outputs_[k]));
  }
  return std::move(lines_);
}

std::vector<int> Execution::entries_of(const Output& output, const std::string& name) const {
  const std::map<int, int>& written = arrays_.at(name).entries;
  std::vector<int> entries(output.entries.size(), -1);
  for (std::size_t e = 0; e < entries.size(); ++e) {
    const auto found = written.find(static_cast<int>(e));
    const bool is_written = found != written.end();
    if (is_written == output.leaves_out(e)) {
      fail(fmt::format("{}[{}] is {}written", output.name, e, is_written ? "" : "not "));
    }
    if (is_written) entries[e] = found->second;
  }
  return entries;
}

void Execution::fail(const std::string& what) const { text_.refuse(token_, what + " in the statement"); }

// An array that parts share is as long as it has to be.
void Execution::require_full_use(const char* array) const {
  const auto found = arrays_.find(array);
  if (found == arrays_.end()) return;
  const std::map<int, int>& entries = found->second.entries;
  const int used = entries.empty() ? 0 : entries.rbegin()->first + 1;
  if (used != found->second.length) fail(fmt::format("another length of {}", array));
}

// Executes a function or a part. It has variables of its own; arrays are common to all. No part is called twice.
Execution::Ending Execution::carry_out(const ScannedFunction& function) {
  if (!carried_out_.insert(&function).second) fail("a second call of one part");
  const std::size_t back = token_;
  Frame caller = std::move(frame_);
  frame_ = Frame();
  frame_.function = &function;
  for (const ParsedStatement& each : parser_->parse(function, is_in_part())) {
    token_ = each.token;
    if (frame_.ending != Ending::none) fail("a statement after the result");
    if (frame_.has_checks && !may_follow_checks(each.statement)) fail("a statement among checks");
    std::visit([this](const auto& statement) { execute(statement); }, each.statement);
  }
  if (frame_.ending != wanted_ending(function.returns)) fail(fmt::format("another result of {}", function.name));
  if (frame_.has_checks) require_all_checked();
  if (frame_.has_checks && frame_.ending != Ending::checked) fail("checks that are dropped");
  const Ending ending = frame_.ending;
  frame_ = std::move(caller);
  token_ = back;
  return ending;
}

Execution::Ending Execution::wanted_ending(const std::string& returns) const {
  if (returns.empty() || returns == "void") return Ending::none;
  if (returns == text_.scalar()) return Ending::value;
  return returns == text_.verdict() ? Ending::checked : Ending::stage;
}

void Execution::execute(const code::Define& define) {
  for (const code::Define::Constant& each : define.constants) {
    refuse_known(each.name);
    const int result = value(each.value);
    frame_.variables.emplace(each.name, result);
  }
}

// Arrays have the names and lengths that they are made with: those of sines are as long as there are angles, or longer
// where nothing reads the rest.
void Execution::execute(const code::Declare& declare_arrays) {
  for (const code::Declare::Array& each : declare_arrays.arrays) {
    const std::string& name = each.name;
    if (round_of_sines(name) > 0) {
      if (!each.length) fail("an array without a length");
      declare(name, static_cast<int>(*each.length));
      continue;
    }
    const bool is_of_sines = name == "sine" || name == "cosine";
    const bool is_of_angles = is_of_sines || (name == "angle" && text_.count("angle_count") != nullptr);
    const bool is_shared = name == kKeptArray || name == kPivotsArray || name == kResultArray;
    if ((!is_of_angles && !is_shared) || (!each.length && name != kResultArray)) fail("an unknown array");
    if (is_of_angles && each.length < static_cast<std::size_t>(text_.count_of_angles().value)) fail("another length");
    if (name == kResultArray && each.length.value_or(1) != 1) fail("another length");
    declare(name, static_cast<int>(each.length.value_or(1)));
  }
}

void Execution::execute(const code::DeclareStage& stage) {
  if (is_in_part() || !outputs_.empty() || stage.type != written_.returns) fail("an unknown statement");
  declare(stage.name, static_cast<int>(like_.outputs[0].entries.size()));
  outputs_ = {stage.name};
}

void Execution::execute(const code::Store& store) {
  std::vector<std::pair<std::string, int>> places;
  for (const code::Place& place : store.places) {
    if (const auto* element = std::get_if<code::Element>(&place)) {
      places.emplace_back(element->array, element->index);
    } else if (const auto* number = std::get_if<code::Number>(&place)) {
      places.emplace_back(number->name, 0);
    } else {
      const auto& entry = std::get<code::Field>(place);
      if (!is_output(entry.structure)) fail("no stage");
      places.emplace_back(entry.structure, field(written_.returns, entry.name));
    }
  }
  const int stored = value(store.value);
  for (const auto& [array, entry] : places) write(array, entry, stored);
}

void Execution::execute(const code::StoreZeros& zeros) {
  if (!is_output(zeros.array)) fail("zeros in what is no output");
  const int zero = value(code::Literal{0});
  for (std::size_t k = zeros.first; k < zeros.end; ++k) write(zeros.array, static_cast<int>(k), zero);
}

// Writes an entry, once; only places of values that parts keep are used again.
void Execution::write(const std::string& array, int entry, int value) {
  const auto found = arrays_.find(array);
  if (found == arrays_.end() || !is_visible(array)) fail("no array " + array);
  if (found->second.length >= 0 && entry >= found->second.length) fail("an entry too many");
  const bool is_new = found->second.entries.insert_or_assign(entry, value).second;
  if (!is_new && array != kKeptArray) fail(fmt::format("{}[{}] is written twice", array, entry));
  has_written_ = has_written_ || is_output(array);
}

void Execution::execute(const code::FillSines& fill) {
  if (fill.is_computed) return fill_computed(fill);
  if (fill.sines != code::kSines || fill.cosines != code::kCosines) fail("sines and cosines in another place");
  const std::string angles = text_.count("angle_count") == nullptr ? "q" : "angle";
  if (is_in_part() || fill.array != angles) fail("sines and cosines in another place");
  for (const char* array : {"sine", "cosine"}) {
    if (frame_.locals.count(array) == 0) fail(fmt::format("no array {}", array));
  }
  for (const int k : fill.angles) ask_for_sine(angles, k);
}

// Sines and cosines of angles that the function has computed, in arrays of one round, all of which are filled.
void Execution::fill_computed(const code::FillSines& fill) {
  const int round = round_of_sines(fill.array);
  const std::string number = "_" + std::to_string(round);
  const bool is_round = round > 0 && fill.array == code::kAngles + number && fill.sines == code::kSines + number &&
                        fill.cosines == code::kCosines + number;
  if (!is_round || !is_visible(fill.array)) fail("sines and cosines of an unknown array");
  const int length = arrays_.at(fill.array).length;
  if (static_cast<int>(fill.angles.size()) != length) fail("another number of angles");
  for (const int k : fill.angles) {
    const int angle = written_entry(fill.array, k);
    write(fill.sines, k, lines_.sine(k, angle));
    write(fill.cosines, k, lines_.cosine(k, angle));
  }
}

void Execution::ask_for_sine(const std::string& angles, int k) {
  if (has_written_) fail("read after an output is written");
  if (k >= text_.count_of_angles().value) fail("no such joint");
  const bool is_position = angles == "q";
  if (is_position && !is_input(angles)) fail("no argument q");
  const int angle = is_position ? kPosition : angle_at(written_entry(angles, k));
  angles_asked_.insert(k);
  write("sine", k, lines_.sine(k, angle));
  write("cosine", k, lines_.cosine(k, angle));
}

// The angle of an operation; an entry of q is identified by its index instead.
int Execution::angle_at(int operation) const {
  const Operation& made = lines_[operation];
  return made.step == Step::input && made.input.kind == InputKind::q ? kPosition : operation;
}

void Execution::execute(const code::Check& check) {
  if (check.is_first == frame_.has_checks) fail("no variable of checks, or a second one");
  if (check.is_first) refuse_known(code::kValid);
  frame_.has_checks = true;
  if (const auto* positive = std::get_if<code::Positive>(&check.condition)) {
    lines_.validity_conditions.push_back(value(positive->value));
  } else if (const auto* finite = std::get_if<code::Finite>(&check.condition)) {
    check_entry(finite->entry.array, finite->entry.index);
  }
}

void Execution::execute(const code::CheckFinite& check) {
  if (!frame_.has_checks) fail("no variable of checks");
  for (std::size_t k = check.first; k < check.end; ++k) check_entry(check.array, static_cast<int>(k));
}

void Execution::check_entry(const std::string& output, int entry) {
  if (!is_output(output)) fail("a check of what is no output");
  written_entry(output, entry);
  if (!finite_.emplace(output, entry).second) fail("a check made twice");
}

void Execution::execute(const code::CheckPositive& check) {
  if (!frame_.has_checks) fail("no variable of checks");
  if (check.array != kPivotsArray || frame_.locals.count(kPivotsArray) == 0) fail("no array of pivots");
  require_full_use(kPivotsArray);
  const std::map<int, int>& pivots = arrays_[kPivotsArray].entries;
  if (check.length != pivots.size()) fail("another number of pivots");
  for (const auto& [index, pivot] : pivots) lines_.validity_conditions.push_back(pivot);
}

// Every entry that is written is checked to be finite.
void Execution::require_all_checked() const {
  for (const std::string& output : outputs_) {
    for (const auto& [entry, value] : arrays_.at(output).entries) {
      if (finite_.count({output, entry}) == 0) fail(fmt::format("{}[{}] is not checked", output, entry));
    }
  }
}

// The arguments of a part have the names of its parameters, and are known here.
void Execution::execute(const code::CallPart& call) {
  const auto part = text_.parts().find(call.name);
  if (part == text_.parts().end()) fail("a call of what is no part");
  for (const code::Argument& each : call.arguments) {
    const bool is_own_stage = each.role == code::Argument::Role::stage && !is_in_part();
    if (!is_own_stage && !is_visible(each.name)) fail("an argument that is not known here");
  }
  const Ending ending = carry_out(part->second);
  if (call.is_returned) {
    frame_.ending = ending;
  } else if (ending != Ending::none) {
    fail("a result that is dropped");
  }
}

void Execution::execute(const code::Return& give_back) {
  if (!give_back.value) {
    frame_.ending = Ending::checked;
    return;
  }
  const auto* name = std::get_if<code::Variable>(&*give_back.value);
  if (name != nullptr && frame_.locals.count(name->name) != 0 && is_output(name->name)) {
    frame_.ending = Ending::stage;
    return;
  }
  arrays_[kReturned].entries[0] = value(*give_back.value);
  frame_.ending = Ending::value;
}

void Execution::execute(const code::Ignore& ignore) {
  if (!is_visible(ignore.name) || frame_.locals.count(ignore.name) != 0) fail("no parameter");
}

// Adds an array of the function that is carried out.
void Execution::declare(const std::string& name, int length) {
  refuse_known(name);
  if (!arrays_.emplace(name, Array{length, {}}).second || !frame_.locals.insert(name).second) {
    fail("an array made twice");
  }
}

// The number of entries of an input; -1: the text does not say it.
int Execution::length_of(InputKind kind) const {
  const ArgumentLength length = argument_row(kind).length;
  if (length == ArgumentLength::wrench) return kWrenchLength;
  if (length == ArgumentLength::vector) return kVectorLength;
  if (length == ArgumentLength::one) return 1;
  if (length == ArgumentLength::base_parameters || length == ArgumentLength::own) {
    const int own = own_length(like_, length);
    return own > 0 ? own : -1;
  }
  const ScannedCount* count = text_.count(length == ArgumentLength::positions ? "position_count" : "velocity_count");
  if (count == nullptr) count = text_.count("joint_count");
  return count == nullptr ? -1 : count->value;
}

bool Execution::is_visible(const std::string& name) const {
  const auto& parameters = frame_.function->parameters;
  return frame_.locals.count(name) != 0 ||
         std::any_of(parameters.begin(), parameters.end(), [&](const auto& each) { return each.name == name; });
}

// Throws if the name means something already.
void Execution::refuse_known(const std::string& name) const {
  const std::vector<std::string>* fields = text_.fields(frame_.function->member_of);
  const bool is_field = fields != nullptr && std::find(fields->begin(), fields->end(), name) != fields->end();
  const bool is_known = is_visible(name) || frame_.variables.count(name) != 0 || limbs_.count(name) != 0 || is_field;
  if (!is_name(name) || is_known || is_taken_by_language(name) || text_.parts().count(name) != 0) {
    fail("a name that means something else");
  }
}

bool Execution::is_output(const std::string& array) const {
  return std::find(outputs_.begin(), outputs_.end(), array) != outputs_.end();
}

int Execution::field(const std::string& structure, const std::string& name) const {
  const std::vector<std::string>* fields = text_.fields(structure);
  if (fields == nullptr) fail("no struct " + structure);
  const auto found = std::find(fields->begin(), fields->end(), name);
  if (found == fields->end()) fail("no field " + name);
  return static_cast<int>(found - fields->begin());
}

}  // namespace flatdyn
