// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "diagnostics/diagnostics.hpp"
#include "readback/scan.hpp"
#include "readback/token_cursor.hpp"

namespace flatdyn {
namespace {

// Scans file scope: declarations, constants, one struct of parameters, and functions.
class CScanner : TokenCursor {
 public:
  CScanner(const std::vector<Token>& tokens, const std::string& scalar) : TokenCursor(tokens), scalar_(scalar) {}

  ScannedText run() {
    while (!at_end()) item();
    return std::move(found_);
  }

 private:
  void item() {
    if (tokens_[at_].is_directive()) {
      ++at_;
    } else if (is("enum") && at_ + 6 < tokens_.size()) {
      note_count(tokens_[at_ + 2].text, tokens_[at_ + 4].text, found_);
      at_ += 7;
    } else if (is("extern") && at_ + 1 < tokens_.size() && tokens_[at_ + 1].text == "\"C\"") {
      at_ += 3;  // with its brace
      ++open_;
    } else if (is("}")) {
      if (open_-- == 0) fail("a } too many");
      ++at_;
    } else if (is("typedef")) {
      structure();
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
    const bool is_static = is("static");
    if (is_static) ++at_;
    written.returns = tokens_.at(at_).text;
    written.name = tokens_.at(at_ + 1).text;
    at_ += 3;
    while (at_ < end) parameter(written);
    written.begin = end + 1;
    at_ = end;
    skip_block();
    written.end = at_ - 1;
    if (is_static) {
      if (!found_.parts.emplace(written.name, written).second) fail("a part made twice");
    } else if (!is_helper_function(written.name)) {
      forget_what_it_calls(written);
      found_.functions.push_back(written);
    }
  }

  // Scans a parameter: "const float* restrict q," or the last one with its parenthesis.
  void parameter(ScannedFunction& written) {
    const bool is_constant = is("const");
    bool is_pointer = false;
    while (!is(",") && !is(")")) {
      is_pointer = is_pointer || is("*");
      ++at_;
    }
    if (is_pointer) written.parameters.push_back({tokens_[at_ - 1].text, !is_constant});
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
  int open_ = 0;  // open braces of extern "C"
  ScannedText found_;
};

}  // namespace

ScannedText scan_c(const std::vector<Token>& tokens, const std::string& scalar) {
  return CScanner(tokens, scalar).run();
}

}  // namespace flatdyn
