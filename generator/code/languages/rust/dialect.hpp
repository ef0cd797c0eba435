// SPDX-License-Identifier: GPL-2.0-or-later
// Rust, for one scalar: a crate without std, without unsafe code and without dependencies, whose arguments are arrays
// of known lengths.
#pragma once

#include <string>
#include <vector>

#include "code/emit/page_dialect.hpp"

namespace flatdyn {

class RustDialect : public PageDialect {
 public:
  explicit RustDialect(const EmitOptions& options);

  std::string count_name(const std::string& name) const override;
  std::vector<std::string> reserved() const override;
  std::vector<std::string> reserved_members() const override;
  std::size_t indent() const override { return 4; }
  LanguageTraits traits() const override { return {.lines_around_body = 6, .lines_per_argument = 1}; }
  std::string literal(const Rational& value) const override;
  std::string infinity(bool negative) const override;
  std::string text(const std::string& value) const override;
  std::string sign(const std::string& of) const override { return "sign(" + of + ")"; }
  std::string sqrt(const std::string& of) const override { return "sqrt(" + of + ")"; }
  std::string fused(const std::string& a, const std::string& b, const std::string& c) const override;
  std::string filled_sines(const code::FillSines& fill) const override;
  bool has_given_variants() const override { return true; }

  std::string input(const std::string& name, std::size_t length) const override;
  std::string output(const std::string& name, std::size_t length) const override;
  std::string parameters_argument() const override { return "parameters: &Parameters"; }
  std::string passed(const code::Argument& argument) const override;
  std::string constant() const override { return "let "; }
  std::string arrays() const override { return "let mut "; }
  std::string array(const std::string& name, const std::string& length) const override;
  std::string declarations(const std::string& begin, const std::vector<std::string>& rests) const override;
  std::string stored(const std::vector<std::string>& places, const std::string& value) const override;
  std::string returned(const std::string& value) const override { return value; }
  std::string call_begin(bool) const override { return ""; }
  std::string call_end(bool is_returned) const override { return is_returned ? ")" : ");"; }
  std::string ignored(const std::string& name) const override { return "let _ = " + name + ";"; }
  std::string conditions_begin() const override { return "let mut valid = "; }
  std::string finite(const std::string& number) const override { return number + ".is_finite()"; }
  std::string check_finite(const std::string& array, std::size_t first, std::size_t end) const override;
  std::string check_positive(const std::string& array, std::size_t length) const override;
  std::string part_begin(const std::string& name) const override { return "fn " + name + "("; }
  void declare(FunctionText& text, const UndeclaredFunction& function) const override;
  std::string count_definition(const std::string& name, int value) const override;

  bool has_known_answer() const override { return true; }
  std::vector<FileTemplate> files() const override;
  std::string member(const std::string& name, const std::string& unit) const override;
  void write_function(kainjow::mustache::data& item, const Function& function, const FunctionText& text) const override;
  void write_page(kainjow::mustache::data& page, const CodeContent& content) const override;

 protected:
  std::string definition_begin(const code::Table& table) const override;
  std::string definition_end() const override { return "];"; }
  std::string flag(bool is_set) const override { return is_set ? "true" : "false"; }

 private:
  bool is_float() const { return scalar() == "f32"; }
};

}  // namespace flatdyn
