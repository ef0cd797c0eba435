// SPDX-License-Identifier: GPL-2.0-or-later
// The file of emitted JavaScript.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "code/languages/common/patterns_sines.hpp"
#include "code/languages/javascript/patterns.hpp"
#include "code/languages/javascript/read.hpp"
#include "code/readback/file_reader.hpp"

namespace flatdyn {
namespace {

class JavascriptFile : public FileReader {
 public:
  JavascriptFile(const EmittedText& text, const FileContents& contents) : FileReader(text, contents) {
    fill("parameters", contents.parameters.empty() ? "" : "parameters,");
  }

 private:
  void file() override {
    expect("'use strict';");
    constants();
    const bool has_sines = has_polynomials() && follows("function sine_of_turned(");
    if (has_sines) sines();
    if (contents_.is_module && !contents_.functions.empty()) expect(kJavascriptCheck);
    for (const FileFunction& each : contents_.functions) function(each);
    const bool asks_library = uses({"Math", ".", "sin"}) || uses({"Math", ".", "cos"});
    if (has_polynomials() && asks_library) fail("sines of the library");
    if (has_polynomials()) require_helper("sine_of_turned()", has_sines, uses({"sin", "("}) || uses({"cos", "("}));
    if (contents_.closing) {
      fill("closure", contents_.closing->closure);
      fill("step", contents_.closing->step);
      fill("rows", std::to_string(contents_.closing->rows));
      expect_on_lines(kJavascriptCloseLoops);
      exports_.emplace_back("close_loops");
    }
    expect(fmt::format("{} {{{}}};", contents_.is_module ? "export" : "return", fmt::join(exports_, ", ")));
    require_lengths_of_sines();
  }

  void sines() {
    SinesStyle style{false, "const"};
    style.one = "1";
    style.has_hexadecimals = false;
    fill(sines_holes(style));
    expect_on_lines(kJavascriptSineBegin);
    expect(reduction_pattern(false) + squares_pattern(false) + "let sine = 0;");
    expect("if ((quadrant & 1) === 0) {" + sine_polynomial_pattern(false) + "sine = " + sine_pattern(false));
    expect("} else {" + cosine_polynomial_pattern(false) + "sine = " + cosine_pattern(false) + "}");
    expect_on_lines(kJavascriptSines);
  }

  // Expects a pattern in which every return has its result on the same line.
  void expect_on_lines(const char* pattern) {
    const std::size_t begin = at_;
    expect(pattern);
    for (std::size_t k = begin; k + 1 < at_; ++k) {
      if (tokens_[k].text == "return" && tokens_[k + 1].line != tokens_[k].line) fail("a result on another line");
    }
  }

  void constants() {
    count("joint_count", contents_.joints);
    if (contents_.has_positions) expect(fmt::format("const position_count = {};", contents_.positions));
    if (contents_.velocities) {
      exports_.emplace_back("velocity_count");
      expect(fmt::format("const velocity_count = {};", *contents_.velocities));
    }
    for (const FileTable& each : contents_.tables) {
      if (each.name == "position_names") exports_.emplace_back("position_count");
      table(each);
    }
    if (contents_.base_count) count("base_parameter_count", *contents_.base_count);
    for (const FileTable& each : contents_.base_tables) table(each);
    if (!contents_.parameters.empty()) parameter_names();
  }

  void count(const char* name, int value) {
    expect(fmt::format("const {} = {};", name, value));
    exports_.emplace_back(name);
  }

  void table(const FileTable& table) {
    expect(fmt::format("const {} = [", table.name));
    take_entries(table, "];");
    exports_.push_back(table.name);
  }

  void take_real(double wanted) override {
    if (std::isinf(wanted)) {
      expect(wanted < 0 ? "-Infinity" : "Infinity");
    } else if (take_literal(0) != wanted) {
      fail("another number");
    }
  }

  void parameter_names() {
    expect("const parameter_names = [");
    for (std::size_t k = 0; k < contents_.parameters.size(); ++k) {
      if (k > 0) expect(",");
      const std::string quoted = take();
      if (quoted.size() < 2 || quoted.front() != '"') fail("a name expected");
      require_name_like(contents_.parameters[k], quoted.substr(1, quoted.size() - 2));
    }
    expect("];");
    exports_.emplace_back("parameter_names");
  }

  void function(const FileFunction& function) {
    for (const FileTable& each : function.zeros) table(each);
    while (follows_part(function.name)) part(function);
    const ScannedFunction& body = next_function();
    expect(fmt::format("function {}(", function.name));
    const char* before = "";
    std::vector<std::pair<std::string, int>> arrays;
    int inputs = 0;
    for (const EmittedParameter& parameter : parameters_of(function, contents_)) {
      expect(before);
      before = ",";
      const std::string name = take_name_like(parameter.name);
      if (parameter.kind != EmittedParameter::Kind::output && name != parameter.name) fail("another parameter");
      if (parameter.kind != EmittedParameter::Kind::parameters) arrays.emplace_back(name, parameter.length);
      inputs += parameter.kind == EmittedParameter::Kind::input ? 1 : 0;
    }
    expect(") {");
    if (contents_.is_module && !arrays.empty()) check_of_lengths(function.name, arrays, inputs);
    require_result(*function.function, body);
    take_body(body);
    exports_.push_back(function.name);
  }

  // Takes the statement that refuses arrays of other lengths.
  void check_of_lengths(const std::string& function, const std::vector<std::pair<std::string, int>>& arrays,
                        int inputs) {
    std::string conditions, names, lengths;
    for (const auto& [name, length] : arrays) {
      const bool is_first = names.empty();
      conditions += fmt::format("{}{}.length !== {}", is_first ? "" : " || ", name, length);
      names += (is_first ? "" : ", ") + name;
      lengths += (is_first ? "" : ", ") + std::to_string(length);
    }
    expect(fmt::format("if ({}) {{ check_lengths('{}', {{{}}}, [{}], {}); }}", conditions, function, names, lengths,
                       inputs));
  }

  bool follows_part(const std::string& owner) const {
    return is("function") && word(1).starts_with(owner + "_part") && text_.parts().count(word(1)) != 0;
  }

  // A function returns whether its result means something, a number, or nothing.
  void require_result(const Function& function, const ScannedFunction& body) {
    const bool returns = body.end > body.begin + 2 && tokens_[body.end - 3].text == "return";
    if (!returns_number(function) && returns == function.validity_conditions.empty()) fail("another result");
  }

  void part(const FileFunction& function) {
    expect("function");
    const std::string name = take();
    std::vector<std::string> possible = {"parameters"};
    for (const InputKind kind : function.function->inputs) possible.push_back(std::string(argument_row(kind).name));
    for (const char* each : {"sine", "cosine", "kept", "pivots", "result"}) possible.emplace_back(each);
    for (const std::string& output : names_of_outputs(function)) possible.push_back(output);
    expect("(");
    take_parameters_of_part(possible);
    expect("{");
    take_part_body(name);
  }

  // Arrays of sines are as long as there are angles.
  void require_lengths_of_sines() {
    const std::size_t end = at_;
    for (at_ = 0; at_ < end; ++at_) {
      if ((is("sine") || is("cosine")) && word(2) == "new") {
        ++at_;
        expect(fmt::format("= new Float64Array({})", contents_.angles));
      }
    }
    at_ = end;
  }

  std::vector<std::string> exports_;
};

}  // namespace

void JavascriptReader::read_file(const EmittedText& text, const FileContents& contents) const {
  JavascriptFile(text, contents).run();
}

AnyLanguageReader javascript_reader() { return std::make_shared<JavascriptReader>(); }

}  // namespace flatdyn
