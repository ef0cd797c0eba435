// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>

#include "code/languages/cpp/read.hpp"
#include "code/readback/token_cursor.hpp"

namespace flatdyn {
namespace {

// Scans namespace scope: structs and function templates.
class CppScanner : TokenCursor {
 public:
  using TokenCursor::TokenCursor;

  ScannedText run() {
    while (!at_end()) {
      if (is("namespace")) {
        open_namespace();
      } else if (is("template")) {
        declaration();
      } else if (is("static")) {
        function();
      } else if (is("}")) {
        close_namespace();
      } else if (tokens_[at_].is_directive()) {
        ++at_;
      } else {
        constant();
      }
    }
    return std::move(found_);
  }

 private:
  void open_namespace() {
    namespaces_.push_back(word(1));
    skip_to("{");
    ++at_;
  }

  // Scans a constant: inline constexpr int joint_count = 7;
  void constant() {
    const std::size_t begin = at_;
    skip_past(";");
    if (at_ == begin + 7 && tokens_[begin].text == "inline") {
      note_count(tokens_[begin + 3].text, tokens_[begin + 5].text, found_);
    }
  }

  void close_namespace() {
    if (namespaces_.empty()) fail("a } too many");
    namespaces_.pop_back();
    ++at_;
  }

  void declaration() {
    if (word(1) != "<") {  // an instantiation
      skip_past(";");
      return;
    }
    skip_to(">");
    ++at_;
    if (is("struct")) {
      structure();
    } else if (is("using")) {
      skip_past(";");
    } else {
      function();
    }
  }

  // Scans a struct, whose fields are declared as "Scalar x, y;".
  void structure() {
    const std::string name = word(1);
    at_ += 2;
    const std::size_t begin = at_;
    skip_past(";");
    const bool is_plain = std::any_of(std::begin(kPlain), std::end(kPlain), [&](const char* of) { return name == of; });
    if (!is_plain) return;
    std::vector<std::string>& fields = found_.fields[name];
    for (std::size_t k = begin; k + 2 < at_; ++k) {
      const bool starts = tokens_[k - 1].text == "{" || tokens_[k - 1].text == ";";
      const bool is_field = tokens_[k + 2].text == "," || tokens_[k + 2].text == ";";
      if (!starts || tokens_[k].text != "Scalar" || !is_field) continue;
      for (; k + 1 < at_ && tokens_[k].text != ";"; k += 2) fields.push_back(tokens_[k + 1].text);
      --k;
    }
  }

  void function() {
    ScannedFunction written;
    const bool is_part = !namespaces_.empty() && namespaces_.back() == "detail";
    skip_attribute();
    while (is("inline") || is("static") || word().starts_with("FLATDYN_")) ++at_;
    written.returns = word();
    while (word() != "(") {
      if (is("::")) written.member_of = word(-4);  // Motion<Scalar>::
      ++at_;
    }
    written.name = word(-1);
    parameters(written);
    while (word() != ";" && word() != "{") ++at_;
    if (is(";")) {  // defined in the source
      ++at_;
      return;
    }
    written.begin = at_ + 1;
    skip_block();
    written.end = at_ - 1;
    if (is_helper_function(written.name) || is_of_sines(written.name)) return;
    if (is_part) {
      if (!found_.parts.emplace(written.name, written).second) fail("a part made twice");
    } else {
      found_.functions.push_back(written);
    }
  }

  // Moves past "[[gnu::noinline]]".
  void skip_attribute() {
    if (!is("[")) return;
    while (word() != "]" || word(1) != "]") ++at_;
    at_ += 2;
  }

  // Whether a function is one of those that evaluate sines and cosines, or that read entries of earlier parts.
  static bool is_of_sines(const std::string& name) {
    constexpr auto kNames = std::to_array<const char*>(
        {"sine_and_cosine", "evaluate", "ask_library", "sines_and_cosines", "stored", "operator"});
    return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
  }

  // Whether this is a type of arrays in CUDA: "In", "In1", "Out2".
  static bool is_array_type(const std::string& type) {
    const std::string begin = type.starts_with("Out") ? "Out" : "In";
    return type.starts_with(begin) && type.find_first_not_of("0123456789", begin.size()) == std::string::npos;
  }

  // Scans parameters: "const Scalar* q", "Scalar* tau", "const Parameters<Scalar>& parameters", but not sin_cos.
  void parameters(ScannedFunction& written) {
    ++at_;
    while (!is(")")) {
      const std::size_t begin = at_;
      std::size_t mark = 0;  // the * or &
      while (word() != "," && word() != ")") {
        if (is("*") || is("&")) mark = at_;
        at_ += is("{") ? 2 : 1;  // "= {}"
      }
      const bool is_source = at_ > begin + 1 && tokens_[begin + 1].text == "SinCos";
      if (is_array_type(tokens_[begin].text)) {
        written.parameters.push_back(
            {begin + 1 < at_ ? tokens_[begin + 1].text : "", tokens_[begin].text.starts_with("Out")});
      }
      if (mark != 0 && !is_source) {
        const bool is_output = tokens_[mark].text == "*" && tokens_[begin].text != "const";
        written.parameters.push_back({mark + 1 < at_ ? tokens_[mark + 1].text : "", is_output});
      }
      if (is(",")) ++at_;
    }
  }

  static constexpr const char* kPlain[] = {"Parameters", "Configuration", "Motion"};

  std::vector<std::string> namespaces_;
  ScannedText found_;
};

}  // namespace

ScannedText CppReader::scan(const std::vector<Token>& tokens) const { return CppScanner(tokens).run(); }

}  // namespace flatdyn
