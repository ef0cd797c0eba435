// SPDX-License-Identifier: GPL-2.0-or-later
// GNU C with vectors of a scalar: one state per lane of a SIMD register. Functions over arrays of states, which are
// exported, call those over lanes.
#pragma once

#include "code/languages/c/dialect.hpp"

namespace flatdyn {

// The robot's own numbers are broadcast to the lanes.
class LanesDialect : public CDialect {
 public:
  LanesDialect(const std::string& number, const std::string& name_space);

  bool encloses_literals() const override { return true; }
  std::string literal(const Rational& value) const override;
  std::string sqrt(const std::string& of) const override;
  std::string parameter(const std::string& member) const override;
  std::string condition_type() const override;
  std::string always() const override;

  bool has_known_answer() const override { return false; }
  std::vector<FileTemplate> files() const override;
  // A function over arrays takes states as rows and writes results as rows.
  void write_function(kainjow::mustache::data& item, const Function& function, const FunctionText& text) const override;
  void write_page(kainjow::mustache::data& page, const CodeContent& content) const override;

 protected:
  std::string linkage() const override { return "static "; }
  bool declares_lengths() const override { return false; }

 private:
  std::string spread(const std::string& value) const;
};

}  // namespace flatdyn
