// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "base/diagnostics/diagnostics.hpp"
#include "code/languages/c/read.hpp"
#include "code/readback/token_cursor.hpp"

namespace flatdyn {
namespace {

// Scans file scope: declarations, constants, one struct of parameters, and functions.
class CScanner : TokenCursor {
 public:
  CScanner(const std::vector<Token>& tokens, const std::string& scalar) : TokenCursor(tokens), scalar_(scalar) {}

  ScannedText run() {
    while (!at_end()) item();
    for (const std::string& name : batches_) take_from_parts(name);
    return std::move(found_);
  }

 private:
  void item() {
    if (tokens_[at_].is_directive()) {
      ++at_;
    } else if (is("enum") && at_ + 6 < tokens_.size() && tokens_[at_ + 5].text == "}") {
      note_count(tokens_[at_ + 2].text, tokens_[at_ + 4].text, found_);
      at_ += 7;
    } else if (is("extern") && at_ + 1 < tokens_.size() && tokens_[at_ + 1].text == "\"C\"") {
      at_ += 3;  // with its brace
      ++open_;
    } else if (is("}")) {
      if (open_-- == 0) fail("a } too many");
      ++at_;
    } else if (is("typedef") && word(1) == "struct") {
      structure();
    } else if (is("typedef")) {
      if (found_.lanes.empty() && word(3) == "__attribute__") found_.lanes = word(2);
      skip_past(";");
    } else if (const std::size_t end = end_of_head();
               end > at_ + 2 && tokens_[end].text == "{" && tokens_[end - 1].text == ")") {
      function(end);
    } else {
      skip_past(";");
    }
  }

  // The position of the first ; or opening brace.
  std::size_t end_of_head() const {
    std::size_t k = at_;
    while (k < tokens_.size() && tokens_[k].text != ";" && tokens_[k].text != "{") ++k;
    if (k >= tokens_.size()) fail("no end");
    return k;
  }

  // Scans typedef struct { float g; float a_1; } arm_parameters;
  void structure() {
    at_ += 3;
    std::vector<std::string>& fields = found_.fields["Parameters"];
    for (; !is("}"); at_ += 3) {
      if (at_ + 2 >= tokens_.size() || !is(scalar_.c_str()) || tokens_[at_ + 2].text != ";") fail("a field expected");
      fields.push_back(tokens_[at_ + 1].text);
    }
    skip_past(";");
  }

  void function(std::size_t end) {
    ScannedFunction written;
    const bool is_static = is("static"), is_inline = is_static && word(1) == "inline";
    if (is_static) ++at_;
    if (is("__attribute__")) skip_brackets();
    while (word(1) != "(") ++at_;
    written.returns = word(-1);
    written.name = word();
    at_ += 2;
    while (at_ < end) parameter(written);
    written.begin = end + 1;
    at_ = end;
    skip_block();
    written.end = at_ - 1;
    add(written, is_static, is_inline);
  }

  void add(const ScannedFunction& written, bool is_static, bool is_inline) {
    if (is_static) {
      const bool is_new = found_.parts.emplace(written.name, written).second;
      if (!is_new && !is_inline) fail("a part made twice");
    } else if (is_batch(written.name)) {
      batches_.push_back(written.name);
    } else if (!is_helper_function(written.name) && found_.lanes.empty()) {
      forget_what_it_calls(written);
      found_.functions.push_back(written);
    }
  }

  // Whether a function computes many states by a function over vectors.
  bool is_batch(const std::string& name) const { return !found_.lanes.empty() && name.ends_with("_batch"); }

  // Makes a function of the part that a function over arrays calls: arm_gravity_batch calls arm_lanes_gravity.
  void take_from_parts(const std::string& batch) {
    constexpr std::size_t kLanes = 5, kBatch = 6;  // lengths of "lanes" and "_batch"
    const std::size_t prefix = found_.lanes.size() - std::min(kLanes, found_.lanes.size());
    const std::size_t end = batch.size() - kBatch;
    const auto part =
        found_.parts.find(found_.lanes + "_" + batch.substr(std::min(prefix, end), end - std::min(prefix, end)));
    if (part == found_.parts.end()) fail("no function of " + batch);
    found_.functions.push_back(part->second);
    found_.parts.erase(part);
  }

  // Moves past "__attribute__((…))".
  void skip_brackets() {
    int depth = 0;
    do {
      ++at_;
      depth += word() == "(" ? 1 : word() == ")" ? -1 : 0;
    } while (depth > 0);
    ++at_;
  }

  // Scans a parameter, "const float* restrict q," or "float tau[restrict 7],", or the last one with its parenthesis.
  void parameter(ScannedFunction& written) {
    const bool is_constant = is("const");
    bool is_pointer = false;
    std::string name_of_array;
    while (!is(",") && !is(")")) {
      if (is("[")) {
        name_of_array = word(-1);
        skip_to("]");
      }
      is_pointer = is_pointer || is("*");
      ++at_;
    }
    if (is_pointer) name_of_array = tokens_[at_ - 1].text;
    if (!name_of_array.empty()) written.parameters.push_back({name_of_array, !is_constant});
    ++at_;
  }

  // Makes the function before this one a part of it if this one calls it, as a function that asks for sines and cosines
  // does.
  void forget_what_it_calls(const ScannedFunction& written) {
    if (found_.functions.empty()) return;
    const ScannedFunction& before = found_.functions.back();
    const bool is_called = std::any_of(tokens_.begin() + static_cast<std::ptrdiff_t>(written.begin),
                                       tokens_.begin() + static_cast<std::ptrdiff_t>(written.end),
                                       [&before](const Token& token) { return token.text == before.name; });
    if (!is_called) return;
    found_.parts.emplace(before.name, before);
    found_.functions.pop_back();
  }

  const std::string& scalar_;
  int open_ = 0;                      // open braces of extern "C"
  std::vector<std::string> batches_;  // functions over arrays of states
  ScannedText found_;
};

}  // namespace

ScannedText CReader::scan(const std::vector<Token>& tokens) const { return CScanner(tokens, number_).run(); }

}  // namespace flatdyn
