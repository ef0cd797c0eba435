// SPDX-License-Identifier: GPL-2.0-or-later
// C99, for one scalar: no templates, plain arrays, names with a prefix; a header and its source.
#pragma once

#include <string>
#include <vector>

#include "code/emit/page_dialect.hpp"

namespace flatdyn {

class CDialect : public PageDialect {
 public:
  // `number`: "double" or "float". `name_space`: that of the C++ form, "a::b", which becomes the prefix a_b_.
  CDialect(const std::string& number, const std::string& name_space);

  // The type of the numbers in variables: "float" also if `scalar` is a vector of floats.
  const std::string& number() const { return number_; }
  // A name that other files use.
  std::string exported(const std::string& name) const { return exported_ + name; }
  // The name of a function of <math.h>, "sinf" for float.
  std::string library(const std::string& function) const;

  std::string count_name(const std::string& name) const override;
  std::vector<std::string> reserved() const override;
  // Names are longer than in C++, and each argument that is not read takes a statement.
  LanguageTraits traits() const override { return {.lines_around_body = 6, .lines_per_argument = 1}; }
  std::string literal(const Rational& value) const override;
  std::string infinity(bool negative) const override;
  std::string sign(const std::string& of) const override;
  std::string sqrt(const std::string& of) const override;
  std::optional<std::string> excess(const std::string& sum, const std::string& term) const override;
  std::string fused(const std::string& a, const std::string& b, const std::string& c) const override;
  std::string parameter(const std::string& member) const override;
  std::string filled_sines(const code::FillSines& fill) const override;
  bool has_given_variants() const override { return true; }
  // Definitions declare outputs `restrict`; declarations, which C++ reads too, do not.
  std::string output(const std::string& name, std::size_t length) const override;
  std::string parameters_argument() const override;
  std::string part_begin(const std::string& name) const override;
  void declare(FunctionText& text, const UndeclaredFunction& function) const override;
  std::string count_definition(const std::string& name, int value) const override;
  bool declares_constants_apart() const override { return true; }
  std::string declaration(const code::Table& table) const override;

  bool has_known_answer() const override { return true; }
  std::vector<FileTemplate> files() const override;
  void write_function(kainjow::mustache::data& item, const Function& function, const FunctionText& text) const override;
  void write_page(kainjow::mustache::data& page, const CodeContent& content) const override;

 protected:
  // For vectors of numbers: their type, and the prefix of names at file scope, follow the exported prefix.
  struct Vectors {
    std::string prefix, scalar;
  };
  CDialect(const std::string& number, const std::string& name_space, const Vectors& vectors);

  virtual std::string linkage() const { return ""; }  // "static " for functions that no other file calls
  // Whether parameters that are arrays are declared with their lengths.
  virtual bool declares_lengths() const { return true; }
  std::string definition_begin(const code::Table& table) const override;

 private:
  std::vector<std::string> parameters(const std::vector<Argument>& arguments, bool restricts) const;
  bool is_sized(const Argument& argument) const;
  std::string sized(const Argument& argument, bool restricts) const;
  std::string definitions(const FunctionText& text) const;
  std::string type_of(const code::Table& table) const;

  std::string number_, exported_;
};

}  // namespace flatdyn
