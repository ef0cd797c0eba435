// SPDX-License-Identifier: GPL-2.0-or-later
// The differences between languages beyond the text of functions: sections of a page, and the files that it is for.
#pragma once

#include <kainjow/mustache.hpp>
#include <string>
#include <vector>

#include "code/emit/dialect.hpp"
#include "code/emit/emit_options.hpp"
#include "code/emit/function_text.hpp"
#include "code/emit/stage_text.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// A file of the emitted code before it is filled in.
struct FileTemplate {
  std::string ending;  // ".hpp"
  const char* text = nullptr;
};

// Everything that is known once all functions are written.
struct CodeContent {
  const Mechanism& mechanism;
  const std::vector<Function>& functions;
  const EmitOptions& options;
  const HeaderScope& scope;
  std::string name_space, file_name;   // the file's name has no ending
  std::vector<FunctionText> texts{};   // by function
  std::vector<StageText> stages{};     // empty: none were asked for
  std::vector<std::string> exports{};  // the names that the text exports, in order
  bool uses_sign = false, uses_sqrt = false, uses_excess = false, uses_fma = false, uses_trigonometry = false,
       uses_limbs = false, uses_zeros = false;
};

class PageDialect : public Dialect {
 public:
  using Dialect::Dialect;

  // The header, and the source if there is one.
  virtual std::vector<FileTemplate> files() const = 0;
  // Whether an output may overlap an input, since all inputs are read first; the page says so.
  virtual bool outputs_may_overlap_inputs() const { return false; }
  // Whether the text has the hash of its functions' results at a known state.
  virtual bool has_known_answer() const { return false; }
  // A member of the parameters with its unit: "m_1;  // kg", in JavaScript "m_1 - kg".
  virtual std::string member(const std::string& name, const std::string& unit) const;
  // Fills in what the language's templates need of a function, in addition to what all need.
  virtual void write_function(kainjow::mustache::data& item, const Function& function,
                              const FunctionText& text) const = 0;
  // Fills in what they need in addition to functions. It comes last.
  virtual void write_page(kainjow::mustache::data& page, const CodeContent& content) const = 0;
};

}  // namespace flatdyn
