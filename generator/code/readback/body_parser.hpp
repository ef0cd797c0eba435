// SPDX-License-Identifier: GPL-2.0-or-later
// The statements of emitted functions: tokens → code, in the plain types that the printer prints, by a parser of its
// own. Each language has a table of the statements that it may have; any other statement is refused.
//
//   sum         [-] product {(+|-) product}
//   product     factor {(*|/) factor}
//   factor      (sum)   and the factors of the language
#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "code/readback/emitted_text.hpp"
#include "code/statement.hpp"

namespace flatdyn {

// A statement and the token that it begins with.
struct ParsedStatement {
  code::Statement statement;
  std::size_t token = 0;
};

class BodyParser {
 public:
  explicit BodyParser(const EmittedText& text) : text_(text) {}
  virtual ~BodyParser() = default;
  BodyParser(const BodyParser&) = delete;
  BodyParser& operator=(const BodyParser&) = delete;

  // The statements of a function or of a part. `is_part`: functions that only others call. Throws Failure(bug) if the
  // text is not such a function.
  std::vector<ParsedStatement> parse(const ScannedFunction& function, bool is_part);

 protected:
  // A form of statement: whether one begins here, and its reading, which adds what it says.
  struct Form {
    std::function<bool()> begins;
    std::function<void()> read;
  };
  // The forms in the order in which they are tried.
  virtual std::vector<Form> forms() = 0;
  // A factor of a product that is not in brackets.
  virtual code::Expression factor() = 0;

  // Tokens.
  [[noreturn]] void fail(const std::string& what) const;
  const std::string& word(std::size_t ahead = 0) const;
  bool is(const char* text) const { return word() == text; }
  bool is_at_begin() const { return at_ == function_->begin; }
  bool is_at_end() const { return at_ == function_->end; }
  // Whether no further statement ends with a semicolon.
  bool is_last_statement() const;
  bool is_on_line_before() const;
  std::string take();
  void expect(const std::string& text);
  void expect_all(std::initializer_list<const char*> texts);
  bool accept(const std::string& text);
  int index();
  bool is_number() const;  // whether a number follows

  void add(code::Statement statement) { statements_.push_back({std::move(statement), statement_begin_}); }

  // Expressions. `nested` reads the rest of one in brackets.
  code::Expression sum();
  code::Expression product();
  code::Expression nested();
  // A literal, in double or as "0.5f" in float, rounded once, in its own type; in some languages without a suffix.
  code::Literal literal(bool is_float) { return literal(is_float, is_float ? "f" : ""); }
  code::Literal literal(bool is_float, const std::string& suffix);
  // A literal with a sign of its own: -0.5.
  code::Literal signed_literal(bool is_float);
  // The rest of a call with so many operands, after its opening bracket.
  code::Expression call(code::Operation operation, int operands);
  // A variable, or an entry of an array: x, q[2].
  code::Expression variable_or_entry();

  // Statements that languages with the syntax of C have in common.
  // x = sum, y = sum;
  void definitions();
  // kept[7] or sine[joint_count], or a number's name alone.
  code::Declare::Array array();
  // B[1] = B[7] = sum;
  void assignment();
  virtual code::Place place();
  // The rest of a return of a sum or of the verdict.
  void give_back();
  code::Return result();
  // f_part_1(q, kept); by its name and arguments; `end` follows the closing bracket.
  void call_of_part(bool is_returned, const std::string& end = ";");
  virtual code::Argument argument(const ScannedFunction::Parameter& parameter);

  // Checks, after their beginning up to the end: D_1 > 0;   true;   0 * tau[3] < 1;
  void first_check();
  void further_check();
  // for (int k = 0; k < 7; ++k) { valid &= 0 * tau[k] < 1; }, after the opening bracket.
  void counted_checks(const char* counter, bool has_braces);
  virtual const char* continues_verdict() const { return "&="; }
  virtual bool accept_always() { return accept("true"); }
  virtual void whole_literal(const char* wanted) = 0;  // "0.0" as the language writes it
  virtual std::size_t tokens_of_literal() const { return 1; }
  virtual code::Condition condition();

  const EmittedText& text_;
  const ScannedFunction* function_ = nullptr;
  bool is_part_ = false;

 private:
  std::size_t last_assignment() const;

  std::vector<ParsedStatement> statements_;
  std::size_t at_ = 0, statement_begin_ = 0;
  int depth_ = 0;
  bool has_checks_ = false;
};

}  // namespace flatdyn
