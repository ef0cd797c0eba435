// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "code/languages/rust/read.hpp"
#include "code/readback/token_cursor.hpp"

namespace flatdyn {
namespace {

// Scans a source up to the manifest that follows it: constants, the parameters, and functions.
class RustScanner : TokenCursor {
 public:
  using TokenCursor::TokenCursor;

  ScannedText run() {
    while (!at_end() && !is("[")) item();
    for (ScannedFunction& written : functions_) {
      const std::string name = written.name;
      if (!is_called(name)) {
        found_.functions.push_back(std::move(written));
      } else if (!found_.parts.emplace(name, std::move(written)).second) {
        fail("a part made twice");
      }
    }
    return std::move(found_);
  }

 private:
  void item() {
    const bool is_public = is("pub");
    if (tokens_[at_].is_directive()) {
      ++at_;
      return;
    }
    if (is_public) ++at_;
    if (is("fn")) {
      function(is_public);
    } else if (is("struct")) {
      structure();
    } else if (is("mod")) {
      at_ += 2;
      skip_block();
    } else if (is("const") || is("static")) {
      if (word(2) == ":" && word(3) == "usize") note_count(word(1), word(5), found_);
      skip_to("=");
      skip_past(";");
    } else {
      skip_past(";");
    }
  }

  // Scans pub struct Parameters { pub g: f64, pub a_1: f64, }
  void structure() {
    std::vector<std::string>& fields = found_.fields[word(1)];
    skip_to("{");
    for (++at_; !is("}"); at_ += 5) {
      if (!is("pub") || word(2) != ":" || word(4) != ",") fail("a field expected");
      fields.push_back(word(1));
    }
    ++at_;
  }

  void function(bool is_public) {
    ScannedFunction written;
    written.name = word(1);
    written.returns = "void";
    at_ += 2;
    if (!is("(")) fail("( expected");
    for (++at_; !is(")");) parameter(written);
    if (word(1) == "->") {
      written.returns = word(2);
      at_ += 2;
    }
    skip_to("{");
    written.begin = at_ + 1;
    skip_block();
    written.end = at_ - 1;
    if (is_helper_function(written.name)) return;
    if (is_public) {
      functions_.push_back(std::move(written));
    } else if (const std::string name = written.name; !found_.parts.emplace(name, std::move(written)).second) {
      fail("a part made twice");
    }
  }

  // Scans q: &[f64; 7], or tau: &mut [f64; 7], with the comma behind it.
  void parameter(ScannedFunction& written) {
    if (at_end()) fail("a parameter expected");
    ScannedFunction::Parameter parameter{word(), word(2) == "&" && word(3) == "mut"};
    int depth = 0;
    while (!at_end() && (depth > 0 || (!is(",") && !is(")")))) {
      depth += is("[") || is("(") ? 1 : is("]") || is(")") ? -1 : 0;
      ++at_;
    }
    if (is(",")) ++at_;
    written.parameters.push_back(std::move(parameter));
  }

  // Whether another public function calls it, as one that asks for sines and cosines does.
  bool is_called(const std::string& name) const {
    return std::any_of(functions_.begin(), functions_.end(), [&](const ScannedFunction& each) {
      const auto begin = tokens_.begin();
      return std::any_of(begin + static_cast<std::ptrdiff_t>(each.begin), begin + static_cast<std::ptrdiff_t>(each.end),
                         [&name](const Token& token) { return token.text == name; });
    });
  }

  std::vector<ScannedFunction> functions_;
  ScannedText found_;
};

}  // namespace

ScannedText RustReader::scan(const std::vector<Token>& tokens) const { return RustScanner(tokens).run(); }

}  // namespace flatdyn
