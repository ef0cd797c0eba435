// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/bench/calls.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "code/emit/sections.hpp"
#include "code/lower/arguments.hpp"
#include "robot/model/identifiers.hpp"

namespace flatdyn {
namespace {

using Words = std::vector<std::string>;

std::string joined(const Words& words) { return fmt::format("{}", fmt::join(words, ", ")); }

// The scalar that the function is compiled for.
std::string scalar_type(const BenchVariant& variant) {
  return variant.call_mode == CallMode::batch ? fmt::format("flatdyn::Lanes<{}>", variant.scalar) : variant.scalar;
}

std::string given_type(const BenchVariant& variant) {
  return fmt::format("{}::GivenSinCos<{}>", name_space_of(variant), scalar_type(variant));
}

// The type of the source of sines and cosines of a function in the namespace `scope`.
std::string source_type(const std::string& scope, const BenchVariant& variant) {
  switch (variant.trigonometry) {
    case SinCosSource::own:
      return scope + "::PolynomialSinCos";
    case SinCosSource::library:
      return scope + "::LibrarySinCos";
    case SinCosSource::together:
      return "flatdyn::TogetherSinCos";
    case SinCosSource::given:
      return given_type(variant);
  }
  return "";
}

// The argument that selects the source of sines and cosines; `given`: the caller's arrays.
Words sin_cos_argument(const BenchVariant& variant, const std::string& given) {
  switch (variant.trigonometry) {
    case SinCosSource::own:
      return {};
    case SinCosSource::library:
      return {fmt::format("{}::LibrarySinCos()", name_space_of(variant))};
    case SinCosSource::together:
      return {"flatdyn::TogetherSinCos()"};
    case SinCosSource::given:
      return {fmt::format("{}{{{}}}", given_type(variant), given)};
  }
  return {};
}

void append(Words& words, const Words& more) { words.insert(words.end(), more.begin(), more.end()); }

InputArgument argument_of(const Mechanism& mechanism, const Function& function, InputKind kind) {
  return input_argument(kind, JointCounts(mechanism), function);
}

// The struct of free symbols at state `k`, the first argument of all functions of a robot that has some.
Words free_symbols(const Mechanism& mechanism, const BenchVariant& variant, const std::string& k) {
  if (mechanism.symbols.empty()) return {};
  Words members;
  for (std::size_t m = 0; m < mechanism.symbols.size(); ++m) {
    members.push_back(fmt::format("{}(x.parameters.of({})[{}])", scalar_type(variant), k, m));
  }
  return {fmt::format("{}::Parameters<{}>{{{}}}", name_space_of(variant), scalar_type(variant), joined(members))};
}

bool is_member(const CalledFunction& called) { return called.receiver.back() == '.'; }

// The free symbols that a stage's member needs as an argument.
Words free_symbols_of(const CalledFunction& called, const Mechanism& mechanism, const BenchVariant& variant,
                      const std::string& k) {
  return is_member(called) ? Words() : free_symbols(mechanism, variant, k);
}

// In CUDA the caller names the scalar.
std::string call_text(const CalledFunction& called, const BenchVariant& variant, const Words& arguments) {
  const std::string scalar = variant.call_mode == CallMode::kernel ? fmt::format("<{}>", variant.scalar) : "";
  return fmt::format("{}{}{}({})", called.receiver, cpp_identifier(called.function.name), scalar, joined(arguments));
}

std::string in_column(int length, const std::string& name) {
  return fmt::format("flatdyn::in<{}>(x.{}.by_entry.data(), kStates)", length, name);
}

std::string in_tiles(int length, const std::string& name) {
  return fmt::format("flatdyn::in_tiles<{}>(x.{}.tiles.data()).from(first)", length, name);
}

bool is_symmetric(const Output& output) {
  const auto side = static_cast<std::size_t>(output.cols);
  if (side < 2 || output.entries.size() != side * side) return false;
  for (std::size_t i = 0; i < side; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (output.entries[i * side + j] != output.entries[j * side + i]) return false;
    }
  }
  return true;
}

bool has_zeros(const Function& function, const Output& output) {
  return std::any_of(output.entries.begin(), output.entries.end(),
                     [&function](NodeId entry) { return function.graph.is_zero(entry); });
}

bool can_be_packed(const Function& function, const Output& output) {
  return is_array_of_arrays(output) && (is_symmetric(output) || has_zeros(function, output));
}

// The type of the set of entries that are stored of a result.
std::string stored_entries(const CalledFunction& called, const BenchVariant& variant, const Output& output) {
  const Function& function = called.function;
  if (!variant.is_packed || !can_be_packed(function, output)) {
    return fmt::format("flatdyn::AllEntries<{}>", output.entries.size());
  }
  return fmt::format("flatdyn::{}Entries<{}::{}{}_nonzero>", is_symmetric(output) ? "Symmetric" : "Nonzero",
                     called.scope, cpp_identifier(function.name),
                     function.outputs.size() == 1 ? "" : "_" + output.name);
}

// "result", "result_2", …
std::string result_name(std::size_t output) { return output == 0 ? "result" : fmt::format("result_{}", output + 1); }

}  // namespace

