// SPDX-License-Identifier: GPL-2.0-or-later
// The functions of emitted C++: signatures, parts, stages.
#include <fmt/format.h>

#include <algorithm>

#include "code/languages/cpp/read_file.hpp"

namespace flatdyn {

std::string CppFile::returns_of(const FileFunction& function, const std::string& scalar) const {
  if (!function.made.empty()) return fmt::format("{}<{}>", function.made, scalar);
  if (returns_number(*function.function)) return scalar;
  return function.function->validity_conditions.empty() ? "void" : "bool";
}

// [[nodiscard]], which the first declaration of a function that returns bool has.
std::string CppFile::not_discarded(const FileFunction& function) const {
  return returns_of(function, "Scalar") == "bool" ? "[[nodiscard]] " : "";
}

// Takes the name of a parameter. In a definition, one that is not read or written has none.
std::string CppFile::parameter_name(const EmittedParameter& parameter, const ScannedFunction* body) {
  if (is(",") || is(")")) {
    if (body == nullptr || names(*body, parameter.name)) fail(fmt::format("no name of {}", parameter.name));
    return parameter.name;
  }
  const bool is_output = parameter.kind == EmittedParameter::Kind::output;
  const std::string name = is_output ? take_name_like(parameter.name) : take();
  if (!is_output && name != parameter.name) fail(fmt::format("{} expected instead of {}", parameter.name, name));
  if (body != nullptr && !names(*body, name)) fail(fmt::format("{} is not used", name));
  return name;
}

// Takes the parameters and the bracket at their end. `body`: of a definition; nullptr: of a declaration.
CppFile::Known CppFile::parameter_list(const FileFunction& function, const ScannedFunction* body) {
  using Kind = EmittedParameter::Kind;
  Known known{&function, {}, false, function.member_of};
  bool is_first = true;
  for (const EmittedParameter& parameter : parameters_of(function, contents_)) {
    if (!is_first) expect(",");
    is_first = false;
    expect(parameter.kind == Kind::parameters ? "const Parameters<Scalar>&"
           : parameter.kind == Kind::input    ? "const Scalar*"
                                              : "Scalar*");
    const std::string name = parameter_name(parameter, body);
    if (parameter.kind == Kind::output) known.outputs.push_back(name);
  }
  known.has_sin_cos = accept(is_first ? "const SinCos& sin_cos" : ", const SinCos& sin_cos");
  const bool has_default = body == nullptr || !is_pair();
  if (known.has_sin_cos && has_default) expect("= {}");
  if (body != nullptr && known.has_sin_cos != names(*body, "sin_cos")) fail("sin_cos is not used");
  expect(")");
  return known;
}

void CppFile::header_function(const FileFunction& function) {
  if (!is_pair()) parts(function);
  for (const FileTable& each : function.zeros) table(each);
  if (is_pair()) {
    declaration(function);
  } else {
    definition(function);
  }
}

// Takes a declaration of a header whose definition is in the source.
void CppFile::declaration(const FileFunction& function) {
  const bool has_sin_cos = accept("template <class Scalar, class SinCos = DefaultSinCos>");
  if (!has_sin_cos) expect("template <class Scalar>");
  expect(fmt::format("{}{} {}(", not_discarded(function), returns_of(function, "Scalar"), function.name));
  Known known = parameter_list(function, nullptr);
  if (known.has_sin_cos != has_sin_cos) fail("sin_cos without its type");
  expect("noexcept;");
  (function.made.empty() ? known_ : makers_).push_back(std::move(known));
}

void CppFile::definition(const FileFunction& function) {
  const ScannedFunction& body = next_function();
  const bool is_member = !function.member_of.empty();
  const bool has_sin_cos = accept(is_pair() ? "template <class Scalar, class SinCos>"
                                            : "template <class Scalar, class SinCos = DefaultSinCos>");
  if (!has_sin_cos) expect("template <class Scalar>");
  if (!is_pair()) expect(is_member ? "inline" : not_discarded(function) + "static inline");
  expect(fmt::format("{} {}{}(", returns_of(function, "Scalar"), is_member ? function.member_of + "<Scalar>::" : "",
                     function.name));
  Known known = parameter_list(function, &body);
  if (known.has_sin_cos != has_sin_cos) fail("sin_cos without its type");
  expect(is_member ? "const noexcept {" : "noexcept {");
  const bool checks_scalar = !is_pair() && !is_member;
  if (follows("static_assert") != checks_scalar) fail("a check of the scalar is not where it has to be");
  take_body(body);
  if (is_pair() || (is_member && !function.made.empty())) return;
  (function.made.empty() ? known_ : makers_).push_back(std::move(known));
}

// Takes the parts of a function, if it has any.
void CppFile::parts(const FileFunction& function) {
  if (!accept("namespace detail {")) return;
  do {
    part(function);
  } while (!is("}"));
  expect("}");
}

void CppFile::part(const FileFunction& function) {
  expect("template <class Scalar> static void");
  const std::string name = take();
  const std::string owner = (function.member_of.empty() ? "" : function.member_of + "_") + function.name;
  if (name != owner && !name.starts_with(owner + "_")) fail(fmt::format("no part of {}", owner));
  std::vector<std::string> possible = {"const Parameters<Scalar>& parameters"};
  if (!function.member_of.empty()) possible.push_back(fmt::format("const {}<Scalar>& stored", function.member_of));
  if (function.function == nullptr) {
    possible = {"const Scalar* q", "Scalar* angle"};
  } else {
    for (const InputKind kind : function.function->inputs)
      possible.push_back("const Scalar* " + std::string(argument_row(kind).name));
    for (const char* each : {"const Scalar* sine", "const Scalar* cosine"}) possible.emplace_back(each);
    for (const std::string& each : arrays_of_sine_rounds()) possible.push_back("Scalar* " + each);
    for (const char* each : {"Scalar* kept", "Scalar* pivots", "Scalar& result"}) possible.emplace_back(each);
    const std::string output = function.made.empty() ? "Scalar* " : function.made + "<Scalar>& ";
    for (const std::string& each : names_of_outputs(function)) possible.push_back(output + each);
  }
  expect("(");
  take_parameters_of_part(possible);
  expect("noexcept {");
  take_part_body(name);
}

std::vector<const FileFunction*> CppFile::staged_functions() const {
  std::vector<const FileFunction*> list;
  for (const FileStage& stage : contents_.stages) {
    list.push_back(&stage.make);
    for (const FileFunction& each : stage.members) list.push_back(&each);
  }
  return list;
}

// Takes the structs, the last stage first, and then the functions.
void CppFile::stages() {
  for (std::size_t k = contents_.stages.size(); k-- > 0;) structure(k);
  for (const FileFunction* function : staged_functions()) {
    if (!is_pair()) {
      parts(*function);
      definition(*function);
    } else if (function->member_of.empty()) {
      declaration(*function);
    }
  }
}

void CppFile::structure(std::size_t k) {
  const FileStage& stage = contents_.stages[k];
  expect(fmt::format("template <class Scalar> struct {} {{", stage.name));
  for (const FileFunction& each : stage.members) member(each);
  if (k + 1 < contents_.stages.size()) member(contents_.stages[k + 1].make);
  const std::size_t fields = stage.make.function->outputs[0].entries.size();
  std::set<std::string> names;
  for (std::size_t field = 0; field < fields; ++field) {
    expect(field == 0 ? "Scalar" : ",");
    if (!names.insert(take()).second) fail("a field made twice");
  }
  if (fields > 0) expect(";");
  expect("};");
}

// Takes the declaration of a member. In a header by itself it is like the definition.
void CppFile::member(const FileFunction& function) {
  expect(fmt::format("{}{} {}(", not_discarded(function), returns_of(function, "Scalar"), function.name));
  const auto& functions = text_.functions();
  const auto body = std::find_if(functions.begin(), functions.end(), [&](const ScannedFunction& each) {
    return each.name == function.name && each.member_of == function.member_of;
  });
  if (body == functions.end()) fail("a member without a definition");
  Known known = parameter_list(function, is_pair() ? nullptr : &*body);
  if (is_pair() && function.made.empty()) known_.push_back(std::move(known));
  expect("const noexcept;");
}

}  // namespace flatdyn
