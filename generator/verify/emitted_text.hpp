// SPDX-License-Identifier: GPL-2.0-or-later
// An emitted header read back. What is known of a graph is known of the text that people compile only if the text says
// the same: so it is read by a parser that shares nothing with the printer, and compared.
//
//   statement   const Scalar x = sum, …;   B[1] = B[7] = sum;   stage.x1 = sum;   return sum;   detail::f_part_1(…);
//   sum         [-] product {(+|-) product}
//   product     factor {(*|/) factor}
//   factor      x   q[2]   parameters.m1   Scalar(0.0825)   detail::sign(sum)   (sum)
#pragma once

#include <map>
#include <string>
#include <vector>

#include "graph/function.hpp"
#include "verify/straight_line.hpp"
#include "verify/tokens.hpp"

namespace flatdyn {

// A function of the text: its tokens.
struct WrittenFunction {
  struct Parameter {
    std::string name;  // empty: not read, or not written
    bool is_output = false;
  };

  std::string name;
  std::string member_of;  // "Motion"
  std::string returns;    // "void", "bool", "Scalar", "Motion"
  std::vector<Parameter> parameters;
  std::size_t begin = 0, end = 0;  // of the body, without its braces
};

class EmittedText {
 public:
  // Throws Failure(bug) where the text is none of the emitter's.
  explicit EmittedText(const std::string& header);

  // Those of the robot's namespace, in their order, members of stages included.
  const std::vector<WrittenFunction>& functions() const { return functions_; }

  // Function k, as it is executed, for the outputs of `like`. Throws Failure(bug) if the text is no such function.
  StraightLine operations(std::size_t k, const Function& like) const;

  // Function k, as what it computes for the outputs and conditions of `like`. Throws Failure(bug) if the text is no
  // such function.
  Function read(std::size_t k, const Function& like) const;

 private:
  friend class TextReader;
  std::vector<Token> tokens_;
  std::vector<WrittenFunction> functions_;
  std::map<std::string, WrittenFunction> parts_;            // of namespace detail, by name
  std::map<std::string, std::vector<std::string>> fields_;  // of structs, by name
};

// The function with every constant as it is printed: the nearest double. Without what is not written, and without
// conditions that always hold.
Function as_printed(const Function& function);

}  // namespace flatdyn
