// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "diagnostics/diagnostics.hpp"
#include "verify/scanned.hpp"

namespace flatdyn {
namespace {

// A module has constants, functions, and a list of the names that others may use: functions that are not in it are
// parts of those that are.
class JavascriptScanner {
 public:
  explicit JavascriptScanner(const std::vector<Token>& tokens) : tokens_(tokens) {}

  Scanned run() {
    while (at_ < tokens_.size()) {
      if (word() == "function") {
        function();
      } else if (word() == "export" || word() == "return") {
        exports();
      } else {
        if (word() == "const" && word(1) == "parameter_names") parameter_names();
        skip_past(";");
      }
    }
    for (WrittenFunction& written : functions_) {
      if (std::find(exported_.begin(), exported_.end(), written.name) != exported_.end()) {
        found_.functions.push_back(std::move(written));
      } else if (const std::string name = written.name; !found_.parts.emplace(name, std::move(written)).second) {
        fail("a part made twice");
      }
    }
    return std::move(found_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    const int line = tokens_.empty() ? 0 : tokens_[std::min(at_, tokens_.size() - 1)].line;
    throw Failure(ExitCode::bug, fmt::format("emitted text cannot be read back: line {}: {}", line, what));
  }

  const std::string& word(std::size_t ahead = 0) const {
    if (at_ + ahead >= tokens_.size()) fail("it ends here");
    return tokens_[at_ + ahead].text;
  }

  void skip_past(const char* end) {
    while (word() != end) ++at_;
    ++at_;
  }

  // const parameter_names = ["g", "a_1"];
  void parameter_names() {
    while (word() != "[") ++at_;
    for (; word() != "]"; ++at_) {
      if (const std::string& name = word(); name.size() > 2 && name.front() == '"') {
        found_.fields["Parameters"].push_back(name.substr(1, name.size() - 2));
      }
    }
  }

  // function gravity(parameters, q, g) { … }
  void function() {
    WrittenFunction written;
    written.name = word(1);
    at_ += 2;
    if (word() != "(") fail("( expected");
    for (++at_; word() != ")"; ++at_) {
      if (word() != ",") written.parameters.push_back({word(), false});
    }
    if (word(1) != "{") fail("{ expected");
    at_ += 2;
    written.begin = at_;
    for (int depth = 1; depth > 0; ++at_) depth += word() == "{" ? 1 : word() == "}" ? -1 : 0;
    written.end = at_ - 1;
    functions_.push_back(std::move(written));
  }

  // export {gravity, bias};
  void exports() {
    for (++at_; word() != ";"; ++at_) exported_.push_back(word());
    ++at_;
  }

  const std::vector<Token>& tokens_;
  std::size_t at_ = 0;
  std::vector<WrittenFunction> functions_;
  std::vector<std::string> exported_;
  Scanned found_;
};

}  // namespace

Scanned scanned_javascript(const std::vector<Token>& tokens) { return JavascriptScanner(tokens).run(); }

}  // namespace flatdyn
