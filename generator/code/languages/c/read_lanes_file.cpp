// SPDX-License-Identifier: GPL-2.0-or-later
// The file of functions over arrays of states, in C with vectors: each calls a function over vectors, whose lanes hold
// a state each, in a loop.
#include <fmt/format.h>

#include <algorithm>

#include "code/languages/c/patterns_lanes.hpp"
#include "code/languages/c/read.hpp"
#include "code/languages/c/read_body.hpp"
#include "code/languages/c/read_file.hpp"
#include "code/languages/common/patterns_sines.hpp"
#include "code/readback/patterns_flags.hpp"

namespace flatdyn {
namespace {

class LanesFile : public CFile {
 public:
  using CFile::CFile;

 private:
  void file() override {
    find_prefix();
    prefix_of_definitions_ = prefix_ + "lanes_";
    header();
    exported_ = prefix_;
    has_lengths_ = false;
    name_lanes();
    expect("#include \"$file$.h\"\n#include <math.h>\n#include <stddef.h>\n");
    expect(kNoFastMath);
    text_hash();
    helpers();
    angles();
    for (const FileFunction& each : contents_.functions) {
      definitions(each, "static");
      batch(each);
    }
    require_helper("sign()", has_sign_, uses({prefixed("sign")}));
    require_helper("excess()", has_excess_, uses({prefixed("excess")}));
    require_helper("sqrt()", has_sqrt_, uses({prefixed("sqrt")}));
    require_helper("sines_and_cosines()", has_sines_, uses({prefixed("sines_and_cosines")}));
  }

  // The header is that of functions of one state.
  std::string condition_type() const override { return scalar_ == contents_.scalar ? "bool" : scalar_ + "_mask"; }
  bool is_float() const { return contents_.scalar == "float"; }

  void name_lanes() {
    scalar_ = exported_ + "lanes";
    prefix_ = scalar_ + "_";
    fill("lanes", scalar_);
    fill("mask", condition_type());
    fill("integer", is_float() ? "int" : "long long");
    fill("first_halves", is_float() ? "0, 4, 1, 5" : "0, 2");
    fill("second_halves", is_float() ? "2, 6, 3, 7" : "1, 3");
    fill("reduced_angles", is_float() ? "6400" : "1e5");
    fill("next", is_float() ? "0x200001u" : "0x4000000000001u");
  }

  // Takes the hash of the text, or what stands for it until all texts are known.
  void text_hash() {
    expect("const char* $exported$text_hash(void) { return");
    const std::string hash = take();
    const bool is_whole = hash.size() > 2 && hash.front() == '"' && hash.back() == '"';
    if (!is_whole || hash.find_first_of("\\?\n") != std::string::npos) fail("a hash expected");
    expect("; }");
  }

  void helpers() {
    expect(kLanesTypes);
    has_sign_ = accept(kLanesSign);
    has_excess_ = accept(kLanesExcess);
    has_sqrt_ = accept(kLanesSqrt);
    has_sines_ = accept(kLanesReducedAngles);
    if (has_sines_) {
      expect(is_float() ? kLanesReductionOfFloats : kLanesReductionOfDoubles);
      polynomials();
      expect(kLanesSines);
    }
    expect(kLanesRows);
    expect(is_float() ? kLanesSquareOfFloats : kLanesSquareOfDoubles);
    expect(kLanesTransposes);
    const auto is_checked = [](const FileFunction& each) { return !each.function->validity_conditions.empty(); };
    if (!std::any_of(contents_.functions.begin(), contents_.functions.end(), is_checked)) return;
    fill("verdict", code::kValid);
    expect(kLanesNoNumber);
  }

  void polynomials() {
    SinesStyle style{is_float(), "const " + scalar_, ",", is_float() ? "f" : ""};
    style.cosine_polynomial = is_float() ? "p" : "k";
    fill(sines_holes(style));
    expect(kLanesSineNearZero);
    expect(is_float() ? "$let$ z = r * r, leading = 1.0f - 0.5f * z;"
                      : "$let$ z = r * r, zz = z * z, leading = 1.0 - 0.5 * z;");
    expect(sine_polynomial_pattern(is_float()) + "return " + sine_pattern(is_float()) + "}");
    expect(kLanesCosineNearZero);
    expect(squares_pattern(is_float()) + cosine_polynomial_pattern(is_float()));
    expect("return " + cosine_pattern(is_float()) + "}");
  }

  // An array of states, as the function over arrays has it.
  struct Rows {
    std::string name;
    int length = 0;
    bool is_partly_written = false;
  };

