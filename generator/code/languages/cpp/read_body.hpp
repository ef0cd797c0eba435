// SPDX-License-Identifier: GPL-2.0-or-later
// Statements of C++: types by the name of the template's parameter, Scalar(0.0825), detail::sign(x), parameters.m_1.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "code/readback/body_parser.hpp"

namespace flatdyn {

class CppBodyParser : public BodyParser {
 public:
  using BodyParser::BodyParser;

 protected:
  std::vector<Form> forms() override;
  code::Expression factor() override;
  code::Place place() override;
  code::Argument argument(const ScannedFunction::Parameter& parameter) override;
  void whole_literal(const char* wanted) override;
  std::size_t tokens_of_literal() const override { return 4; }

 private:
  void check_of_scalar();
  void fused_operation();
  void arrays();
  void stage();
  void sines();
  void loop_of_checks();
  void type_of_lanes();
  void lanes();
  void part();
  void zeros();
  code::Expression detail_call();
  code::Expression member();

  bool has_fused_ = false;
  std::map<std::string, std::size_t> lengths_;  // of the arrays that are declared
};

}  // namespace flatdyn
