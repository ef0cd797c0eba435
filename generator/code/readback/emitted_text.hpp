// SPDX-License-Identifier: GPL-2.0-or-later
// Emitted code, read back. Properties of a graph hold for the text that people compile only if the text says the same;
// so it is read by a parser that shares nothing with the printer, and compared.
//
// The grammar of statements is body_parser.hpp's, with a table for each language (language_reader.hpp); execution.hpp
// carries them out and refuses each where it is not written.
//
// read_file() reads everything around the functions (file_contents.hpp).
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "code/readback/straight_line.hpp"
#include "code/readback/tokens.hpp"
#include "graph/function.hpp"

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

class LanguageReader;
using AnyLanguageReader = std::shared_ptr<const LanguageReader>;

class EmittedText {
 public:
  // A header, followed by its source if there is one, or a module, in the reader's language. Throws Failure(bug) if the
  // emitter cannot have written the text.
  EmittedText(const std::string& text, AnyLanguageReader language);

  const LanguageReader& language() const { return *language_; }
  // The type of variables, "Scalar", and that of a function's verdict, "bool".
  const std::string& scalar() const { return scalar_; }
  const std::string& verdict() const { return verdict_; }
  // The type to which constants are rounded: "double" or "float". C++ is printed with constants in double.
  std::string constants() const;

  // The functions of the robot's namespace, in their order, members of stages included.
  const std::vector<ScannedFunction>& functions() const { return functions_; }

  const std::vector<Token>& tokens() const { return tokens_; }
  // The parts that these functions call, by name.
  const std::map<std::string, ScannedFunction>& parts() const { return parts_; }
  // The count "joint_count", "position_count" or "angle_count"; nullptr if there is none.
  const ScannedCount* count(const std::string& name) const;

  // The number of angles whose sines and cosines there are. Throws Failure(bug) if the text does not say it.
  const ScannedCount& count_of_angles() const;
  // The fields of a struct of this name; nullptr if there is no such struct.
  const std::vector<std::string>* fields(const std::string& structure) const;

  // Throws UnreadableText with the line of the token, or of the last one.
  [[noreturn]] void refuse(std::size_t token, const std::string& what) const;

  // Function k as it is executed, with the outputs of `like`. Throws Failure(bug) if the text is not such a function.
  StraightLine operations(std::size_t k, const Function& like) const;

  // Function k as the graph of what it computes, with the outputs and conditions of `like`. Throws Failure(bug) if the
  // text is not such a function.
  Function read(std::size_t k, const Function& like) const;

 private:
  ScannedFunction as_called(std::size_t k, const Function& like) const;

  AnyLanguageReader language_;
  std::string scalar_, verdict_;
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
