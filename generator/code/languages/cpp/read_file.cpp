// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/cpp/read_file.hpp"

#include <fmt/format.h>

#include <cmath>

#include "code/languages/common/patterns_sines.hpp"
#include "code/languages/cpp/patterns.hpp"
#include "code/languages/cpp/patterns_limbs.hpp"
#include "code/languages/cpp/read.hpp"
#include "code/languages/cpp/read_body.hpp"
#include "code/readback/file_known_answer.hpp"
#include "code/readback/patterns_flags.hpp"
#include "flatdyn/interface.hpp"

namespace flatdyn {

CppFile::CppFile(const EmittedText& text, const FileContents& contents) : FileReader(text, contents) {
  const bool has_parameters = !contents.parameters.empty();
  fill("real", contents.scalar);
  fill("interface", std::to_string(kInterface));
  fill("parameters", has_parameters ? "parameters," : "");
  fill("parameters_argument", has_parameters ? "const Parameters<Scalar>& parameters," : "");
  fill("hash_of_sines", kRightDoubleSines);
  fill("hash_of_float_sines", kRightFloatSines);
  fill("file", contents.file_name);
  fill("default_sines", has_polynomials() ? "PolynomialSinCos" : "LibrarySinCos");
}

void CppFile::file() {
  header();
  if (is_pair()) source();
  require_helper("sign()", has_sign_, uses({"detail", "::", "sign"}));
  require_helper("sqrt()", has_sqrt_, uses({"detail", "::", "sqrt"}));
  require_helper("Zeros", has_zeros_, uses({"detail", "::", "Zeros", "::", "store"}));
  require_helper("Excess", has_excess_, uses({"detail", "::", "Excess", "<", "Scalar"}));
  require_helper("MultiplyAdd", has_fma_, uses({"MultiplyAdd", "<", "Scalar", ">", "fma"}));
  require_helper("Limbs", has_limbs_, uses({"detail", "::", "Limbs", "<", "Scalar"}));
  require_helper("LibrarySinCos", has_sines_, uses({"sin_cos"}) || uses({"DefaultSinCos", "(", ")", "("}));
}

// Takes the sines and cosines by polynomials.
void CppFile::polynomials() {
  expect(kCppTypesOfSines);
  for (const bool is_float : {false, true}) {
    const std::string number = is_float ? "Floats" : "Doubles";
    fill("sine_number", number);
    fill(sines_holes({is_float, "const " + number, ",", is_float ? "f" : ""}));
    expect(kCppSineAndCosine);
    expect(sines_by_bits_pattern(is_float, {number, "BitsOf" + number, false}));
  }
  expect(kCppSinesOfJoints);
}

void CppFile::guard() {
  constexpr const char* kIf = "#ifndef ";
  const std::string guard = take();
  if (!guard.starts_with(std::string(kIf) + "FLATDYN_")) fail("a guard expected");
  fill("guard", guard.substr(std::string(kIf).size()));
  expect("#define $guard$\n");
}

void CppFile::flags() {
  expect(kNoFastMath);
  if (contents_.scalar != "float") expect(kCppDoubleConstants);
}

void CppFile::name_space() {
  fill("namespace", contents_.name_spaces.front());
  for (const std::string& name_space : contents_.name_spaces) {
    if (follows("namespace " + name_space + " {")) fill("namespace", name_space);
  }
  expect("namespace $namespace$ {");
}

void CppFile::header() {
  guard();
  expect(kCppStandard);
  if (!is_pair()) expect(kCppRoundingIncludes);
  expect("#include <cmath>\n");
  if (!is_pair()) flags();
  name_space();
  constants();
  helpers();
  for (const FileFunction& function : contents_.functions) header_function(function);
  if (!contents_.stages.empty()) stages();
  refusals();
  shapes();
  loops(kCppCloseLoops);
  rounding();
  if (is_pair()) instances("extern template");
  expect("}\n#endif");
}

void CppFile::source() {
  expect("#include \"$file$.hpp\"\n");
  expect(kCppRoundingIncludes);
  flags();
  expect("namespace $namespace$ {");
  has_sign_ = accept(kCppSign);
  has_sqrt_ = accept(kCppSqrt);
  has_zeros_ = accept(kCppZeros);
  has_excess_ = accept(kCppExcess);
  has_fma_ = accept(kCppMultiplyAdd);
  has_limbs_ = accept(kCppLimbs);
  if (has_sines_ && has_polynomials()) {
    polynomials();
    expect(kCppPolynomialSinesDefined);
  }
  if (contents_.angles > contents_.positions) parts({nullptr, "angles"});
  for (const FileFunction& function : contents_.functions) {
    parts(function);
    definition(function);
  }
  for (const FileFunction* function : staged_functions()) {
    parts(*function);
    definition(*function);
  }
  rounding_helpers();
  expect("template <class Scalar> bool rounding_is_as_written() noexcept");
  known_answer();
  instances("template");
  expect("}");
}

void CppFile::constants() {
  expect("using Real = $real$;");
  count("joint_count", contents_.joints);
  if (contents_.has_positions) count("position_count", contents_.positions);
  if (contents_.velocities) count("velocity_count", *contents_.velocities);
  if (contents_.angles > contents_.positions && follows("inline constexpr int angle_count")) {
    count("angle_count", contents_.angles);
  }
  for (const FileTable& each : contents_.tables) table(each);
  if (contents_.base_count) count("base_parameter_count", *contents_.base_count);
  for (const FileTable& each : contents_.base_tables) table(each);
  if (!contents_.parameters.empty()) parameters();
}

void CppFile::count(const char* name, int value) { expect(fmt::format("inline constexpr int {} = {};", name, value)); }

void CppFile::table(const FileTable& table) {
  expect(fmt::format("inline constexpr {} {}[{}] = {{", table.type, table.name, table.length));
  take_entries(table, "};");
}

// Takes Real(0.5) or Real(-HUGE_VAL).
void CppFile::take_real(double wanted) {
  expect("Real(");
  if (std::isinf(wanted)) {
    expect(wanted < 0 ? "-HUGE_VAL" : "HUGE_VAL");
  } else if (take_literal(0) != wanted) {
    fail("another number");
  }
  expect(")");
}

void CppFile::parameters() {
  expect("template <class Scalar = Real> struct Parameters {");
  for (const std::string& name : contents_.parameters) {
    expect("Scalar");
    take_name_like(name);
    expect(";");
  }
  expect("};");
}

void CppFile::helpers() {
  if (!is_pair()) {
    has_sign_ = accept(kCppSign);
    has_sqrt_ = accept(kCppSqrt);
    has_zeros_ = accept(kCppZeros);
    has_excess_ = accept(kCppExcess);
    has_fma_ = accept(kCppMultiplyAdd);
    has_limbs_ = accept(kCppLimbs);
    expect(kCppInterface);
  }
  has_sines_ = accept(kCppLibrarySines);
  if (has_sines_ && has_polynomials()) {
    if (!is_pair()) polynomials();
    expect(is_pair() ? kCppPolynomialSinesDeclared : kCppPolynomialSines);
  }
  if (has_sines_) expect(kCppGivenSines);
  if (!is_pair() && contents_.angles > contents_.positions) parts({nullptr, "angles"});
}

// Takes the declarations that are found where objects stand in place of arrays.
void CppFile::refusals() {
  std::vector<std::string> names;
  for (const FileFunction& function : contents_.functions) names.push_back(function.name);
  if (!contents_.stages.empty()) names.push_back(contents_.stages.front().make.name);
  if (names.empty()) return;
  expect(kCppObjectArguments);
  for (const std::string& name : names) {
    expect(fmt::format("template <class... Of> detail::IfObjects<Of...> {}(const Of&...);", name));
  }
}

void CppFile::loops(const char* close_loops) {
  if (!contents_.closing) return;
  fill("closure", contents_.closing->closure);
  fill("step", contents_.closing->step);
  fill("rows", std::to_string(contents_.closing->rows));
  expect(close_loops);
}

void CppFile::rounding() {
  if (is_pair()) {
    expect("template <class Scalar = Real> [[nodiscard]] bool rounding_is_as_written() noexcept;");
    return;
  }
  rounding_helpers();
  expect("template <class Scalar = Real> [[nodiscard]] static bool rounding_is_as_written() noexcept");
  known_answer();
}

void CppFile::rounding_helpers() {
  expect(kCppRoundingHelpers);
  if (has_sines_) expect(has_polynomials() ? kCppPolynomialsAreRight : kCppLibraryIsRight);
  expect("}");
}

// Takes the statements of rounding_is_as_written().
void CppFile::known_answer() {
  KnownAnswerWords words{"Scalar", "detail::", "Parameters<Scalar>", "GivenSinCos<Scalar>", false};
  std::vector<KnownCall> calls;
  for (const Known& known : known_) {
    if (!known.stage.empty() || computes_angles(*known.function->function)) continue;
    words.asks_sines = words.asks_sines || known.has_sin_cos;
    KnownCall call{known.function, known.function->name, {}};
    for (const EmittedParameter& each : parameters_of(*known.function, contents_)) {
      call.arguments.push_back(each.kind == EmittedParameter::Kind::output ? "" : each.name);
    }
    if (known.has_sin_cos) call.arguments.emplace_back("given");
    calls.push_back(std::move(call));
  }
  expect(kCppRounding);
  if (calls.empty()) {
    expect("return true; }");
    return;
  }
  if (has_sines_) expect("if (!detail::sines_are_right<Scalar>()) return false;");
  expect(kCppKnownState);
  expect(known_answer_pattern(contents_, calls, words));
  expect("return hash == (is_float ?");
  if (!is_hash(take())) fail("a hash expected");
  expect(":");
  if (!is_hash(take())) fail("a hash expected");
  expect("); }");
}

std::unique_ptr<BodyParser> CppReader::body_parser(const EmittedText& text) const {
  return std::make_unique<CppBodyParser>(text);
}

void CppReader::read_file(const EmittedText& text, const FileContents& contents) const {
  CppFile(text, contents).run();
}

AnyLanguageReader cpp_reader() { return std::make_shared<CppReader>(); }

}  // namespace flatdyn
