// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/cuda/read_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "code/languages/common/patterns_sines.hpp"
#include "code/languages/cpp/patterns.hpp"
#include "code/languages/cpp/read.hpp"
#include "code/languages/cuda/patterns.hpp"
#include "code/languages/cuda/read.hpp"

namespace flatdyn {
namespace {

// By entry: its place where zeros (-1) are left out and equal entries are there once.
std::vector<int> places_wanted(const Function& function, const Output& output) {
  std::vector<int> places;
  std::map<NodeId, int> numbers;
  for (std::size_t k = 0; k < output.entries.size(); ++k) {
    const bool is_left = !output.leaves_out(k) && !function.graph.is_zero(output.entries[k]);
    const int next = static_cast<int>(numbers.size());
    places.push_back(is_left ? numbers.emplace(output.entries[k], next).first->second : -1);
  }
  return places;
}

bool all_stay(const std::vector<int>& places) {
  int next = 0;
  return std::all_of(places.begin(), places.end(), [&next](int place) { return place == next++; });
}

}  // namespace

CudaFile::CudaFile(const EmittedText& text, const FileContents& contents) : CppFile(text, contents) {}

void CudaFile::file() {
  guard();
  expect(kCppStandard);
  expect(kCudaIncludes);
  flags();
  expect(kCudaHead);
  name_space();
  constants();
  cuda_helpers();
  for (const FileFunction& function : contents_.functions) cuda_function(function);
  kernels();
  loops(kCudaCloseLoops);
  expect("}\n#endif");
  require_helper("sign()", has_sign_, uses({"detail", "::", "sign"}));
  require_helper("sqrt()", has_sqrt_, uses({"detail", "::", "sqrt"}));
  require_helper("Excess", has_excess_, uses({"detail", "::", "Excess", "<", "Scalar"}));
  require_helper("MultiplyAdd", has_fma_, uses({"MultiplyAdd", "<", "Scalar", ">", "fma"}));
  require_helper("stored()", has_stored_, uses({"detail", "::", "stored"}));
  require_helper("LibrarySinCos", has_sines_, uses({"sin_cos"}) || uses({"DefaultSinCos", "(", ")", "("}));
}

// Takes the sines and cosines by polynomials.
void CudaFile::cuda_polynomials() {
  expect("namespace detail {");
  for (const bool is_float : {false, true}) {
    const std::string number = is_float ? "float" : "double";
    fill("sine_number", number);
    fill(sines_holes({is_float, "const " + number, ",", is_float ? "f" : ""}));
    expect(kCudaSineAndCosine);
    expect(sines_by_bits_pattern(is_float, {number, is_float ? "uint32_t" : "uint64_t"}));
  }
  expect(kCudaSinesOfJoints);
}

void CudaFile::cuda_helpers() {
  has_sign_ = accept(kCudaSign);
  has_sqrt_ = accept(kCudaSqrt);
  has_excess_ = accept(kCudaExcess);
  has_fma_ = accept(kCudaMultiplyAdd);
  has_stored_ = accept(kCudaStored);
  has_sines_ = accept(kCudaLibrarySines);
  if (has_sines_ && has_polynomials()) cuda_polynomials();
  if (has_sines_) expect(kCudaGivenSines);
  if (contents_.angles > contents_.positions) angles_part();
}

void CudaFile::angles_part() {
  if (!accept("namespace detail {")) return;
  expect("template <class Scalar, class In> FLATDYN_FUNCTION void");
  const std::string name = take();
  if (name != "angles") fail("no part of angles");
  expect("(In q, Scalar* angle) noexcept {");
  take_part_body(name);
  expect("}");
}

void CudaFile::cuda_function(const FileFunction& function) {
  for (const FileTable& each : function.zeros) table(each);
  const ScannedFunction& body = next_function();
  std::string head = "template <class Scalar";
  int inputs = 0, outputs = 0;
  for (const EmittedParameter& each : parameters_of(function, contents_)) {
    if (each.kind == EmittedParameter::Kind::input) head += fmt::format(", class In{}", ++inputs);
    if (each.kind == EmittedParameter::Kind::output) head += fmt::format(", class Out{}", ++outputs);
  }
  const bool has_sin_cos = accept(head + ", class SinCos = DefaultSinCos>");
  if (!has_sin_cos) expect(head + ">");
  expect(
      fmt::format("{}FLATDYN_FUNCTION {} {}(", not_discarded(function), returns_of(function, "Scalar"), function.name));
  kernels_.push_back(parameters_and_body(function, has_sin_cos, body));
}

CudaFile::Kernel CudaFile::parameters_and_body(const FileFunction& function, bool has_sin_cos,
                                               const ScannedFunction& body) {
  using Kind = EmittedParameter::Kind;
  Kernel kernel{&function, {}};
  bool is_first = true;
  int inputs = 0, outputs = 0;
  for (const EmittedParameter& parameter : parameters_of(function, contents_)) {
    if (!is_first) expect(",");
    is_first = false;
    expect(parameter.kind == Kind::parameters ? std::string("const Parameters<Scalar>&")
           : parameter.kind == Kind::input    ? fmt::format("In{}", ++inputs)
                                              : fmt::format("Out{}", ++outputs));
    const std::string name = parameter_name(parameter, &body);
    if (parameter.kind == Kind::output) kernel.outputs.push_back(name);
  }
  if (has_sin_cos) expect(is_first ? "const SinCos& sin_cos = {}" : ", const SinCos& sin_cos = {}");
  if (has_sin_cos != names(body, "sin_cos")) fail("sin_cos is not used");
  expect(") noexcept {");
  take_body(body);
  return kernel;
}

void CudaFile::kernels() {
  expect("namespace functions {");
  const std::size_t whole = contents_.kernel_parts.empty() ? kernels_.size() : contents_.kernel_parts.size();
  std::size_t first_part = whole;
  for (std::size_t k = 0; k < whole; ++k) {
    const int parts = contents_.kernel_parts.empty() ? 0 : contents_.kernel_parts[k];
    const std::vector<EmittedParameter> list = parameters_of(*kernels_[k].function, contents_);
    const bool is_empty = std::any_of(list.begin(), list.end(), [](const EmittedParameter& each) {
      return each.kind == EmittedParameter::Kind::output && each.length == 0;
    });
    if (!is_empty) kernel(k, first_part, parts);
    first_part += static_cast<std::size_t>(parts);
  }
  if (first_part != kernels_.size()) fail("parts of no function");
  expect("}");
}

void CudaFile::kernel(std::size_t k, std::size_t first_part, int parts) {
  const Kernel& kernel = kernels_[k];
  const FileFunction& function = *kernel.function;
  expect(fmt::format("struct {} {{ template <class Scalar> using Shape = {}(", function.name,
                     returns_of(function, "Scalar")));
  bool is_first = true;
  std::size_t output = 0;
  for (const EmittedParameter& parameter : parameters_of(function, contents_)) {
    if (!is_first) expect(",");
    is_first = false;
    if (parameter.kind == EmittedParameter::Kind::parameters) {
      expect("const Parameters<Scalar>&");
      continue;
    }
    const bool is_output = parameter.kind == EmittedParameter::Kind::output;
    if (!is_output && parameter.length == 0) {
      expect("decltype(nullptr)");
      continue;
    }
    shape_of_array(parameter, is_output ? kernel.outputs[output++] : parameter.name);
  }
  expect(");");
  expect(fmt::format("static constexpr int parts = {};", std::max(1, parts)));
  places(*function.function);
  expect("template <class Scalar, int part, class... Of> FLATDYN_MEMBER static auto call(const Of&... of) noexcept {");
  if (parts == 0) callee(function, 0);
  for (int part = 0; part < parts; ++part) {
    callee(*kernels_[first_part + static_cast<std::size_t>(part)].function, part);
  }
  expect("} };");
}

void CudaFile::callee(const FileFunction& function, int part) {
  expect(fmt::format("if constexpr (part == {}) return ::$namespace$::{}<Scalar>(of...);", part, function.name));
}

void CudaFile::places(const Function& function) {
  expect("template <int output> FLATDYN_MEMBER static constexpr int place(int entry) noexcept {");
  for (std::size_t k = 0; k < function.outputs.size(); ++k) {
    const std::vector<int> wanted = places_wanted(function, function.outputs[k]);
    if (all_stay(wanted)) continue;
    expect(fmt::format("if constexpr (output == {}) {{ constexpr int places[] = {{", k));
    expect(fmt::format("{} }}; return places[entry]; }}", fmt::join(wanted, ", ")));
  }
  expect("return entry; }");
}

namespace {

class CudaReader : public CppReader {
 public:
  void read_file(const EmittedText& text, const FileContents& contents) const override {
    CudaFile(text, contents).run();
  }
};

}  // namespace

AnyLanguageReader cuda_reader() { return std::make_shared<CudaReader>(); }

}  // namespace flatdyn
