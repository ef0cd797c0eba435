// SPDX-License-Identifier: GPL-2.0-or-later
// C++17: templates over Scalar, in the robot's namespace; constants have type Real. Stages are structs. Everything is
// in one header, or declared in a header and defined in a source, which is compiled once.
#pragma once

#include <string>
#include <vector>

#include "code/emit/page_dialect.hpp"

namespace flatdyn {

class CppDialect : public PageDialect {
 public:
  // All in one header.
  CppDialect() : PageDialect("Scalar", "") {}
  // In the form of the options. Throws what compiled_scalars() throws.
  explicit CppDialect(const EmitOptions& options);

  std::vector<std::string> reserved() const override;
  LanguageTraits traits() const override {
    return {.fills_sines = true, .stores_zeros_together = true, .has_lanes = true};
  }
  bool encloses_literals() const override { return true; }
  std::string literal(const Rational& value) const override;
  std::string real_literal(const Rational& value) const override;
  std::string infinity(bool negative) const override;
  std::string sign(const std::string& of) const override;
  std::string sqrt(const std::string& of) const override;
  std::optional<std::string> excess(const std::string& sum, const std::string& term) const override;
  std::string fused_begin() const override;
  // One call for the sines and cosines of all joints, so that they can be evaluated together.
  std::string filled_sines(const code::FillSines& fill) const override;
  std::string stored_zeros(const std::string& array, std::size_t first, std::size_t end) const override;
  std::string parameters_argument() const override { return "const Parameters<Scalar>& parameters"; }
  std::string number_output(const std::string& name) const override { return "Scalar& " + name; }
  std::string number_definition(const std::string& name) const override { return name; }
  std::string number_use(const std::string& name) const override { return name; }
  std::string stage_type(const std::string& stage) const override { return stage + "<Scalar>"; }
  std::string own_stage() const override { return "*this"; }
  std::string part_begin(const std::string& name) const override { return "static void " + name + "("; }
  std::string limbs_definition(int lanes) const override;
  std::string before_part() const override { return "template <class Scalar>\n"; }
  std::string function_end() const override { return ") noexcept {"; }
  std::string part_call(const std::string& name) const override { return "detail::" + name + "("; }
  void declare(FunctionText& text, const UndeclaredFunction& function) const override;
  std::string count_definition(const std::string& name, int value) const override;
  std::string check_positive(const std::string& array, std::size_t length) const override;

  bool has_known_answer() const override { return true; }
  std::vector<FileTemplate> files() const override;
  bool outputs_may_overlap_inputs() const override { return true; }
  void write_function(kainjow::mustache::data& item, const Function& function, const FunctionText& text) const override;
  void write_page(kainjow::mustache::data& page, const CodeContent& content) const override;

 protected:
  std::string check_loop(std::size_t first, std::size_t end, const std::string& check) const override;
  std::string definition_begin(const code::Table& table) const override;

 private:
  bool is_pair() const { return !compiled_.empty(); }
  void write_known_answer(kainjow::mustache::data& page, const CodeContent& content) const;
  void write_instances(kainjow::mustache::data& page, const CodeContent& content) const;

  std::vector<std::string> compiled_;  // the scalars that the source is compiled for; empty: all is in the header
};

}  // namespace flatdyn
