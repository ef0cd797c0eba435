// SPDX-License-Identifier: GPL-2.0-or-later
#include "readback/text_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "readback/unreadable_text.hpp"

namespace flatdyn {
namespace {

// Names that a variable would hide.
bool is_taken_by_language(const std::string& name) {
  constexpr auto kNames = std::to_array<const char*>({"Math", "sin", "cos", "Float64Array", "Scalar", "detail", "std"});
  return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

bool is_name(const std::string& text) {
  return !text.empty() && (std::isalpha(static_cast<unsigned char>(text.front())) != 0 || text.front() == '_');
}

}  // namespace

TextReader::TextReader(const EmittedText& text, const ScannedFunction& written, const Function& like)
    : text_(text), notation_(text.notation_), written_(written), like_(like) {
  for (const ScannedFunction::Parameter& parameter : written.parameters) {
    if (parameter.is_output) outputs_.push_back(parameter.name);
  }
}

StraightLine TextReader::read() {
  const bool returns_result = !outputs_.empty() || written_.returns == "void" || written_.returns == notation_.verdict;
  if (returns_result) {
    if (outputs_.size() != like_.outputs.size()) fail("another number of outputs");
    for (std::size_t k = 0; k < outputs_.size(); ++k) {
      arrays_[outputs_[k]].length = static_cast<int>(like_.outputs[k].entries.size());
    }
  } else {
    if (like_.outputs.size() != 1) fail("another number of outputs");
    if (written_.returns == notation_.scalar) arrays_[kReturned].length = 1;
  }
  carry_out(written_);
  for (const char* array : {"kept", "pivots"}) require_full_use(array);
  const bool all_read =
      std::includes(angles_read_.begin(), angles_read_.end(), angles_asked_.begin(), angles_asked_.end());
  if (!all_read) fail("sines and cosines that nothing reads");
  if (!returns_result && written_.returns == notation_.scalar) outputs_ = {kReturned};
  if (outputs_.size() != like_.outputs.size()) fail("another number of outputs");
  for (std::size_t k = 0; k < outputs_.size(); ++k) {
    lines_.outputs.push_back(entries_of(like_.outputs[k], outputs_[k]));
  }
  return std::move(lines_);
}

std::vector<int> TextReader::entries_of(const Output& output, const std::string& name) const {
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

// An array that parts share is as long as it has to be.
void TextReader::require_full_use(const char* array) const {
  const auto found = arrays_.find(array);
  if (found == arrays_.end()) return;
  const std::map<int, int>& entries = found->second.entries;
  const int used = entries.empty() ? 0 : entries.rbegin()->first + 1;
  if (used != found->second.length) fail(fmt::format("another length of {}", array));
}

void TextReader::fail(const std::string& what) const {
  if (text_.tokens_.empty()) throw Failure(ExitCode::bug, "emitted text cannot be read back: it is empty");
  const std::size_t k = std::min(at_, text_.tokens_.size() - 1);
  throw UnreadableText(text_.tokens_[k].line, fmt::format("{} at \"{}\"", what, text_.tokens_[k].text));
}

// The token's text; "" after the end.
const std::string& TextReader::word(std::size_t ahead) const {
  static const std::string none;
  return at_ + ahead < text_.tokens_.size() ? text_.tokens_[at_ + ahead].text : none;
}

std::string TextReader::take() {
  if (is_at_end()) fail("it ends");
  return text_.tokens_[at_++].text;
}

void TextReader::expect(const std::string& text) {
  if (word() != text) fail(fmt::format("\"{}\" expected", text));
  ++at_;
}

void TextReader::expect_all(std::initializer_list<const char*> texts) {
  for (const char* text : texts) expect(text);
}

bool TextReader::accept(const char* text) {
  if (!is(text)) return false;
  ++at_;
  return true;
}

// Reads a whole number without leading zeros, which would make it octal.
int TextReader::index() {
  constexpr std::size_t kMostDigits = 8;
  const std::string text = take();
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const bool is_number = !text.empty() && text.size() <= kMostDigits && std::all_of(text.begin(), text.end(), is_digit);
  if (!is_number || (text.size() > 1 && text.front() == '0')) fail("an index expected");
  return std::stoi(text);
}

// Adds an array of the function that is carried out.
void TextReader::declare(const std::string& name, int length) {
  refuse_known(name);
  if (!arrays_.emplace(name, Array{length, {}}).second || !locals_.insert(name).second) fail("an array made twice");
}

// The number of angles whose sines and cosines there are.
const ScannedCount& TextReader::count_of_sines() const {
  for (const char* name : {"angle_count", "position_count", "joint_count"}) {
    if (const ScannedCount* count = text_.count(name)) return *count;
  }
  fail("no count of joints");
}

// The number of entries of an input; -1: the text does not say it.
int TextReader::length_of(InputKind kind) const {
  constexpr int kWrench = 6, kVector = 3;
  if (kind == InputKind::h_e) return kWrench;
  if (kind == InputKind::g_b) return kVector;
  if (kind == InputKind::pi_b) return like_.base_parameters > 0 ? like_.base_parameters : -1;
  const ScannedCount* count = text_.count(kind == InputKind::q ? "position_count" : "velocity_count");
  if (count == nullptr) count = text_.count("joint_count");
  return count == nullptr ? -1 : count->value;
}

bool TextReader::is_visible(const std::string& name) const {
  const auto& parameters = current_->parameters;
  return locals_.count(name) != 0 ||
         std::any_of(parameters.begin(), parameters.end(), [&](const auto& each) { return each.name == name; });
}

// Throws if the name means something already.
void TextReader::refuse_known(const std::string& name) const {
  const auto fields = text_.fields_.find(current_->member_of);
  const bool is_field = fields != text_.fields_.end() &&
                        std::find(fields->second.begin(), fields->second.end(), name) != fields->second.end();
  if (!is_name(name) || is_visible(name) || variables_.count(name) != 0 || limbs_.count(name) != 0 ||
      types_of_limbs_.count(name) != 0 || is_field || is_taken_by_language(name) || text_.parts_.count(name) != 0) {
    fail("a name that means something else");
  }
}

bool TextReader::is_output(const std::string& array) const {
  return std::find(outputs_.begin(), outputs_.end(), array) != outputs_.end();
}

int TextReader::field(const std::string& structure, const std::string& name) const {
  const auto fields = text_.fields_.find(structure);
  if (fields == text_.fields_.end()) fail("no struct " + structure);
  const auto found = std::find(fields->second.begin(), fields->second.end(), name);
  if (found == fields->second.end()) fail("no field " + name);
  return static_cast<int>(found - fields->second.begin());
}

}  // namespace flatdyn