std::string single_call(const Mechanism& mechanism, const CalledFunction& called, const BenchVariant& variant,
                        std::size_t first) {
  const Function& function = called.function;
  Words arguments = free_symbols_of(called, mechanism, variant, "k");
  for (const InputKind kind : function.inputs) {
    arguments.push_back(fmt::format("x.{}.of(k)", argument_of(mechanism, function, kind).name));
  }
  const Words sin_cos = sin_cos_argument(variant, "x.s.of(k), x.c.of(k)");
  if (returns_value(function)) {
    append(arguments, sin_cos);
    return fmt::format("out[{}] = {}", first, call_text(called, variant, arguments));
  }
  std::size_t offset = first;
  for (const Output& output : function.outputs) {
    arguments.push_back(offset == 0 ? "out" : fmt::format("out + {}", offset));
    offset += output.entries.size();
  }
  append(arguments, sin_cos);
  const std::string call = call_text(called, variant, arguments);
  return function.validity_conditions.empty() ? call : "keep(" + call + ")";
}

std::string at_call(const Mechanism& mechanism, const BenchVariant& variant) {
  Words arguments = free_symbols(mechanism, variant, "k");
  arguments.emplace_back("x.q.of(k)");
  return fmt::format("{}::at({})", kBenchNamespace, joined(arguments));
}

BatchCall batch_call(const Mechanism& mechanism, const CalledFunction& called, const BenchVariant& variant) {
  const Function& function = called.function;
  Words arguments = free_symbols(mechanism, variant, "0"), parameters, columns, tiles, entries;
  for (const InputKind kind : function.inputs) {
    const InputArgument argument = argument_of(mechanism, function, kind);
    parameters.push_back("auto " + argument.name);
    arguments.push_back(argument.name);
    columns.push_back(in_column(argument.length, argument.name));
    tiles.push_back(in_tiles(argument.length, argument.name));
  }
  if (variant.trigonometry == SinCosSource::given) {
    for (const char* name : {"s", "c"}) {
      parameters.push_back(fmt::format("auto {}", name));
      columns.push_back(in_column(mechanism.position_count(), name));
      tiles.push_back(in_tiles(mechanism.position_count(), name));
    }
  }
  std::size_t offset = 0;
  for (std::size_t k = 0; k < function.outputs.size(); ++k) {
    const std::size_t length = function.outputs[k].entries.size();
    parameters.push_back("auto " + result_name(k));
    if (!returns_value(function)) arguments.push_back(result_name(k));
    columns.push_back(fmt::format("flatdyn::out<{}>(out + {} * kStates, kStates)", length, offset));
    entries.push_back(stored_entries(called, variant, function.outputs[k]));
    offset += length;
  }
  tiles.emplace_back("results...");
  append(arguments, sin_cos_argument(variant, "s, c"));
  const std::string call = call_text(called, variant, arguments);
  const std::string body = returns_value(function)                ? "*result = " + call
                           : function.validity_conditions.empty() ? call
                                                                  : "return " + call;
  constexpr const char* kNextLine = ",\n        ";
  return {mechanism.symbols.empty() ? "" : "&x",
          joined(parameters),
          body,
          fmt::format("{}", fmt::join(columns, kNextLine)),
          fmt::format("{}", fmt::join(tiles, kNextLine)),
          joined(entries)};
}

