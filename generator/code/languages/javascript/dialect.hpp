// SPDX-License-Identifier: GPL-2.0-or-later
// JavaScript: names are local to the module; numbers are doubles; comments have the types that editors read.
#pragma once

#include <string>
#include <vector>

#include "code/emit/page_dialect.hpp"

namespace flatdyn {

// An ES module, which checks the lengths of arrays; its types for TypeScript; or the body of a function that returns
// the same functions in an object, for a web page.
enum class JavascriptForm { module, types, function_body };

class JavascriptDialect : public PageDialect {
 public:
  explicit JavascriptDialect(JavascriptForm form = JavascriptForm::module, Sines sines = Sines::polynomials)
      : PageDialect("number", ""), form_(form), sines_(sines) {}

  std::vector<std::string> reserved() const override;
  std::string literal(const Rational& value) const override;
  std::string infinity(bool negative) const override;
  std::string text(const std::string& value) const override;
  std::string sign(const std::string& of) const override;
  std::string sqrt(const std::string& of) const override;
  // V8 gives up on functions of 60 kB of bytecode.
  LanguageTraits traits() const override { return {.evaluates_sines = true, .longest_function = 1000}; }
  std::string angle_function(const std::string& function, const std::string& angle) const override;
  std::string input(const std::string& name, std::size_t) const override { return name; }
  std::string output(const std::string& name, std::size_t) const override { return name; }
  std::string parameters_argument() const override { return "parameters"; }
  std::string constant() const override { return "const "; }
  std::string arrays() const override { return "const "; }
  std::string array(const std::string& name, const std::string& length) const override;
  std::string conditions_begin() const override { return "let valid = "; }
  std::string conditions_continue() const override { return "valid &&= "; }
  std::string part_begin(const std::string& name) const override { return "function " + name + "("; }
  void declare(FunctionText& text, const UndeclaredFunction& function) const override;
  std::string count_definition(const std::string& name, int value) const override;

  std::vector<FileTemplate> files() const override;
  std::string member(const std::string& name, const std::string& unit) const override;
  void write_function(kainjow::mustache::data& item, const Function& function, const FunctionText& text) const override;
  void write_page(kainjow::mustache::data& page, const CodeContent& content) const override;

 protected:
  std::string definition_begin(const code::Table& table) const override;
  std::string definition_end() const override { return "];"; }
  const char* counter_type() const override { return "let"; }

 private:
  void write_types(kainjow::mustache::data& page, const CodeContent& content) const;

  JavascriptForm form_;
  Sines sines_;
};

}  // namespace flatdyn
