// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/rust/read_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "code/languages/common/patterns_sines.hpp"
#include "code/languages/rust/patterns.hpp"
#include "code/languages/rust/read.hpp"
#include "code/readback/file_known_answer.hpp"

namespace flatdyn {
namespace {

std::string upper(std::string text) {
  for (char& c : text) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return text;
}

}  // namespace

RustFile::RustFile(const EmittedText& text, const FileContents& contents)
    : FileReader(text, contents), real_(contents.scalar == "float" ? "f32" : "f64") {
  fill_words_of_scalar();
  const bool has_parameters = !contents.parameters.empty();
  fill("real", real_);
  fill("position_count", std::to_string(contents.positions));
  fill("parameters", has_parameters ? "parameters," : "");
  fill("parameters_argument", has_parameters ? "parameters: &Parameters," : "");
  SinesStyle style{is_float(), "let", "; let"};
  style.has_hexadecimals = false;
  fill(sines_holes(style));
  if (!contents.closing) return;
  fill("closure", contents.closing->closure);
  fill("step", contents.closing->step);
  fill("rows", std::to_string(contents.closing->rows));
}

// The words that depend on the scalar: a row has the hole, the word for f64, and that for f32.
void RustFile::fill_words_of_scalar() {
  constexpr const char* kWords[][3] = {{"bits", "u64", "u32"},
                                       {"wide", "u128", "u64"},
                                       {"tiny_factor", "18014398509481984.0", "16777216.0"},
                                       {"places", "52", "23"},
                                       {"least", "1075", "150"},
                                       {"fraction", "0x000f_ffff_ffff_ffff", "0x007f_ffff"},
                                       {"hidden", "0x0010_0000_0000_0000", "0x0080_0000"},
                                       {"odd_or_even", "is_odd", "(1 - is_odd)"},
                                       {"behind", "54", "25"},
                                       {"pairs", "54", "25"},
                                       {"half_exponent", "- is_odd) / 2 - 26", "+ is_odd) / 2 - 12"},
                                       {"tiny_scale", "27", "12"},
                                       {"bias", "1023", "127"},
                                       {"to_sign", "62", "30"},
                                       {"most_angle", "1e5", "6400.0"},
                                       {"as_double", "x", "f64::from(x)"},
                                       {"hashed_bits", "bits", "u64::from(bits)"},
                                       {"hash_of_sines", kRightDoubleSines, kRightFloatSines},
                                       {"half_a_place", "0x3ca0_0100_0000_0000", "0x3380_0800"}};
  for (const auto& [hole, in_double, in_float] : kWords) fill(hole, is_float() ? in_float : in_double);
}

void RustFile::file() {
  is_without_std_ = accept("#![no_std]\n");
  expect(kRustAttributes);
  constants();
  if (!contents_.parameters.empty()) parameters();
  helpers();
  angles();
  for (const FileFunction& each : contents_.functions) function(each);
  if (contents_.closing) expect(kRustCloseLoops);
  known_answer();
  expect(kRustTestBegin);
  if (has_fma_) expect(kRustTestOfFused);
  expect(kRustTest);
  require_helpers();
  const std::string crate = tokens_.size() > at_ + 5 ? word(6) : "";
  if (crate.size() < 3 || crate.front() != '"') fail("the name of a crate expected");
  fill("crate", crate.substr(1, crate.size() - 2));
  expect(kRustManifest);
}

void RustFile::require_helpers() const {
  require_helper("sign()", has_sign_, uses({"sign", "("}));
  require_helper("sqrt()", has_sqrt_, uses({"sqrt", "("}));
  require_helper("multiply_add()", has_fma_, uses({"multiply_add", "("}));
  require_helper("sines_and_cosines()", has_sines_, uses({"sines_and_cosines", "("}));
  const bool needs_std = has_fma_ || (has_sines_ && !has_polynomials());
  if (is_without_std_ == needs_std) fail("std is asked for in vain, or not asked for");
}

void RustFile::constants() {
  count("joint_count", contents_.joints);
  if (contents_.has_positions) count("position_count", contents_.positions);
  if (contents_.velocities) count("velocity_count", *contents_.velocities);
  const bool has_angles = contents_.angles > contents_.positions;
  if (has_angles && follows("pub const ANGLE_COUNT")) count("angle_count", contents_.angles);
  for (const FileTable& each : contents_.tables) table(each);
  if (contents_.base_count) count("base_parameter_count", *contents_.base_count);
  for (const FileTable& each : contents_.base_tables) table(each);
}

void RustFile::count(const char* name, int value) {
  expect(fmt::format("pub const {}: usize = {};", upper(name), value));
}

void RustFile::table(const FileTable& table) {
  const std::string type = table.type == "Real"   ? real_
                           : table.type == "bool" ? "bool"
                           : table.type == "int"  ? "usize"
                                                  : "&str";
  expect(fmt::format("pub static {}: [{}; {}] = [", upper(table.name), type, upper(table.length)));
  take_entries(table, "];");
}

// Takes 0.5, or f64::INFINITY.
void RustFile::take_real(double wanted) {
  if (std::isinf(wanted)) {
    expect("$real$::" + std::string(wanted < 0 ? "NEG_INFINITY" : "INFINITY"));
    return;
  }
  const double found = take_literal(0);
  if (is_float() ? float(found) != float(wanted) : found != wanted) fail("another number");
}

void RustFile::take_flag(bool wanted) { expect(wanted ? "true" : "false"); }

void RustFile::parameters() {
  expect("#[derive(Clone, Copy, Debug, Default, PartialEq)]\npub struct Parameters {");
  for (const std::string& name : contents_.parameters) {
    expect("pub");
    take_name_like(name);
    expect(": $real$,");
  }
  expect("}");
}

void RustFile::helpers() {
  has_sign_ = accept(kRustSign);
  has_sqrt_ = accept(kRustSqrt);
  has_fma_ = accept(kRustMultiplyAdd);
  sines();
}

void RustFile::sines() {
  if (!has_polynomials()) {
    has_sines_ = accept(kRustLibrarySines);
    return;
  }
  has_sines_ = accept(kRustSineBegin);
  if (!has_sines_) return;
  expect(reduction_pattern(is_float()));
  expect(kRustSineReduced);
  expect(polynomials_pattern(is_float()));
  expect(kRustSineEnd);
  expect(is_float() ? kRustBitsForFloats : kRustBitsForDoubles);
  expect(kRustLargeAngles);
  expect(is_float() ? kRustLargeInFloat : kRustLargeInDouble);
  expect(kRustSines);
}

std::string RustFile::array_type(int length, bool is_output) const {
  return fmt::format("&{}[{}; {}]", is_output ? "mut " : "", real_, length);
}

// Takes the functions that multiply positions, if there are any.
void RustFile::angles() {
  while (is("fn") && (word(1) == "angles" || word(1).starts_with("angles_"))) {
    expect("fn");
    const std::string part = take();
    expect(fmt::format("(q: {}, angle: {}) {{", array_type(contents_.positions), array_type(contents_.angles, true)));
    take_part_body(part);
  }
}

// The function that takes sines and cosines; nullptr if there is none.
const ScannedFunction* RustFile::given_of(const FileFunction& function) const {
  const auto found = text_.parts().find(function.given);
  return found == text_.parts().end() ? nullptr : &found->second;
}

void RustFile::function(const FileFunction& function) {
  for (const FileTable& each : function.zeros) table(each);
  const ScannedFunction& body = next_function();
  while (is("fn") && word(1).starts_with(function.name + "_part")) part(function, body);
  signature(function, function.name, false, body);
  take_body(body);
  if (const ScannedFunction* given = given_of(function)) {
    signature(function, function.given, true, *given);
    take_part_body(given->name);
  }
}

// Takes the declaration of a function up to its brace. Where sines are taken, q is only if its values are read.
void RustFile::signature(const FileFunction& function, const std::string& name, bool takes_sines,
                         const ScannedFunction& body) {
  using Kind = EmittedParameter::Kind;
  const bool is_checked = !function.function->validity_conditions.empty();
  expect((is_checked ? "#[must_use]\npub fn " : "pub fn ") + name + "(");
  const char* before = "";
  const auto parameter = [&](const std::string& wanted, const std::string& type, bool is_output) {
    expect(before);
    before = ",";
    const std::string found = take_name_like(wanted);
    if (!is_output && found != wanted) fail("another parameter");
    require_used(body, found);
    expect(": " + type);
  };
  bool has_sines = !takes_sines;
  for (const EmittedParameter& each : parameters_of(function, contents_)) {
    if (!has_sines && each.kind != Kind::parameters) {
      has_sines = true;
      for (const char* array : {"sine", "cosine"}) parameter(array, array_type(contents_.angles), false);
    }
    const bool is_read = !takes_sines || each.kind != Kind::input || each.name != "q" || names(body, "q");
    if (!is_read) continue;
    const bool is_output = each.kind == Kind::output;
    parameter(each.name, each.kind == Kind::parameters ? "&Parameters" : array_type(each.length, is_output), is_output);
  }
  expect(is_checked ? ") -> bool {" : returns_number(*function.function) ? ") -> $real$ {" : ") {");
}

// A parameter that is not used is mentioned by let _ = qd; and no other one is.
void RustFile::require_used(const ScannedFunction& body, const std::string& name) const {
  std::size_t used = 0, mentioned = 0;
  for (std::size_t k = body.begin; k < body.end; ++k) {
    if (tokens_[k].text != name || is_member(k)) continue;
    const bool is_mentioned = k >= body.begin + 3 && tokens_[k - 1].text == "=" && tokens_[k - 2].text == "_";
    ++(is_mentioned ? mentioned : used);
  }
  if (mentioned > 1 || (mentioned == 1) != (used == 0)) fail(fmt::format("{} is not used, or mentioned in vain", name));
}

void RustFile::part(const FileFunction& function, const ScannedFunction& asking) {
  expect("fn");
  const std::string name = take();
  std::vector<std::string> possible = {"parameters: &Parameters"};
  for (const EmittedParameter& each : parameters_of(function, contents_)) {
    if (each.kind == EmittedParameter::Kind::input) possible.push_back(each.name + ": " + array_type(each.length));
  }
  for (const char* each : {"sine", "cosine"}) {
    possible.push_back(fmt::format("{}: {}", each, array_type(contents_.angles)));
  }
  std::vector<std::string> shared = arrays_of_sine_rounds();
  shared.insert(shared.end(), {"kept", "pivots"});
  for (const std::string& each : shared) {
    if (const std::string type = type_of_shared(each, given_of(function), asking); !type.empty()) {
      possible.push_back(fmt::format("{}: &mut {}", each, type));
    }
  }
  possible.push_back("result: " + array_type(1, true));
  for (std::size_t k = 0; k < function.function->outputs.size() && !returns_number(*function.function); ++k) {
    const int length = static_cast<int>(function.function->outputs[k].entries.size());
    possible.push_back(names_of_outputs_read().at(k) + ": " + array_type(length, true));
  }
  expect("(");
  take_parameters_of_part(possible);
  expect("{");
  take_part_body(name);
}

// The type of an array that the function declares for its parts: [f64; 12]. Empty: it declares none.
std::string RustFile::type_of_shared(const std::string& array, const ScannedFunction* given,
                                     const ScannedFunction& asking) const {
  const ScannedFunction& body = given != nullptr ? *given : asking;
  for (std::size_t k = body.begin; k + 6 < body.end; ++k) {
    const bool is_declared = tokens_[k].text == "mut" && tokens_[k + 1].text == array && tokens_[k + 2].text == "=";
    if (is_declared) return fmt::format("[{}; {}]", real_, tokens_[k + 6].text);
  }
  return "";
}

// Takes rounding_is_as_written() and what it calls.
void RustFile::known_answer() {
  std::vector<FileFunction> called;
  for (const FileFunction& each : contents_.functions) {
    if (!computes_angles(*each.function)) called.push_back(each);
  }
  const bool has_functions = !called.empty();
  if (has_functions) {
    expect(kRustFill);
    if (has_sines_) expect(kRustFillSines);
    expect(kRustHash);
    if (has_sines_ && has_polynomials()) expect(kRustSinesAreRight);
  }
  expect(kRustRounding);
  if (!has_functions) {
    expect("true }");
    return;
  }
  if (has_sines_ && has_polynomials()) expect("if !sines_are_right() { return false; }");
  expect("let mut hash = 14695981039346656037;");
  const auto filled = [this](const KnownInput& each) {
    expect(fmt::format("let mut {0} = [0.0; {1}]; fill(&mut {0}, black_box({2}));", each.name, each.length, each.seed));
  };
  for (const KnownInput& each : known_inputs(contents_)) filled(each);
  if (has_sines_) {
    expect(
        fmt::format("let mut sine = [0.0; {0}]; let mut cosine = [0.0; {0}]; fill_sines(&mut sine, &mut cosine, "
                    "black_box({1}));",
                    contents_.angles, kSeedOfTangents));
  }
  known_parameters();
  for (const FileFunction& each : called) known_call(each);
  expect("hash ==");
  if (!is_hash(take() + "u")) fail("a hash expected");
  expect("}");
}

void RustFile::known_parameters() {
  const std::vector<std::string>* names = text_.fields("Parameters");
  if (contents_.parameters.empty() || names == nullptr) return;
  for (std::size_t k = 0; k < names->size(); ++k) {
    expect(fmt::format("{} {}: symbol[{}]", k == 0 ? "let parameters = Parameters {" : ",", (*names)[k], k));
  }
  expect("};");
}

// Takes the call of a function, or of the one that takes its sines and cosines.
void RustFile::known_call(const FileFunction& file_function) {
  const Function& function = *file_function.function;
  std::vector<int> lengths;
  for (const EmittedParameter& each : parameters_of(file_function, contents_)) {
    if (each.kind == EmittedParameter::Kind::output) lengths.push_back(each.length);
  }
  const auto result = [&](std::size_t k) { return lengths.size() < 2 ? "result" : fmt::format("result_{}", k + 1); };
  for (std::size_t k = 0; k < lengths.size(); ++k) {
    expect(fmt::format("let mut {} = [0.0; {}];", result(k), lengths[k]));
    if (is_whole(function)) continue;
    expect(fmt::format("{} fill(&mut {}, {});", k + 1 < lengths.size() ? "let next =" : "", result(k),
                       k == 0 ? "0" : "next"));
  }
  const ScannedFunction* given = given_of(file_function);
  const std::vector<ScannedFunction::Parameter> parameters =
      given != nullptr ? given->parameters : scanned(file_function.name).parameters;
  std::string arguments;
  std::size_t output = 0;
  for (const ScannedFunction::Parameter& each : parameters) {
    arguments += arguments.empty() ? "&" : ", &";
    arguments += each.is_output ? "mut " + result(output++) : each.name;
  }
  const bool is_number = returns_number(function);
  const bool drops_verdict = !is_number && !function.validity_conditions.empty();
  expect(fmt::format("{} {}({}{}",
                     is_number       ? "let result = ["
                     : drops_verdict ? "let _ ="
                                     : "",
                     given != nullptr ? file_function.given : file_function.name, arguments, is_number ? ")];" : ");"));
  for (std::size_t k = 0; k < std::max<std::size_t>(lengths.size(), 1); ++k) {
    expect(fmt::format("hash = hash_of(&{}, hash);", result(k)));
  }
}

const ScannedFunction& RustFile::scanned(const std::string& name) const {
  const auto& functions = text_.functions();
  const auto found =
      std::find_if(functions.begin(), functions.end(), [&](const ScannedFunction& each) { return each.name == name; });
  if (found == functions.end()) fail("no function " + name);
  return *found;
}

void RustReader::read_file(const EmittedText& text, const FileContents& contents) const {
  RustFile(text, contents).run();
}

AnyLanguageReader rust_reader(const std::string& scalar) { return std::make_shared<RustReader>(scalar); }

}  // namespace flatdyn
