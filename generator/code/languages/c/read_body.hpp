// SPDX-License-Identifier: GPL-2.0-or-later
// Statements of C: 0.0825f, arm_sign(x), sqrtf(x), parameters->m_1.
#pragma once

#include <string>
#include <vector>

#include "code/readback/body_parser.hpp"

namespace flatdyn {

class CBodyParser : public BodyParser {
 public:
  // `number`: the type of its numbers, "double" or "float".
  CBodyParser(const EmittedText& text, std::string number) : BodyParser(text), number_(std::move(number)) {}

 protected:
  std::vector<Form> forms() override;
  code::Expression factor() override;
  void whole_literal(const char* wanted) override;
  bool is_float() const { return number_ == "float"; }
  bool is_own(const std::string& function, const char* end) const;
  // The name of the square root.
  virtual std::string root() const { return is_float() ? "sqrtf" : "sqrt"; }

 private:
  void ignored();
  void arrays();
  void sines();
  bool calls_part(std::size_t ahead) const;

  std::string number_;
};

}  // namespace flatdyn
