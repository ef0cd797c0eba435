// SPDX-License-Identifier: GPL-2.0-or-later
// Emitted code, read back. Properties of a graph hold for the text that people compile only if the text says the same;
// so it is read by a parser that shares nothing with the printer, and compared.
//
//   statement   const Scalar x = sum, …;   B[1] = B[7] = sum;   stage.x1 = sum;   return sum;   detail::f_part_1(…);
//               Scalar sine[joint_count], cosine[joint_count];   sin_cos(q, Joints<1, 2>(), sine, cosine);
//               Configuration<Scalar> stage;   constexpr detail::MultiplyAdd<Scalar> fma{};
//               static_assert(detail::Interface::checked<Scalar>());
//               and the checks of text_conditions.cpp
//   sum         [-] product {(+|-) product}
//   product     factor {(*|/) factor}
//   factor      x   q[2]   parameters.m1   Scalar(0.0825)   detail::sign(sum)   fma(sum, sum, sum)   (sum)
//
// In C the type's name replaces Scalar, and 0.0825 or 0.0825f the literal; there are parameters->m1 and arm_sign(sum);
// and a function that needs sines and cosines calls the one that takes them as arguments. In JavaScript no type is
// named; Math.sin(q[2]) and Math.sign(sum) may be factors. There is no other statement, and each is refused where it is
// not written: an entry of an output is written once, inputs are read before that, results are returned at the end.
//
// read_file() reads everything around the functions (file_contents.hpp).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "graph/function.hpp"
#include "readback/notation.hpp"
#include "readback/straight_line.hpp"
#include "readback/tokens.hpp"

namespace flatdyn {

// A function of the text: its tokens.
struct ScannedFunction {
  struct Parameter {
    std::string name;  // empty: unnamed
    bool is_output = false;
  };

  std::string name;
  std::string member_of;              // "Motion"
  std::string returns;                // "void", "bool", "Scalar", "float", "Motion"
  std::vector<Parameter> parameters;  // arrays, the robot's parameters and stages; not sin_cos
  std::size_t begin = 0, end = 0;     // tokens of the body, without its braces
};

// A constant of the text that counts joints, positions or angles.
struct ScannedCount {
  std::string name;  // "joint_count", "ARM_JOINT_COUNT"
  int value = 0;
};

class EmittedText {
 public:
  // A header, followed by its source if there is one, or a module. `scalar`: the type of variables, which tells the
  // language: "Scalar" in C++, "double" or "float" in C, "number" in JavaScript. Throws Failure(bug) if the emitter
  // cannot have written the text.
  explicit EmittedText(const std::string& text, const std::string& scalar = "Scalar");

  // The type to which constants are rounded: "double" or "float". C++ is printed with constants in double.
  const std::string& constants() const { return notation_.constants; }

  // The functions of the robot's namespace, in their order, members of stages included.
  const std::vector<ScannedFunction>& functions() const { return functions_; }

  const std::vector<Token>& tokens() const { return tokens_; }
  // The parts that these functions call, by name.
  const std::map<std::string, ScannedFunction>& parts() const { return parts_; }
  // The count "joint_count", "position_count" or "angle_count"; nullptr: there is none.
  const ScannedCount* count(const std::string& name) const;

  // Function k as it is executed, with the outputs of `like`. Throws Failure(bug) if the text is not such a function.
  StraightLine operations(std::size_t k, const Function& like) const;

  // Function k as the graph of what it computes, with the outputs and conditions of `like`. Throws Failure(bug) if the
  // text is not such a function.
  Function read(std::size_t k, const Function& like) const;

 private:
  friend class TextReader;
  ScannedFunction as_called(std::size_t k, const Function& like) const;

  EmittedNotation notation_;
  std::vector<Token> tokens_;
  std::vector<ScannedFunction> functions_;
  std::map<std::string, ScannedFunction> parts_;
  std::map<std::string, std::vector<std::string>> fields_;  // fields of structs, by name
  std::map<std::string, ScannedCount> counts_;
};

// The function with every constant as it is printed: rounded to the nearest double, and for "float" once more. It lacks
// what is not printed: entries left out, and conditions that always hold. A condition with a scale is 1/64 of the
// pivot, as in scale + pivot / 64 - scale.
Function as_printed(const Function& function, const std::string& scalar = "double");

}  // namespace flatdyn
