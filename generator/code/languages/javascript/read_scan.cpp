// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "code/languages/javascript/read.hpp"
#include "code/readback/token_cursor.hpp"

namespace flatdyn {
namespace {

// Scans a module: constants, functions, and a list of the exported names. Functions not in the list are parts of those
// that are.
class JavascriptScanner : TokenCursor {
 public:
  using TokenCursor::TokenCursor;

  ScannedText run() {
    while (!at_end()) {
      if (word() == "function") {
        function();
      } else if (word() == "export" || word() == "return") {
        exports();
      } else {
        if (word() == "const" && word(1) == "parameter_names") parameter_names();
        if (word() == "const" && word(2) == "=") note_count(word(1), word(3), found_);
        skip_past(";");
      }
    }
    for (ScannedFunction& written : functions_) {
      if (std::find(exported_.begin(), exported_.end(), written.name) != exported_.end()) {
        found_.functions.push_back(std::move(written));
      } else if (const std::string name = written.name; !found_.parts.emplace(name, std::move(written)).second) {
        fail("a part made twice");
      }
    }
    return std::move(found_);
  }

 private:
  // Scans const parameter_names = ["g", "a_1"];
  void parameter_names() {
    skip_to("[");
    for (; word() != "]"; ++at_) {
      if (const std::string& name = word(); name.size() > 2 && name.front() == '"') {
        found_.fields["Parameters"].push_back(name.substr(1, name.size() - 2));
      }
    }
  }

  // Scans function gravity(parameters, q, g) { … }
  void function() {
    ScannedFunction written;
    written.name = word(1);
    at_ += 2;
    if (word() != "(") fail("( expected");
    for (++at_; word() != ")"; ++at_) {
      if (word() != ",") written.parameters.push_back({word(), false});
    }
    if (word(1) != "{") fail("{ expected");
    ++at_;
    const std::size_t brace = at_;
    skip_block();
    written.end = at_ - 1;
    written.begin = end_of_check(brace + 1, written.end);
    if (!is_helper_function(written.name)) functions_.push_back(std::move(written));
  }

  // Where the statements begin after the one that refuses arrays of other lengths, if that is there.
  std::size_t end_of_check(std::size_t begin, std::size_t end) const {
    const bool is_check = begin + 5 < end && tokens_[begin].text == "if" && tokens_[begin + 4].text == "length";
    if (!is_check) return begin;
    std::size_t k = begin;
    while (k < end && tokens_[k].text != ";") ++k;
    return std::min(k + 2, end);  // with its brace
  }

  // Scans export {gravity, bias};
  void exports() {
    for (++at_; word() != ";"; ++at_) exported_.push_back(word());
    ++at_;
  }

  std::vector<ScannedFunction> functions_;
  std::vector<std::string> exported_;
  ScannedText found_;
};

}  // namespace

ScannedText JavascriptReader::scan(const std::vector<Token>& tokens) const { return JavascriptScanner(tokens).run(); }

}  // namespace flatdyn