  // Takes the function over arrays of a function that has just been read.
  void batch(const FileFunction& function) {
    using Kind = EmittedParameter::Kind;
    const std::vector<std::string> names = names_of_outputs_read();
    std::vector<Rows> inputs, results;
    bool has_parameters = false;
    for (const EmittedParameter& each : parameters_of(function, contents_)) {
      has_parameters = has_parameters || each.kind == Kind::parameters;
      if (each.kind == Kind::input) inputs.push_back({each.name, each.length});
    }
    for (std::size_t k = 0; k < function.function->outputs.size(); ++k) {
      const Output& output = function.function->outputs[k];
      const bool returned = returns_number(*function.function);
      results.push_back({returned ? output.name : names.at(k), returned ? 1 : static_cast<int>(output.entries.size()),
                         !output.left_out.empty()});
    }
    signature(function, inputs, results, has_parameters);
    expect("for (size_t k = 0; k < count; k += $lanes$_count) { const size_t states = $lanes$_states(count - k);");
    blocks(inputs, results);
    for (const Rows& each : inputs) {
      expect(
          fmt::format("$lanes$_read({0} + {0}_step * k, {0}_step, states, {1}, {0}_block);", each.name, each.length));
    }
    call(function, inputs, results, has_parameters);
    for (const Rows& each : results) write_rows(function, each);
    expect("} }");
  }

  void signature(const FileFunction& function, const std::vector<Rows>& inputs, const std::vector<Rows>& results,
                 bool has_parameters) {
    std::string list = "size_t count";
    if (has_parameters) list += ", const $exported$parameters* parameters";
    for (const Rows& each : inputs) list += fmt::format(", const $real$* {0}, size_t {0}_step", each.name);
    for (const Rows& each : results) list += ", $real$* " + each.name;
    expect(fmt::format("void $exported${}_batch({}) {{", function.name, list));
  }

  void blocks(const std::vector<Rows>& inputs, const std::vector<Rows>& results) {
    std::string list;
    for (const Rows& each : inputs)
      list += fmt::format("{}{}_block[{}]", list.empty() ? "" : ", ", each.name, each.length);
    for (const Rows& each : results) {
      const char* const initial = each.is_partly_written ? " = {{0}}" : "";
      list += fmt::format("{}{}_block[{}]", list.empty() ? "" : ", ", each.name, each.length) + initial;
    }
    expect("$lanes$ " + list + ";");
  }

  void call(const FileFunction& function, const std::vector<Rows>& inputs, const std::vector<Rows>& results,
            bool has_parameters) {
    std::string list = has_parameters ? "parameters" : "";
    const bool returned = returns_number(*function.function);
    const auto add = [&list](const Rows& rows) { list += (list.empty() ? "" : ", ") + rows.name + "_block"; };
    for (const Rows& each : inputs) add(each);
    for (std::size_t k = 0; k < results.size() && !returned; ++k) add(results[k]);
    if (returned) expect(results[0].name + "_block[0] =");
    if (!function.function->validity_conditions.empty()) {
      expect("const $mask$");
      verdict_ = take();
      if (verdict_ != code::kValid) fail("an unknown verdict");
      expect("=");
    }
    expect(fmt::format("{}({});", prefixed(function.name), list));
  }

  // A row whose result means nothing is NaN.
  void write_rows(const FileFunction& function, const Rows& rows) {
    if (!function.function->validity_conditions.empty()) {
      expect(fmt::format("$lanes$_or_not_a_number({}, {}, {}_block);", verdict_, rows.length, rows.name));
    }
    expect(fmt::format("$lanes$_write({0}_block, states, {1}, {0} + {1} * k);", rows.name, rows.length));
  }

  bool has_sign_ = false, has_excess_ = false, has_sqrt_ = false, has_sines_ = false;
  std::string exported_, verdict_;
};

// Vectors with a lane for each state: arm_lanes_all(0.0825), arm_lanes_all(parameters->m_1), arm_lanes_sqrt(x).
class LanesBodyParser : public CBodyParser {
 public:
  using CBodyParser::CBodyParser;

 private:
  code::Expression factor() override {
    if (word() == spread()) return same_in_all_lanes();
    const bool is_fused = word().ends_with("_fma") && word(1) == "(";
    if (is_number() || is_fused || word(1) == "->") fail("a number of one state");
    return CBodyParser::factor();
  }

  code::Expression same_in_all_lanes() {
    expect_all({spread().c_str(), "("});
    code::Expression value =
        is(code::kParameters) ? CBodyParser::factor() : code::Expression(signed_literal(is_float()));
    expect(")");
    return value;
  }

  void whole_literal(const char* wanted) override {
    expect_all({spread().c_str(), "("});
    CBodyParser::whole_literal(wanted);
    expect(")");
  }
  std::size_t tokens_of_literal() const override { return 4; }

  // Reads ~(arm_lanes_mask){0}.
  bool accept_always() override {
    if (!accept("~")) return false;
    expect_all({"(", text_.verdict().c_str(), ")", "{", "0", "}"});
    return true;
  }

  std::string root() const override { return text_.scalar() + "_sqrt"; }
  std::string spread() const { return text_.scalar() + "_all"; }
};

class LanesReader : public CReader {
 public:
  using CReader::CReader;
  std::string scalar(const ScannedText& found) const override { return found.lanes; }
  std::string verdict(const ScannedText& found) const override { return found.lanes + "_mask"; }
  std::unique_ptr<BodyParser> body_parser(const EmittedText& text) const override {
    return std::make_unique<LanesBodyParser>(text, number());
  }
  void read_file(const EmittedText& text, const FileContents& contents) const override {
    LanesFile(text, contents).run();
  }
};

}  // namespace

AnyLanguageReader lanes_reader(const std::string& scalar) { return std::make_shared<LanesReader>(scalar); }

}  // namespace flatdyn
