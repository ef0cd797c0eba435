// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/c/read_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "code/languages/c/patterns.hpp"
#include "code/languages/c/read.hpp"
#include "code/languages/c/read_body.hpp"
#include "code/languages/common/patterns_sines.hpp"
#include "code/languages/cpp/patterns.hpp"
#include "code/readback/file_known_answer.hpp"
#include "code/readback/patterns_flags.hpp"

namespace flatdyn {
namespace {

std::string in_capital_letters(std::string text) {
  for (char& c : text) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return text;
}

// The beginning of names for a namespace: "acme::arm_" → "acme_arm_".
std::string prefix_of_names(const std::string& name_space) {
  std::string prefix;
  for (const char c : name_space + "::") {
    const bool is_next = !prefix.empty() && prefix.back() == '_';
    if (c != ':') {
      prefix += c;
    } else if (!is_next) {
      prefix += '_';
    }
  }
  while (prefix.ends_with("__")) prefix.pop_back();
  return prefix;
}

}  // namespace

CFile::CFile(const EmittedText& text, const FileContents& contents) : FileReader(text, contents) {
  const bool is_float = contents.scalar == "float";
  scalar_ = contents.scalar;
  fill("real", contents.scalar);
  fill("f", is_float ? "f" : "");
  fill("F", is_float ? "F" : "");
  fill("floats_bit", is_float ? "4" : "8");
  fill("floats_length", is_float ? "32" : "64");
  fill("file", contents.file_name);
  fill("half_a_place", is_float ? "0x1.001p-24f" : "0x1.001p-53");
  fill("smallest", is_float ? "0x1p-126f" : "0x1p-1022");
  fill("or_double", is_float ? "" : "&& method != 1");
  fill("bits", is_float ? "uint32_t" : "uint64_t");
  fill("signed_bits", is_float ? "int32_t" : "int64_t");
  fill("most_angle", is_float ? "6400.0f" : "1e5");
  fill("hash_of_sines", is_float ? kRightFloatSines : kRightDoubleSines);
  fill("places", is_float ? "8388608.0f" : "4503599627370496.0");
}

void CFile::find_prefix() {
  for (const std::string& name_space : contents_.name_spaces) {
    const ScannedCount* count = text_.count("joint_count");
    prefix_ = prefix_of_names(name_space);
    if (count != nullptr && count->name == count_name("joint_count")) break;
  }
  prefix_of_definitions_ = prefix_;
  fill("prefix", prefix_);
  fill("exported", prefix_);
  fill("positions", count_name("position_count"));
  fill("nodiscard", count_name("nodiscard"));
  fill("position_count", std::to_string(contents_.positions));
  const bool has_parameters = !contents_.parameters.empty();
  fill("parameters", has_parameters ? "parameters," : "");
  fill("parameters_argument", has_parameters ? fmt::format("const {}parameters* parameters,", prefix_) : "");
  if (!contents_.closing) return;
  fill("closure", prefixed(contents_.closing->closure));
  fill("step", prefixed(contents_.closing->step));
  fill("rows", std::to_string(contents_.closing->rows));
}

std::string CFile::count_name(const std::string& name) const { return in_capital_letters(prefix_ + name); }

void CFile::file() {
  find_prefix();
  header();
  source();
  require_helper("sign()", has_sign_, uses({prefixed("sign")}));
  require_helper("excess()", has_excess_, uses({prefixed("excess")}));
  require_helper("sines_and_cosines()", has_sines_, uses({prefixed("sines_and_cosines")}));
  require_helper("fma()", has_fma_, uses({prefixed("fma")}));
  require_helper("<math.h>", has_math_,
                 has_sines_ || has_limits_missing_ || has_fma_ || uses({"sqrt"}) || uses({"sqrtf"}));
}

void CFile::header() {
  constexpr const char* kIf = "#ifndef ";
  const std::string guard = take();
  if (!guard.starts_with(std::string(kIf) + "FLATDYN_")) fail("a guard expected");
  fill("guard", guard.substr(std::string(kIf).size()));
  expect("#define $guard$\n");
  expect(kCStandard);
  counts();
  for (const FileTable& each : contents_.tables) declare(each);
  if (contents_.base_count) count("base_parameter_count", *contents_.base_count);
  for (const FileTable& each : contents_.base_tables) declare(each);
  if (!contents_.parameters.empty()) parameters();
  for (const FileFunction& each : contents_.functions) declarations(each);
  if (contents_.closing) {
    expect(
        "$nodiscard$ bool $prefix$close_loops($parameters_argument$ $real$ q[$position_count$], $real$ tolerance, int "
        "most_steps);");
  }
  expect("$nodiscard$ bool $prefix$rounding_is_as_written(void);\n#ifdef __cplusplus\n}\n#endif\n#endif");
}

void CFile::source() {
  expect("#define $nodiscard$\n#include \"$file$.h\"\n#include <float.h>\n");
  has_math_ = accept("#include <math.h>\n");
  expect("#include <stdint.h>\n#include <string.h>\n");
  expect(kNoFastMath);
  if (contents_.scalar != "float") expect(kCDoubleConstants);
  for (const FileTable& each : contents_.tables) define(each);
  for (const FileTable& each : contents_.base_tables) define(each);
  has_sign_ = accept(kCSign);
  has_excess_ = accept(kCExcess);
  has_fma_ = accept(kCMultiplyAdd);
  sines();
  angles();
  for (const FileFunction& each : contents_.functions) {
    for (const FileTable& zeros : each.zeros) define(zeros);
    definitions(each, "");
  }
  if (contents_.closing) expect(kCCloseLoops);
  known_answer();
}

void CFile::sines() {
  if (!has_polynomials()) {
    has_sines_ = accept(kCLibrarySines);
    return;
  }
  has_sines_ = accept(kCSineAndCosine);
  if (!has_sines_) return;
  const bool is_float = contents_.scalar == "float";
  fill(sines_holes({is_float, "const " + scalar_, ",", is_float ? "f" : ""}));
  expect(sines_by_bits_pattern(is_float, {scalar_, is_float ? "uint32_t" : "uint64_t", true, "(void)memcpy", ""}));
  expect(kCPolynomialSines);
}

// Takes rounding_is_as_written() and what it calls.
void CFile::known_answer() {
  std::vector<KnownCall> calls;
  for (const FileFunction& function : contents_.functions) {
    if (!computes_angles(*function.function)) calls.push_back(known_call(function));
  }
  expect(kCIsZero);
  if (!calls.empty()) {
    expect(kCFill);
    if (has_sines_) expect(kCFillSines);
    expect(kCHash);
    if (has_sines_) expect(has_polynomials() ? kCPolynomialsAreRight : kCLibraryIsRight);
  }
  expect(kCRounding);
  if (calls.empty()) {
    expect("return true; }");
    return;
  }
  if (has_sines_) expect("if (!$prefix$sines_are_right()) return false;");
  expect(kCKnownState);
  expect(known_answer_pattern(contents_, calls, {"$real$", "$prefix$", "$prefix$parameters", "", has_sines_}));
  expect("return hash ==");
  if (!is_hash(take())) fail("a hash expected");
  expect("; }");
}

// The call of the function, or of the one that takes its sines and cosines.
KnownCall CFile::known_call(const FileFunction& function) const {
  const ScannedFunction* given = given_of(function);
  KnownCall call{&function, prefixed(given != nullptr ? function.given : function.name), {}};
  for (const ScannedFunction::Parameter& each : given != nullptr ? given->parameters : scanned(function).parameters) {
    call.arguments.push_back(each.is_output ? "" : each.name == "parameters" ? "&parameters" : each.name);
  }
  return call;
}

const ScannedFunction& CFile::scanned(const FileFunction& function) const {
  const auto& functions = text_.functions();
  const auto found = std::find_if(functions.begin(), functions.end(),
                                  [&](const ScannedFunction& each) { return each.name == prefixed(function.name); });
  if (found == functions.end()) fail("no function " + function.name);
  return *found;
}

void CFile::counts() {
  count("joint_count", contents_.joints);
  if (contents_.has_positions) count("position_count", contents_.positions);
  if (contents_.velocities) count("velocity_count", *contents_.velocities);
  const bool has_angles = contents_.angles > contents_.positions;
  if (has_angles && follows("enum { " + count_name("angle_count"))) count("angle_count", contents_.angles);
}

void CFile::count(const char* name, int value) { expect(fmt::format("enum {{ {} = {} }};", count_name(name), value)); }

std::string CFile::type_of(const FileTable& table) const {
  if (table.type == "Real") return "const " + contents_.scalar;
  return table.type.ends_with('*') ? table.type + " const" : "const " + table.type;
}

std::string CFile::length_of(const FileTable& table) const {
  const bool is_number = table.length.find_first_not_of("0123456789") == std::string::npos;
  return is_number ? table.length : count_name(table.length);
}

void CFile::declare(const FileTable& table) {
  expect(fmt::format("extern {} {}[{}];", type_of(table), prefixed(table.name), length_of(table)));
}

void CFile::define(const FileTable& table) {
  expect(fmt::format("{} {}[{}] = {{", type_of(table), prefixed(table.name), length_of(table)));
  take_entries(table, "};");
}

// Takes 0.5, in float 0.5f, or -HUGE_VAL.
void CFile::take_real(double wanted) {
  const bool is_float = contents_.scalar == "float";
  if (std::isinf(wanted)) {
    has_limits_missing_ = true;
    expect(std::string(wanted < 0 ? "-" : "") + (is_float ? "HUGE_VALF" : "HUGE_VAL"));
  } else if (is_float ? float(take_literal('f')) != float(wanted) : take_literal(0) != wanted) {
    fail("another number");
  }
}

void CFile::parameters() {
  expect("typedef struct {");
  for (const std::string& name : contents_.parameters) {
    expect("$real$");
    take_name_like(name);
    expect(";");
  }
  expect("} $prefix$parameters;");
}

std::unique_ptr<BodyParser> CReader::body_parser(const EmittedText& text) const {
  return std::make_unique<CBodyParser>(text, number_);
}

void CReader::read_file(const EmittedText& text, const FileContents& contents) const { CFile(text, contents).run(); }

AnyLanguageReader c_reader(const std::string& scalar) { return std::make_shared<CReader>(scalar); }

}  // namespace flatdyn