std::string kernel_call(const Mechanism& mechanism, const CalledFunction& called, const BenchVariant& variant) {
  const Function& function = called.function;
  Words arguments = {"states"};
  append(arguments, free_symbols(mechanism, variant, "first"));
  for (const InputKind kind : function.inputs) {
    const InputArgument argument = argument_of(mechanism, function, kind);
    arguments.push_back(argument.length == 0 ? "nullptr" : fmt::format("x.{}.of(first)", argument.name));
  }
  std::size_t offset = 0;
  for (const Output& output : function.outputs) {
    arguments.push_back(offset == 0 ? "out" : fmt::format("out + {} * states", offset));
    offset += output.entries.size();
  }
  if (!function.validity_conditions.empty()) arguments.emplace_back("valid");
  return fmt::format("flatdyn::cuda::for_each_state_on_host<{}::functions::{}, {}, flatdyn::cuda::Rows>({})",
                     called.scope, cpp_identifier(function.name), variant.scalar, joined(arguments));
}

bool can_be_packed(const Function& function) {
  return std::any_of(function.outputs.begin(), function.outputs.end(),
                     [&function](const Output& output) { return can_be_packed(function, output); });
}

std::string plain_symbol(const Function& function, const std::string& variant) {
  return cpp_identifier(function.name + "_" + variant);
}

std::string template_symbol(const CalledFunction& called, const BenchVariant& variant) {
  const std::string function = cpp_identifier(called.function.name);
  if (is_member(called)) return fmt::format("{}<{}>::{}", called.scope, scalar_type(variant), function);
  if (variant.call_mode == CallMode::kernel) return fmt::format("{}::{}<{}, ", called.scope, function, variant.scalar);
  std::string types = scalar_type(variant);
  if (has_angles(called.function)) {
    types += ", " + source_type(called.scope, variant);
  }
  // nm separates closing brackets by blanks, and so inner ones, too.
  std::string name = fmt::format("{}::{}<{}>", called.scope, function, types);
  for (std::size_t k = name.find(">>"); k != std::string::npos; k = name.find(">>", k)) name.replace(k, 2, "> >");
  return name;
}

std::string velocity_argument(const Mechanism& mechanism) {
  return input_argument(with_base(InputKind::qd, mechanism.has_quasi_velocities()), 0).name;
}

PlainFunction plain_function(const Mechanism& mechanism, const CalledFunction& called, const BenchVariant& variant) {
  const Function& function = called.function;
  const std::string scalar = scalar_type(variant);
  Words arguments, parameters;
  if (is_member(called)) {
    const std::string stage = called.receiver.substr(0, called.receiver.size() - 1);
    parameters.push_back(fmt::format("const {}<{}>& {}", called.scope, scalar, stage));
  } else if (!mechanism.symbols.empty()) {
    parameters.push_back(fmt::format("const {}::Parameters<{}>& parameters", name_space_of(variant), scalar));
    arguments.emplace_back("parameters");
  }
  for (const InputKind kind : function.inputs) {
    const std::string name = argument_of(mechanism, function, kind).name;
    parameters.push_back(fmt::format("const {}* {}", scalar, name));
    arguments.push_back(name);
  }
  for (std::size_t k = 0; k < function.outputs.size(); ++k) {
    parameters.push_back(fmt::format("{}* {}", scalar, result_name(k)));
    if (!returns_value(function)) arguments.push_back(result_name(k));
  }
  if (variant.trigonometry == SinCosSource::given) {
    for (const char* name : {"s", "c"}) parameters.push_back(fmt::format("const {}* {}", scalar, name));
  }
  append(arguments, sin_cos_argument(variant, "s, c"));
  const bool conditional = !function.validity_conditions.empty();
  return {conditional ? "bool" : "void", plain_symbol(function, variant.name), joined(parameters),
          (returns_value(function) ? "*result = "
           : conditional           ? "return "
                                   : "") +
              call_text(called, variant, arguments)};
}

}  // namespace flatdyn
